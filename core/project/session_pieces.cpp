// After a search that found no net: nets of several pieces, side by side, of which one may be taken. They are
// looked for on the search's lane, which has nothing else to do then.
#include "core/base/counted.h"
#include "core/base/error.h"
#include "core/project/commands.h"
#include "core/project/session_impl.h"
#include "core/sheet/pages.h"

namespace netwright {

bool Session::Impl::take_found_pieces() {
  const auto found = piecing ? piecing->result.take() : nullptr;
  if (!found) return false;
  piecing = nullptr;
  if (failed_run && !found->was_cancelled) failed_run->pieces = found;
  return true;
}

// A size that fits the page depends on how the pieces lie on it: a chore.
bool Session::Impl::measure_pieces() {
  const Failed* const failed = failure();
  const auto found = failed != nullptr ? failed->pieces : nullptr;
  const auto news = printing_pieces ? printing_pieces->result.take() : nullptr;
  if (news) {
    printing_pieces = nullptr;
    printed_pieces = news;
  }
  if (printing_pieces || !found || (printed_pieces && printed_pieces->is_of(found, project())))
    return news != nullptr;
  printing_pieces = std::make_shared<Chore<PrintedPieces>>(bell);
  auto wanted =
      std::make_shared<PrintedPieces>(PrintedPieces{found, project().paper, project().size, project().tabs});
  printing_pieces->progress =
      worker.submit(Worker::Lane::Chores, [chore = printing_pieces, wanted](Progress& /*progress*/) {
        try {
          for (const PiecesChoice& choice : wanted->pieces->choices)
            wanted->cut_mm.push_back(choice.cut_length *
                                     arrange(choice.net, wanted->paper, wanted->size, wanted->tabs).scale);
        } catch (const Error&) {
          wanted->cut_mm.clear();  // the paper's own panel says what is wrong with it
        }
        chore->result.post(wanted);
      });
  return news != nullptr;
}

std::vector<double> Session::pieces_cut_mm() const {
  const std::shared_ptr<const PiecesResult> found = pieces();
  const auto& printed = impl_->printed_pieces;
  return found && printed && printed->is_of(found, project()) ? printed->cut_mm : std::vector<double>();
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
