// Where pieces lie on paper: the largest scale that fits, true heights, tiling and packing.
#include "core/sheet/pages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "core/base/best_angle.h"
#include "core/base/error.h"
#include "core/sheet/pack.h"
#include "core/sheet/pack_outlines.h"
#include "core/sheet/piece_shapes.h"
#include "core/sheet/tiles.h"
#include "tests/sheet_support.h"

namespace netwright {
namespace {

using testing::net_of;

PrintSize height(double mm) { return {PrintSize::Kind::Height, mm}; }

Box2 box_on_canvas(const Net& net, const PageLayout& layout, int piece) {
  Box2 box;
  for (const FaceId f : net.mesh().faces())
    if (net.piece[f] == piece)
      for (const HalfedgeId h : net.mesh().halfedges(f)) box.add(layout.on_canvas(piece, net.corner(h)));
  return box;
}

void expect_inside(const Box2& inner, const Box2& outer) {
  EXPECT_GE(inner.min.x, outer.min.x - 1e-6);
  EXPECT_GE(inner.min.y, outer.min.y - 1e-6);
  EXPECT_LE(inner.max.x, outer.max.x + 1e-6);
  EXPECT_LE(inner.max.y, outer.max.y + 1e-6);
}

std::string refusal(const Net& net, const PaperSetup& paper, const PrintSize& size) {
  try {
    arrange(net, paper, size);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Usage);
    return error.what();
  }
  ADD_FAILURE() << "nothing was refused";
  return "";
}

TEST(BestAngle, LaysASlantedBoxFlat) {
  const Rigid2 slant = Rigid2::rotation(0.3);
  std::vector<glm::dvec2> corners;
  for (const glm::dvec2 p : {glm::dvec2(0, 0), glm::dvec2(8, 0), glm::dvec2(8, 1), glm::dvec2(0, 1)})
    corners.push_back(slant(p));
  const auto hull = convex_hull(corners);
  const glm::dvec2 size = turned_box(hull, best_angle(hull, [](glm::dvec2 s) { return s.x * s.y; })).size();
  EXPECT_NEAR(size.x * size.y, 8, 1e-9);
}

TEST(BestAngle, FindsTheDiagonalBetweenTheSidesDirections) {
  // A thin rod fits a square best along the diagonal, which no side of its hull points along.
  const std::vector<glm::dvec2> rod = {{0, 0}, {10, 0}, {10, 0.1}, {0, 0.1}};
  const auto cost = [](glm::dvec2 s) { return std::max(s.x, s.y); };
  const glm::dvec2 size = turned_box(rod, best_angle(rod, cost)).size();
  EXPECT_NEAR(std::max(size.x, size.y), 10.1 / std::sqrt(2.0), 1e-6);
}

TEST(ConvexHull, LeavesOutCollinearAndRepeatedPoints) {
  EXPECT_EQ(convex_hull({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}, {0, 0}, {0, 1}}).size(), 4U);
}

TEST(Pack, KeepsRectanglesApartAndOnTheirPages) {
  const glm::dvec2 page(100, 80);
  std::vector<glm::dvec2> sizes;
  Random random(3);
  for (int i = 0; i < 60; ++i) sizes.emplace_back(3 + 60 * random.unit(), 3 + 60 * random.unit());
  const std::vector<Packed> packed = pack(sizes, page, 3);
  std::vector<Box2> boxes;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const glm::dvec2 size = packed[i].is_turned ? glm::dvec2(sizes[i].y, sizes[i].x) : sizes[i];
    boxes.push_back({packed[i].at, packed[i].at + size});
    expect_inside(boxes[i], {{0, 0}, page});
    for (std::size_t j = 0; j < i; ++j) {
      if (packed[i].page != packed[j].page) continue;
      const glm::dvec2 apart = glm::max(boxes[i].min - boxes[j].max, boxes[j].min - boxes[i].max);
      EXPECT_GE(std::max(apart.x, apart.y), 3 - 1e-6);
    }
  }
}

