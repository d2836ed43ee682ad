// Finding one's way in a log: positions count pictures over all episodes.
#include "core/project/run_log.h"

#include <algorithm>
#include <cassert>

namespace netwright {

namespace {

/// A run of more moves than this cannot be followed in two seconds: its last episode tells the story.
constexpr std::size_t kMostMoves = 600;

}  // namespace

RunLog::RunLog(SolveResult& result)
    : dual_(result.net.dual),
      log_(std::make_shared<const std::vector<Episode>>(std::move(result.log))),
      roots_(result.net.tree.roots()),
      restarts_(result.restarts),
      moves_before_(result.moves) {
  assert(!log_->empty());
  index();
  moves_before_ -= n_moves();
}

RunLog::RunLog(const RunLog& whole, Extent extent) : RunLog(whole) {
  if (extent == Extent::Whole || static_cast<std::size_t>(n_moves()) <= kMostMoves) return;
  moves_before_ += n_moves();
  first_episode_ = static_cast<std::size_t>(n_searched()) - 1;
  index();
  moves_before_ -= n_moves();
}

void RunLog::index() {
  begins_.clear();
  fewest_.clear();
  n_steps_ = 0;
  for (std::size_t e = first_episode_; e < log_->size(); ++e) {
    const Episode& episode = (*log_)[e];
    begins_.push_back(n_steps_);
    n_steps_ += 1 + static_cast<int>(episode.moves.size());
    const int before = fewest_.empty() ? episode.overlaps_at_start : fewest_.back();
    fewest_.push_back(std::min(before, episode.overlaps_at_start));
    for (const MoveRecord& move : episode.moves)
      fewest_.push_back(std::min(fewest_.back(), move.overlaps_after));
  }
}

std::size_t RunLog::bytes() const {
  std::size_t bytes = fewest_.size() * sizeof(int);
  for (const Episode& episode : *log_)
    bytes += episode.moves.size() * sizeof(MoveRecord) + episode.start.n_faces() * sizeof(HalfedgeId);
  return bytes;
}

int RunLog::episode_at(int position) const {
  return static_cast<int>(std::upper_bound(begins_.begin(), begins_.end(), position) - begins_.begin()) - 1;
}

std::optional<MoveRecord> RunLog::move(int position) const {
  const int number = episode_at(position);
  const int at = position - begin_of(number);
  if (at == 0) return std::nullopt;
  return episode(number).moves[static_cast<std::size_t>(at) - 1];
}

int RunLog::overlaps(int position) const {
  const std::optional<MoveRecord> last = move(position);
  return last ? last->overlaps_after : episode(episode_at(position)).overlaps_at_start;
}

int RunLog::fewest_overlaps(int position) const { return fewest_[static_cast<std::size_t>(position)]; }

std::int64_t RunLog::moves(int position) const { return moves_before_ + position - episode_at(position); }

int RunLog::restarts(int position) const {
  // A model of several parts has an episode more for each of them: those are no restarts.
  return std::max(0, restarts_ - std::max(0, n_searched() - 1 - episode_at(position)));
}

int RunLog::n_searched() const {
  const auto is_polish = [](const Episode& episode) { return episode.is_polish; };
  return n_episodes() - static_cast<int>(std::count_if(log_->begin(), log_->end(), is_polish));
}

double RunLog::polish_fraction(int position) const {
  const Episode& last = episode(episode_at(position));
  return last.is_polish ? last.polish_fraction : -1;
}

int RunLog::n_searched_steps() const {
  return n_searched() == n_episodes() ? n_steps_ : begin_of(n_searched());
}

int RunLog::best_position() const {
  if (log_->back().is_polish) return n_steps_ - 1;
  const auto first = std::lower_bound(fewest_.begin(), fewest_.end(), fewest_.back(), std::greater<>());
  return static_cast<int>(first - fewest_.begin());
}

std::vector<int> RunLog::history(std::size_t most, std::int64_t& stride) const {
  const auto n_values = static_cast<std::size_t>(n_moves()) + 1;
  const std::size_t step = (n_values + most - 1) / most;
  stride = static_cast<std::int64_t>(step);
  std::vector<int> history;
  std::size_t i = 0;
  int last = episode(0).overlaps_at_start;
  const auto take = [&](int overlaps) {
    last = overlaps;
    if (i++ % step == 0) history.push_back(overlaps);
  };
  take(last);
  for (int e = 0; e < n_episodes(); ++e)
    for (const MoveRecord& move : episode(e).moves) take(move.overlaps_after);
  if ((n_values - 1) % step != 0) history.push_back(last);
  return history;
}

}  // namespace netwright
