// The SVG read back: millimetres, one Inkscape layer per kind of line, dashes as numbers, words as outlines.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>

#include "core/sheet/write.h"
#include "tests/sheet_support.h"

namespace netwright {
namespace {

using testing::net_of;

struct SvgPath {
  std::string data;
  std::string style;
  std::string label;
};

std::string attribute(const std::string& element, const std::string& name) {
  const std::size_t at = element.find(" " + name + "=\"");
  if (at == std::string::npos) return "";
  const std::size_t start = at + name.size() + 3;
  return element.substr(start, element.find('"', start) - start);
}

/// The paths of each layer; also checks that every element is closed again.
std::map<std::string, std::vector<SvgPath>> layers_of(const std::string& svg) {
  std::map<std::string, std::vector<SvgPath>> layers;
  std::string layer;
  int depth = 0;
  for (std::size_t at = svg.find("<svg"); at != std::string::npos; at = svg.find('<', at + 1)) {
    const std::size_t end = svg.find('>', at);
    const std::string element = svg.substr(at, end - at + 1);
    if (element[1] == '/')
      --depth;
    else if (element[element.size() - 2] != '/')
      ++depth;
    if (element.rfind("<g ", 0) == 0) {
      EXPECT_EQ(attribute(element, "inkscape:groupmode"), "layer");
      layer = attribute(element, "inkscape:label");
      layers[layer];
    }
    if (element.rfind("<path", 0) == 0)
      layers[layer].push_back(
          {attribute(element, "d"), attribute(element, "style"), attribute(element, "aria-label")});
  }
  EXPECT_EQ(depth, 0);
  return layers;
}

std::vector<glm::dvec2> points_of(const std::string& data) {
  std::vector<glm::dvec2> points;
  for (std::size_t comma = data.find(','); comma != std::string::npos; comma = data.find(',', comma + 1)) {
    const std::size_t before = data.find_last_not_of("0123456789.-", comma - 1);
    points.emplace_back(std::atof(data.c_str() + before + 1), std::atof(data.c_str() + comma + 1));
  }
  return points;
}

std::string svg_of(const PolygonSoup& soup, const PrintSize& size = {}) {
  const Net net = net_of(soup);
  return svg_bytes(draw_sheets(net, arrange(net, {}, size), {}).front(), "A <b> & \"c\"");
}

TEST(WriteSvg, IsInMillimetresAndNamed) {
  const Net net = net_of(shapes::cube());
  const Sheet sheet = draw_sheets(net, arrange(net, {"A4", Orientation::Portrait, 10}, {}), {}).front();
  const std::string svg = svg_bytes(sheet, "A <b> & \"c\"");
  EXPECT_NE(svg.find("width=\"210mm\" height=\"297mm\" viewBox=\"0 0 210 297\""), std::string::npos);
  EXPECT_NE(svg.find("<title>A &lt;b&gt; &amp; &quot;c&quot;</title>"), std::string::npos);
}

TEST(WriteSvg, HasALayerForEachKindOfLine) {
  const auto layers = layers_of(svg_of(shapes::star(7)));
  ASSERT_EQ(layers.size(), 7U);
  for (const char* const name : {"Print", "Cut", "Fold Mountain", "Fold Valley"})
    EXPECT_FALSE(layers.at(name).empty()) << name;
  EXPECT_TRUE(layers.at("Regmarks").empty()) << "one page needs no registration";
}

TEST(WriteSvg, PutsTheCrossesOfTilesIntoTheirOwnLayer) {
  EXPECT_FALSE(layers_of(svg_of(shapes::cube(), {PrintSize::Kind::Height, 300})).at("Regmarks").empty());
}

TEST(WriteSvg, CutsACubeAlongOneClosedPathOfItsLength) {
  const auto layers = layers_of(svg_of(shapes::cube(), {PrintSize::Kind::Height, 40}));
  ASSERT_EQ(layers.at("Cut").size(), 1U);
  const std::string& data = layers.at("Cut").front().data;
  EXPECT_EQ(data.back(), 'Z');
  const std::vector<glm::dvec2> points = points_of(data);
  ASSERT_EQ(points.size(), 14U);
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_NEAR(glm::length(points[(i + 1) % points.size()] - points[i]), 40, 1e-3);
}

TEST(WriteSvg, DashesFoldsAndNothingElse) {
  const auto layers = layers_of(svg_of(shapes::star(5)));
  const auto is_dashed = [](const SvgPath& path) {
    return path.style.find("stroke-dasharray") != std::string::npos;
  };
  EXPECT_TRUE(std::any_of(layers.at("Fold Mountain").begin(), layers.at("Fold Mountain").end(), is_dashed));
  EXPECT_TRUE(std::any_of(layers.at("Fold Valley").begin(), layers.at("Fold Valley").end(), is_dashed));
  EXPECT_TRUE(std::none_of(layers.at("Cut").begin(), layers.at("Cut").end(), is_dashed));
}

TEST(WriteSvg, GivesEachLayerOfTheNetOneColour) {
  for (const auto& [name, paths] : layers_of(svg_of(shapes::star(7)))) {
    if (name == "Print") continue;
    for (const SvgPath& path : paths)
      EXPECT_EQ(path.style.substr(0, path.style.find(";stroke-width")),
                paths.front().style.substr(0, paths.front().style.find(";stroke-width")));
  }
}

TEST(WriteSvg, DrawsWordsAsOutlines) {
  const std::string svg = svg_of(shapes::cube());
  EXPECT_EQ(svg.find("<text"), std::string::npos);
  bool has_words = false;
  const auto layers = layers_of(svg);
  for (const SvgPath& path : layers.at("Print"))
    if (path.label == "valley fold") {
      has_words = true;
      EXPECT_NE(path.data.find('C'), std::string::npos);
    }
  EXPECT_TRUE(has_words);
}

TEST(WriteSvg, WritesOneFilePerPage) {
  const Net net = net_of(shapes::cube());
  const testing::TemporaryFolder folder;
  const PageLayout layout = arrange(net, {}, {PrintSize::Kind::Height, 300});
  const auto files = write_drawing(folder / "box.svg", net, layout, {}).files;
  ASSERT_EQ(files.size(), layout.pages.size());
  EXPECT_EQ(files[1].filename(), "box_2.svg");
  for (const auto& file : files) EXPECT_EQ(layers_of(read_file(file, 10'000'000)).size(), 7U);
}

TEST(WriteSvg, WritesDashesAsLinesOfTheirOwnOnRequest) {
  const Net net = net_of(shapes::cube());
  const Sheet sheet = draw_sheets(net, arrange(net, {}, {PrintSize::Kind::Height, 40}), {}).front();
  const std::string svg = svg_bytes(sheet, "", {.real_dashes = true});
  EXPECT_EQ(svg.find("stroke-dasharray"), std::string::npos);
  const auto layers = layers_of(svg);
  ASSERT_EQ(layers.at("Fold Mountain").size(), 5U) << "one element for each fold";
  for (const SvgPath& fold : layers.at("Fold Mountain")) {
    const std::vector<glm::dvec2> points = points_of(fold.data);
    ASSERT_GT(points.size(), 20U);
    EXPECT_NEAR(glm::length(points.back() - points.front()), 40, 1e-3) << "ink at both ends";
    EXPECT_EQ(2 * std::ranges::count(fold.data, 'M'), static_cast<int>(points.size()));
  }
}

TEST(WriteSvg, PutsAllSheetsIntoOneFileAsPagesSideBySideOnRequest) {
  const Net net = net_of(shapes::cube());
  const testing::TemporaryFolder folder;
  const PageLayout layout = arrange(net, {}, {PrintSize::Kind::Height, 300});
  const auto files = write_drawing(folder / "box.svg", net, layout, {}, {}, {.is_one_file = true}).files;
  ASSERT_EQ(files.size(), 1U);
  const std::string svg = read_file(files[0], 10'000'000);
  std::size_t n_pages = 0;
  for (std::size_t at = svg.find("<inkscape:page "); at != std::string::npos;
       at = svg.find("<inkscape:page ", at + 1))
    ++n_pages;
  EXPECT_EQ(n_pages, layout.pages.size());
  EXPECT_EQ(layers_of(svg).size(), 7U);
}

TEST(WriteSvg, EmbedsPicturesWhereTheyLie) {
  Sheet sheet;
  auto image = std::make_shared<Image>(Image{2, 1, {255, 0, 0, 255, 0, 0, 255, 255}});
  sheet.pictures.push_back({Layer::Print, {20, 30}, {100, 50}, image});
  const testing::TemporaryFolder folder;
  write_file(folder / "picture.svg", svg_bytes(sheet, "picture"));
  const std::string png = (folder / "picture.png").string();
  testing::output_of(
      {"rsvg-convert", "-w", "210", "-h", "297", "-o", png, (folder / "picture.svg").string()});
  const Image drawn = decode_image(read_file(png, 10'000'000));
  ASSERT_EQ(drawn.width, 210);
  const auto red_and_blue = [&](int x, int y) {
    const std::size_t at = 4 * static_cast<std::size_t>(y * drawn.width + x);
    return std::pair<int, int>(drawn.rgba[at], drawn.rgba[at + 2]);
  };
  EXPECT_EQ(red_and_blue(25, 55), std::pair(255, 0));
  EXPECT_EQ(red_and_blue(115, 55), std::pair(0, 255));
  EXPECT_EQ(red_and_blue(25, 25), std::pair(0, 0)) << "nothing is there";
}

TEST(WriteSvg, TurnsWordsByTheirAngle) {
  Sheet sheet;
  sheet.texts.push_back({Layer::Labels, {50, 100}, "1111", 10, FontWeight::Regular, {0, 0, 0}, 1.5707963268});
  const auto layers = layers_of(svg_bytes(sheet, ""));
  double lowest = 0;
  for (const glm::dvec2 p : points_of(layers.at("Labels").front().data)) {
    EXPECT_GE(p.x, 50 - 0.1);
    EXPECT_LE(p.x, 60);
    lowest = std::max(lowest, p.y);
  }
  EXPECT_GT(lowest, 115) << "down the page";
}

TEST(WriteSvg, KeepsWordsAsTextInItsOwnTypefaceOnRequest) {
  const Net net = net_of(shapes::cube());
  const Sheet sheet = draw_sheets(net, arrange(net, {}, {}), {}).front();
  const std::string svg = svg_bytes(sheet, "", {.live_text = true});
  EXPECT_NE(svg.find(">valley fold</text>"), std::string::npos);
  EXPECT_NE(svg.find("@font-face{font-family:Inter;font-weight:600;src:url(data:font/otf;base64,"),
            std::string::npos);
  EXPECT_EQ(svg_bytes(sheet, "").find("@font-face"), std::string::npos);
}

}  // namespace
}  // namespace netwright
