// Tiled nets: where their seams run, and whether the printed sheets fit together again.
#include "core/sheet/tiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/sheet/piece_shapes.h"
#include "core/sheet/sheet.h"
#include "core/solve/solve.h"
#include "tests/fixed_grid.h"
#include "tests/sheet_support.h"

namespace netwright {
namespace {

using testing::FixedGrid;
using testing::marks_cut;
using testing::net_of;
using testing::on_a_fixed_grid;

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

/// Where two neighbouring sheets are joined, on the canvas.
struct Joint {
  int axis = 0;  ///< 0: side by side
  glm::dvec2 from{0, 0};
  glm::dvec2 to{0, 0};
};

Joint joint_of(const PageLayout::Page& a, const PageLayout::Page& b) {
  Joint joint;
  joint.axis = a.row == b.row ? 0 : 1;
  joint.from = glm::max(a.share.min, b.share.min);
  joint.to = glm::min(a.share.max, b.share.max);
  return joint;
}

/// All pairs of sheets whose shares touch along a seam, the left or upper one first.
std::vector<std::pair<const PageLayout::Page*, const PageLayout::Page*>> joined_pages(
    const PageLayout& layout) {
  std::vector<std::pair<const PageLayout::Page*, const PageLayout::Page*>> pairs;
  for (const PageLayout::Page& a : layout.pages)
    for (const PageLayout::Page& b : layout.pages) {
      if (a.canvas != b.canvas) continue;
      const bool beside = b.row == a.row && a.share.max.x == b.share.min.x;
      const bool below =
          b.row == a.row + 1 && a.share.max.y == b.share.min.y &&
          std::min(a.share.max.x, b.share.max.x) - std::max(a.share.min.x, b.share.min.x) > 1e-6;
      if (beside || below) pairs.emplace_back(&a, &b);
    }
  return pairs;
}

bool is_joined(const PageLayout::Page& page, const std::string& tag, const PageLayout& layout) {
  const auto pairs = joined_pages(layout);
  return std::any_of(pairs.begin(), pairs.end(),
                     [&](const auto& pair) { return pair.first == &page && pair.second->tag == tag; });
}

TEST(TileSeams, CutFewerMarksThanAFixedGridOnFewerSheets) {
  int n_cut = 0;
  int n_cut_on_grid = 0;
  std::size_t n_sheets = 0;
  std::size_t n_sheets_on_grid = 0;
  for (const PolygonSoup& soup : {shapes::icosphere(2), shapes::icosphere(3), shapes::sand_clock(),
                                  shapes::torus(8, 8), shapes::globe()}) {
    SCOPED_TRACE(soup.name);
    const Net net = solved_net_of(soup);
    const PageLayout layout = arrange(net, {}, height(300), TabSettings());
    ASSERT_TRUE(is_tiled(layout));
    const PieceShapes shapes = piece_shapes(net, layout.scale, layout.tabs);
    const FixedGrid grid = on_a_fixed_grid(shapes.pieces.front(), possible_frames({}));
    EXPECT_LE(layout.pages.size(), grid.n_sheets);
    EXPECT_EQ(layout.canvases.front().n_cut_marks, marks_cut(shapes, layout));
    n_sheets += layout.pages.size();
    n_sheets_on_grid += grid.n_sheets;
    n_cut += marks_cut(shapes, layout);
    n_cut_on_grid += grid.n_cut_marks;
  }
  EXPECT_GT(n_cut_on_grid, 100);
  EXPECT_LT(n_cut, 0.7 * n_cut_on_grid) << n_cut << " of " << n_cut_on_grid;
  EXPECT_LT(n_sheets, n_sheets_on_grid);
}

/// Where a point of the canvas is drawn.
bool shows(const PageLayout::Page& page, glm::dvec2 at) {
  return at.x >= page.shown.min.x - 1e-6 && at.x <= page.shown.max.x + 1e-6 &&
         at.y >= page.shown.min.y - 1e-6 && at.y <= page.shown.max.y + 1e-6;
}

TEST(Tiles, ShowEverythingInsideTheirWindowsAndBothSidesOfEverySeam) {
  const Net net = net_of(shapes::icosphere(3));
  for (const double mm : {250.0, 400.0, 700.0}) {
    const PageLayout layout = arrange(net, {}, height(mm), TabSettings());
    ASSERT_TRUE(is_tiled(layout));
    const glm::dvec2 room = layout.frame.net.size();
    for (const PageLayout::Page& page : layout.pages) {
      EXPECT_TRUE(glm::all(glm::greaterThanEqual(page.shown.min, page.origin - 1e-6)));
      EXPECT_TRUE(glm::all(glm::lessThanEqual(page.shown.max, page.origin + room + 1e-6)));
    }
    for (const HalfedgeId h : net.mesh().halfedges()) {
      const glm::dvec2 from = layout.on_canvas(0, net.corner(h));
      const glm::dvec2 to = layout.on_canvas(0, net.corner(net.mesh().next(h)));
      for (int i = 0; i <= 8; ++i) {
        const glm::dvec2 at = from + (to - from) * (i / 8.0);
        EXPECT_TRUE(std::any_of(layout.pages.begin(), layout.pages.end(),
                                [&](const PageLayout::Page& page) { return shows(page, at); }));
      }
    }
    const double reach = layout.overlap_mm / 2 - 1e-6;
    for (const auto& [a, b] : joined_pages(layout)) {
      const Joint joint = joint_of(*a, *b);
      const glm::dvec2 across = joint.axis == 0 ? glm::dvec2(reach, 0) : glm::dvec2(0, reach);
      for (const glm::dvec2 end : {joint.from, joint.to})
        for (const glm::dvec2 at : {end - across, end + across}) {
          EXPECT_TRUE(shows(*a, at)) << a->tag << " and " << b->tag;
          EXPECT_TRUE(shows(*b, at)) << a->tag << " and " << b->tag;
        }
    }
  }
}

TEST(Tiles, OverlapNoneOfTheOthersShares) {
  const Net net = net_of(shapes::icosphere(3));
  const PageLayout layout = arrange(net, {}, height(500));
  for (const PageLayout::Page& a : layout.pages)
    for (const PageLayout::Page& b : layout.pages) {
      if (a.tag == b.tag) continue;
      const glm::dvec2 apart = glm::max(a.share.min - b.share.max, b.share.min - a.share.max);
      EXPECT_GE(std::max(apart.x, apart.y), -1e-9) << a.tag << " and " << b.tag;
    }
}

TEST(Tiles, LeaveOutPaperThatHasNoneOfTheNet) {
  // A comb: a long back and two teeth at its ends, with nothing between them.
  PieceShape comb;
  comb.outlines = {{{0, 0}, {900, 0}, {900, 400}, {850, 400}, {850, 100}, {50, 100}, {50, 400}, {0, 400}}};
  TiledArea area;
  add_to_area(area, comb, {});
  const Tiling tiling = tile_area(area, {190, 260}, 10);
  ASSERT_EQ(tiling.n_rows, 2);
  std::vector<int> n_in_row(2, 0);
  for (const Tiling::Tile& tile : tiling.tiles) ++n_in_row[static_cast<std::size_t>(tile.row)];
  EXPECT_EQ(std::min(n_in_row[0], n_in_row[1]), 2) << "one sheet for each tooth";
  EXPECT_EQ(std::max(n_in_row[0], n_in_row[1]), 5) << "the whole back";
}

TEST(Tiles, CoverAFaceThatIsLargerThanASheet) {
  PieceShape square;
  square.outlines = {{{0, 0}, {700, 0}, {700, 700}, {0, 700}}};
  TiledArea area;
  add_to_area(area, square, {});
  const Tiling tiling = tile_area(area, {190, 260}, 10);
  EXPECT_EQ(tiling.n_rows, 3);
  EXPECT_EQ(tiling.tiles.size(), 12U);
  EXPECT_EQ(tiling.seams.size(), 2U + 3 * 3);
}

/// Where the arms of the crosses on a sheet meet, as whoever joins the sheets sees them.
std::vector<glm::dvec2> crosses_of(const Sheet& sheet) {
  std::vector<glm::dvec2> crosses;
  for (std::size_t i = 1; i < sheet.strokes.size(); ++i) {
    const Stroke& level = sheet.strokes[i - 1];
    const Stroke& upright = sheet.strokes[i];
    const bool is_cross = level.layer == Layer::Regmarks && upright.layer == Layer::Regmarks &&
                          level.points[0].y == level.points[1].y &&
                          upright.points[0].x == upright.points[1].x;
    if (is_cross) crosses.emplace_back(upright.points[0].x, level.points[0].y);
  }
  return crosses;
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
      // Paper may end just where the seam does, on one of the sheets a rounding error further.
      constexpr double kRounding = 1e-3;
      if (along > kRounding && along < to[1 - axis] - from[1 - axis] - kRounding) found.push_back(along);
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// The cross on a sheet that stands for a point of the canvas.
glm::dvec2 cross_for(const PageLayout& layout, const PageLayout::Page& page, const Sheet& sheet,
                     glm::dvec2 on_canvas) {
  const glm::dvec2 wanted = layout.on_page(page, on_canvas);
  const std::vector<glm::dvec2> crosses = crosses_of(sheet);
  const auto nearest = std::min_element(crosses.begin(), crosses.end(), [&](glm::dvec2 a, glm::dvec2 b) {
    return glm::distance(a, wanted) < glm::distance(b, wanted);
  });
  EXPECT_LT(glm::distance(*nearest, wanted), 1e-6) << page.tag;
  return *nearest;
}

TEST(Tiles, FitTogetherAgainByTheirCrosses) {
  std::size_t n_lines = 0;
  for (const PolygonSoup& soup : {shapes::icosphere(3), shapes::sand_clock(), shapes::globe()}) {
    SCOPED_TRACE(soup.name);
    const Net net = net_of(soup);
    const PageLayout layout = arrange(net, {}, height(400), TabSettings());
    const std::vector<Sheet> sheets = draw_sheets(net, layout, {});
    for (const auto& [a, b] : joined_pages(layout)) {
      SCOPED_TRACE(a->tag + " and " + b->tag);
      const Joint joint = joint_of(*a, *b);
      const Sheet& one = sheets[static_cast<std::size_t>(a - layout.pages.data())];
      const Sheet& other = sheets[static_cast<std::size_t>(b - layout.pages.data())];
      const glm::dvec2 from = cross_for(layout, *a, one, joint.from);
      const glm::dvec2 to = cross_for(layout, *a, one, joint.to);
      const glm::dvec2 other_from = cross_for(layout, *b, other, joint.from);
      const glm::dvec2 other_to = cross_for(layout, *b, other, joint.to);
      EXPECT_NEAR(glm::distance(to - from, other_to - other_from), 0, 1e-6);
      const std::vector<double> lines = crossings(one, from, to, joint.axis);
      const std::vector<double> others = crossings(other, other_from, other_to, joint.axis);
      ASSERT_EQ(lines.size(), others.size());
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
  std::size_t n_bands = 0;
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    const PageLayout::Page& page = layout.pages[i];
    for (const Text& text : sheets[i].texts) {
      if (!text.words.starts_with("glue ") || !text.words.ends_with(" here")) continue;
      ++n_bands;
      const std::string tag = text.words.substr(5, text.words.size() - 10);
      EXPECT_TRUE(is_joined(page, tag, layout)) << page.tag << ": " << text.words;
    }
  }
  std::size_t n_long = 0;
  for (const auto& [a, b] : joined_pages(layout)) {
    const Joint joint = joint_of(*a, *b);
    n_long += glm::distance(joint.from, joint.to) > 60 ? 1 : 0;
  }
  EXPECT_GE(n_bands, n_long) << "every joint that has room for words has them";
  EXPECT_GT(n_long, 5U);
}

}  // namespace
}  // namespace netwright
