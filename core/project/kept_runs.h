// Finished runs as a project's file keeps them: trees and figures, without moves. What else the list of runs
// shows of them is worked out again when the file is opened.
#pragma once

#include <memory>
#include <vector>

#include "core/base/progress.h"
#include "core/project/project.h"
#include "core/project/run_list.h"

namespace netwright {

struct KeptRun {
  std::shared_ptr<const UnfoldTree> tree;
  RunSummary summary;
};

/// How many a file keeps, and how many it may bring along.
inline constexpr std::size_t kMostKeptRuns = 20;

/// The best runs of a mesh, oldest first.
std::vector<KeptRun> runs_to_keep(const RunList& runs, const std::shared_ptr<const DualGraph>& dual);

/// Runs for the list: nets that are said to be proved are proved again. Milliseconds for hundreds of faces
/// each; what is not done when `progress` is cancelled is left out.
std::vector<FinishedRun> finished_again(const std::shared_ptr<const DualGraph>& dual,
                                        const std::vector<KeptRun>& kept, const Progress& progress);

}  // namespace netwright
