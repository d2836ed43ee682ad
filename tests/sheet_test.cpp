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

std::string words_of(const Sheet& sheet) {
  std::string all;
  for (const Text& text : sheet.texts) all += text.words + "\n";
  return all;
}

std::vector<Stroke> strokes_on(const Sheet& sheet, Layer layer) {
  std::vector<Stroke> found;
  for (const Stroke& stroke : sheet.strokes)
    if (stroke.layer == layer) found.push_back(stroke);
  return found;
}

/// The stroke's points with left and right exchanged about the middle of the paper.
std::vector<glm::dvec2> turned_over(const Sheet& sheet, const Stroke& stroke) {
  std::vector<glm::dvec2> points = stroke.points;
  for (glm::dvec2& p : points) p.x = sheet.width_mm - p.x;
  return points;
}

void expect_same_points(const std::vector<glm::dvec2>& a, const std::vector<glm::dvec2>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_LT(glm::length(a[i] - b[i]), 1e-9);
}

TEST(PrintedSides, TheInsideIsMirroredAndItsMountainsAreValleys) {
  const Net net = net_of(shapes::star(7));
  const PageLayout layout = arrange(net, {}, {});
  SheetSettings settings;
  const std::vector<Sheet> outside = draw_sheets(net, layout, {}, settings);
  settings.printed_side = PrintedSide::Inside;
  const std::vector<Sheet> inside = draw_sheets(net, layout, {}, settings);
  ASSERT_EQ(inside.size(), outside.size());
  EXPECT_FALSE(inside[0].is_back);
  EXPECT_EQ(strokes_on(inside[0], Layer::Mountain).size(), strokes_on(outside[0], Layer::Valley).size());
  EXPECT_EQ(strokes_on(inside[0], Layer::Valley).size(), strokes_on(outside[0], Layer::Mountain).size());
  for (const Stroke& stroke : strokes_on(inside[0], Layer::Valley))
    EXPECT_EQ(stroke.colour, settings.lines.valley.colour);
  // The net's frame lies in the middle of an A4 page, so that mirroring it is turning the page over.
  expect_same_points(turned_over(outside[0], strokes_on(outside[0], Layer::Cut)[0]),
                     strokes_on(inside[0], Layer::Cut)[0].points);
  EXPECT_NE(words_of(inside[0]).find("inside"), std::string::npos);
  EXPECT_NE(words_of(outside[0]).find("The printed side is the outside."), std::string::npos);
}

TEST(PrintedSides, FrontAndBackRegisterWhenTheSheetIsTurnedOver) {
  const Net net = net_of(shapes::icosphere(2));
  for (const PaperSetup& paper : {PaperSetup{}, PaperSetup{"A6", Orientation::Portrait, 10},
                                  PaperSetup{"A4", Orientation::Landscape, 10}})
    for (const double mm : {60.0, 300.0}) {
      const PageLayout layout = arrange(net, paper, height(mm));
      SheetSettings settings;
      settings.printed_side = PrintedSide::Both;
      const std::vector<Sheet> sheets = draw_sheets(net, layout, {}, settings);
      ASSERT_EQ(sheets.size(), 2 * layout.pages.size());
      for (std::size_t i = 0; i < sheets.size(); i += 2) {
        const Sheet& front = sheets[i];
        const Sheet& back = sheets[i + 1];
        EXPECT_FALSE(front.is_back);
        EXPECT_TRUE(back.is_back);
        EXPECT_EQ(front.tag, back.tag);
        const std::vector<Stroke> cuts = strokes_on(front, Layer::Cut);
        const std::vector<Stroke> behind = strokes_on(back, Layer::Cut);
        ASSERT_EQ(cuts.size(), behind.size());
        for (std::size_t k = 0; k < cuts.size(); ++k)
          expect_same_points(turned_over(front, cuts[k]), behind[k].points);
        EXPECT_TRUE(strokes_on(front, Layer::Mountain).empty()) << "the front shows no marks";
        const Box2 p = layout.frame.printable;
        expect_on_paper(front, p);
        expect_on_paper(back, {{front.width_mm - p.max.x, p.min.y}, {front.width_mm - p.min.x, p.max.y}});
      }
      EXPECT_NE(words_of(sheets[0]).find("outside"), std::string::npos);
      EXPECT_NE(words_of(sheets[0]).find(layout.frame.is_landscape() ? "short edge" : "long edge"),
                std::string::npos);
      EXPECT_NE(words_of(sheets[1]).find("inside"), std::string::npos);
    }
}

