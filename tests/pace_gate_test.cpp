// The gate between a watched search and its watcher: every change takes effect on a search that waits.
#include "core/project/pace_gate.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

namespace netwright {
namespace {

/// A search that passes the gate again and again until it is told to stop.
class Walker {
 public:
  explicit Walker(PaceGate& gate) : gate_(gate), thread_([this] { walk(); }) {}
  ~Walker() { gate_.stop(); }

  [[nodiscard]] int n_moves() const { return n_moves_; }
  void wait_for_moves(int n) const {
    while (n_moves_ < n) std::this_thread::yield();
  }
  void wait_for_full_speed() const {
    const int before = n_full_;
    while (n_full_ <= before) std::this_thread::yield();
  }
  void join() { thread_.join(); }

 private:
  void walk() {
    for (Pace pace = gate_.wait(); pace != Pace::Stop; pace = gate_.wait()) {
      if (pace == Pace::Move) ++n_moves_;
      if (pace == Pace::Full) ++n_full_;
    }
  }
  PaceGate& gate_;
  std::atomic<int> n_moves_{0};
  std::atomic<int> n_full_{0};
  std::jthread thread_;
};

TEST(PaceGate, IsOpenAtFullSpeed) {
  PaceGate gate;
  EXPECT_EQ(gate.wait(), Pace::Full);
  EXPECT_EQ(gate.wait(), Pace::Full);
}

TEST(PaceGate, LetsExactlyTheStepsThroughWhilePaused) {
  PaceGate gate;
  gate.pause();
  Walker walker(gate);
  for (int i = 1; i <= 20; ++i) {
    gate.step();
    walker.wait_for_moves(i);
  }
  gate.stop();
  walker.join();
  EXPECT_EQ(walker.n_moves(), 20);
}

TEST(PaceGate, StepsWhereTheSearchHasNotCalledYetAreKept) {
  PaceGate gate;
  gate.step();
  gate.step();
  EXPECT_EQ(gate.wait(), Pace::Move);
  EXPECT_EQ(gate.wait(), Pace::Move);
}

TEST(PaceGate, ResumesAtFullSpeed) {
  PaceGate gate;
  gate.pause();
  Walker walker(gate);
  gate.step();
  walker.wait_for_moves(1);
  gate.resume();
  walker.wait_for_full_speed();
  EXPECT_EQ(walker.n_moves(), 1);
}

TEST(PaceGate, PausesARunningSearch) {
  PaceGate gate;
  Walker walker(gate);
  walker.wait_for_full_speed();
  gate.pause();
  gate.step();
  walker.wait_for_moves(1);
  gate.step();
  walker.wait_for_moves(2);
}

TEST(PaceGate, LetsASearchGoThatWaitsForItsNextMove) {
  PaceGate gate;
  gate.set_speed(PaceGate::kSlowest);
  Walker walker(gate);
  walker.wait_for_moves(1);
  gate.stop();
  walker.join();
  EXPECT_EQ(walker.n_moves(), 1);
  EXPECT_EQ(gate.wait(), Pace::Stop);
}

TEST(PaceGate, TakesANewSpeedAtOnce) {
  PaceGate gate;
  gate.set_speed(PaceGate::kSlowest);
  Walker walker(gate);
  walker.wait_for_moves(1);
  gate.set_speed(1e6);
  walker.wait_for_moves(100);
  gate.set_speed(std::numeric_limits<double>::infinity());
  walker.wait_for_full_speed();
}

TEST(PaceGate, NeverWaitsLongerThanItsSlowestSpeed) {
  PaceGate gate;
  gate.set_speed(0);
  EXPECT_EQ(gate.wait(), Pace::Move);
  Walker walker(gate);
  gate.set_speed(1e6);
  walker.wait_for_moves(3);
}

}  // namespace
}  // namespace netwright
