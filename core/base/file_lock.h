// A lock that one process holds on a name, and that the system gives back when the process dies, however it
// dies.
#pragma once

#include <filesystem>
#include <optional>
#include <utility>

namespace netwright {

class FileLock {
 public:
  /// Makes the file where it is missing. Nothing when another holder (in this process or any other) is alive,
  /// or when the file cannot be made.
  static std::optional<FileLock> try_take(const std::filesystem::path& path);
  /// Whether somebody holds it. Several may ask at once: asking never looks like holding to another who asks.
  static bool is_held(const std::filesystem::path& path);

  FileLock(FileLock&& other) noexcept
      : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)) {}
  FileLock& operator=(FileLock&& other) noexcept {
    std::swap(path_, other.path_);
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;
  ~FileLock();  ///< gives it back; the file stays

  /// Removes the file; the lock is given back with it.
  void remove();

 private:
  FileLock(std::filesystem::path path, int descriptor) : path_(std::move(path)), descriptor_(descriptor) {}

  std::filesystem::path path_;
  int descriptor_ = -1;
};

}  // namespace netwright
