// Tiled nets: where their seams run, and whether the printed sheets fit together again.
#include "core/sheet/tile_seams.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "core/base/best_angle.h"
#include "core/sheet/sheet.h"
#include "core/solve/solve.h"
#include "tests/sheet_support.h"

namespace netwright {
namespace {

using testing::net_of;

PrintSize height(double mm) { return {PrintSize::Kind::Height, mm}; }

/// One piece without overlaps, as people print it.
Net solved_net_of(const PolygonSoup& soup) {
  Progress progress;
  return solve(testing::make_dual(soup), {.seed = 1, .streams = 1, .threads = 1}, progress, {}).net;
}

bool is_tiled(const PageLayout& layout) {
  return std::any_of(layout.canvases.begin(), layout.canvases.end(),
                     [](const PageLayout::Canvas& canvas) { return canvas.is_tiled(); });
}

/// The tiling of a single piece on a fixed grid: of all angles, the one with the fewest sheets.
Tiling on_a_fixed_grid(const Net& net, double scale, const PageFrame& frame, const TabSettings& tabs) {
  const PieceShapes shapes = piece_shapes(net, scale, tabs);
  const PieceShape& piece = shapes.pieces.front();
  const glm::dvec2 room = frame.net.size();
  std::optional<Tiling> best;
  double least_fill = 0;
  for (int k = 0; k < 60; ++k) {
    const double angle = k * std::numbers::pi / 60;
    const Box2 box = turned_box(piece.hull, angle);
    const auto [columns, rows] = tiles_for(box.size(), room, 10);
    const glm::dvec2 canvas = glm::dvec2(columns, rows) * (room - 10.0) + 10.0;
    Rigid2 turn = Rigid2::rotation(angle);
    turn.x = (canvas.x - box.size().x) / 2 - box.min.x;
    turn.y = -(canvas.y - box.size().y) / 2 - box.max.y;
    TiledArea area;
    add_to_area(area, piece, turn);
    Tiling tiling = even_tiling(area, room, 10, columns, rows);
    const double fill = std::max(box.size().x / canvas.x, box.size().y / canvas.y);
    const bool is_first =
        !best || tiling.n_sheets < best->n_sheets || (tiling.n_sheets == best->n_sheets && fill < least_fill);
    if (!is_first) continue;
    best = std::move(tiling);
    least_fill = fill;
  }
  return *best;
}

/// How often the layout's seams run through folds, tabs and the middles of glued edges.
int marks_cut(const Net& net, const PageLayout& layout) {
  const PieceShapes shapes = piece_shapes(net, layout.scale, layout.tabs);
  TiledArea area;
  add_to_area(area, shapes.pieces.front(), layout.pieces.front().turn);
  int count = 0;
  for (const Box2& mark : area.marks) {
    for (const double x : layout.canvases.front().column_seams) count += mark.min.x < x && x < mark.max.x;
    for (const double y : layout.canvases.front().row_seams) count += mark.min.y < y && y < mark.max.y;
  }
  return count;
}

TEST(TileSeams, CutFewerMarksThanAFixedGridOnNoMoreSheets) {
  int n_moved = 0;
  int n_fixed = 0;
  for (const PolygonSoup& soup : {shapes::icosphere(2), shapes::icosphere(3), shapes::sand_clock(),
                                  shapes::torus(8, 8), shapes::globe()}) {
    SCOPED_TRACE(soup.name);
    const Net net = solved_net_of(soup);
    const PageLayout layout = arrange(net, {}, height(300), TabSettings());
    if (!is_tiled(layout)) continue;
    std::size_t n_sheets = std::numeric_limits<std::size_t>::max();
    int fewest = 0;
    for (const PageFrame& frame : possible_frames({})) {
      const Tiling fixed = on_a_fixed_grid(net, layout.scale, frame, TabSettings());
      if (fixed.n_sheets >= n_sheets) continue;
      n_sheets = fixed.n_sheets;
      fewest = fixed.n_cut_marks;
    }
    EXPECT_LE(layout.pages.size(), n_sheets);
    n_fixed += fewest;
    n_moved += marks_cut(net, layout);
  }
  EXPECT_GT(n_fixed, 100);
  EXPECT_LT(n_moved, 0.8 * n_fixed) << n_moved << " of " << n_fixed;
}

TEST(TileSeams, WindowsReachOverEverySeamAndShowEverything) {
  const Net net = net_of(shapes::icosphere(3));
  for (const double mm : {250.0, 400.0, 700.0}) {
    const PageLayout layout = arrange(net, {}, height(mm), TabSettings());
    ASSERT_TRUE(is_tiled(layout));
    const PageLayout::Canvas& canvas = layout.canvases.front();
    ASSERT_EQ(canvas.column_seams.size() + 1, static_cast<std::size_t>(canvas.columns));
    ASSERT_EQ(canvas.row_seams.size() + 1, static_cast<std::size_t>(canvas.rows));
    const double half = layout.overlap_mm / 2 - 1e-9;
    for (const PageLayout::Page& page : layout.pages) {
      const glm::dvec2 end = page.origin + layout.frame.net.size();
      // Over every seam that the tile has on each of its sides.
      const auto expect_over = [&](int axis, int index, const std::vector<double>& seams) {
        const auto i = static_cast<std::size_t>(index);
        if (i > 0) {
          EXPECT_LE(page.origin[axis], seams[i - 1] - half);
        }
        if (i < seams.size()) {
          EXPECT_GE(end[axis], seams[i] + half);
        }
      };
      expect_over(0, page.column, canvas.column_seams);
      expect_over(1, page.row, canvas.row_seams);
    }
    for (const HalfedgeId h : net.mesh().halfedges()) {
      const glm::dvec2 at = layout.on_canvas(0, net.corner(h));
      EXPECT_TRUE(std::any_of(layout.pages.begin(), layout.pages.end(), [&](const PageLayout::Page& page) {
        return at.x >= page.shown.min.x - 1e-6 && at.x <= page.shown.max.x + 1e-6 &&
               at.y >= page.shown.min.y - 1e-6 && at.y <= page.shown.max.y + 1e-6;
      }));
    }
  }
}

/// The middles of the crosses on a sheet, as whoever joins the sheets sees them.
std::vector<glm::dvec2> crosses_of(const Sheet& sheet) {
  std::vector<glm::dvec2> crosses;
  for (const Stroke& stroke : sheet.strokes) {
    const bool is_level = stroke.layer == Layer::Regmarks && stroke.points.size() == 2 &&
                          stroke.points[0].y == stroke.points[1].y;
    if (is_level) crosses.push_back((stroke.points[0] + stroke.points[1]) * 0.5);
  }
  return crosses;
}

/// The two crosses furthest in a direction, ordered along the seam between them.
std::pair<glm::dvec2, glm::dvec2> crosses_at(const Sheet& sheet, int axis, bool is_high) {
  std::vector<glm::dvec2> crosses = crosses_of(sheet);
  EXPECT_EQ(crosses.size(), 4U);
  std::sort(crosses.begin(), crosses.end(),
            [&](glm::dvec2 a, glm::dvec2 b) { return is_high ? a[axis] > b[axis] : a[axis] < b[axis]; });
  if (crosses[0][1 - axis] > crosses[1][1 - axis]) std::swap(crosses[0], crosses[1]);
  return {crosses[0], crosses[1]};
}

/// Where lines of the net cross the seam between two points, as distances from the first one.
std::vector<double> crossings(const Sheet& sheet, glm::dvec2 from, glm::dvec2 to, int axis) {
  std::vector<double> found;
  for (const Stroke& stroke : sheet.strokes) {
    if (!testing::is_of_net(stroke) && stroke.layer != Layer::TabFold) continue;
    const std::size_t n_sides = stroke.points.size() - (stroke.is_closed ? 0 : 1);
    for (std::size_t i = 0; i < n_sides; ++i) {
      const glm::dvec2 a = stroke.points[i];
      const glm::dvec2 b = stroke.points[(i + 1) % stroke.points.size()];
      if ((a[axis] < from[axis]) == (b[axis] < from[axis])) continue;
      const glm::dvec2 at = a + (b - a) * ((from[axis] - a[axis]) / (b[axis] - a[axis]));
      const double along = at[1 - axis] - from[1 - axis];
      if (along > 0 && along < to[1 - axis] - from[1 - axis]) found.push_back(along);
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

TEST(Tiles, FitTogetherAgainByTheirCrosses) {
  std::size_t n_lines = 0;
  for (const PolygonSoup& soup : {shapes::icosphere(3), shapes::sand_clock(), shapes::globe()}) {
    SCOPED_TRACE(soup.name);
    const Net net = net_of(soup);
    const PageLayout layout = arrange(net, {}, height(400), TabSettings());
    const std::vector<Sheet> sheets = draw_sheets(net, layout, {});
    for (std::size_t i = 0; i < layout.pages.size(); ++i)
      for (std::size_t j = 0; j < layout.pages.size(); ++j) {
        const PageLayout::Page& a = layout.pages[i];
        const PageLayout::Page& b = layout.pages[j];
        const bool beside = b.row == a.row && b.column == a.column + 1;
        const bool below = b.column == a.column && b.row == a.row + 1;
        if (a.canvas != b.canvas || (!beside && !below)) continue;
        const int axis = beside ? 0 : 1;
        const auto [from, to] = crosses_at(sheets[i], axis, true);
        const auto [other_from, other_to] = crosses_at(sheets[j], axis, false);
        EXPECT_NEAR(glm::distance(to - from, other_to - other_from), 0, 1e-6) << a.tag << " and " << b.tag;
        const std::vector<double> lines = crossings(sheets[i], from, to, axis);
        const std::vector<double> others = crossings(sheets[j], other_from, other_to, axis);
        ASSERT_EQ(lines.size(), others.size()) << a.tag << " and " << b.tag;
        for (std::size_t k = 0; k < lines.size(); ++k) EXPECT_NEAR(lines[k], others[k], 0.2);
        n_lines += lines.size();
      }
  }
  EXPECT_GT(n_lines, 50U);
}

TEST(Tiles, HaveABandToGlueWhereANeighbourComesAndOnlyThere) {
  const Net net = net_of(shapes::icosphere(3));
  const PageLayout layout = arrange(net, {}, height(400));
  const std::vector<Sheet> sheets = draw_sheets(net, layout, {});
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    const PageLayout::Page& page = layout.pages[i];
    const auto n_bands = std::count_if(sheets[i].texts.begin(), sheets[i].texts.end(), [](const Text& text) {
      return text.words.starts_with("glue ") && text.words.ends_with(" here");
    });
    const auto n_neighbours =
        std::count_if(layout.pages.begin(), layout.pages.end(), [&](const PageLayout::Page& other) {
          return (other.row == page.row && other.column == page.column + 1) ||
                 (other.column == page.column && other.row == page.row + 1);
        });
    EXPECT_EQ(n_bands, n_neighbours) << page.tag;
  }
}

}  // namespace
}  // namespace netwright
