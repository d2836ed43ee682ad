// The PDF measured from outside, with the tools people have: page size, lengths, dashes and words. And the
// PNG.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "core/base/error.h"
#include "core/sheet/print_preferences.h"
#include "core/sheet/write.h"
#include "tests/sheet_support.h"

namespace netwright {
namespace {

using testing::net_of;
using testing::output_of;
using testing::TemporaryFolder;

constexpr double kMmPerPoint = 25.4 / 72;

struct TracedPath {
  double width_mm = 0;
  std::vector<double> dash_mm;
  std::vector<glm::dvec2> points_mm;
};

std::string attribute(const std::string& line, const std::string& name) {
  const std::size_t at = line.find(" " + name + "=\"");
  if (at == std::string::npos) return "";
  const std::size_t start = at + name.size() + 3;
  return line.substr(start, line.find('"', start) - start);
}

/// Every stroked path as mutool sees it, in mm from the top left.
std::vector<TracedPath> traced(const std::filesystem::path& pdf) {
  std::vector<TracedPath> paths;
  std::istringstream lines(output_of({"mutool", "trace", pdf.string()}));
  bool is_stroke = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("<stroke_path") != std::string::npos) {
      is_stroke = true;
      TracedPath& path = paths.emplace_back();
      path.width_mm = std::atof(attribute(line, "linewidth").c_str()) * kMmPerPoint;
      std::istringstream dash(attribute(line, "dash"));
      for (double part = 0; dash >> part;) path.dash_mm.push_back(part * kMmPerPoint);
      EXPECT_EQ(attribute(line, "transform"), "1 0 0 1 0 0");
    } else if (line.find("</stroke_path") != std::string::npos) {
      is_stroke = false;
    } else if (is_stroke && line.find("to x=") != std::string::npos) {
      paths.back().points_mm.emplace_back(std::atof(attribute(line, "x").c_str()) * kMmPerPoint,
                                          std::atof(attribute(line, "y").c_str()) * kMmPerPoint);
    }
  }
  return paths;
}

class WritePdf : public ::testing::Test {
 protected:
  void write(const PolygonSoup& soup, const PrintSize& size) {
    const Net net = net_of(soup);
    layout_ = arrange(net, {}, size);
    write_drawing(pdf_, net, layout_, {"Test <model> & co", true, 7});
  }

  TemporaryFolder folder_;
  std::filesystem::path pdf_ = folder_ / "net.pdf";
  PageLayout layout_;
};

TEST_F(WritePdf, IsA4AndNamed) {
  write(shapes::icosphere(2), {});
  const std::string info = output_of({"pdfinfo", pdf_.string()});
  EXPECT_NE(info.find("(A4)"), std::string::npos) << info;
  EXPECT_NE(info.find("Test <model> & co"), std::string::npos) << info;
  EXPECT_NE(info.find("Pages:           1\n"), std::string::npos) << info;
}

TEST_F(WritePdf, PrintsAnEdgeAtItsLengthWithinATenthOfAMillimetre) {
  write(shapes::cube(), {PrintSize::Kind::Height, 43});
  int edges = 0;
  for (const TracedPath& path : traced(pdf_)) {
    if (path.dash_mm.size() != 4 || path.points_mm.size() != 2) continue;
    const double length = glm::length(path.points_mm[1] - path.points_mm[0]);
    if (length < 20) continue;  // the legend's sample
    EXPECT_NEAR(length, 43, 0.1);
    ++edges;
  }
  EXPECT_EQ(edges, 5) << "a cube's net has five folds";
}

TEST_F(WritePdf, DrawsTheOutlineOfACubeAsOnePathOfFourteenEdges) {
  write(shapes::cube(), {PrintSize::Kind::Height, 43});
  double longest = 0;
  for (const TracedPath& path : traced(pdf_)) {
    double length = 0;
    for (std::size_t i = 0; i < path.points_mm.size(); ++i)
      length += glm::length(path.points_mm[(i + 1) % path.points_mm.size()] - path.points_mm[i]);
    if (std::abs(path.width_mm - 0.25) < 0.01) longest = std::max(longest, length);
  }
  EXPECT_NEAR(longest, 14 * 43, 0.5);
}