TEST(TileTag, CountsLikeASpreadsheet) {
  EXPECT_EQ(tile_tag(0, 0), "A1");
  EXPECT_EQ(tile_tag(1, 2), "B3");
  EXPECT_EQ(tile_tag(25, 0), "Z1");
  EXPECT_EQ(tile_tag(26, 11), "AA12");
}

TEST(PageFrame, KeepsItsStripsApartOnEveryPaper) {
  for (const PaperFormat& format : paper_formats())
    for (const double margin : {0.0, 5.0, 10.0, 15.0})
      for (const PageFrame& frame : possible_frames({std::string(format.name), Orientation::Auto, margin})) {
        SCOPED_TRACE(std::string(format.name) + ", margin " + std::to_string(margin));
        for (const Box2& box : {frame.header, frame.footer, frame.net}) expect_inside(box, frame.printable);
        EXPECT_LE(frame.header.max.y, frame.net.min.y);
        EXPECT_LE(frame.net.max.y, frame.footer.min.y);
        if (frame.side.is_empty()) continue;
        expect_inside(frame.side, frame.printable);
        EXPECT_LE(frame.side.max.x, frame.net.min.x);
      }
}

TEST(Arrange, FitsEveryShapeOnOnePageAndFillsItToTheBorder) {
  for (const testing::ZooShape& shape : testing::zoo()) {
    SCOPED_TRACE(shape.soup.name);
    const Net net = net_of(shape.soup);
    const PageLayout layout = arrange(net, {}, {});
    ASSERT_EQ(layout.pages.size(), 1U);
    Box2 all;
    for (int piece = 0; piece < net.n_pieces; ++piece) {
      const Box2 box = box_on_canvas(net, layout, piece);
      expect_inside(box, {{0, 0}, layout.frame.net.size()});
      all.add(box);
    }
    const glm::dvec2 share = all.size() / layout.frame.net.size();
    EXPECT_GT(std::max(share.x, share.y), net.n_pieces == 1 ? 0.999 : 0.7);
  }
}

TEST(Arrange, KeepsTabsOnThePageAndMakesTheMostOfIt) {
  for (const testing::ZooShape& shape : testing::zoo()) {
    SCOPED_TRACE(shape.soup.name);
    const Net net = net_of(shape.soup);
    const PageLayout layout = arrange(net, {"A5"}, {}, TabSettings());
    ASSERT_EQ(layout.pages.size(), 1U);
    Box2 all;
    for (int piece = 0; piece < net.n_pieces; ++piece) all.add(box_on_canvas(net, layout, piece));
    for (const GlueTab& tab : layout.tabs.tabs)
      for (const glm::dvec2 p : tab.points)
        all.add(layout.on_canvas_mm(net.piece[net.mesh().face(tab.side)], p));
    expect_inside(all, {{0, 0}, layout.frame.net.size()});
    const glm::dvec2 share = all.size() / layout.frame.net.size();
    EXPECT_GT(std::max(share.x, share.y), net.n_pieces == 1 ? 0.985 : 0.7);
    EXPECT_LE(layout.scale, arrange(net, {"A5"}, {}).scale);
  }
}

TEST(Arrange, CountsTabsForTheTilesItNeeds) {
  const Net net = net_of(shapes::icosphere(2));
  TabSettings wide;
  wide.width_mm = 20;
  const PageLayout layout = arrange(net, {}, height(400), wide);
  ASSERT_GT(layout.tabs.tabs.size(), 20U);
  for (const GlueTab& tab : layout.tabs.tabs)
    for (const glm::dvec2 p : tab.points) {
      const glm::dvec2 at = layout.on_canvas_mm(0, p);
      const bool is_shown =
          std::any_of(layout.pages.begin(), layout.pages.end(), [&](const PageLayout::Page& page) {
            const glm::dvec2 on = at - page.origin;
            const glm::dvec2 room = layout.frame.net.size();
            return on.x >= 0 && on.y >= 0 && on.x <= room.x && on.y <= room.y;
          });
      EXPECT_TRUE(is_shown);
    }
}

