// Threads and their queues. Nothing here knows what the work is about.
#include "core/base/worker.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <exception>

namespace netwright {
namespace {

/// The present thread, and those it makes, leave the processor to the others of this program when all want
/// it: a search takes what pictures leave, and all of it while none is drawn.
void give_way() {
  constexpr int kNicer = 3;
  const auto self = static_cast<id_t>(gettid());
  setpriority(PRIO_PROCESS, self, getpriority(PRIO_PROCESS, self) + kNicer);
}

}  // namespace

ThreadPool::ThreadPool(int n_threads) {
  for (int i = 1; i < n_threads; ++i) threads_.emplace_back([this] { work(); });
}

ThreadPool::~ThreadPool() {
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
  }
  wake_.notify_all();
}

int ThreadPool::hardware_threads() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void ThreadPool::run(int n, const std::function<void(int)>& task) {
  std::unique_lock lock(mutex_);
  task_ = &task;
  next_ = 0;
  count_ = n;
  unfinished_ = n;
  failure_ = nullptr;
  if (n > 1) wake_.notify_all();
  run_tasks(lock);
  done_.wait(lock, [this] { return unfinished_ == 0; });
  task_ = nullptr;
  count_ = 0;
  if (failure_) std::rethrow_exception(failure_);
}

void ThreadPool::run_tasks(std::unique_lock<std::mutex>& lock) {
  while (next_ < count_) {
    const int mine = next_++;
    const auto* task = task_;
    lock.unlock();
    std::exception_ptr failure;
    try {
      (*task)(mine);
    } catch (...) {
      failure = std::current_exception();
    }
    lock.lock();
    if (failure && !failure_) failure_ = failure;
    if (--unfinished_ == 0) done_.notify_all();
  }
}

void ThreadPool::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    wake_.wait(lock, [this] { return closing_ || next_ < count_; });
    if (closing_) return;
    run_tasks(lock);
  }
}

Worker::Worker() {
  search_.thread = std::jthread([this] {
    give_way();
    work(search_);
  });
  chores_.thread = std::jthread([this] { work(chores_); });
}

Worker::~Worker() {
  for (LaneState* lane : {&search_, &chores_}) {
    {
      const std::lock_guard lock(lane->mutex);
      lane->closing = true;
      lane->queue.clear();
      if (lane->running) lane->running->cancel();
    }
    lane->wake.notify_all();
  }
  search_.thread.join();
  chores_.thread.join();
}

std::shared_ptr<Progress> Worker::submit(Lane which, Job job) {
  auto progress = std::make_shared<Progress>();
  LaneState& target = lane(which);
  {
    const std::lock_guard lock(target.mutex);
    target.queue.push_back({progress, std::move(job)});
  }
  target.wake.notify_all();
  return progress;
}

bool Worker::is_idle(Lane which) const {
  const LaneState& target = lane(which);
  const std::lock_guard lock(target.mutex);
  return target.queue.empty() && !target.running;
}

void Worker::work(LaneState& lane) {
  std::unique_lock lock(lane.mutex);
  while (true) {
    lane.wake.wait(lock, [&lane] { return lane.closing || !lane.queue.empty(); });
    if (lane.closing) return;
    Entry entry = std::move(lane.queue.front());
    lane.queue.pop_front();
    lane.running = entry.progress;
    lock.unlock();
    entry.job(*entry.progress);
    entry.job = nullptr;  // what the job captured is released on this thread, before the lane counts as idle
    lock.lock();
    lane.running.reset();
  }
}

}  // namespace netwright
