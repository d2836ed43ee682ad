// How long work reports where it is and learns that it should stop. One object is shared by the one who
// waits and the one who works; every member may be called from any thread.
#pragma once

#include <atomic>
#include <mutex>
#include <string>

namespace netwright {

class Progress {
 public:
  /// Asks the work to end at its next step. Sticky; cancelling is not an error.
  void cancel() noexcept { cancelled_.store(true, std::memory_order_relaxed); }
  [[nodiscard]] bool is_cancelled() const noexcept { return cancelled_.load(std::memory_order_relaxed); }

  /// Share of the present phase that is done, 0…1 (clamped).
  void set_fraction(double fraction) noexcept {
    fraction_.store(fraction < 0 ? 0 : (fraction > 1 ? 1 : fraction), std::memory_order_relaxed);
  }
  [[nodiscard]] double fraction() const noexcept { return fraction_.load(std::memory_order_relaxed); }

  /// What is being done, for people ("reading bunny.obj"); starts a new fraction at 0.
  void set_phase(std::string phase) {
    const std::lock_guard lock(mutex_);
    phase_ = std::move(phase);
    set_fraction(0);
  }
  [[nodiscard]] std::string phase() const {
    const std::lock_guard lock(mutex_);
    return phase_;
  }

 private:
  std::atomic<bool> cancelled_{false};
  std::atomic<double> fraction_{0};
  mutable std::mutex mutex_;
  std::string phase_;
};

}  // namespace netwright