TEST(Arrange, PrintsLargerThanUnturned) {
  const Net net = net_of(shapes::cuboid({1, 20, 0.5}));
  const PageLayout turned = arrange(net, {}, {});
  const glm::dvec2 share = net.box().size() / turned.frame.net.size();
  EXPECT_GE(turned.scale, 1 / std::max(share.x, share.y) - 1e-9);
}

TEST(Arrange, ObeysTheChosenOrientation) {
  const Net net = net_of(shapes::icosahedron());
  EXPECT_FALSE(arrange(net, {"A4", Orientation::Portrait, 10}, {}).frame.is_landscape());
  EXPECT_TRUE(arrange(net, {"A4", Orientation::Landscape, 10}, {}).frame.is_landscape());
}

TEST(Arrange, DoesNotMirrorTheNet) {
  const Net net = net_of(shapes::letter_l());
  const PageLayout layout = arrange(net, {}, {});
  for (const FaceId f : net.mesh().faces()) {
    double area = 0;
    for (const HalfedgeId h : net.mesh().halfedges(f))
      area += cross(layout.on_canvas(0, net.corner(h)), layout.on_canvas(0, net.corner(net.mesh().next(h))));
    EXPECT_LT(area, 0) << "counter-clockwise faces must look so on paper, where y points down";
  }
}

TEST(Arrange, MeetsTheHeightExactly) {
  const Net net = net_of(shapes::icosphere(2));
  const PageLayout layout = arrange(net, {}, height(80));
  EXPECT_NEAR(layout.scale * net.mesh().height(), 80, 1e-9);
  EXPECT_NEAR(layout.model_height_mm, 80, 1e-9);
}

TEST(Arrange, MeetsTheLengthOfAnEdgeAndAScale) {
  const Net net = net_of(shapes::cuboid({2, 3, 5}));
  for (const EdgeId e : net.mesh().edges()) {
    PrintSize size{PrintSize::Kind::EdgeLength};
    size.edge = e;
    size.edge_mm = 34;
    EXPECT_NEAR(arrange(net, {}, size).scale * net.mesh().length(e), 34, 1e-9);
  }
  PrintSize size{PrintSize::Kind::Scale};
  size.scale = 7.5;
  EXPECT_DOUBLE_EQ(arrange(net, {}, size).scale, 7.5);
}

TEST(Arrange, PrintsAsLargeAsFitsOnSomeSheetsAndNoFewerDo) {
  const Net net = net_of(shapes::icosphere(2));
  double scale = arrange(net, {}, {}).scale;
  for (const int sheets : {2, 4, 9}) {
    PrintSize size{PrintSize::Kind::FitSheets};
    size.sheets = sheets;
    const PageLayout layout = arrange(net, {}, size);
    EXPECT_LE(layout.pages.size(), static_cast<std::size_t>(sheets));
    EXPECT_GT(layout.scale, 1.05 * scale) << sheets << " sheets have room for more than fewer have";
    scale = layout.scale;
  }
}

TEST(Paper, IsKnownByNameOrByItsSides) {
  for (const char series : {'A', 'B'})
    for (int k = 0; k <= 6; ++k) {
      const auto paper = find_paper(std::string(1, series) + std::to_string(k));
      ASSERT_TRUE(paper) << series << k;
      EXPECT_NEAR(paper->height_mm / paper->width_mm, std::sqrt(2.0), 0.01);
    }
  EXPECT_EQ(find_paper("legal")->name, "Legal");
  const auto own = find_paper("300x99.5");
  ASSERT_TRUE(own);
  EXPECT_EQ(own->width_mm, 99.5);
  EXPECT_EQ(own->height_mm, 300);
  EXPECT_EQ(custom_paper(300, 99.5), "99.5x300");
  for (const char* word :
       {"x", "300x", "x300", "300", "10x300", "300x6000", "300xx300", "-300x300", "nanx300"})
    EXPECT_FALSE(find_paper(word)) << word;
  EXPECT_NEAR(page_frame({"300x200", Orientation::Landscape, 5}).width_mm, 300, 1e-9);
}

