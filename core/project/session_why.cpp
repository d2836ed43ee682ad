// After a search that found no net: what it was stuck at, and what is tried to get out of it. Trials run on
// the search's lane, which has nothing else to do then.
#include "core/project/commands.h"
#include "core/project/session_impl.h"

namespace netwright {

namespace {

// As a share of the model's diagonal: what changes it more is another model.
constexpr double kMostSoftening = 0.1;

}  // namespace

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
  if (softening) softening->progress->cancel();
  softening = nullptr;
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
  if (impl_->softening) return impl_->softening->progress;
  return impl_->releasing ? impl_->releasing->progress : nullptr;
}

bool Session::Impl::take_found_softening() {
  const auto found = softening ? softening->result.take() : nullptr;
  if (!found) return false;
  softening = nullptr;
  if (failed_run && !found->was_cancelled) failed_run->softening = found;
  return true;
}

void Session::look_for_softening() {
  const Impl::Failed* const failed = impl_->failure();
  if (failed == nullptr || failed->softening || impl_->softening || !impl_->has_pins_of(*failed)) return;
  impl_->stop_trial();
  auto chore = std::make_shared<Impl::Chore<Softening>>(impl_->bell);
  chore->progress =
      impl_->worker.submit(Worker::Lane::Search, [chore, source = project().source, recipe = project().recipe,
                                                  made = project().made, options = failed->options,
                                                  trouble = failed->trouble](Progress& progress) {
        progress.set_phase("Trying other shapes");
        const double most = kMostSoftening * glm::length(made->dual->mesh().box().size());
        chore->result.post(std::make_shared<const Softening>(
            soften(source, recipe, *made, options, *trouble, most, progress)));
      });
  impl_->softening = std::move(chore);
}

std::shared_ptr<const Softening> Session::softening() const {
  const Impl::Failed* const failed = impl_->failure();
  return failed != nullptr && impl_->has_pins_of(*failed) ? failed->softening : nullptr;
}

void Session::take_softening() {
  const std::shared_ptr<const Softening> found = softening();
  if (!found || !found->is_found() || impl_->run) return;
  impl_->queued.reset();
  impl_->make({found->recipe, "soften", true, false});
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
