// Plays the recorded moves of a run that was over too fast to be seen: start trees and exchanges of hinges,
// one step after the other, as fast as its watcher asks.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/solve/solve.h"

namespace netwright {

class Replay {
 public:
  /// The result's log must hold an episode; it leads to the folds of the result's tree, whose roots the
  /// pictures are laid out from. Everything is played when it is short enough to be followed, else the last
  /// episode alone.
  explicit Replay(const SolveResult& result);

  /// Pictures there are: each episode's start and every move after it.
  [[nodiscard]] int n_steps() const { return n_steps_; }
  [[nodiscard]] int position() const { return position_; }
  /// How long it should take to be pleasant, at most kLongest seconds.
  [[nodiscard]] double seconds() const;
  static constexpr double kLongest = 2;

  /// Plays up to this picture, 0 … n_steps() - 1; never back.
  void advance_to(int position);

  // All of the moment reached.
  [[nodiscard]] Net net() const;
  [[nodiscard]] int overlaps() const;
  [[nodiscard]] int overlaps_at_start() const { return log_.front().overlaps_at_start; }
  [[nodiscard]] int best_overlaps() const { return best_; }
  [[nodiscard]] std::int64_t moves() const { return moves_; }
  [[nodiscard]] int restarts() const;
  [[nodiscard]] std::optional<MoveRecord> last_move() const;
  [[nodiscard]] const std::vector<int>& history() const { return history_; }

 private:
  void begin_episode();
  void play_move();

  std::shared_ptr<const DualGraph> dual_;
  std::vector<Episode> log_;
  std::vector<FaceId> roots_;
  IdVector<EdgeId, char> is_fold_;
  std::vector<int> history_;
  std::size_t episode_ = 0;
  std::size_t next_move_ = 0;
  int last_restart_;    ///< the number of the last episode
  std::int64_t moves_;  ///< made up to now, since the run began
  int n_steps_ = 0;
  int position_ = 0;
  int best_ = 0;
};

}  // namespace netwright