/// Loose rectangles, each a piece of its own.
PolygonSoup rectangles(const std::vector<glm::dvec2>& sizes) {
  PolygonSoup soup;
  double x = 0;
  for (const glm::dvec2 size : sizes) {
    const int first = static_cast<int>(soup.points.size());
    for (const glm::dvec2 p : {glm::dvec2(0, 0), {size.x, 0}, size, {0, size.y}})
      soup.points.emplace_back(x + p.x, p.y, 0);
    soup.add_face(std::vector<int>{first, first + 1, first + 2, first + 3});
    x += size.x + 10;
  }
  return soup;
}

TEST(Arrange, TurnsThePaperRatherThanTileAPieceThatFitsTheOtherWay) {
  const std::vector<PageFrame> frames = possible_frames({});
  const glm::dvec2 upright = frames[0].net.size();
  const glm::dvec2 lying = frames[1].net.size();
  // The long one fits lying paper alone; the others share an upright page, but no lying one.
  const glm::dvec2 long_one = lying * glm::dvec2(0.97, 0.65);
  const glm::dvec2 other = upright * glm::dvec2(0.97, 0.48);
  const Net net = net_of(rectangles({long_one, other, other}));
  const PrintSize size{.kind = PrintSize::Kind::Scale, .scale = 1};
  const PageLayout upright_only = arrange(net, {"A4", Orientation::Portrait, 10}, size);
  const PageLayout lying_only = arrange(net, {"A4", Orientation::Landscape, 10}, size);
  ASSERT_EQ(upright_only.pages.size(), lying_only.pages.size());
  ASSERT_TRUE(std::ranges::any_of(upright_only.canvases, &PageLayout::Canvas::is_tiled));
  ASSERT_FALSE(std::ranges::any_of(lying_only.canvases, &PageLayout::Canvas::is_tiled));
  const PageLayout layout = arrange(net, {}, size);
  EXPECT_TRUE(layout.frame.is_landscape());
  EXPECT_EQ(layout.canvases.size(), 3U);
}

TEST(Arrange, TilesWhatIsLargerThanThePaper) {
  const Net net = net_of(shapes::icosphere(2));
  const PageLayout layout = arrange(net, {}, height(300));
  ASSERT_EQ(layout.canvases.size(), 1U);
  EXPECT_TRUE(layout.canvases[0].is_tiled());
  EXPECT_GT(layout.pages.size(), 1U);
  expect_inside(box_on_canvas(net, layout, 0),
                {{0, 0}, {layout.canvases[0].width_mm, layout.canvases[0].height_mm}});
  std::map<std::string, int> tags;
  for (const PageLayout::Page& page : layout.pages) {
    ++tags[page.tag];
    expect_inside(page.shown, {page.origin, page.origin + layout.frame.net.size()});
  }
  EXPECT_EQ(tags.size(), layout.pages.size()) << "every tile has a tag of its own";
}

TEST(Arrange, ShowsEveryFaceOnSomePage) {
  for (const double mm : {200.0, 500.0, 900.0}) {
    const Net net = net_of(shapes::sand_clock());
    const PageLayout layout = arrange(net, {}, height(mm));
    for (const FaceId f : net.mesh().faces()) {
      glm::dvec2 centre(0, 0);
      for (const HalfedgeId h : net.mesh().halfedges(f)) centre += net.corner(h);
      centre = layout.on_canvas(0, centre / static_cast<double>(net.mesh().degree(f)));
      const bool is_shown =
          std::any_of(layout.pages.begin(), layout.pages.end(), [&](const PageLayout::Page& page) {
            const glm::dvec2 at = centre - page.origin;
            return at.x >= 0 && at.y >= 0 && at.x <= layout.frame.net.size().x &&
                   at.y <= layout.frame.net.size().y;
          });
      EXPECT_TRUE(is_shown) << "face " << f.value << " at " << mm << " mm";
    }
  }
}

