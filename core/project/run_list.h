// The finished runs of a session, kept so that one can look at them again, play them back, and take another
// one's net.
#pragma once

#include <memory>
#include <vector>

#include "core/base/image.h"
#include "core/project/net_measures.h"
#include "core/project/project.h"
#include "core/project/run_figures.h"
#include "core/project/run_log.h"

namespace netwright {

/// Pixels of a run's picture: sharp in the list at twice the usual scale.
inline constexpr int kRunPictureWidth = 156;
inline constexpr int kRunPictureHeight = 128;

struct FinishedRun {
  int number = 0;                         ///< counted from 1 since the file was opened
  std::shared_ptr<const DualGraph> dual;  ///< the mesh it unfolded
  std::shared_ptr<const UnfoldTree> tree;
  RunSummary summary;
  RunFigures figures;  ///< with the chart
  std::vector<Overlap> overlaps;
  NetMeasures measures;
  Image picture;                      ///< see net_picture()
  std::shared_ptr<const RunLog> log;  ///< null when its moves are kept no more
  /// 0 … 100: how much of its smallest rectangle the net fills. Compact nets print larger on the same page.
  [[nodiscard]] int score() const;
};

/// Is `a` the better result? Proved before unproved, then fewer overlaps, fewer pieces, the higher fill.
bool is_better(const FinishedRun& a, const FinishedRun& b);

/// Bounded: the last kMostRuns runs, and the moves of the last ones up to kMostLogBytes in all (those of the
/// very last run always). The best run of a mesh outlives older ones, without its moves where need be.
class RunList {
 public:
  static constexpr std::size_t kMostRuns = 50;
  static constexpr std::size_t kMostLogBytes = 128U << 20U;
  using Entry = std::shared_ptr<const FinishedRun>;

  explicit RunList(std::size_t most_log_bytes = kMostLogBytes) : most_log_bytes_(most_log_bytes) {}

  /// Takes a run in and numbers it; one with the same seed and tree as another one of its mesh takes that
  /// one's place and number.
  Entry add(FinishedRun run);
  void erase(int number);
  /// Forgets the runs of meshes that are not wanted any more.
  template <class Wanted>
  void keep(const Wanted& is_wanted) {
    std::erase_if(runs_, [&](const Entry& run) { return !is_wanted(run->dual); });
  }
  void clear();

  [[nodiscard]] Entry find(int number) const;  ///< null when there is none
  /// Those of one mesh, oldest first.
  [[nodiscard]] std::vector<Entry> of(const std::shared_ptr<const DualGraph>& dual) const;
  [[nodiscard]] Entry best_of(const std::shared_ptr<const DualGraph>& dual) const;  ///< null without runs

 private:
  void drop_one();
  void shed_logs();

  std::vector<Entry> runs_;  ///< oldest first
  std::size_t most_log_bytes_;
  int n_numbers_ = 0;
};

}  // namespace netwright