TEST(PrintedSides, LabelsOnTheReverseLieBehindTheirPlaces) {
  const Net net = net_of(shapes::icosphere(2));
  const PageLayout layout = arrange(net, {}, {});
  SheetSettings settings;
  const std::vector<Sheet> plain = draw_sheets(net, layout, {}, settings);
  settings.labels.on_reverse = true;
  const std::vector<Sheet> sheets = draw_sheets(net, layout, {}, settings);
  ASSERT_EQ(sheets.size(), 2U);
  const auto labels = [](const Sheet& sheet) {
    std::vector<Text> found;
    for (const Text& text : sheet.texts)
      if (text.layer == Layer::Labels) found.push_back(text);
    return found;
  };
  EXPECT_TRUE(labels(sheets[0]).empty());
  EXPECT_TRUE(std::ranges::none_of(sheets[1].strokes, is_of_net));
  ASSERT_EQ(labels(sheets[1]).size(), labels(plain[0]).size());
  const Font font(FontWeight::Regular);
  const auto centre = [&](const Text& text) {
    const glm::dvec2 half(font.width(text.words, text.size_mm) / 2, -0.37 * text.size_mm);
    return text.at + Rigid2::rotation(text.angle_rad).rotate(half);
  };
  for (std::size_t i = 0; i < labels(plain[0]).size(); ++i) {
    const Text front = labels(plain[0])[i];
    const Text back = labels(sheets[1])[i];
    EXPECT_EQ(front.words, back.words);
    const glm::dvec2 behind(plain[0].width_mm - centre(front).x, centre(front).y);
    EXPECT_LT(glm::length(behind - centre(back)), 1e-6);
    EXPECT_NEAR(front.angle_rad, -back.angle_rad, 1e-12);
  }
}

TEST(PrintedSides, MirroredTilesNameTheNeighboursThatLieThere) {
  const Net net = net_of(shapes::cube());
  const PageLayout layout = arrange(net, {"A4", Orientation::Portrait, 10}, height(150));
  SheetSettings settings;
  settings.printed_side = PrintedSide::Inside;
  const std::vector<Sheet> outside = draw_sheets(net, layout, {});
  const std::vector<Sheet> inside = draw_sheets(net, layout, {}, settings);
  int n_exchanged = 0;
  const auto place_of = [](const Sheet& sheet, const std::string& tag) -> std::optional<glm::dvec2> {
    for (const Text& text : sheet.texts)
      if (text.words == "glue " + tag + " here" || text.words == "cut off, glue on " + tag) return text.at;
    return std::nullopt;
  };
  for (std::size_t i = 0; i < inside.size(); ++i)
    for (const PageLayout::Page& other : layout.pages) {
      if (other.canvas != layout.pages[i].canvas || other.row != layout.pages[i].row) continue;
      if (std::abs(other.column - layout.pages[i].column) != 1) continue;
      const auto before = place_of(outside[i], other.tag);
      const auto after = place_of(inside[i], other.tag);
      ASSERT_TRUE(before && after);
      EXPECT_NEAR(before->x, 210 - after->x, 3);
      ++n_exchanged;
    }
  EXPECT_GT(n_exchanged, 0);
}

TEST(DrawSheets, PrintsEverythingInGreyOnRequest) {
  const Net net = net_of(shapes::star(7));
  SheetSettings settings;
  settings.is_grey = true;
  settings.words.picture = std::make_shared<const Image>(Image{1, 1, {200, 0, 0, 255}});
  const auto expect_grey = [](const glm::dvec3& c) {
    EXPECT_NEAR(c.r, c.g, 1e-12);
    EXPECT_NEAR(c.g, c.b, 1e-12);
  };
  for (const Sheet& sheet : draw_sheets(net, arrange(net, {}, {}), {"", true, {}}, settings)) {
    for (const Stroke& stroke : sheet.strokes) expect_grey(stroke.colour);
    for (const Fill& fill : sheet.fills) expect_grey(fill.colour);
    for (const Text& text : sheet.texts) expect_grey(text.colour);
    ASSERT_EQ(sheet.pictures.size(), 1U);
    EXPECT_EQ(sheet.pictures[0].image->rgba, (std::vector<std::uint8_t>{43, 43, 43, 255}));
  }
}

TEST(DrawSheets, HidesAndShowsSingleFolds) {
  const Net net = net_of(shapes::grid_cube(3));
  const PageLayout layout = arrange(net, {}, {});
  SheetSettings settings;
  const auto n_folds = [&] {
    const std::vector<Sheet> sheets = draw_sheets(net, layout, {}, settings);
    return strokes_on(sheets[0], Layer::Mountain).size() + strokes_on(sheets[0], Layer::Valley).size();
  };
  const std::size_t usual = n_folds();
  const IdVector<EdgeId, EdgeKind> kinds = edge_kinds(net);
  for (const EdgeId e : net.mesh().edges()) {
    if (kinds[e] == EdgeKind::Flat && settings.shown_folds.empty()) settings.shown_folds.push_back(e);
    if (kinds[e] == EdgeKind::Mountain && settings.hidden_folds.size() < 2)
      settings.hidden_folds.push_back(e);
  }
  ASSERT_EQ(settings.shown_folds.size(), 1U);
  ASSERT_EQ(settings.hidden_folds.size(), 2U);
  EXPECT_EQ(n_folds(), usual - 1);
  settings.lines.flat_below_rad = 2;
  EXPECT_EQ(n_folds(), 1U) << "the one that is shown though flat";
}

