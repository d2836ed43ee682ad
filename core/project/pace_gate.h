// The gate that a watched search passes before each move that is shown: open at full speed, closed while
// paused, opened for one move by a step, and at any other speed opened when the next move is due.
#pragma once

#include <chrono>
#include <condition_variable>
#include <limits>
#include <mutex>

#include "core/solve/solve.h"

namespace netwright {

class PaceGate {
 public:
  /// Called by the search on its own thread; blocks until the next move may be shown.
  Pace wait();

  // All others are called by whoever watches; each takes effect at once, also on a search that waits.
  void pause();
  void resume();
  void step();  ///< lets one more move through, then holds
  void stop();  ///< lets the search go for good: it was cancelled
  /// Moves a second; infinity = don't wait. At least kSlowest.
  void set_speed(double moves_per_second);

  static constexpr double kSlowest = 0.1;

 private:
  using Clock = std::chrono::steady_clock;

  std::mutex mutex_;
  std::condition_variable changed_;
  bool is_paused_ = false;
  bool is_stopped_ = false;
  int steps_ = 0;
  double speed_ = std::numeric_limits<double>::infinity();
  Clock::time_point last_move_;  ///< when the last move was due; the clock's epoch before the first
};

}  // namespace netwright