TEST_F(WritePdf, ShowsBothDashPatternsInMillimetres) {
  write(shapes::star(7), {});
  bool has_mountain = false;
  bool has_valley = false;
  for (const TracedPath& path : traced(pdf_)) {
    if (path.dash_mm.size() == 4) has_mountain |= std::abs(path.dash_mm[0] / path.dash_mm[2] - 10) < 0.3;
    if (path.dash_mm.size() == 2) has_valley |= std::abs(path.dash_mm[0] / path.dash_mm[1] - 2 / 1.2) < 0.05;
  }
  EXPECT_TRUE(has_mountain);
  EXPECT_TRUE(has_valley);
}

TEST_F(WritePdf, ContainsARulerOf100Millimetres) {
  write(shapes::cube(), {});
  bool has_ruler = false;
  for (const TracedPath& path : traced(pdf_))
    has_ruler |= path.points_mm.size() == 2 && path.dash_mm.empty() &&
                 std::abs(glm::length(path.points_mm[1] - path.points_mm[0]) - 100) < 0.01;
  EXPECT_TRUE(has_ruler);
}

TEST_F(WritePdf, CanBeSearchedForItsWords) {
  write(shapes::icosphere(2), {PrintSize::Kind::Height, 300});
  ASSERT_GT(layout_.pages.size(), 1U);
  const std::string words = output_of({"pdftotext", "-layout", pdf_.string(), "-"});
  for (std::size_t n = 1; n <= layout_.pages.size(); ++n) {
    const std::string page = "page " + std::to_string(n) + " of " + std::to_string(layout_.pages.size());
    EXPECT_NE(words.find(page), std::string::npos) << page << " in\n" << words;
  }
  for (const char* const expected : {"Test <model> & co", "Scale 1 unit = 1", "model 300 mm high",
                                     "proved: no overlaps", "Print at 100 %", "A1"})
    EXPECT_NE(words.find(expected), std::string::npos) << expected << " in\n" << words;
}

TEST_F(WritePdf, EmbedsItsTypeface) {
  write(shapes::cube(), {});
  const std::string fonts = output_of({"pdffonts", pdf_.string()});
  EXPECT_NE(fonts.find("Inter-Regular"), std::string::npos) << fonts;
  EXPECT_NE(fonts.find("Inter-SemiBold"), std::string::npos) << fonts;
}

TEST_F(WritePdf, AsksViewersNotToShrinkThePage) {
  write(shapes::cube(), {});
  const std::string root = output_of({"mutool", "show", pdf_.string(), "trailer/Root"});
  EXPECT_NE(root.find("/PrintScaling /None"), std::string::npos) << root;
}

TEST_F(WritePdf, AsksPrintersToTurnTheSheetOverWhenThereAreBackPages) {
  std::vector<Sheet> sheets(2);
  const auto root_of = [&] {
    write_file(pdf_, pdf_bytes(sheets, ""));
    return output_of({"mutool", "show", pdf_.string(), "trailer/Root/ViewerPreferences"});
  };
  EXPECT_EQ(root_of().find("/Duplex"), std::string::npos);
  sheets[1].is_back = true;
  EXPECT_NE(root_of().find("/Duplex /DuplexFlipLongEdge"), std::string::npos);
  std::swap(sheets[1].width_mm, sheets[1].height_mm);
  EXPECT_NE(root_of().find("/Duplex /DuplexFlipShortEdge"), std::string::npos);
}

TEST(PrintPreferences, RefuseADamagedFile) {
  try {
    with_print_preferences("%PDF-1.5 and no more", Duplex::None);
    ADD_FAILURE() << "nothing was refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Write);
    EXPECT_NE(std::string(error.what()).find("cannot be finished"), std::string::npos) << error.what();
  }
}

TEST_F(WritePdf, GivesTheSameBytesEachTime) {
  write(shapes::icosphere(2), {});
  const std::string first = read_file(pdf_, 10'000'000);
  write(shapes::icosphere(2), {});
  EXPECT_EQ(first, read_file(pdf_, 10'000'000));
  EXPECT_EQ(first.find("CreationDate"), std::string::npos);
}

