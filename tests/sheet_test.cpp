// The drawing of a page: nothing leaves it, tiles lose nothing, outlines are joined, dashes begin and end
// with ink.
#include "core/sheet/sheet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/sheet/dash.h"
#include "core/sheet/font.h"
#include "core/sheet/number_text.h"
#include "core/sheet/outline.h"
#include "core/sheet/print_style.h"
#include "tests/sheet_support.h"

namespace netwright {
namespace {

using testing::is_of_net;
using testing::length_of;
using testing::net_of;

PrintSize height(double mm) { return {PrintSize::Kind::Height, mm}; }

void expect_on_paper(const Sheet& sheet, const Box2& printable) {
  static const Font regular(FontWeight::Regular);
  static const Font semi_bold(FontWeight::SemiBold);
  Box2 used;
  const auto add = [&](glm::dvec2 p, double around) {
    used.add(p - around);
    used.add(p + around);
  };
  for (const Stroke& stroke : sheet.strokes)
    // A line's end is butt: only its width goes beyond its points, and that sideways.
    for (const glm::dvec2 p : stroke.points) add(p, is_of_net(stroke) ? stroke.width_mm / 2 : 0);
  for (const Fill& fill : sheet.fills)
    for (const glm::dvec2 p : fill.points) add(p, 0);
  for (const Text& text : sheet.texts)
    for (const Font::Step& step :
         (text.weight == FontWeight::Regular ? regular : semi_bold).outline(text.words, text.size_mm, {0, 0}))
      if (step.kind != 'Z')
        add(text.at + Rigid2::rotation(text.angle_rad).rotate(step.points[step.kind == 'C' ? 2 : 0]), 0);
  EXPECT_GE(used.min.x, printable.min.x - 0.05);
  EXPECT_GE(used.min.y, printable.min.y - 0.05);
  EXPECT_LE(used.max.x, printable.max.x + 0.05);
  EXPECT_LE(used.max.y, printable.max.y + 0.05);
}

/// What the net's lines measure on paper: cuts twice (each side once), borders and drawn folds once.
double expected_ink(const Net& net, double scale) {
  const IdVector<EdgeId, EdgeKind> kinds = edge_kinds(net);
  double length = 0;
  for (const EdgeId e : net.mesh().edges()) {
    if (kinds[e] == EdgeKind::Flat) continue;
    length += net.mesh().length(e) * (kinds[e] == EdgeKind::Cut ? 2 : 1);
  }
  return length * scale;
}

double net_ink(const std::vector<Sheet>& sheets) {
  double length = 0;
  for (const Sheet& sheet : sheets)
    for (const Stroke& stroke : sheet.strokes)
      if (is_of_net(stroke)) length += length_of(stroke);
  return length;
}

TEST(DrawSheets, DrawsEveryLineOfTheNetAtItsLength) {
  for (const testing::ZooShape& shape : testing::zoo()) {
    SCOPED_TRACE(shape.soup.name);
    const Net net = net_of(shape.soup);
    const PageLayout layout = arrange(net, {}, {});
    const double expected = expected_ink(net, layout.scale);
    EXPECT_NEAR(net_ink(draw_sheets(net, layout, {})), expected, 1e-6 * expected);
  }
}

TEST(DrawSheets, NeverLeavesThePrintableArea) {
  for (const testing::ZooShape& shape : testing::zoo()) {
    SCOPED_TRACE(shape.soup.name);
    const Net net = net_of(shape.soup);
    for (const PaperSetup& paper : {PaperSetup{}, PaperSetup{"A6", Orientation::Portrait, 10},
                                    PaperSetup{"A5", Orientation::Auto, 5}, PaperSetup{"Letter"}}) {
      const PageLayout layout = arrange(net, paper, {});
      for (const Sheet& sheet : draw_sheets(net, layout, {"", true, 123456789}))
        expect_on_paper(sheet, layout.frame.printable);
    }
  }
}

TEST(DrawSheets, NeverLeavesThePrintableAreaOnTilesEither) {
  for (const PolygonSoup& soup : {shapes::icosphere(2), shapes::letter_e(), shapes::star(7)}) {
    const Net net = net_of(soup);
    for (const char* format : {"A4", "A6", "Tabloid"}) {
      const PaperSetup paper{format, Orientation::Auto, 10};
      const PageLayout layout = arrange(net, paper, height(3 * arrange(net, paper, {}).model_height_mm));
      EXPECT_GT(layout.pages.size(), 2U);
      for (const Sheet& sheet : draw_sheets(net, layout, {std::string(200, 'W'), true, {}}))
        expect_on_paper(sheet, layout.frame.printable);
    }
  }
}

TEST(DrawSheets, LosesNothingBetweenTiles) {
  for (const PolygonSoup& soup : {shapes::cube(), shapes::icosphere(2), shapes::sand_clock()}) {
    const Net net = net_of(soup);
    for (const double mm : {150.0, 420.0, 1000.0}) {
      const PageLayout layout = arrange(net, {}, height(mm));
      EXPECT_GE(net_ink(draw_sheets(net, layout, {})), expected_ink(net, layout.scale) * (1 - 1e-9));
      // Every sample of every line is on some page.
      for (const OutlineLoop& loop : outline_loops(net))
        for (const HalfedgeId h : loop.sides)
          for (const double t : {0.0, 0.25, 0.5, 0.75}) {
            const glm::dvec2 a = net.corner(h);
            const glm::dvec2 p = layout.on_canvas(0, a + t * (net.corner(net.mesh().next(h)) - a));
            EXPECT_TRUE(std::any_of(layout.pages.begin(), layout.pages.end(), [&](const auto& page) {
              const glm::dvec2 at = layout.on_page(page, p);
              return glm::all(glm::greaterThanEqual(at, layout.frame.net.min - 1e-9)) &&
                     glm::all(glm::lessThanEqual(at, layout.frame.net.max + 1e-9));
            }));
          }
    }
  }
}

TEST(DrawSheets, JoinsEachPiecesOutlineIntoOneClosedPath) {
  for (const testing::ZooShape& shape : testing::zoo()) {
    SCOPED_TRACE(shape.soup.name);
    const Net net = net_of(shape.soup);
    const std::vector<Sheet> sheets = draw_sheets(net, arrange(net, {}, {}), {});
    const auto& strokes = sheets.front().strokes;
    EXPECT_EQ(std::count_if(strokes.begin(), strokes.end(),
                            [](const Stroke& s) { return s.layer == Layer::Cut && s.is_closed; }),
              net.n_pieces);
    EXPECT_EQ(std::count_if(strokes.begin(), strokes.end(),
                            [](const Stroke& s) { return s.layer == Layer::Cut && !s.is_closed; }),
              0);
  }
}

TEST(DrawSheets, LeadsTheOutlineRoundTheTabs) {
  for (const testing::ZooShape& shape : testing::zoo()) {
    SCOPED_TRACE(shape.soup.name);
    const Net net = net_of(shape.soup);
    PageLayout layout = arrange(net, {}, {});
    layout.tabs = testing::tabs_everywhere(net, layout.scale);
    testing::widen(layout, 4);
    const std::vector<Sheet> sheets = draw_sheets(net, layout, {});
    std::size_t n_corners = 0;
    double length = 0;
    for (const Stroke& stroke : sheets.front().strokes) {
      if (stroke.layer != Layer::Cut) continue;
      EXPECT_TRUE(stroke.is_closed);
      n_corners += stroke.points.size();
      length += length_of(stroke);
    }
    std::size_t n_sides = 0;
    for (const OutlineLoop& loop : outline_loops(net)) n_sides += loop.sides.size();
    EXPECT_EQ(n_corners, n_sides + 2 * layout.tabs.tabs.size());
    // Each tab replaces its side by two slants of 45 degrees and a shorter rim.
    double expected = 0;
    for (const OutlineLoop& loop : outline_loops(net))
      for (const HalfedgeId h : loop.sides) expected += net.mesh().length(net.mesh().edge(h)) * layout.scale;
    for (const GlueTab& tab : layout.tabs.tabs) expected += 2 * (std::sqrt(2.0) - 1) * tab.width_mm;
    EXPECT_NEAR(length, expected, 1e-6 * expected);
  }
}

TEST(DrawSheets, DrawsAFoldWhereATabBegins) {
  const Net net = net_of(shapes::cube());
  PageLayout layout = arrange(net, {}, {});
  const auto tab_folds = [&](const SheetSettings& settings) {
    std::vector<Stroke> found;
    const std::vector<Sheet> sheets = draw_sheets(net, layout, {}, settings);
    for (const Stroke& stroke : sheets.front().strokes)
      if (stroke.layer == Layer::TabFold) found.push_back(stroke);
    return found;
  };
  EXPECT_TRUE(tab_folds({}).empty());
  layout.tabs = testing::tabs_everywhere(net, layout.scale);
  ASSERT_EQ(tab_folds({}).size(), 14U);
  for (const Stroke& stroke : tab_folds({})) {
    const double period = std::accumulate(stroke.dash_mm.begin(), stroke.dash_mm.end(), 0.0);
    EXPECT_NEAR(std::fmod(length_of(stroke) + 1e-9, period), stroke.dash_mm[0], 1e-6);
  }
}

TEST(DrawSheets, NamesTabFoldsInTheLegendWhereThereAreTabs) {
  const Net net = net_of(shapes::icosphere(2));
  for (const char* format : {"A4", "A5", "A6"}) {
    PageLayout layout = arrange(net, {format, Orientation::Portrait, 10}, {});
    const auto has_entry = [&] {
      const std::vector<Sheet> sheets = draw_sheets(net, layout, {});
      return std::ranges::any_of(sheets.front().texts, [](const Text& t) { return t.words == "tab fold"; });
    };
    EXPECT_FALSE(has_entry());
    layout.tabs = testing::tabs_everywhere(net, layout.scale, 1);
    EXPECT_TRUE(has_entry());
    for (const Sheet& sheet : draw_sheets(net, layout, {})) {
      Sheet margin = sheet;
      std::erase_if(margin.strokes, is_of_net);
      expect_on_paper(margin, layout.frame.printable);
    }
  }
}

TEST(DrawSheets, MarksOnlyTheEndsOfFoldsOnRequest) {
  const Net net = net_of(shapes::cube());
  const PageLayout layout = arrange(net, {}, {});
  SheetSettings settings;
  settings.lines.only_ends = true;
  settings.lines.end_mark_mm = 4;
  int n_marks = 0;
  const std::vector<Sheet> sheets = draw_sheets(net, layout, {}, settings);
  for (const Stroke& stroke : sheets.front().strokes) {
    if (stroke.layer != Layer::Mountain) continue;
    ++n_marks;
    EXPECT_NEAR(length_of(stroke), 4, 1e-9);
  }
  EXPECT_EQ(n_marks, 2 * 5);
}

TEST(DrawSheets, GivesMountainsAndValleysTheirOwnStyle) {
  const Net net = net_of(shapes::star(7));
  const PageLayout layout = arrange(net, {}, {});
  int mountains = 0;
  int valleys = 0;
  const std::vector<Sheet> sheets = draw_sheets(net, layout, {});
  for (const Stroke& stroke : sheets.front().strokes) {
    if (stroke.layer == Layer::Mountain && stroke.dash_mm.size() == 4) ++mountains;
    if (stroke.layer == Layer::Valley && stroke.dash_mm.size() == 2) ++valleys;
  }
  EXPECT_GT(mountains, 0);
  EXPECT_GT(valleys, 0);
}

TEST(DrawSheets, LeavesFlatFoldsOut) {
  const Net net = net_of(shapes::grid_patch(4, 4));
  const std::vector<Sheet> sheets = draw_sheets(net, arrange(net, {}, {}), {});
  for (const Stroke& stroke : sheets.front().strokes)
    EXPECT_TRUE(stroke.layer != Layer::Mountain && stroke.layer != Layer::Valley);
}

TEST(DrawSheets, SaysWhatIsPrintedAndHowLarge) {
  const Net net = net_of(shapes::icosphere(2));
  const std::vector<Sheet> sheets = draw_sheets(net, arrange(net, {}, height(300)), {"Moon", true, 42});
  for (const Sheet& sheet : sheets) {
    std::string all;
    for (const Text& text : sheet.texts) all += text.words + "\n";
    for (const std::string& words :
         {std::string("Moon"), std::string("model 300 mm high"), std::string("80 faces"),
          std::string("seed 42"), std::string("one piece, proved: no overlaps"),
          std::string("Print at 100 %"),
          "page " + std::to_string(sheet.number) + " of " + std::to_string(sheets.size()), sheet.tag,
          std::string("mountain fold"), std::string("valley fold"), std::string("cut")})
      EXPECT_NE(all.find(words), std::string::npos) << words;
  }
}

TEST(DrawSheets, DoesNotClaimAProofThatWasNotMade) {
  const Net net = net_of(shapes::cube());
  const std::vector<Sheet> sheets = draw_sheets(net, arrange(net, {}, {}), {});
  for (const Text& text : sheets.front().texts) EXPECT_EQ(text.words.find(", proved"), std::string::npos);
}

TEST(DrawSheets, DrawsARulerOfExactly100Millimetres) {
  const Net net = net_of(shapes::cube());
  for (const PaperSetup& paper : {PaperSetup{}, PaperSetup{"A6", Orientation::Portrait, 10}}) {
    const std::vector<Sheet> sheets = draw_sheets(net, arrange(net, paper, {}), {});
    const auto& strokes = sheets.front().strokes;
    EXPECT_TRUE(std::any_of(strokes.begin(), strokes.end(), [](const Stroke& s) {
      return s.layer == Layer::Print && s.width_mm == print_style::kRulerWidth &&
             std::abs(length_of(s) - 100) < 1e-9;
    }));
  }
}

TEST(DrawSheets, KeepsTheTestSquareClearOfTheNet) {
  int squares = 0;
  for (const testing::ZooShape& shape : testing::zoo()) {
    const Net net = net_of(shape.soup);
    const std::vector<Sheet> sheets = draw_sheets(net, arrange(net, {}, {}), {});
    for (const Stroke& square : sheets.front().strokes) {
      if (square.layer != Layer::Print || !square.is_closed) continue;
      ++squares;
      EXPECT_NEAR(length_of(square), 200, 1e-9);
      const Box2 box{square.points[0], square.points[2]};
      for (const Stroke& stroke : sheets.front().strokes)
        for (std::size_t i = 0; is_of_net(stroke) && i + 1 < stroke.points.size(); ++i)
          EXPECT_FALSE(clip_segment(box, stroke.points[i], stroke.points[i + 1])) << shape.soup.name;
    }
  }
  EXPECT_GT(squares, 0);
}

TEST(DrawSheets, CarriesDashesOnAcrossTileBorders) {
  const Net net = net_of(shapes::cube());
  const PageLayout layout = arrange(net, {}, height(300));
  int continued = 0;
  for (const Sheet& sheet : draw_sheets(net, layout, {}))
    for (const Stroke& stroke : sheet.strokes) {
      if (stroke.layer != Layer::Mountain || stroke.dash_phase_mm == 0) continue;
      ++continued;
      EXPECT_LT(stroke.dash_phase_mm, 300);
      EXPECT_LE(stroke.dash_phase_mm + length_of(stroke), 300 + 1e-6);
    }
  EXPECT_GT(continued, 0);
}

TEST(FitDash, EndsWithInkAndStaysNearThePattern) {
  for (double length = 4; length < 60; length += 0.37) {
    const auto& pattern = print_style::kMountainDash;
    const std::vector<double> dash = fit_dash(pattern, length);
    ASSERT_EQ(dash.size(), pattern.size()) << length;
    const double period = std::accumulate(dash.begin(), dash.end(), 0.0);
    const double rest = std::fmod(length + 1e-9, period);
    EXPECT_NEAR(rest, dash[0], 1e-6) << "the last dash is whole on an edge of " << length << " mm";
    if (length > 20) {
      EXPECT_NEAR(dash[0] / pattern[0], 1, 0.2);
    }
  }
}

TEST(FitDash, LeavesEdgesSolidThatAreTooShortToShowAPattern) {
  EXPECT_TRUE(fit_dash(print_style::kMountainDash, 1.0).empty());
  EXPECT_TRUE(fit_dash(print_style::kValleyDash, 0.0).empty());
}

TEST(ClipPolyline, CutsAClosedLineIntoTheRunsInsideTheBox) {
  const std::vector<glm::dvec2> square = {{-1, -1}, {3, -1}, {3, 1}, {-1, 1}};
  const ClippedLine clipped = clip_polyline({{0, -2}, {2, 2}}, square, true);
  EXPECT_FALSE(clipped.is_whole);
  ASSERT_EQ(clipped.runs.size(), 2U);
  EXPECT_EQ(clipped.runs[0], (std::vector<glm::dvec2>{{0, -1}, {2, -1}}));
  EXPECT_EQ(clipped.runs[1], (std::vector<glm::dvec2>{{2, 1}, {0, 1}}));
}

TEST(ClipPolyline, KeepsCornersInsideAsOneRunAndTheWholeAsOne) {
  const std::vector<glm::dvec2> square = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  const ClippedLine corner = clip_polyline({{1, 1}, {5, 5}}, square, true);
  ASSERT_EQ(corner.runs.size(), 1U);
  EXPECT_EQ(corner.runs[0], (std::vector<glm::dvec2>{{2, 1}, {2, 2}, {1, 2}}));
  EXPECT_TRUE(clip_polyline({{-1, -1}, {5, 5}}, square, true).is_whole);
  EXPECT_TRUE(clip_polyline({{7, 7}, {9, 9}}, square, true).runs.empty());
}

TEST(Font, MeasuresWordsAndDrawsTheirOutline) {
  const Font font(FontWeight::Regular);
  EXPECT_NEAR(font.width("mm", 4), 2 * font.width("m", 4), 1e-9);
  EXPECT_NEAR(font.width("Scale", 5), 5 * font.width("Scale", 1), 1e-9);
  EXPECT_GT(Font(FontWeight::SemiBold).width("Netwright", 1), font.width("Netwright", 1));
  Box2 box;
  for (const Font::Step& step : font.outline("H", 10, {100, 50}))
    if (step.kind != 'Z') box.add(step.points[0]);
  EXPECT_NEAR(box.max.y, 50, 0.05) << "letters stand on the baseline";
  EXPECT_NEAR(box.min.y, 50 - 7.3, 0.2) << "Inter's capitals are 0.73 em high";
}

TEST(Font, SurvivesAnyBytes) {
  const Font font(FontWeight::Regular);
  for (const std::string& bytes :
       {std::string("\xff\xfe\x80"), std::string("\xe2\x82"), std::string("a\0b", 3),
        std::string("\xed\xa0\x80"), std::string("折り紙")}) {
    EXPECT_GE(font.width(bytes, 3), 0);
    EXPECT_EQ(code_points(clean_utf8(bytes)).size(), code_points(bytes).size());
  }
}

TEST(ShortNumber, ShowsThreeDigitsWithoutNoise) {
  EXPECT_EQ(short_number(1.4321), "1.43");
  EXPECT_EQ(short_number(150), "150");
  EXPECT_EQ(short_number(57.86), "57.9");
  EXPECT_EQ(short_number(0.012345), "0.0123");
  EXPECT_EQ(short_number(1234.5), "1234");
  EXPECT_EQ(short_number(0), "0");
  EXPECT_EQ(decimal_number(-0.00001, 4), "0");
  EXPECT_EQ(decimal_number(12.5, 4), "12.5");
}

}  // namespace
}  // namespace netwright