TEST(DrawSheets, PrintsTheUsersWordsAndPictureBesideTheNet) {
  const auto picture = std::make_shared<const Image>(Image{4, 2, std::vector<std::uint8_t>(32, 200)});
  SheetSettings settings;
  settings.words = {"My moon", "Ada Lovelace", "Use strong paper and a bone folder, and begin at the top.",
                    picture};
  for (const testing::ZooShape& shape : testing::zoo()) {
    if (!shape.is_closed) continue;
    const Net net = net_of(shape.soup);
    const PageLayout layout = arrange(net, {}, {PrintSize::Kind::Height, 40});
    const std::vector<Sheet> sheets = draw_sheets(net, layout, {"", true, 5}, settings);
    expect_on_paper(sheets[0], layout.frame.printable);
    EXPECT_NE(words_of(sheets[0]).find("My moon"), std::string::npos);
    EXPECT_NE(words_of(sheets[0]).find("by Ada Lovelace"), std::string::npos);
    EXPECT_NE(words_of(sheets[0]).find("bone folder"), std::string::npos) << words_of(sheets[0]);
    for (const Picture& p : sheets[0].pictures) {
      EXPECT_NEAR(p.size_mm.x, 2 * p.size_mm.y, 1e-9);
      for (const Stroke& stroke : sheets[0].strokes)
        for (std::size_t i = 0; is_of_net(stroke) && i + 1 < stroke.points.size(); ++i)
          EXPECT_FALSE(clip_segment({p.at, p.at + p.size_mm}, stroke.points[i], stroke.points[i + 1]));
    }
  }
}

TEST(DrawSheets, KeepsTheUsersNoteWhereNothingIsFreeBesideTheNet) {
  SheetSettings settings;
  settings.words.note = "Begin here";
  const Net net = net_of(shapes::icosphere(2));
  const PageLayout layout = arrange(net, {}, height(700));
  const std::vector<Sheet> sheets = draw_sheets(net, layout, {}, settings);
  EXPECT_NE(words_of(sheets[0]).find("Begin here"), std::string::npos);
  EXPECT_EQ(words_of(sheets[1]).find("Begin here"), std::string::npos);
}

TEST(LineStyles, PresetsTellMountainsFromValleys) {
  const LineStyles origami = line_styles(LinePreset::Origami);
  EXPECT_EQ(origami.mountain.dash_mm.size(), 4U);
  EXPECT_EQ(origami.valley.dash_mm.size(), 2U);
  EXPECT_EQ(origami.cut.width_mm, 0.25);
  EXPECT_EQ(origami.valley.width_mm, 0.18);
  const LineStyles kit = line_styles(LinePreset::Kit);
  EXPECT_EQ(kit.mountain.dash_mm, origami.valley.dash_mm);
  EXPECT_EQ(kit.valley.dash_mm, origami.mountain.dash_mm);
  EXPECT_TRUE(line_styles(LinePreset::SolidDash).mountain.dash_mm.empty());
  EXPECT_FALSE(line_styles(LinePreset::SolidDash).valley.dash_mm.empty());
  const LineStyles cutter = line_styles(LinePreset::Cutter);
  for (const PrintedLine* line : {&cutter.cut, &cutter.mountain, &cutter.valley, &cutter.tab_fold})
    EXPECT_TRUE(line->dash_mm.empty());
  EXPECT_NE(cutter.mountain.colour, cutter.valley.colour);
  EXPECT_NE(cutter.mountain.colour, cutter.cut.colour);
}

TEST(FitDash, TakesPatternsThatAPersonTypes) {
  EXPECT_TRUE(fit_dash(std::vector<double>{0, 0}, 50).empty()) << "nothing to draw is a line";
  EXPECT_TRUE(fit_dash(std::vector<double>{-1, 2}, 50).empty());
  const std::vector<double> odd = fit_dash(std::vector<double>{3}, 50);
  ASSERT_EQ(odd.size(), 2U) << "three of ink, three of nothing";
  EXPECT_NEAR(std::fmod(50 + 1e-9, odd[0] + odd[1]), odd[0], 1e-6);
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
