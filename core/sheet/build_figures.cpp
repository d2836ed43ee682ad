// Counts what there is to cut, fold and glue, and guesses how long that takes.
#include <algorithm>

#include "core/sheet/draw.h"
#include "core/sheet/instructions.h"

namespace netwright {

namespace {

constexpr double kSecondsPerHour = 3600;

void count_edges(BuildFigures& figures, const Net& net, const PageLayout& layout,
                 const SheetSettings& settings) {
  const IdVector<EdgeId, EdgeKind> kinds = drawn_kinds(net, settings);
  std::vector<double> cuts;
  for (const EdgeId e : net.mesh().edges()) {
    const double length_mm = net.mesh().length(e) * layout.scale;
    if (kinds[e] == EdgeKind::Mountain) ++figures.n_mountains;
    if (kinds[e] == EdgeKind::Valley) ++figures.n_valleys;
    if (kinds[e] == EdgeKind::Mountain || kinds[e] == EdgeKind::Valley) figures.fold_mm += length_mm;
    if (kinds[e] == EdgeKind::Cut) cuts.push_back(length_mm);
  }
  figures.n_cuts = static_cast<int>(cuts.size());
  if (cuts.empty()) return;
  std::ranges::sort(cuts);
  for (const double length_mm : cuts) figures.cut_mm += length_mm;
  figures.shortest_cut_mm = cuts.front();
  figures.tenth_cut_mm = cuts[cuts.size() / 10];
}

void measure_outlines(BuildFigures& figures, const Net& net, const PageLayout& layout,
                      const SheetSettings& settings) {
  for (const NetLines::Outline& outline : net_lines(net, layout, settings).outlines) {
    const std::size_t n = outline.points.size();
    figures.n_corners += static_cast<int>(n);
    for (std::size_t i = 0; i < n; ++i)
      figures.outline_mm += glm::length(outline.points[(i + 1) % n] - outline.points[i]);
  }
}

}  // namespace

BuildFigures build_figures(const Net& net, const PageLayout& layout, const SheetSettings& settings) {
  BuildFigures figures;
  count_edges(figures, net, layout, settings);
  measure_outlines(figures, net, layout, settings);
  figures.n_tabs = static_cast<int>(layout.tabs.tabs.size());
  figures.n_sheets = static_cast<int>(layout.pages.size());
  figures.cutting_h = (4 * figures.n_corners + figures.outline_mm / 10) / kSecondsPerHour;
  figures.folding_h =
      (6 * (figures.n_mountains + figures.n_valleys + figures.n_tabs) + figures.fold_mm / 20) /
      kSecondsPerHour;
  figures.gluing_h = (45 * figures.n_cuts + figures.cut_mm / 4) / kSecondsPerHour;
  for (const bool is_harder : {figures.n_cuts > 30, figures.n_cuts > 120,
                               figures.n_cuts > 0 && figures.tenth_cut_mm<6, figures.hours()> 10})
    figures.difficulty += is_harder ? 1 : 0;
  return figures;
}

const char* paper_weight(const BuildFigures& figures, double model_height_mm) {
  if (figures.n_cuts > 0 && figures.tenth_cut_mm < 8) return "120 to 160";
  return model_height_mm > 300 ? "200 to 300" : "160 to 200";
}

}  // namespace netwright
