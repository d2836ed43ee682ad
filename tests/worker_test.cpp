// The worker's two lanes, its Progress tokens and the pool: order, independence, cancelling, orderly ends.
#include "core/base/worker.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <latch>
#include <numeric>
#include <stdexcept>
#include <thread>

namespace netwright {
namespace {

void wait_until_idle(const Worker& worker, Worker::Lane lane) {
  while (!worker.is_idle(lane)) std::this_thread::yield();
}

TEST(Worker, RunsTheJobsOfALaneOneAfterTheOther) {
  std::vector<int> order;
  std::atomic<int> at_once{0};
  std::atomic<bool> was_alone{true};
  Worker worker;
  for (int i = 0; i < 50; ++i)
    worker.submit(Worker::Lane::Chores, [&, i](Progress&) {
      if (++at_once != 1) was_alone = false;
      order.push_back(i);
      --at_once;
    });
  wait_until_idle(worker, Worker::Lane::Chores);
  std::vector<int> expected(50);
  std::iota(expected.begin(), expected.end(), 0);
  EXPECT_EQ(order, expected);
  EXPECT_TRUE(was_alone);
}

TEST(Worker, LetsTheSearchGiveWayToEverythingElse) {
  const auto own_niceness = [] { return getpriority(PRIO_PROCESS, static_cast<id_t>(gettid())); };
  int of_search = 0;
  int of_its_pool = 0;
  int of_chores = 0;
  Worker worker;
  worker.submit(Worker::Lane::Chores, [&](Progress&) { of_chores = own_niceness(); });
  worker.submit(Worker::Lane::Search, [&](Progress&) {
    of_search = own_niceness();
    std::latch both(2);
    const auto caller = std::this_thread::get_id();
    ThreadPool(2).run(2, [&](int) {
      if (std::this_thread::get_id() != caller) of_its_pool = own_niceness();
      both.arrive_and_wait();
    });
  });
  wait_until_idle(worker, Worker::Lane::Chores);
  wait_until_idle(worker, Worker::Lane::Search);
  EXPECT_EQ(of_chores, own_niceness());
  EXPECT_EQ(of_search, std::min(own_niceness() + 3, 19));
  EXPECT_EQ(of_its_pool, of_search);
}

TEST(Worker, RunsChoresBesideASearch) {
  Worker worker;
  std::latch search_started(1);
  std::latch search_may_end(1);
  std::atomic<bool> chore_ran{false};
  worker.submit(Worker::Lane::Search, [&](Progress&) {
    search_started.count_down();
    search_may_end.wait();
  });
  search_started.wait();
  worker.submit(Worker::Lane::Chores, [&](Progress&) { chore_ran = true; });
  wait_until_idle(worker, Worker::Lane::Chores);
  EXPECT_TRUE(chore_ran);
  EXPECT_FALSE(worker.is_idle(Worker::Lane::Search));
  search_may_end.count_down();
  wait_until_idle(worker, Worker::Lane::Search);
}

TEST(Worker, CancelsOneJobByItsProgressAndGoesOnWithTheNext) {
  Worker worker;
  std::atomic<bool> next_ran{false};
  const auto progress = worker.submit(Worker::Lane::Search, [](Progress& token) {
    while (!token.is_cancelled()) std::this_thread::yield();
  });
  const auto next = worker.submit(Worker::Lane::Search, [&](Progress& token) {
    EXPECT_FALSE(token.is_cancelled());
    next_ran = true;
  });
  EXPECT_FALSE(worker.is_idle(Worker::Lane::Search));
  progress->cancel();
  wait_until_idle(worker, Worker::Lane::Search);
  EXPECT_TRUE(next_ran);
  EXPECT_FALSE(next->is_cancelled());
}

TEST(Worker, CancelsWhatRunsAndDropsWhatWaitsWhenItIsDestroyed) {
  std::atomic<bool> was_cancelled{false};
  std::atomic<bool> waiting_ran{false};
  {
    Worker worker;
    std::latch started(1);
    worker.submit(Worker::Lane::Chores, [&](Progress& token) {
      started.count_down();
      while (!token.is_cancelled()) std::this_thread::yield();
      was_cancelled = true;
    });
    worker.submit(Worker::Lane::Chores, [&](Progress&) { waiting_ran = true; });
    started.wait();
  }
  EXPECT_TRUE(was_cancelled);
  EXPECT_FALSE(waiting_ran);
}

TEST(Worker, ReleasesWhatAJobCapturedBeforeTheLaneIsIdle) {
  Worker worker;
  auto treasure = std::make_shared<int>(1);
  const std::weak_ptr<int> watched = treasure;
  worker.submit(Worker::Lane::Chores, [kept = std::move(treasure)](Progress&) {});
  wait_until_idle(worker, Worker::Lane::Chores);
  EXPECT_TRUE(watched.expired());
}

TEST(Progress, KeepsItsFractionBetweenNothingAndAll) {
  Progress progress;
  progress.set_fraction(-1);
  EXPECT_EQ(progress.fraction(), 0);
  progress.set_fraction(2);
  EXPECT_EQ(progress.fraction(), 1);
}

TEST(Progress, StartsEachPhaseAtNothing) {
  Progress progress;
  progress.set_fraction(0.5);
  progress.set_phase("reading bunny.obj");
  EXPECT_EQ(progress.phase(), "reading bunny.obj");
  EXPECT_EQ(progress.fraction(), 0);
}

TEST(Progress, MayBeReadWhileItIsWritten) {
  Progress progress;
  std::jthread writer([&progress] {
    for (int i = 0; i <= 2000; ++i) {
      if (i % 100 == 0) progress.set_phase("phase " + std::to_string(i));
      progress.set_fraction(i / 2000.0);
    }
    progress.cancel();
  });
  while (!progress.is_cancelled()) {
    EXPECT_LE(progress.fraction(), 1.0);
    if (!progress.phase().empty()) {
      EXPECT_EQ(progress.phase().substr(0, 6), "phase ");
    }
  }
}

class ThreadPoolOf : public testing::TestWithParam<int> {};

TEST_P(ThreadPoolOf, CallsTheTaskOnceForEveryIndex) {
  ThreadPool pool(GetParam());
  for (const int n : {0, 1, 2, 7, 1000}) {
    std::vector<int> calls(static_cast<std::size_t>(n), 0);
    pool.run(n, [&](int i) { ++calls[static_cast<std::size_t>(i)]; });
    EXPECT_EQ(calls, std::vector<int>(static_cast<std::size_t>(n), 1));
  }
}

TEST_P(ThreadPoolOf, ThrowsAFailureAgainAfterAllAreDone) {
  ThreadPool pool(GetParam());
  std::atomic<int> n_calls{0};
  const auto task = [&](int i) {
    ++n_calls;
    if (i == 3) throw std::runtime_error("the third");
  };
  EXPECT_THROW(pool.run(10, task), std::runtime_error);
  EXPECT_EQ(n_calls, 10);
  pool.run(5, [&](int) { ++n_calls; });
  EXPECT_EQ(n_calls, 15);
}

INSTANTIATE_TEST_SUITE_P(AnyNumberOfThreads, ThreadPoolOf, testing::Values(0, 1, 2, 4));

}  // namespace
}  // namespace netwright
