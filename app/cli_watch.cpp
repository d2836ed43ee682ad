// The main thread's side of a running job: it sleeps until the job is over and wakes now and then to look at
// the signals, the clock and the terminal.
#include "app/cli_watch.h"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <semaphore>
#include <string>

#include "core/base/worker.h"

namespace netwright {
namespace {

constexpr int kCancelled = 130;
constexpr double kPatienceSeconds = 2;
constexpr auto kGlance = std::chrono::milliseconds(20);
constexpr double kRedrawSeconds = 0.1;

/// The result of a finished job travels through this.
struct Ending {
  std::exception_ptr failure;
  std::binary_semaphore is_over{0};
};

}  // namespace

double now_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Interrupts::Interrupts() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
}

bool Interrupts::has_come() const {
  sigset_t pending;
  sigemptyset(&pending);
  sigpending(&pending);
  return sigismember(&pending, SIGINT) == 1;
}

ProgressLine::ProgressLine() : is_shown_(isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
  if (is_shown_) std::fputs("\r\x1b[K", stderr);
}

void ProgressLine::show(double seconds) {
  if (!is_shown_) return;
  const auto snapshot = snapshots_.take();
  if (snapshot == nullptr) return;
  std::fprintf(stderr, "\r\x1b[KUnfolding: %d %s left at best · %lld moves · %.1f s", snapshot->best_overlaps,
               snapshot->best_overlaps == 1 ? "overlap" : "overlaps", static_cast<long long>(snapshot->moves),
               seconds);
  std::fflush(stderr);
}

Watched run_watched(Worker& worker, const Interrupts& interrupts, const std::function<void(Progress&)>& job,
                    std::optional<double> time_limit_s, const std::function<void(double)>& glance) {
  Watched seen;
  // Shared with the job, whose last step is to let go of it when this function may be over.
  const auto ending = std::make_shared<Ending>();
  const double start = now_seconds();
  double interrupted_at = 0;
  double shown_at = start;
  const auto progress = worker.submit(Worker::Lane::Search, [&job, ending](Progress& own) {
    try {
      job(own);
    } catch (...) {
      ending->failure = std::current_exception();
    }
    ending->is_over.release();
  });
  while (!ending->is_over.try_acquire_for(kGlance)) {
    const double now = now_seconds();
    if (!seen.was_interrupted && interrupts.has_come()) {
      seen.was_interrupted = true;
      interrupted_at = now;
      progress->cancel();
    }
    if (seen.was_interrupted && now - interrupted_at > kPatienceSeconds) std::_Exit(kCancelled);
    if (time_limit_s && !seen.was_out_of_time && now - start >= *time_limit_s) {
      seen.was_out_of_time = true;
      progress->cancel();
    }
    if (glance && now - shown_at >= kRedrawSeconds) {
      shown_at = now;
      glance(now - start);
    }
  }
  seen.was_interrupted = seen.was_interrupted || interrupts.has_come();
  if (ending->failure) std::rethrow_exception(ending->failure);
  return seen;
}

Watched run_watched(const Interrupts& interrupts, const std::function<void(Progress&)>& job,
                    std::optional<double> time_limit_s, ProgressLine* line) {
  Worker worker;
  std::function<void(double)> glance;
  if (line != nullptr) glance = [line](double seconds) { line->show(seconds); };
  return run_watched(worker, interrupts, job, time_limit_s, glance);
}

}  // namespace netwright
