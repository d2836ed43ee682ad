// Whole-file reading and writing. A write goes to a temporary file in the target's own folder (a rename is
// only atomic within one file system), is flushed to the disk, and then takes the target's name in one step.
// Where the file system allows, the temporary file has no name until then, so a killed program leaves none.
#include "core/base/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "core/base/error.h"

namespace netwright {

namespace {

[[noreturn]] void refuse(const std::filesystem::path& path, int error_number) {
  std::string sentence = path.string() + " cannot be written: " + std::strerror(error_number);
  switch (error_number) {
    case ENOENT:
      sentence = path.string() +
                 " cannot be written: its folder does not exist; make it first, or plug in the disk it is on";
      break;
    case EACCES:
    case EROFS:
      sentence = path.string() + " cannot be written: choose a folder you may write to";
      break;
    case ENOSPC:
      sentence = path.string() + " cannot be written: the disk is full; make room or choose another disk";
      break;
    case EDQUOT:
      sentence = path.string() + " cannot be written: your share of the disk is used up; make room";
      break;
    case EFBIG:
      sentence = path.string() + " cannot be written: the disk takes no file that large; choose another one";
      break;
    default:
      break;
  }
  throw Error(ErrorKind::Write, sentence + ".");
}

/// A file beside the target that disappears unless it is moved over it.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::filesystem::path& target)
      : target_(target), folder_(target.parent_path()) {
    if (folder_.empty()) folder_ = ".";
    if (::access(kOwnFiles, X_OK) == 0)
      descriptor_ = ::open(folder_.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, S_IRUSR | S_IWUSR);
    if (descriptor_ >= 0) return;
    name_ = target.string() + ".XXXXXX";
    descriptor_ = ::mkostemp(name_.data(), O_CLOEXEC);
    if (descriptor_ < 0) {
      name_.clear();
      refuse(target_, errno);
    }
  }
  ~TemporaryFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!is_moved_ && !name_.empty()) ::unlink(name_.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  void write(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) refuse(target_, errno);
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
  }

  /// Sees to it that the bytes and the rights are on the disk.
  void flush() {
    if (::fchmod(descriptor_, mode_of_target()) != 0) refuse(target_, errno);
    if (::fsync(descriptor_) != 0) refuse(target_, errno);
  }

  /// What is on the disk now.
  [[nodiscard]] std::string read_back(std::size_t n_expected) const {
    ::posix_fadvise(descriptor_, 0, 0,
                    POSIX_FADV_DONTNEED);  // from the disk, not from what is remembered of it
    std::string bytes(n_expected + 1, '\0');
    std::size_t n = 0;
    while (n < bytes.size()) {
      const ssize_t got = ::pread(descriptor_, bytes.data() + n, bytes.size() - n, static_cast<off_t>(n));
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) refuse(target_, errno);
      if (got == 0) break;
      n += static_cast<std::size_t>(got);
    }
    bytes.resize(n);
    return bytes;
  }

  void move_over_target() {
    if (name_.empty()) give_name();
    if (::rename(name_.c_str(), target_.c_str()) != 0) refuse(target_, errno);
    is_moved_ = true;
    // The new name is on the disk once the folder is. Not every file system can; the file is whole anyway.
    const int folder = ::open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder < 0) return;
    ::fsync(folder);
    ::close(folder);
  }

 private:
  static constexpr const char* kOwnFiles = "/proc/self/fd";

  void give_name() {
    const std::string own = std::string(kOwnFiles) + "/" + std::to_string(descriptor_);
    const std::string start = target_.string() + "." + std::to_string(::getpid()) + "-";
    for (int n = 1;; ++n) {
      const std::string name = start + std::to_string(n);
      if (::linkat(AT_FDCWD, own.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0) {
        name_ = name;
        return;
      }
      if (errno != EEXIST) refuse(target_, errno);
    }
  }

  /// Temporary files are private; the result keeps the old file's rights, or gets those of any new file.
  [[nodiscard]] mode_t mode_of_target() const {
    struct stat old {};
    return ::stat(target_.c_str(), &old) == 0 ? (old.st_mode & 0777U) : 0644U;
  }

  std::filesystem::path target_;
  std::filesystem::path folder_;
  std::string name_;  ///< empty while it has none
  int descriptor_ = -1;
  bool is_moved_ = false;
};

/// A link is written through, not replaced; a name that is no plain file is refused.
std::filesystem::path real_target(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw Error(ErrorKind::Write, path.string() + " cannot be written: it is a folder; add a file name.");
  if (std::filesystem::is_symlink(path, ignored)) {
    std::filesystem::path real = std::filesystem::weakly_canonical(path, ignored);
    if (!ignored) return real;
  }
  return path;
}

}  // namespace

void write_file(const std::filesystem::path& path, std::string_view bytes, const WrittenCheck& check) {
  TemporaryFile file(real_target(path));
  file.write(bytes);
  file.flush();
  if (check) check(file.read_back(bytes.size()));
  file.move_over_target();
}

std::string read_file(const std::filesystem::path& path, std::size_t max_bytes) {
  std::error_code failed;
  if (!std::filesystem::exists(path, failed))
    throw Error(ErrorKind::Read, path.string() + " does not exist; check the name.");
  if (!std::filesystem::is_regular_file(path, failed))
    throw Error(ErrorKind::Read, path.string() + " is not a file.");
  const std::uintmax_t size = std::filesystem::file_size(path, failed);
  if (!failed && size > max_bytes)
    throw Error(ErrorKind::Read, path.string() + " is too large: " + std::to_string(size / 1'000'000) +
                                     " MB, where at most " + std::to_string(max_bytes / 1'000'000) +
                                     " MB are read.");
  std::ifstream file(path, std::ios::binary);
  std::string bytes(failed ? 0 : static_cast<std::size_t>(size), '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!file || file.gcount() != static_cast<std::streamsize>(bytes.size()))
    throw Error(ErrorKind::Read, path.string() + " cannot be read; check that you may open it.");
  return bytes;
}

}  // namespace netwright
