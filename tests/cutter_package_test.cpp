// The cutter's files: the marks where machines look for them, the same in all files, and a check that notices
// what would spoil a sheet of card.
#include "core/sheet/cutter_package.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "core/base/error.h"
#include "core/sheet/write.h"
#include "tests/sheet_support.h"

namespace netwright {
namespace {

using testing::net_of;
using testing::output_of;

constexpr std::array<CutterPreset, 3> kPresets = {CutterPreset::Silhouette, CutterPreset::Cricut,
                                                  CutterPreset::Laser};

struct Drawn {
  Net net;
  PageLayout layout;
  std::vector<Sheet> sheets;
};

Drawn drawn(const PolygonSoup& soup, CutterPreset preset, const PaperSetup& paper = {},
            const PrintSize& size = {}) {
  Drawn result{net_of(soup), {}, {}};
  result.layout = arrange(result.net, cutter_paper(paper, preset), size);
  result.sheets = draw_sheets(result.net, result.layout, {});
  return result;
}

int count(const Sheet& sheet, Layer layer) {
  return static_cast<int>(std::ranges::count(sheet.strokes, layer, &Stroke::layer) +
                          std::ranges::count(sheet.texts, layer, &Text::layer));
}

std::string sentence_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(CutterSheets, HaveTheMarksThatSilhouettesLookFor) {
  const Drawn d = drawn(shapes::star(7), CutterPreset::Silhouette, {"A4", Orientation::Portrait, 10});
  const Sheet cut = cutter_sheets(d.sheets[0], d.layout, CutterPreset::Silhouette).cut;
  ASSERT_EQ(cut.fills.size(), 1U);
  EXPECT_EQ(cut.fills[0].points.front(), glm::dvec2(10, 10));
  EXPECT_EQ(cut.fills[0].points[2], glm::dvec2(15, 15));
  std::vector<glm::dvec2> corners;
  for (const Stroke& stroke : cut.strokes)
    if (stroke.layer == Layer::Regmarks) corners.push_back(stroke.points[1]);
  ASSERT_EQ(corners.size(), 2U);
  EXPECT_EQ(corners[0] - glm::dvec2(10, 10), glm::dvec2(190, 0));
  EXPECT_EQ(corners[1] - glm::dvec2(10, 10), glm::dvec2(0, 277));
}

TEST(CutterSheets, PartWhatIsPrintedFromWhatIsCut) {
  for (const CutterPreset preset : {CutterPreset::Silhouette, CutterPreset::Cricut}) {
    Drawn d = drawn(shapes::star(7), preset);
    d.sheets[0].texts.push_back({Layer::Labels, d.layout.frame.net.centre(), "12"});
    const CutterSheets parts = cutter_sheets(d.sheets[0], d.layout, preset);
    EXPECT_EQ(count(parts.print, Layer::Cut) + count(parts.print, Layer::Mountain), 0);
    EXPECT_EQ(count(parts.print, Layer::Labels), count(d.sheets[0], Layer::Labels));
    EXPECT_EQ(count(parts.cut, Layer::Labels), 0);
    EXPECT_EQ(count(parts.cut, Layer::Cut), count(d.sheets[0], Layer::Cut));
    EXPECT_EQ(count(parts.print, Layer::Print), 0) << "words beside a mark confuse the camera";
    EXPECT_TRUE(parts.cut.pictures.empty());
  }
}

TEST(CutterSheets, CarryTheSameMarks) {
  for (const CutterPreset preset : kPresets) {
    const Drawn d = drawn(shapes::star(5), preset);
    const CutterSheets parts = cutter_sheets(d.sheets[0], d.layout, preset);
    std::vector<std::vector<glm::dvec2>> marks[2];
    for (int i = 0; i < 2; ++i)
      for (const Stroke& stroke : (i == 0 ? parts.print : parts.cut).strokes)
        if (stroke.layer == Layer::Regmarks) marks[i].push_back(stroke.points);
    EXPECT_EQ(marks[0], marks[1]);
    EXPECT_GE(marks[0].size(), 2U);
  }
}

TEST(CutterSheets, GiveLasersHairlinesInPureColours) {
  const Drawn d = drawn(shapes::star(7), CutterPreset::Laser);
  for (const Stroke& stroke : cutter_sheets(d.sheets[0], d.layout, CutterPreset::Laser).cut.strokes) {
    if (stroke.layer == Layer::Regmarks) continue;
    EXPECT_LT(stroke.width_mm, 0.03);
    EXPECT_TRUE(stroke.dash_mm.empty());
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(stroke.colour[i] == 0 || stroke.colour[i] == 1);
  }
}

class CheckCutFiles : public ::testing::Test {
 protected:
  CheckCutFiles() {
    const Drawn d = drawn(shapes::star(7), CutterPreset::Silhouette);
    cut_ = cutter_sheets(d.sheets[0], d.layout, CutterPreset::Silhouette).cut;
    svg_ = svg_bytes(cut_, "star", {.real_dashes = true});
    dxf_ = dxf_bytes(std::span(&cut_, 1), {.real_dashes = true});
  }
  [[nodiscard]] std::string verdict() const {
    return sentence_of([&] { check_cut_files(cut_, svg_, dxf_); });
  }
  static void replace_last(std::string& text, const std::string& what, const std::string& with) {
    const std::size_t at = text.rfind(what);
    ASSERT_NE(at, std::string::npos);
    text.replace(at, what.size(), with);
  }

