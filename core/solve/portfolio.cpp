// Rounds and marks. Rounds are short at first, so that easy models cost little, and stay short enough to be
// watched.
#include "core/solve/portfolio.h"

#include <algorithm>
#include <atomic>
#include <numeric>

#include "core/base/cpu_time.h"

namespace netwright {

namespace {

constexpr std::int64_t kFirstRound = 256;

}  // namespace

Portfolio::Portfolio(const DualGraph& dual, const SearchModel& model, const SearchSettings& settings,
                     std::uint64_t seed, int n_streams, std::uint64_t first_stream, ThreadPool& pool,
                     const Progress& progress, const std::vector<char>& from)
    : pool_(&pool),
      progress_(&progress),
      streams_(static_cast<std::size_t>(std::max(1, n_streams))),
      cpu_seconds_(streams_.size(), 0),
      longest_round_(std::clamp<std::int64_t>(200'000 / model.n_faces, kFirstRound, 1024)) {
  pool.run(this->n_streams(), [&](int k) {
    const double before = thread_cpu_seconds();
    const auto i = static_cast<std::size_t>(k);
    streams_[i] =
        std::make_unique<TabuSolver>(dual, model, settings, seed, first_stream + i, &progress, from);
    cpu_seconds_[i] += thread_cpu_seconds() - before;
  });
  find_winner();
}

void Portfolio::advance(std::int64_t max_iterations) {
  mark_ += std::clamp<std::int64_t>(mark_, kFirstRound, longest_round_);
  if (max_iterations > 0) mark_ = std::min(mark_, max_iterations);
  // Once a stream is solved, the others can win only by being solved at fewer iterations: no need to go on to
  // the mark. Which of them was told in time changes nothing about the winner.
  std::atomic<std::int64_t> end = mark_;
  pool_->run(n_streams(), [&](int k) {
    const double before = thread_cpu_seconds();
    TabuSolver& solver = *streams_[static_cast<std::size_t>(k)];
    while (!solver.is_solved() && solver.iterations() < end.load(std::memory_order_relaxed) &&
           !progress_->is_cancelled())
      solver.step();
    if (solver.is_solved()) {
      std::int64_t known = end.load();
      while (solver.iterations() < known && !end.compare_exchange_weak(known, solver.iterations())) {
      }
    }
    cpu_seconds_[static_cast<std::size_t>(k)] += thread_cpu_seconds() - before;
  });
  find_winner();
}

void Portfolio::return_home() {
  if (!is_solved()) return;
  const double before = thread_cpu_seconds();
  streams_[static_cast<std::size_t>(winner_)]->return_home();
  cpu_seconds_[static_cast<std::size_t>(winner_)] += thread_cpu_seconds() - before;
}

void Portfolio::find_winner() {
  for (int k = 0; k < n_streams(); ++k) {
    const bool is_better = winner_ < 0 || stream(k).iterations() < stream(winner_).iterations();
    if (stream(k).is_solved() && is_better) winner_ = k;
  }
}

int Portfolio::lead() const {
  if (winner_ >= 0) return winner_;
  int lead = 0;
  for (int k = 1; k < n_streams(); ++k)
    if (stream(k).state().overlaps() < stream(lead).state().overlaps()) lead = k;
  return lead;
}

int Portfolio::best() const {
  if (winner_ >= 0) return winner_;
  int best = 0;
  for (int k = 1; k < n_streams(); ++k)
    if (stream(k).best_overlaps() < stream(best).best_overlaps()) best = k;
  return best;
}

double Portfolio::cpu_seconds() const {
  return std::accumulate(cpu_seconds_.begin(), cpu_seconds_.end(), 0.0);
}

}  // namespace netwright
