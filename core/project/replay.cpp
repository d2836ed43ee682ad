// A replay keeps only the set of folds, since a move is an exchange of two hinges whatever the root, and
// taking it back is the same exchange the other way; trees are made of it for the moments that are drawn.
#include "core/project/replay.h"

#include <algorithm>

#include "core/project/shown_net.h"

namespace netwright {

namespace {

constexpr double kMovesPerSecond = 30;
constexpr double kShortest = 0.4;  ///< seconds; less is a flicker

}  // namespace

Replay::Replay(std::shared_ptr<const RunLog> log) : log_(std::move(log)) { begin_episode(0); }

double Replay::seconds() const { return std::clamp(log_->n_steps() / kMovesPerSecond, kShortest, kLongest); }

void Replay::begin_episode(int number) {
  const Mesh& mesh = log_->dual()->mesh();
  const UnfoldTree& start = log_->episode(number).start;
  is_fold_.assign(mesh.n_edges(), 0);
  for (const FaceId f : mesh.faces())
    if (!start.is_root(f)) is_fold_[mesh.edge(start.to_parent(f))] = 1;
  episode_ = number;
  position_ = log_->begin_of(number);
}

void Replay::exchange(const HalfedgeId& from, const HalfedgeId& to) {
  const Mesh& mesh = log_->dual()->mesh();
  is_fold_[mesh.edge(from)] = 0;
  is_fold_[mesh.edge(to)] = 1;
}

void Replay::seek(int position) {
  const int goal = std::clamp(position, 0, log_->n_steps() - 1);
  const int episode = log_->episode_at(goal);
  const int begin = log_->begin_of(episode);
  const bool is_nearer_from_start = goal < position_ && goal - begin < position_ - goal;
  if (episode != episode_ || is_nearer_from_start) begin_episode(episode);
  const std::vector<MoveRecord>& moves = log_->episode(episode).moves;
  for (; position_ < goal; ++position_) {
    const MoveRecord& move = moves[static_cast<std::size_t>(position_ - begin)];
    exchange(move.removed, move.inserted);
  }
  for (; position_ > goal; --position_) {
    const MoveRecord& move = moves[static_cast<std::size_t>(position_ - begin) - 1];
    exchange(move.inserted, move.removed);
  }
}

Net Replay::net() const {
  return layout_from(log_->dual(), tree_from_folds(log_->dual()->mesh(), is_fold_), log_->roots());
}

}  // namespace netwright
