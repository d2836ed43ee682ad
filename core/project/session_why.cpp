// After a search that found no net: what it was stuck at, and what is tried to get out of it. Trials run on
// the search's lane, which has nothing else to do then.
#include "core/project/commands.h"
#include "core/project/session_impl.h"

namespace netwright {

const Session::Impl::Failed* Session::Impl::failure() const {
  const bool is_shown = is_unfinished && failed_run && failed_run->dual == project().dual && !run && !viewing;
  return is_shown ? &*failed_run : nullptr;
}

bool Session::Impl::has_pins_of(const Failed& failure) const {
  return failure.pins == project().pins && failure.edits == project().edits;
}

void Session::Impl::stop_trial() {
  if (releasing) releasing->progress->cancel();
  releasing = nullptr;
  if (piecing) piecing->progress->cancel();
  piecing = nullptr;
}

bool Session::Impl::take_releases() {
  const auto found = releasing ? releasing->result.take() : nullptr;
  if (!found) return false;
  releasing = nullptr;
  if (failed_run && !found->was_cancelled) failed_run->releases = found;
  return true;
}

std::shared_ptr<const Trouble> Session::trouble() const {
  const Impl::Failed* const failed = impl_->failure();
  return failed == nullptr ? nullptr : failed->trouble;
}

std::shared_ptr<const Releases> Session::releases() const {
  const Impl::Failed* const failed = impl_->failure();
  return failed != nullptr && impl_->has_pins_of(*failed) ? failed->releases : nullptr;
}

void Session::look_for_releases() {
  const Impl::Failed* const failed = impl_->failure();
  if (failed == nullptr || failed->releases || impl_->releasing || !impl_->has_pins_of(*failed)) return;
  auto chore = std::make_shared<Impl::Chore<Releases>>(impl_->bell);
  chore->progress = impl_->worker.submit(
      Worker::Lane::Search,
      [chore, dual = failed->dual, options = failed->options, trouble = failed->trouble](Progress& progress) {
        progress.set_phase("Trying without pins");
        chore->result.post(
            std::make_shared<const Releases>(find_releases(dual, options, *trouble, progress)));
      });
  impl_->releasing = std::move(chore);
}

std::shared_ptr<const Progress> Session::trial() const {
  if (impl_->piecing) return impl_->piecing->progress;
  return impl_->releasing ? impl_->releasing->progress : nullptr;
}

void Session::stop_trial() { impl_->stop_trial(); }

void Session::release(const std::vector<Pin>& pins) {
  if (!has_model() || impl_->run || pins.empty()) return;
  impl_->end_replay();
  Project next = netwright::set_pins(project(), without(project().pins, pins));
  next.edits = without(next.edits, pins);
  impl_->edit(pins.size() == 1 ? "release pin" : "release pins", std::move(next));
  unfold();
}

}  // namespace netwright