  Sheet cut_;
  std::string svg_, dxf_;
};

TEST_F(CheckCutFiles, PassesWhatTheWritersWrote) { EXPECT_EQ(verdict(), ""); }

TEST_F(CheckCutFiles, NoticesAnOpenOutlineInTheSvg) {
  replace_last(svg_, " Z\"", "\"");
  EXPECT_NE(verdict().find("SVG failed its check: one of the outlines is not closed"), std::string::npos);
}

TEST_F(CheckCutFiles, NoticesAnOpenOutlineInTheDxf) {
  replace_last(dxf_, "\n70\n1\n", "\n70\n0\n");
  EXPECT_NE(verdict().find("DXF failed its check: one of the outlines is not closed"), std::string::npos);
}

TEST_F(CheckCutFiles, NoticesACornerThatMovedAndOneThatIsMissing) {
  const std::string good = dxf_;
  const std::size_t vertex = dxf_.rfind("VERTEX\n8\nCUT\n10\n");
  ASSERT_NE(vertex, std::string::npos);
  dxf_.insert(vertex + 16, "1");
  EXPECT_NE(verdict().find("lies elsewhere"), std::string::npos);
  dxf_ = good;
  dxf_.replace(vertex, 6, "POINT ");
  EXPECT_NE(verdict().find("lies elsewhere"), std::string::npos);
}

TEST_F(CheckCutFiles, NoticesAMissingMark) {
  replace_last(dxf_, "SEQEND\n8\nREG", "SEQEND\n8\nREG\n0\nPOLYLINE\n8\nREG");
  EXPECT_NE(verdict().find("registration marks"), std::string::npos);
}

TEST_F(CheckCutFiles, RefusesAnOutlineThatNobodyCanCutOut) {
  for (Stroke& stroke : cut_.strokes) stroke.is_closed = false;
  EXPECT_NE(verdict().find("use larger paper"), std::string::npos);
}

TEST(CutterPackage, WritesWhatIsPrintedAndWhatIsCutIntoOneFolder) {
  for (const CutterPreset preset : kPresets) {
    const testing::TemporaryFolder folder;
    const Drawn d = drawn(shapes::cube(), preset, {}, {PrintSize::Kind::Height, 40});
    const CutterPackage package =
        write_cutter_package(folder / "cut me", d.net, d.layout, {"Box/1", false, {}}, {}, {}, preset);
    ASSERT_EQ(package.files.size(), 3U);
    EXPECT_EQ(package.files[0], folder / "cut me/Box_1-print.pdf");
    EXPECT_EQ(package.files[1].filename(), "Box_1-cut.svg");
    EXPECT_EQ(package.files[2].filename(), "Box_1-cut.dxf");
    EXPECT_NE(output_of({"pdfinfo", package.files[0].string()}).find("(A4)"), std::string::npos);
    EXPECT_TRUE(package.notes.empty());
  }
}

TEST(CutterPackage, PrintsItsMarksWhereTheCutFileHasThem) {
  const testing::TemporaryFolder folder;
  const Drawn d = drawn(shapes::cube(), CutterPreset::Silhouette, {"A4", Orientation::Portrait, 10});
  const auto files = write_cutter_package(folder / "out", d.net, d.layout, {"box", false, {}}, {}, {},
                                          CutterPreset::Silhouette)
                         .files;
  // 10 mm are 28.3465 points, 190 mm further 566.929, from the top down as mutool counts.
  const std::string trace = output_of({"mutool", "trace", files[0].string()});
  EXPECT_NE(trace.find("x=\"28.34"), std::string::npos);
  EXPECT_NE(trace.find("x=\"566.9"), std::string::npos) << trace;
}

TEST(CutterPackage, NumbersTheSheetsToCut) {
  const testing::TemporaryFolder folder;
  const Drawn d = drawn(shapes::combined(shapes::cube(), shapes::cube(), {5, 0, 0}), CutterPreset::Laser, {},
                        {PrintSize::Kind::Height, 50});
  ASSERT_EQ(d.layout.pages.size(), 2U);
  const auto files =
      write_cutter_package(folder / "out", d.net, d.layout, {"two", false, {}}, {}, {}, CutterPreset::Laser)
          .files;
  ASSERT_EQ(files.size(), 5U);
  EXPECT_EQ(files[3].filename(), "two-cut_2.svg");
}

TEST(CutterPackage, RefusesPiecesThatAreLargerThanTheSheet) {
  const testing::TemporaryFolder folder;
  const Drawn d = drawn(shapes::cube(), CutterPreset::Laser, {}, {PrintSize::Kind::Height, 300});
  const std::string sentence = sentence_of(
      [&] { write_cutter_package(folder / "out", d.net, d.layout, {}, {}, {}, CutterPreset::Laser); });
  EXPECT_NE(sentence.find("larger than the paper"), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("--split-to-fit"), std::string::npos) << "it names the cure: " << sentence;
  EXPECT_TRUE(folder.files().empty());
}

TEST(CutterPackage, RefusesToPrintTheNetOverAMark) {
  const testing::TemporaryFolder folder;
  Drawn d = drawn(shapes::cube(), CutterPreset::Silhouette);
  // Moves a corner of the outline into the middle of the square, on a page that clips nothing.
  const auto outline = std::ranges::find(d.sheets[0].strokes, Layer::Cut, &Stroke::layer);
  d.layout.pages[0].origin += outline->points[0] - glm::dvec2(12.5) - d.layout.frame.net.min - 500.0;
  d.layout.frame.net = {glm::dvec2(-500), glm::dvec2(500)};
  const std::string sentence = sentence_of(
      [&] { write_cutter_package(folder / "out", d.net, d.layout, {}, {}, {}, CutterPreset::Silhouette); });
  EXPECT_NE(sentence.find("covers a registration mark on sheet 1"), std::string::npos) << sentence;
}

TEST(CutterPackage, TellsWhatIsTooLargeForCricutsPrintThenCut) {
  const testing::TemporaryFolder folder;
  const Drawn d = drawn(shapes::cube(), CutterPreset::Cricut);
  const auto notes =
      write_cutter_package(folder / "out", d.net, d.layout, {}, {}, {}, CutterPreset::Cricut).notes;
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_NE(notes[0].find("9.25 x 6.75 inches"), std::string::npos);
}

}  // namespace
}  // namespace netwright
