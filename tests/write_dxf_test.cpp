// The DXF read back by ezdxf, as a cutter's program would: layers, closed outlines, lengths in millimetres.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "core/sheet/write.h"
#include "tests/sheet_support.h"

namespace netwright {
namespace {

using testing::net_of;
using testing::output_of;

struct Shape {
  std::string layer;
  std::string kind;
  bool is_closed = false;
  int n_points = 0;
  double length = 0;
  double left = 0, bottom = 0, right = 0, top = 0;
};

struct Drawing {
  int units = 0;
  int errors = -1;
  std::vector<std::string> layers;
  std::vector<Shape> shapes;
  std::vector<std::string> texts;

  [[nodiscard]] std::vector<Shape> on(const std::string& layer) const {
    std::vector<Shape> found;
    for (const Shape& shape : shapes)
      if (shape.layer == layer) found.push_back(shape);
    return found;
  }
};

Drawing read_back(const std::string& dxf) {
  const testing::TemporaryFolder folder;
  write_file(folder / "net.dxf", dxf);
  std::istringstream lines(
      output_of({"/usr/bin/python3", NETWRIGHT_TESTS "/read_dxf.py", (folder / "net.dxf").string()}));
  Drawing drawing;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string what;
    words >> what;
    if (what == "units") words >> drawing.units;
    if (what == "errors") words >> drawing.errors;
    if (what == "layer") words >> drawing.layers.emplace_back();
    if (what == "text") drawing.texts.push_back(line);
    if (what != "shape") continue;
    Shape& s = drawing.shapes.emplace_back();
    words >> s.layer >> s.kind >> s.is_closed >> s.n_points >> s.length >> s.left >> s.bottom >> s.right >>
        s.top;
  }
  return drawing;
}

std::vector<Sheet> sheets_of(const PolygonSoup& soup, const PrintSize& size = {}) {
  const Net net = net_of(soup);
  return draw_sheets(net, arrange(net, {}, size), {});
}

TEST(WriteDxf, IsInMillimetresAndSoundWithALayerForEachKindOfLine) {
  const Drawing drawing = read_back(dxf_bytes(sheets_of(shapes::star(7))));
  EXPECT_EQ(drawing.units, 4);
  EXPECT_EQ(drawing.errors, 0);
  for (const char* const name : {"CUT", "FOLD_M", "FOLD_V", "FOLD_TAB", "REG", "LABEL"})
    EXPECT_EQ(std::ranges::count(drawing.layers, name), 1) << name;
  EXPECT_FALSE(drawing.on("FOLD_M").empty());
  EXPECT_FALSE(drawing.on("FOLD_V").empty());
}

TEST(WriteDxf, CutsACubeAlongOneClosedPolylineOfItsLength) {
  const Drawing drawing = read_back(dxf_bytes(sheets_of(shapes::cube(), {PrintSize::Kind::Height, 40})));
  ASSERT_EQ(drawing.on("CUT").size(), 1U);
  const Shape outline = drawing.on("CUT").front();
  EXPECT_EQ(outline.kind, "POLYLINE");
  EXPECT_TRUE(outline.is_closed);
  EXPECT_EQ(outline.n_points, 14);
  EXPECT_NEAR(outline.length, 14 * 40, 1e-4);
  ASSERT_EQ(drawing.on("FOLD_M").size(), 5U);
  for (const Shape& fold : drawing.on("FOLD_M")) EXPECT_NEAR(fold.length, 40, 1e-5);
}

TEST(WriteDxf, HasTheUpperEdgeOfThePaperUp) {
  const std::vector<Sheet> sheets = sheets_of(shapes::star(5));
  const auto cut = std::ranges::find(sheets[0].strokes, Layer::Cut, &Stroke::layer);
  double least_y = 1e9;
  for (const glm::dvec2 p : cut->points) least_y = std::min(least_y, p.y);
  const Drawing drawing = read_back(dxf_bytes(sheets));
  EXPECT_NEAR(drawing.on("CUT").front().top, sheets[0].height_mm - least_y, 1e-5);
}

TEST(WriteDxf, WritesDashesAsLinesOfTheirOwnOnRequest) {
  const std::vector<Sheet> sheets = sheets_of(shapes::cube(), {PrintSize::Kind::Height, 40});
  const Drawing drawing = read_back(dxf_bytes(sheets, {.real_dashes = true}));
  double ink = 0;
  for (const Shape& dash : drawing.on("FOLD_M")) {
    EXPECT_LT(dash.length, 4);
    ink += dash.length;
  }
  EXPECT_GT(drawing.on("FOLD_M").size(), 5 * 10U);
  // Of 3.0 ink, 0.9 gap, 0.3 ink, 0.9 gap some 65 percent is ink, and each fold ends with a dash.
  EXPECT_NEAR(ink / (5 * 40), 3.3 / 5.1, 0.05);
  EXPECT_TRUE(drawing.on("CUT").front().is_closed);
}

TEST(WriteDxf, WritesWordsAsOutlinesOrAsText) {
  Sheet sheet;
  sheet.texts.push_back({Layer::Labels, {50, 100}, "12 ü", 10, FontWeight::Regular, {0, 0, 0}, 0});
  const Drawing outlines = read_back(dxf_bytes(std::span(&sheet, 1)));
  ASSERT_GE(outlines.on("LABEL").size(), 5U) << "two digits, a letter and its two dots, with holes if any";
  for (const Shape& letter : outlines.on("LABEL")) {
    EXPECT_TRUE(letter.is_closed);
    EXPECT_GT(letter.left, 49);
    EXPECT_LT(letter.right, 80);
    EXPECT_GE(letter.bottom, 297 - 100 - 0.5);
    EXPECT_LE(letter.top, 297 - 100 + 10);
  }
  const Drawing text = read_back(dxf_bytes(std::span(&sheet, 1), {.live_text = true}));
  ASSERT_EQ(text.texts.size(), 1U);
  EXPECT_NE(text.texts[0].find("12 "), std::string::npos);
  EXPECT_TRUE(text.on("LABEL").empty());
}

TEST(WriteDxf, TurnsWordsUpwardsOnThePage) {
  Sheet sheet;
  sheet.texts.push_back(
      {Layer::Labels, {50, 100}, "1111", 10, FontWeight::Regular, {0, 0, 0}, -1.5707963268});
  for (const Shape& letter : read_back(dxf_bytes(std::span(&sheet, 1))).on("LABEL")) {
    EXPECT_GT(letter.right, 42 - 1.0);
    EXPECT_LT(letter.right, 51);
    EXPECT_GE(letter.bottom, 197) << "the words run up from their start";
  }
}

TEST(WriteDxf, PutsSeveralSheetsSideBySideOnRequest) {
  const Net net = net_of(shapes::cube());
  const testing::TemporaryFolder folder;
  const PageLayout layout = arrange(net, {}, {PrintSize::Kind::Height, 300});
  ASSERT_GT(layout.pages.size(), 1U);
  EXPECT_EQ(write_drawing(folder / "many.dxf", net, layout, {}).files.size(), layout.pages.size());
  const auto files = write_drawing(folder / "one.dxf", net, layout, {}, {}, {.is_one_file = true}).files;
  ASSERT_EQ(files.size(), 1U);
  EXPECT_EQ(files[0].filename(), "one.dxf");
  double right = 0;
  for (const Shape& mark : read_back(read_file(files[0], 10'000'000)).on("REG"))
    right = std::max(right, mark.right);
  EXPECT_GT(right, (layout.frame.width_mm + 10) * static_cast<double>(layout.pages.size() - 1));
}

TEST(WriteDxf, GivesTheSameBytesEachTime) {
  EXPECT_EQ(dxf_bytes(sheets_of(shapes::icosphere(2))), dxf_bytes(sheets_of(shapes::icosphere(2))));
}

}  // namespace
}  // namespace netwright
