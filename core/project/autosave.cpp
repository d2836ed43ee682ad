// Places are numbered from 1: the first one that is neither locked nor holds a file is taken.
#include "core/project/autosave.h"

#include <algorithm>
#include <string>

#include "core/base/error.h"

namespace netwright {

namespace {

namespace fs = std::filesystem;

fs::path lock_of(fs::path file) { return file.replace_extension(".lock"); }

/// What an editor that was killed between two system calls may have left beside the file.
void remove_drafts(const fs::path& file) {
  std::error_code error;
  const std::string start = file.filename().string() + ".";
  for (fs::directory_iterator it(file.parent_path(), error), end; !error && it != end; it.increment(error)) {
    std::error_code ignored;
    if (it->path().filename().string().starts_with(start)) fs::remove(it->path(), ignored);
  }
}

Leftover read_leftover(const fs::path& file) {
  ProjectGlance glance = glance_at_project(file);
  std::error_code ignored;
  const fs::file_time_type saved_at = fs::last_write_time(file, ignored);
  std::error_code missing;
  const fs::file_time_type own = fs::last_write_time(glance.outline.belongs_to, missing);
  return {file, std::move(glance.outline), std::move(glance.thumbnail), saved_at, !missing && own > saved_at};
}

}  // namespace

AutosaveSlot AutosaveSlot::make(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  constexpr int kMost = 1000;
  for (int n = 1; n <= kMost; ++n) {
    const fs::path file = folder / (std::to_string(n) + "." + std::string(kProjectExtension));
    std::optional<FileLock> lock = FileLock::try_take(lock_of(file));
    if (!lock && !fs::exists(lock_of(file), error)) break;  // not taken, but impossible
    if (!lock || fs::exists(file, error)) continue;
    remove_drafts(file);
    return {file, std::move(*lock)};
  }
  throw Error(ErrorKind::Write, "Changes cannot be kept in " + folder.string() +
                                    " while you work; make sure that you may write there, and save often.");
}

std::optional<AutosaveSlot> AutosaveSlot::take(const fs::path& file) {
  std::error_code error;
  if (!fs::exists(file, error)) return std::nullopt;
  std::optional<FileLock> lock = FileLock::try_take(lock_of(file));
  // Whoever held it a moment ago may have cleared it.
  if (!lock || !fs::exists(file, error)) return std::nullopt;
  return AutosaveSlot(file, std::move(*lock));
}

void AutosaveSlot::clear() {
  std::error_code ignored;
  fs::remove(file_, ignored);
}

void AutosaveSlot::give_up() {
  clear();
  lock_.remove();
}

std::vector<Leftover> find_leftovers(const fs::path& folder) {
  std::vector<Leftover> all;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const fs::path& file = it->path();
    if (!has_project_name(file)) continue;
    // Not by taking it: another editor that starts at the same moment would not see it.
    if (FileLock::is_held(lock_of(file))) continue;
    try {
      all.push_back(read_leftover(file));
    } catch (const Error&) {
      continue;
    }
  }
  std::sort(all.begin(), all.end(),
            [](const Leftover& a, const Leftover& b) { return a.saved_at > b.saved_at; });
  return all;
}

}  // namespace netwright
