// A replay keeps only the set of folds, since a move is an exchange of two hinges whatever the root; trees
// are made of it for the moments that are drawn.
#include "core/project/replay.h"

#include <algorithm>
#include <cassert>

#include "core/project/shown_net.h"

namespace netwright {

namespace {

/// A run of more moves than this cannot be followed in two seconds: its last episode tells the story.
constexpr std::size_t kMostMoves = 600;

constexpr double kMovesPerSecond = 30;
constexpr double kShortest = 0.4;  ///< seconds; less is a flicker

}  // namespace

Replay::Replay(const SolveResult& result)
    : dual_(result.net.dual),
      log_(result.log),
      roots_(result.net.tree.roots()),
      last_restart_(result.restarts),
      moves_(result.moves) {
  assert(!log_.empty());
  std::size_t n_moves = 0;
  for (const Episode& episode : log_) n_moves += episode.moves.size();
  if (n_moves > kMostMoves) {
    log_.erase(log_.begin(), log_.end() - 1);
    n_moves = log_.front().moves.size();
  }
  moves_ -= static_cast<std::int64_t>(n_moves);
  n_steps_ = static_cast<int>(n_moves + log_.size());
  best_ = log_.front().overlaps_at_start;
  begin_episode();
}

double Replay::seconds() const { return std::clamp(n_steps_ / kMovesPerSecond, kShortest, kLongest); }

void Replay::begin_episode() {
  const Mesh& mesh = dual_->mesh();
  const Episode& episode = log_[episode_];
  is_fold_.assign(mesh.n_edges(), 0);
  for (const FaceId f : mesh.faces())
    if (!episode.start.is_root(f)) is_fold_[mesh.edge(episode.start.to_parent(f))] = 1;
  next_move_ = 0;
  best_ = std::min(best_, episode.overlaps_at_start);
  history_.push_back(episode.overlaps_at_start);
}

void Replay::play_move() {
  const MoveRecord& move = log_[episode_].moves[next_move_++];
  is_fold_[dual_->mesh().edge(move.removed)] = 0;
  is_fold_[dual_->mesh().edge(move.inserted)] = 1;
  best_ = std::min(best_, move.overlaps_after);
  history_.push_back(move.overlaps_after);
  ++moves_;
}

void Replay::advance_to(int position) {
  const int goal = std::min(position, n_steps_ - 1);
  for (; position_ < goal; ++position_) {
    if (next_move_ < log_[episode_].moves.size()) {
      play_move();
    } else {
      ++episode_;
      begin_episode();
    }
  }
}

Net Replay::net() const { return layout_from(dual_, tree_from_folds(dual_->mesh(), is_fold_), roots_); }

int Replay::restarts() const {
  // A model of several parts has an episode more for each of them: those are no restarts.
  return std::max(0, last_restart_ - static_cast<int>(log_.size() - 1 - episode_));
}

int Replay::overlaps() const {
  const Episode& episode = log_[episode_];
  return next_move_ == 0 ? episode.overlaps_at_start : episode.moves[next_move_ - 1].overlaps_after;
}

std::optional<MoveRecord> Replay::last_move() const {
  if (next_move_ == 0) return std::nullopt;
  return log_[episode_].moves[next_move_ - 1];
}

}  // namespace netwright
