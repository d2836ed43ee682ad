// A page's place follows from the layout that drew it, so that pointing at the printed net finds the faces
// that lie there.
#include "ui/printed.h"

#include <algorithm>
#include <limits>

#include "ui/desk.h"

namespace netwright {
namespace {

constexpr double kGapMm = 15;        ///< between a front and its back, and before what stands at the right
constexpr double kSpreadGapMm = 40;  ///< above and between the spread sheets of tiled canvases

/// A tile shows the part of the canvas that it prints.
std::optional<Box2> clip_of(const PageLayout& layout, const PageLayout::Page& page) {
  if (!layout.canvases[static_cast<std::size_t>(page.canvas)].is_tiled()) return std::nullopt;
  const glm::dvec2 left(canvas_left(layout, page.canvas), 0);
  const glm::dvec2 from = page.shown.min + left;
  const glm::dvec2 to = page.shown.max + left;
  Box2 box;
  box.add(glm::dvec2(from.x, -from.y) / layout.scale);
  box.add(glm::dvec2(to.x, -to.y) / layout.scale);
  return box;
}

/// How many sheets each row of each canvas has.
std::vector<std::vector<int>> sheets_in_rows(const PageLayout& layout) {
  std::vector<std::vector<int>> rows(layout.canvases.size());
  for (const PageLayout::Page& page : layout.pages) {
    std::vector<int>& of_canvas = rows[static_cast<std::size_t>(page.canvas)];
    of_canvas.resize(std::max(of_canvas.size(), static_cast<std::size_t>(page.row) + 1), 0);
    ++of_canvas[static_cast<std::size_t>(page.row)];
  }
  return rows;
}

}  // namespace

std::vector<PlacedSheet> place_sheets(const std::vector<Sheet>& sheets, const PageLayout& layout,
                                      PrintedSide printed_side) {
  std::vector<PlacedSheet> placed;
  std::size_t n_fronts = 0;
  double right = canvas_left(layout, static_cast<int>(layout.canvases.size()));
  const bool is_mirrored = printed_side == PrintedSide::Inside;
  for (const Sheet& sheet : sheets) {
    const bool is_front = !sheet.is_back || is_mirrored;
    const std::size_t at = is_front ? n_fronts++ : n_fronts - 1;
    if (at >= layout.pages.size()) {
      if (!is_front) continue;
      placed.push_back({&sheet, glm::dvec2(right, 0) - layout.frame.net.min, std::nullopt, true});
      right += sheet.width_mm + kGapMm;
      continue;
    }
    const PageLayout::Page& page = layout.pages[at];
    glm::dvec2 corner = page.origin - layout.frame.net.min + glm::dvec2(canvas_left(layout, page.canvas), 0);
    const std::optional<Box2> clip = clip_of(layout, page);
    // What is mirrored lies elsewhere than the net it shows.
    const bool stands_apart = !is_front || is_mirrored;
    if (stands_apart && clip) continue;
    if (stands_apart) corner.y += sheet.height_mm + kGapMm;
    placed.push_back({&sheet, corner, clip, stands_apart});
  }
  return placed;
}

std::vector<PlacedSheet> spread_tiles(const std::vector<Sheet>& sheets, const PageLayout& layout,
                                      PrintedSide printed_side, const std::vector<PlacedSheet>& above) {
  const double width = layout.frame.width_mm + kGapMm;
  const double height = layout.frame.height_mm + kGapMm;
  double top = 0;
  for (const PageLayout::Canvas& canvas : layout.canvases) top = std::max(top, canvas.height_mm);
  for (const PlacedSheet& sheet : above)
    if (!sheet.clip) top = std::max(top, sheet.corner_mm.y + sheet.sheet->height_mm);
  const std::vector<std::vector<int>> rows = sheets_in_rows(layout);
  // The longest row below the middle of its canvas, but none over the canvas before; the others amid it.
  std::vector<double> middles;
  double free = std::numeric_limits<double>::lowest();
  for (std::size_t i = 0; i < layout.canvases.size(); ++i) {
    const int longest = rows[i].empty() ? 1 : *std::max_element(rows[i].begin(), rows[i].end());
    const double all = longest * width - kGapMm;
    const double below = canvas_left(layout, static_cast<int>(i)) + layout.canvases[i].width_mm / 2;
    middles.push_back(std::max(free + all / 2, below));
    if (layout.canvases[i].is_tiled()) free = middles.back() + all / 2 + kSpreadGapMm;
  }
  std::vector<PlacedSheet> spread;
  const std::size_t n_sides = sheets.size() / std::max<std::size_t>(layout.pages.size(), 1);
  for (std::size_t i = 0; i < layout.pages.size() * n_sides; ++i) {
    const PageLayout::Page& page = layout.pages[i / n_sides];
    const auto canvas = static_cast<std::size_t>(page.canvas);
    if (!layout.canvases[canvas].is_tiled()) continue;
    const auto row = static_cast<std::size_t>(page.row) + (i % n_sides) * rows[canvas].size();
    const int n_in_row = rows[canvas][static_cast<std::size_t>(page.row)];
    const bool is_mirrored = sheets[i].is_back || printed_side == PrintedSide::Inside;
    const int column = is_mirrored ? n_in_row - 1 - page.column : page.column;
    const double left = middles[canvas] - (n_in_row * width - kGapMm) / 2;
    const glm::dvec2 corner(left + column * width, top + kSpreadGapMm + static_cast<double>(row) * height);
    spread.push_back({&sheets[i], corner, std::nullopt, true});
  }
  return spread;
}

PlacedSheet place_beside(const Sheet& page, bool is_before, const std::vector<PlacedSheet>& sheets,
                         const PageLayout& layout) {
  Box2 all;
  for (const PlacedSheet& sheet : sheets) all.add(box_of(sheet, layout.scale));
  const double x =
      is_before ? all.min.x * layout.scale - kGapMm - page.width_mm : all.max.x * layout.scale + kGapMm;
  return {&page, glm::dvec2(x, -layout.frame.net.min.y), std::nullopt, true};
}

Box2 box_of(const PlacedSheet& placed, double scale) {
  if (placed.clip) return *placed.clip;
  const glm::dvec2 end = placed.corner_mm + glm::dvec2(placed.sheet->width_mm, placed.sheet->height_mm);
  Box2 box;
  box.add(glm::dvec2(placed.corner_mm.x, -placed.corner_mm.y) / scale);
  box.add(glm::dvec2(end.x, -end.y) / scale);
  return box;
}

std::vector<glm::dvec2> tab_outline(const GlueTab& tab, const Net& shown, const Net& net, double scale) {
  const FaceId f = shown.mesh().face(tab.side);
  const Rigid2 there = net.placement[f] * shown.placement[f].inverse();
  std::vector<glm::dvec2> outline;
  for (const glm::dvec2 p : tab.points) outline.push_back(there(p / scale));
  return outline;
}

Sheet draw_tabs(const GlueTabs& tabs, const Net& shown, const Net& net, double scale,
                const Palette& palette) {
  Sheet sheet;
  const glm::dvec3 paper = glm::dvec3(0.93, 0.93, 0.90);
  for (const GlueTab& tab : tabs.tabs) {
    std::vector<glm::dvec2> outline = tab_outline(tab, shown, net, scale);
    for (glm::dvec2& p : outline) p = glm::dvec2(p.x, -p.y) * scale;
    sheet.fills.push_back({Layer::Print, outline, paper});
    // The side it grows from has a line of its own already.
    std::vector<glm::dvec2> rim(outline.begin() + 1, outline.end());
    rim.push_back(outline.front());
    sheet.strokes.push_back(
        {Layer::Cut, std::move(rim), false, 0, glm::dvec3(glm::vec3(palette.cut)), {}, 0});
  }
  return sheet;
}

}  // namespace netwright
