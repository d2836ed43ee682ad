// The session's project file: opening one, saving it, and what is kept for the case that the editor dies.
#include <algorithm>

#include "core/project/session_impl.h"

namespace netwright {

namespace {

using Kind = Message::Kind;

}  // namespace

void Session::Impl::take_stored(const StoredProject& stored, const std::vector<FinishedRun>& finished) {
  std::error_code ignored;
  const std::filesystem::path opened = std::filesystem::absolute(std::exchange(opening_file, {}), ignored);
  replace(stored.project);
  for (const FinishedRun& one : finished) runs.add(one);
  if (opening_slot) {
    std::erase_if(leftovers, [&](const Leftover& leftover) { return leftover.file == opening_slot->file(); });
    keeper.adopt_unsaved(project(), stored.belongs_to, std::move(*opening_slot));
    opening_slot.reset();
  } else {
    keeper.adopt_saved(project(), opened);
  }
  for (const std::string& notice : project().source->notices) say(Kind::Notice, notice);
}

bool Session::Impl::take_leftovers() {
  const auto found = searching_leftovers ? searching_leftovers->result.take() : nullptr;
  if (!found) return false;
  searching_leftovers = nullptr;
  leftovers = *found;
  return true;
}

bool Session::Impl::watch_files() {
  const std::vector<Keeper::News> news = keeper.poll(project(), clock());
  for (const Keeper::News& one : news)
    say(one.is_good ? Kind::Good : (one.is_failure ? Kind::Error : Kind::Notice), one.text);
  return !news.empty();
}

const std::filesystem::path& Session::file() const { return impl_->keeper.file(); }

bool Session::is_modified() const { return impl_->keeper.is_modified(project()); }

void Session::save(const std::filesystem::path& file) { impl_->keeper.save(project(), file); }

bool Session::is_saving() const { return impl_->keeper.is_saving(); }

void Session::keep_changes_in(const std::filesystem::path& folder) {
  impl_->keeper.set_folder(folder);
  impl_->searching_leftovers = std::make_shared<Impl::Chore<std::vector<Leftover>>>(impl_->bell);
  impl_->searching_leftovers->progress =
      impl_->worker.submit(Worker::Lane::Chores, [chore = impl_->searching_leftovers, folder](Progress&) {
        chore->result.post(std::make_shared<const std::vector<Leftover>>(find_leftovers(folder)));
      });
}

void Session::set_autosave_minutes(int minutes) { impl_->keeper.set_autosave(60.0 * minutes); }

const std::vector<Leftover>& Session::leftovers() const { return impl_->leftovers; }

void Session::recover(const std::filesystem::path& leftover) {
  std::optional<AutosaveSlot> slot = AutosaveSlot::take(leftover);
  if (!slot) {
    std::erase_if(impl_->leftovers, [&](const Leftover& one) { return one.file == leftover; });
    impl_->say(Kind::Notice, "Another window has recovered this work already.");
    return;
  }
  open(leftover);
  impl_->opening_slot = std::move(slot);
}

void Session::discard(const std::filesystem::path& leftover) {
  if (std::optional<AutosaveSlot> slot = AutosaveSlot::take(leftover)) slot->give_up();
  std::erase_if(impl_->leftovers, [&](const Leftover& one) { return one.file == leftover; });
}

void Session::give_up_changes() { impl_->keeper.give_up(); }

}  // namespace netwright