TEST(Arrange, PacksPartsOnPagesAndTilesTheLargeOnes) {
  PolygonSoup soup = shapes::cuboid({1, 1, 1});
  for (int i = 1; i < 5; ++i) soup = shapes::combined(soup, shapes::cube(), {4.0 * i, 0, 0});
  soup = shapes::combined(soup, shapes::cuboid({1, 12, 1}), {40, 0, 0});
  const Net net = net_of(soup);
  ASSERT_EQ(net.n_pieces, 6);
  const PageLayout layout = arrange(net, {}, height(480));
  EXPECT_TRUE(layout.canvases[0].is_tiled());
  EXPECT_FALSE(layout.canvases.back().is_tiled());
  const PieceShapes shapes = piece_shapes(net, layout.scale, no_tabs());
  const auto lying = [&](std::size_t piece) {
    Outlines outlines = shapes.pieces[piece].outlines;
    for (auto& outline : outlines)
      for (glm::dvec2& p : outline) p = layout.on_canvas_mm(static_cast<int>(piece), p);
    return outlines;
  };
  for (std::size_t i = 0; i < layout.pieces.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (layout.pieces[i].canvas != layout.pieces[j].canvas) continue;
      EXPECT_GE(distance_between(lying(i), lying(j)), 3 - 1e-6) << i << " and " << j;
    }
}

TEST(Arrange, RefusesWhatCannotBePrintedInOneSentence) {
  const Net net = net_of(shapes::cube());
  EXPECT_NE(refusal(net, {"A9", Orientation::Auto, 10}, {}).find("A4"), std::string::npos);
  EXPECT_NE(refusal(net, {"A6", Orientation::Auto, 60}, {}).find("margin of 60 mm"), std::string::npos);
  EXPECT_NE(refusal(net, {"A4", Orientation::Auto, -1}, {}).find("margin"), std::string::npos);
  EXPECT_NE(refusal(net, {"A4", Orientation::Auto, std::nan("")}, {}).find("margin"), std::string::npos);
  EXPECT_NE(refusal(net, {}, height(0)).find("above 0"), std::string::npos);
  EXPECT_NE(refusal(net, {}, height(1e9)).find("1000 pages"), std::string::npos);
  EXPECT_NE(refusal(net, {}, {PrintSize::Kind::EdgeLength}).find("edge"), std::string::npos);
  PrintSize size{PrintSize::Kind::Scale};
  size.scale = -2;
  EXPECT_NE(refusal(net, {}, size).find("scale of -2"), std::string::npos);
  size = {PrintSize::Kind::FitSheets};
  size.sheets = 0;
  EXPECT_NE(refusal(net, {}, size).find("0 sheets"), std::string::npos);
  EXPECT_NE(refusal(net_of(shapes::grid_patch(3, 3)), {}, height(100)).find("up axis"), std::string::npos);
}

TEST(SpreadPieces, PutsPartsSideBySideWithoutTurningThem) {
  const Net net = net_of(shapes::combined(shapes::cube(), shapes::tetrahedron(), {5, 0, 0}));
  const Net spread = spread_pieces(net);
  Box2 boxes[2];
  for (const FaceId f : spread.mesh().faces()) {
    boxes[spread.piece[f]].add(spread.box(f));
    EXPECT_EQ(spread.placement[f].cos, net.placement[f].cos);
    EXPECT_EQ(spread.placement[f].sin, net.placement[f].sin);
  }
  const glm::dvec2 apart = glm::max(boxes[1].min - boxes[0].max, boxes[0].min - boxes[1].max);
  EXPECT_GT(std::max(apart.x, apart.y), 0);
}

}  // namespace
}  // namespace netwright
