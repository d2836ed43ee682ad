// The recorded moves of a finished run, with what can be told of every moment without laying out a net. Never
// changes, so that replays on any thread may share it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/solve/solve.h"

namespace netwright {

class RunLog {
 public:
  /// Which part of a run.
  enum class Extent {
    Whole,
    Followable,  ///< everything when it is short enough to be followed in two seconds, else the last episode
  };

  /// Takes the result's log over; it must hold an episode.
  explicit RunLog(SolveResult& result);
  /// Without a copy, the part of a log that can be followed.
  RunLog(const RunLog& whole, Extent extent);

  /// Pictures there are: each episode's start and every move after it, at last the nets that polish reached.
  [[nodiscard]] int n_steps() const { return n_steps_; }
  /// Moves in all pictures.
  [[nodiscard]] std::int64_t n_moves() const { return n_steps_ - n_episodes(); }
  [[nodiscard]] std::size_t bytes() const;

  // Of the picture at a position, 0 … n_steps() - 1.
  [[nodiscard]] int overlaps(int position) const;
  [[nodiscard]] int fewest_overlaps(int position) const;  ///< up to there
  [[nodiscard]] std::int64_t moves(int position) const;   ///< made up to there, since the run began
  [[nodiscard]] int restarts(int position) const;
  /// The move that led there; none at an episode's start.
  [[nodiscard]] std::optional<MoveRecord> move(int position) const;
  /// How far polish was, see PolishStation; -1 before it.
  [[nodiscard]] double polish_fraction(int position) const;
  /// Pictures before polish.
  [[nodiscard]] int n_searched_steps() const;
  /// The first picture with the fewest overlaps of all; the last one, when that is a polished net.
  [[nodiscard]] int best_position() const;

  /// Overlaps over moves for the chart, thinned to about `most` values; `stride` moves lie between two.
  [[nodiscard]] std::vector<int> history(std::size_t most, std::int64_t& stride) const;

  // For those who play it.
  [[nodiscard]] const std::shared_ptr<const DualGraph>& dual() const { return dual_; }
  [[nodiscard]] const std::vector<FaceId>& roots() const { return roots_; }  ///< of the result's net
  [[nodiscard]] int episode_at(int position) const;
  [[nodiscard]] int begin_of(int episode) const { return begins_[static_cast<std::size_t>(episode)]; }
  [[nodiscard]] const Episode& episode(int number) const {
    return (*log_)[first_episode_ + static_cast<std::size_t>(number)];
  }

 private:
  [[nodiscard]] int n_searched() const;  ///< episodes that are not of polish
  [[nodiscard]] int n_episodes() const { return static_cast<int>(begins_.size()); }
  void index();

  std::shared_ptr<const DualGraph> dual_;
  std::shared_ptr<const std::vector<Episode>> log_;
  std::size_t first_episode_ = 0;
  std::vector<FaceId> roots_;
  std::vector<int> begins_;  ///< position of each episode's start
  std::vector<int> fewest_;  ///< by position
  int n_steps_ = 0;
  int restarts_ = 0;               ///< of the whole run
  std::int64_t moves_before_ = 0;  ///< of the first picture
};

}  // namespace netwright
