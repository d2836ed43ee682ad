// Where threads are made, and nowhere else: the editor's worker with its two lanes, and the small pool that
// search streams run on. Both join their threads when they are destroyed.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "core/base/progress.h"

namespace netwright {

/// Runs the same function for 0 … n-1 on a fixed number of threads and waits for all of them.
class ThreadPool {
 public:
  /// With one thread (or fewer) everything runs on the caller's.
  explicit ThreadPool(int n_threads);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  /// How many threads this machine runs at once, at least 1.
  [[nodiscard]] static int hardware_threads();

  /// Calls task(i) once for every i; returns when all are done. The first exception is thrown again here.
  void run(int n, const std::function<void(int)>& task);

 private:
  void work();
  void run_tasks(std::unique_lock<std::mutex>& lock);

  std::mutex mutex_;
  std::condition_variable wake_;
  std::condition_variable done_;
  const std::function<void(int)>* task_ = nullptr;
  int next_ = 0;
  int count_ = 0;
  int unfinished_ = 0;
  std::exception_ptr failure_;
  bool closing_ = false;
  std::vector<std::jthread> threads_;
};

/// Two lanes, one job at a time on each: the search may take minutes while chores (reading, derived data,
/// proofs, exports) go on beside it. The search, and the threads it makes, give way to everything else.
class Worker {
 public:
  enum class Lane { Search, Chores };
  using Job = std::function<void(Progress&)>;

  Worker();
  ~Worker();  ///< cancels what runs, drops what waits, joins
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Queues a job; the returned Progress shows how far it is and cancels it. Jobs must not throw.
  std::shared_ptr<Progress> submit(Lane lane, Job job);

  /// True when the lane neither runs nor holds a job.
  [[nodiscard]] bool is_idle(Lane lane) const;

 private:
  struct Entry {
    std::shared_ptr<Progress> progress;
    Job job;
  };
  struct LaneState {
    mutable std::mutex mutex;
    std::condition_variable wake;
    std::deque<Entry> queue;
    std::shared_ptr<Progress> running;
    bool closing = false;
    std::jthread thread;
  };
  static void work(LaneState& lane);
  LaneState& lane(Lane which) { return which == Lane::Search ? search_ : chores_; }
  [[nodiscard]] const LaneState& lane(Lane which) const { return which == Lane::Search ? search_ : chores_; }

  LaneState search_;
  LaneState chores_;
};

}  // namespace netwright
