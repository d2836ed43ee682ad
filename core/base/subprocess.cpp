// Starts a child with posix_spawn (safe while other threads run), limits it with prlimit before it is given
// anything to chew on, and talks to it over a socket and a pipe until it ends or has had its time.
#include "core/base/subprocess.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstring>
#include <utility>

#include "core/base/error.h"

namespace netwright {
namespace {

using Clock = std::chrono::steady_clock;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kCanLimitMemory = false;
#else
constexpr bool kCanLimitMemory = true;
#endif

/// A file descriptor that closes itself.
class Handle {
 public:
  explicit Handle(int fd = -1) : fd_(fd) {}
  ~Handle() { close(); }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  [[nodiscard]] int get() const { return fd_; }
  [[nodiscard]] bool is_open() const { return fd_ >= 0; }
  void close() {
    if (fd_ >= 0) ::close(fd_);
    fd_ = -1;
  }

 private:
  int fd_;
};

[[noreturn]] void cannot_start(const std::filesystem::path& program, int error) {
  throw Error(ErrorKind::Read, "The helper program " + program.string() + " cannot be started (" +
                                   std::strerror(error) + "); install Netwright again.");
}

pid_t spawn(const std::filesystem::path& program, const std::vector<std::string>& arguments, int input,
            int output) {
  posix_spawn_file_actions_t actions{};
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  std::vector<std::string> words{program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_t child = -1;
  const int error = posix_spawn(&child, program.c_str(), &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) cannot_start(program, error);
  return child;
}

void limit(pid_t child, const ChildLimits& limits) {
  const auto set = [child](auto resource, rlim_t amount) {
    const rlimit both{amount, amount};
    prlimit(child, resource, &both, nullptr);
  };
  set(RLIMIT_CORE, 0);
  if (limits.seconds > 0) set(RLIMIT_CPU, static_cast<rlim_t>(std::ceil(limits.seconds)) + 1);
  if (kCanLimitMemory && limits.memory_bytes > 0) set(RLIMIT_AS, limits.memory_bytes);
}

/// Sends as much as the socket takes now; closes it when all is sent or nobody listens any more.
void feed(Handle& socket, std::string_view& input) {
  const ssize_t sent =
      input.empty() ? 0 : ::send(socket.get(), input.data(), input.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  if (sent > 0) input.remove_prefix(static_cast<std::size_t>(sent));
  const bool is_broken = sent < 0 && errno != EAGAIN && errno != EINTR;
  if (input.empty() || is_broken) socket.close();
}

/// Takes what lies in the pipe; closes it at its end.
void drain(Handle& pipe, std::string& output) {
  std::array<char, 65536> block{};
  const ssize_t got = ::read(pipe.get(), block.data(), block.size());
  if (got > 0) output.append(block.data(), static_cast<std::size_t>(got));
  if (got == 0 || (got < 0 && errno != EINTR && errno != EAGAIN)) pipe.close();
}

/// How often a cancellation is looked for.
constexpr int kCancelMs = 50;

/// Milliseconds until something has to be looked at, as poll wants them; -1 = for ever.
int wait_ms(Clock::time_point deadline, const Progress* progress) {
  if (progress != nullptr) return kCancelMs;
  if (deadline == Clock::time_point::max()) return -1;
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
  return static_cast<int>(std::clamp<decltype(left)>(left, 0, 60000));
}

/// Feeds and drains until the child closes its output. Tells why it was given up, or Exited.
ChildResult::End converse(Handle& socket, Handle& pipe, std::string_view input, std::string& output,
                          const ChildLimits& limits) {
  Clock::time_point deadline = Clock::time_point::max();
  if (limits.seconds > 0) {
    deadline = Clock::now() +
               std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(limits.seconds));
  }
  while (pipe.is_open()) {
    std::array<pollfd, 2> waits{{{pipe.get(), POLLIN, 0}, {socket.get(), POLLOUT, 0}}};
    const int n = ::poll(waits.data(), socket.is_open() ? 2 : 1, wait_ms(deadline, limits.progress));
    if (limits.progress != nullptr && limits.progress->is_cancelled()) return ChildResult::End::Cancelled;
    if (Clock::now() >= deadline) return ChildResult::End::TimedOut;
    if (n <= 0) continue;
    if (waits[1].revents != 0 && socket.is_open()) feed(socket, input);
    if (waits[0].revents != 0) drain(pipe, output);
    if (limits.output_bytes > 0 && output.size() > limits.output_bytes) return ChildResult::End::Flooded;
  }
  return ChildResult::End::Exited;
}

int wait_for(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

}  // namespace

ChildResult run_child(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                      std::string_view input, const ChildLimits& limits) {
  std::array<int, 2> in{};
  std::array<int, 2> out{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, in.data()) != 0) cannot_start(program, errno);
  Handle socket(in[0]);
  Handle child_input(in[1]);
  if (::pipe2(out.data(), O_CLOEXEC) != 0) cannot_start(program, errno);
  Handle pipe(out[0]);
  Handle child_output(out[1]);

  const pid_t child = spawn(program, arguments, child_input.get(), child_output.get());
  child_input.close();
  child_output.close();
  limit(child, limits);

  ChildResult result;
  result.end = converse(socket, pipe, input, result.output, limits);
  if (result.end != ChildResult::End::Exited) ::kill(child, SIGKILL);
  const int status = wait_for(child);
  if (result.end == ChildResult::End::Exited) {
    if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) {
      result.end = WTERMSIG(status) == SIGXCPU ? ChildResult::End::TimedOut : ChildResult::End::Crashed;
    }
  }
  return result;
}

std::filesystem::path program_folder() {
  std::error_code error;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) throw Error(ErrorKind::Read, "The folder of the program cannot be found; is /proc mounted?");
  return self.parent_path();
}

}  // namespace netwright
