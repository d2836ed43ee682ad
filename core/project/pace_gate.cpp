// Waiting for the next move. The clock here only spaces moves for the eyes, it never decides what is found.
#include "core/project/pace_gate.h"

#include <algorithm>
#include <cmath>

namespace netwright {

namespace {

/// A search that fell behind (a big model, a busy machine) catches up at most this much, rather than race.
constexpr std::chrono::milliseconds kMostCatchUp{50};

}  // namespace

Pace PaceGate::wait() {
  std::unique_lock lock(mutex_);
  while (!is_stopped_) {
    if (steps_ > 0) {
      --steps_;
      last_move_ = Clock::now();
      return Pace::Move;
    }
    if (is_paused_) {
      changed_.wait(lock);
      continue;
    }
    if (std::isinf(speed_)) return Pace::Full;
    const auto now = Clock::now();
    const auto due =
        last_move_ + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1 / speed_));
    if (due <= now) {
      last_move_ = std::max(due, now - kMostCatchUp);
      return Pace::Move;
    }
    changed_.wait_until(lock, due);
  }
  return Pace::Stop;
}

void PaceGate::pause() {
  const std::lock_guard lock(mutex_);
  is_paused_ = true;
  changed_.notify_all();
}

void PaceGate::resume() {
  const std::lock_guard lock(mutex_);
  is_paused_ = false;
  steps_ = 0;
  changed_.notify_all();
}

void PaceGate::step() {
  const std::lock_guard lock(mutex_);
  is_paused_ = true;
  ++steps_;
  changed_.notify_all();
}

void PaceGate::stop() {
  const std::lock_guard lock(mutex_);
  is_stopped_ = true;
  changed_.notify_all();
}

void PaceGate::set_speed(double moves_per_second) {
  const std::lock_guard lock(mutex_);
  speed_ = std::max(moves_per_second, kSlowest);
  changed_.notify_all();
}

}  // namespace netwright
