// A kept run has lost its chart and its moves; all else follows from its tree.
#include "core/project/kept_runs.h"

#include <algorithm>

#include "core/base/predicates.h"
#include "core/unfold/flat_net.h"
#include "core/unfold/verify.h"

namespace netwright {

namespace {

FinishedRun finished(const std::shared_ptr<const DualGraph>& dual, const KeptRun& kept) {
  FinishedRun run;
  run.dual = dual;
  run.tree = kept.tree;
  run.summary = kept.summary;
  const Net net = layout(dual, *kept.tree);
  run.overlaps = find_overlaps(net, kShownDepth);
  run.summary.overlaps = static_cast<int>(run.overlaps.size());
  run.summary.is_proved = kept.summary.is_proved &&
                          verify(to_flat_net(net, 1), static_cast<int>(dual->mesh().n_components())).is_net;
  run.measures = measure(net);
  run.picture = net_picture(net, kRunPictureWidth, kRunPictureHeight);
  RunFigures& figures = run.figures;
  figures.faces = static_cast<int>(dual->mesh().n_faces());
  figures.seed = run.summary.seed;
  figures.overlaps = figures.best_overlaps = run.summary.overlaps;
  figures.moves = run.summary.moves;
  figures.restarts = run.summary.restarts;
  figures.seconds = run.summary.seconds;
  if (figures.seconds > 0) figures.moves_per_second = static_cast<double>(figures.moves) / figures.seconds;
  return run;
}

}  // namespace

std::vector<KeptRun> runs_to_keep(const RunList& runs, const std::shared_ptr<const DualGraph>& dual) {
  std::vector<RunList::Entry> entries = runs.of(dual);
  if (entries.size() > kMostKeptRuns) {
    const auto better = [](const RunList::Entry& a, const RunList::Entry& b) { return is_better(*a, *b); };
    std::stable_sort(entries.begin(), entries.end(), better);
    entries.resize(kMostKeptRuns);
    std::ranges::sort(entries, {}, [](const RunList::Entry& entry) { return entry->number; });
  }
  std::vector<KeptRun> kept;
  for (const RunList::Entry& entry : entries) kept.push_back({entry->tree, entry->summary});
  return kept;
}

std::vector<FinishedRun> finished_again(const std::shared_ptr<const DualGraph>& dual,
                                        const std::vector<KeptRun>& kept, const Progress& progress) {
  std::vector<FinishedRun> runs;
  for (const KeptRun& run : kept) {
    if (progress.is_cancelled()) break;
    runs.push_back(finished(dual, run));
  }
  return runs;
}

}  // namespace netwright
