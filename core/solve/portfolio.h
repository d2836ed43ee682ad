// Several independent searches ("streams") of one component. Streams advance in rounds to common iteration
// marks; the one that was solved at the fewest iterations wins, the lowest number among equals. So the answer
// depends on the seed and the number of streams, never on how many threads ran them or which was faster.
#pragma once

#include <memory>
#include <vector>

#include "core/base/progress.h"
#include "core/base/worker.h"
#include "core/solve/tabu_solver.h"

namespace netwright {

class Portfolio {
 public:
  /// `progress` cancels the start trees and later rounds alike; it must outlive the portfolio. `from` as
  /// TabuSolver has it.
  Portfolio(const DualGraph& dual, const SearchModel& model, const SearchSettings& settings,
            std::uint64_t seed, int n_streams, std::uint64_t first_stream, ThreadPool& pool,
            const Progress& progress, const std::vector<char>& from = {});

  /// Takes every stream to the next mark, or until it is solved, cannot win any more, is cancelled, or is at
  /// max_iterations (0 = no limit).
  void advance(std::int64_t max_iterations);

  /// Once solved: brings the winner back to `from` as far as that goes without overlaps.
  void return_home();

  [[nodiscard]] bool is_solved() const { return winner_ >= 0; }
  /// The stream to look at: the winner, else the one with the fewest overlaps now.
  [[nodiscard]] int lead() const;
  /// The stream that has had the fewest overlaps so far.
  [[nodiscard]] int best() const;
  [[nodiscard]] const TabuSolver& stream(int k) const { return *streams_[static_cast<std::size_t>(k)]; }
  [[nodiscard]] int n_streams() const { return static_cast<int>(streams_.size()); }
  [[nodiscard]] std::int64_t mark() const { return mark_; }
  [[nodiscard]] double cpu_seconds() const;

 private:
  void find_winner();

  ThreadPool* pool_;
  const Progress* progress_;
  std::vector<std::unique_ptr<TabuSolver>> streams_;
  std::vector<double> cpu_seconds_;
  std::int64_t mark_ = 0;
  std::int64_t longest_round_;
  int winner_ = -1;
};

}  // namespace netwright