TEST_F(WritePdf, LeavesNothingBehindWhenTheFolderIsMissing) {
  const Net net = net_of(shapes::cube());
  const PageLayout layout = arrange(net, {}, {});
  const auto nowhere = folder_ / "missing";
  try {
    write_drawing(nowhere / "net.pdf", net, layout, {});
    ADD_FAILURE() << "nothing was refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Write);
    EXPECT_NE(std::string(error.what()).find("folder does not exist"), std::string::npos) << error.what();
  }
  EXPECT_TRUE(folder_.files().empty());
}

TEST(WriteDrawing, RefusesUnknownEndingsAndNamesTheKnownOnes) {
  const Net net = net_of(shapes::cube());
  try {
    write_drawing("net.docx", net, arrange(net, {}, {}), {});
    ADD_FAILURE() << "nothing was refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Usage);
    for (const ExportFormat& format : export_formats())
      EXPECT_NE(std::string(error.what()).find(format.extension), std::string::npos);
  }
}

TEST(WriteDrawing, TakesEndingsInAnyCase) {
  EXPECT_TRUE(is_export_format("NET.PDF"));
  EXPECT_TRUE(is_export_format("a.b/net.Fold"));
  EXPECT_FALSE(is_export_format("pdf"));
}

TEST(WritePng, HasTheSizeAndTheResolutionOfThePage) {
  const Net net = net_of(shapes::cube());
  Sheet sheet = draw_sheets(net, arrange(net, {"A4", Orientation::Portrait, 10}, {}), {}).front();
  const std::string png = png_bytes(sheet);
  const auto number_at = [&](std::size_t at) {
    unsigned value = 0;
    for (std::size_t i = at; i < at + 4; ++i) value = value * 256 + static_cast<unsigned char>(png[i]);
    return value;
  };
  EXPECT_EQ(number_at(16), 2480U);
  EXPECT_EQ(number_at(20), 3508U);
  const std::size_t chunk = png.find("pHYs");
  ASSERT_NE(chunk, std::string::npos);
  EXPECT_EQ(number_at(chunk + 4), 11811U);
  EXPECT_EQ(number_at(chunk + 8), 11811U);
  const TemporaryFolder folder;
  write_file(folder / "net.png", png);
  const std::string seen = output_of({"identify", "-format", "%w %h %x %U", (folder / "net.png").string()});
  EXPECT_EQ(seen.rfind("2480 3508 118.1", 0), 0U) << seen;
}

TEST(WritePng, HasAsManyDotsPerInchAsAskedFor) {
  const Net net = net_of(shapes::cube());
  const TemporaryFolder folder;
  const PageLayout layout = arrange(net, {"A4", Orientation::Portrait, 10}, {});
  for (const auto& [asked, width] : {std::pair(72, 595), {150, 1240}, {20, 595}}) {
    const auto files = write_drawing(folder / "net.png", net, layout, {}, {}, {.png_dpi = asked}).files;
    EXPECT_EQ(image_size(read_file(files[0], 10'000'000)).width, width) << asked;
  }
}

TEST(WritePng, RefusesMorePixelsThanMemoryHolds) {
  const Net net = net_of(shapes::cube());
  const TemporaryFolder folder;
  const PageLayout layout = arrange(net, {"A0", Orientation::Portrait, 10}, {});
  try {
    write_drawing(folder / "net.png", net, layout, {}, {}, {.png_dpi = 600});
    ADD_FAILURE() << "nothing was refused";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("19866 x 28087 pixels"), std::string::npos) << error.what();
  }
}

TEST(WritePng, NumbersItsPagesWhenThereAreSeveral) {
  const Net net = net_of(shapes::cube());
  const TemporaryFolder folder;
  const PageLayout layout = arrange(net, {"A6", Orientation::Auto, 10}, {PrintSize::Kind::Height, 60});
  const auto files = write_drawing(folder / "net.png", net, layout, {}).files;
  ASSERT_EQ(files.size(), layout.pages.size());
  ASSERT_GT(files.size(), 1U);
  EXPECT_EQ(files[0].filename(), "net_1.png");
  EXPECT_EQ(folder.files().size(), files.size());
}

}  // namespace
}  // namespace netwright
