// After a search that found no net: nets of several pieces, side by side, of which one may be taken. They are
// looked for on the search's lane, which has nothing else to do then.
#include "core/base/counted.h"
#include "core/project/commands.h"
#include "core/project/session_impl.h"

namespace netwright {

bool Session::Impl::take_found_pieces() {
  const auto found = piecing ? piecing->result.take() : nullptr;
  if (!found) return false;
  piecing = nullptr;
  if (failed_run && !found->was_cancelled) failed_run->pieces = found;
  return true;
}

bool Session::is_impossible() const {
  const Impl::Failed* const failed = impl_->failure();
  return failed != nullptr && failed->is_impossible;
}

void Session::look_for_pieces() {
  const Impl::Failed* const failed = impl_->failure();
  if (failed == nullptr || failed->pieces || impl_->piecing || !impl_->has_pins_of(*failed)) return;
  impl_->stop_trial();
  auto chore = std::make_shared<Impl::Chore<PiecesResult>>(impl_->bell);
  PiecesOptions options;
  options.seed = failed->options.seed;
  options.pins = failed->options.pins;
  options.from = std::make_shared<const UnfoldTree>(shown()->net.tree);
  chore->progress = impl_->worker.submit(
      Worker::Lane::Search, [chore, dual = failed->dual, options = std::move(options)](Progress& progress) {
        progress.set_phase("Looking for pieces");
        chore->result.post(std::make_shared<const PiecesResult>(fewest_pieces(dual, options, progress)));
      });
  impl_->piecing = std::move(chore);
}

std::shared_ptr<const PiecesResult> Session::pieces() const {
  const Impl::Failed* const failed = impl_->failure();
  return failed != nullptr && impl_->has_pins_of(*failed) ? failed->pieces : nullptr;
}

void Session::take_pieces(std::size_t choice) {
  const std::shared_ptr<const PiecesResult> found = pieces();
  if (!found || choice >= found->choices.size() || impl_->run) return;
  const Net& net = found->choices[choice].net;
  RunSummary summary;
  summary.seed = impl_->failed_run->options.seed;
  summary.is_proved = true;
  impl_->settled = impl_->stamp(std::make_shared<ShownNet>(make_shown_net(net, {}, true)));
  impl_->is_unfinished = false;
  impl_->edit("unfold into " + counted(net.n_pieces, "piece", "pieces"),
              accept_tree(project(), net.tree, summary));
}

}  // namespace netwright
