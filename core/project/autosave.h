// Where an editor keeps what its user has not saved yet: a file of its own in a common folder, and a lock
// beside it. When the editor dies the lock is free and the file is still there: that is a leftover, and the
// next start offers to recover it.
#pragma once

#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/file_lock.h"
#include "core/project/project_file.h"

namespace netwright {

class AutosaveSlot {
 public:
  /// A place that nobody else uses; the folder is made where it is missing. Throws Error(Write).
  static AutosaveSlot make(const std::filesystem::path& folder);
  /// Takes a leftover over; nothing when somebody else was faster.
  static std::optional<AutosaveSlot> take(const std::filesystem::path& file);

  AutosaveSlot(AutosaveSlot&&) noexcept = default;
  AutosaveSlot& operator=(AutosaveSlot&&) noexcept = default;
  AutosaveSlot(const AutosaveSlot&) = delete;
  AutosaveSlot& operator=(const AutosaveSlot&) = delete;
  /// Lets the lock go. A file that is there stays, for the next start to find.
  ~AutosaveSlot() = default;

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  /// Removes the file: there is nothing to recover any more.
  void clear();
  /// clear(), and the place is free again.
  void give_up();

 private:
  AutosaveSlot(std::filesystem::path file, FileLock lock) : file_(std::move(file)), lock_(std::move(lock)) {}

  std::filesystem::path file_;
  FileLock lock_;
};

/// What an editor that died has left.
struct Leftover {
  std::filesystem::path file;
  ProjectOutline outline;
  Image thumbnail;
  std::filesystem::file_time_type saved_at;
  bool is_outdated = false;  ///< the file it belongs to was saved after it was kept
};

/// Newest first. Files that cannot be read are left where they are.
std::vector<Leftover> find_leftovers(const std::filesystem::path& folder);

}  // namespace netwright
