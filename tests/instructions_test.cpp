// The page of instructions: figures that can be checked by hand, pictures that lie in their boxes and show
// what is near, and a page that goes before or behind the sheets.
#include "core/sheet/instructions.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/polygon2.h"
#include "core/sheet/font.h"
#include "core/sheet/write.h"
#include "tests/sheet_support.h"

namespace netwright {
namespace {

using testing::net_of;
using testing::output_of;

struct Printed {
  Net net;
  PageLayout layout;
};

Printed printed(const PolygonSoup& soup, const PrintSize& size = {}) {
  Net net = net_of(soup);
  PageLayout layout = arrange(net, {}, size);
  return {std::move(net), std::move(layout)};
}

TEST(BuildFigures, CountACube) {
  const Printed cube = printed(shapes::cube(), {PrintSize::Kind::Height, 40});
  const BuildFigures figures = build_figures(cube.net, cube.layout, {});
  EXPECT_EQ(figures.n_mountains, 5);
  EXPECT_EQ(figures.n_valleys, 0);
  EXPECT_NEAR(figures.fold_mm, 200, 1e-9);
  EXPECT_EQ(figures.n_cuts, 7);
  EXPECT_NEAR(figures.cut_mm, 280, 1e-9);
  EXPECT_NEAR(figures.outline_mm, 560, 1e-9);
  EXPECT_EQ(figures.n_corners, 14);
  EXPECT_NEAR(figures.shortest_cut_mm, 40, 1e-9);
  EXPECT_NEAR(figures.cutting_h * 3600, 14 * 4 + 56, 1e-6);
  EXPECT_NEAR(figures.folding_h * 3600, 5 * 6 + 10, 1e-6);
  EXPECT_NEAR(figures.gluing_h * 3600, 7 * 45 + 70, 1e-6);
  EXPECT_EQ(figures.difficulty, 1);
  EXPECT_STREQ(paper_weight(figures, 40), "160 to 200");
  EXPECT_STREQ(paper_weight(figures, 400), "200 to 300");
}

TEST(BuildFigures, CallManyAndSmallSeamsHarder) {
  const Printed ball = printed(shapes::icosphere(8), {PrintSize::Kind::Height, 60});
  const BuildFigures small = build_figures(ball.net, ball.layout, {});
  EXPECT_EQ(small.difficulty, 5) << small.n_cuts << " seams, " << small.hours() << " hours";
  EXPECT_STREQ(paper_weight(small, 60), "120 to 160");
  const Printed large = printed(shapes::icosphere(2), {PrintSize::Kind::Height, 200});
  EXPECT_LT(build_figures(large.net, large.layout, {}).difficulty, 5);
}

Box2 box_of(const std::vector<Fill>& fills) {
  Box2 box{glm::dvec2(1e9), glm::dvec2(-1e9)};
  for (const Fill& fill : fills)
    for (const glm::dvec2 p : fill.points) box = {glm::min(box.min, p), glm::max(box.max, p)};
  return box;
}

TEST(FoldingPicture, FillsItsBoxOneWayOrTheOther) {
  const Net net = net_of(shapes::star(7));
  const Box2 room{{20, 30}, {110, 90}};
  for (const double amount : {0.0, 0.3, 0.7, 1.0}) {
    const Box2 seen = box_of(folding_picture(net, amount, room));
    EXPECT_GE(seen.min.x, room.min.x - 0.1);
    EXPECT_GE(seen.min.y, room.min.y - 0.1);
    EXPECT_LE(seen.max.x, room.max.x + 0.1);
    EXPECT_LE(seen.max.y, room.max.y + 0.1);
    EXPECT_TRUE(std::abs(seen.size().x - room.size().x) < 0.3 ||
                std::abs(seen.size().y - room.size().y) < 0.3);
  }
}

TEST(FoldingPicture, StartsWithTheNetAsPrintedAndTrueInItsProportions) {
  const Net net = net_of(shapes::cube());
  std::vector<double> areas;
  for (const Fill& fill : folding_picture(net, 0, {{0, 0}, {100, 100}}))
    if (std::abs(signed_area(fill.points)) > 20) areas.push_back(signed_area(fill.points));
  ASSERT_EQ(areas.size(), 6U);
  for (const double area : areas) {
    EXPECT_NEAR(area, areas.front(), 1e-6);
    EXPECT_LT(area, 0) << "seen from the outside: counter-clockwise, with y down";
  }
}

TEST(FoldingPicture, PaintsNearFacesOverFarOnes) {
  const Net net = net_of(shapes::cube());
  std::vector<Fill> faces;
  for (const Fill& fill : folding_picture(net, 1, {{0, 0}, {100, 100}}))
    if (std::abs(signed_area(fill.points)) > 20) faces.push_back(fill);
  ASSERT_EQ(faces.size(), 6U);
  // The three far sides are seen from inside and come first; the three near ones from outside.
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(signed_area(faces[i].points) < 0, i >= 3) << i;
}

TEST(InstructionSheet, KeepsWithinThePrintablePage) {
  for (const Orientation orientation : {Orientation::Portrait, Orientation::Landscape}) {
    const Net net = net_of(shapes::torus(12, 8));
    const PageLayout layout = arrange(net, {"A4", orientation, 10}, {});
    const Sheet sheet = instruction_sheet(net, layout, {}, {});
    const Box2 page = layout.frame.printable;
    const Box2 drawn = box_of(sheet.fills);
    EXPECT_GE(drawn.min.x, page.min.x);
    EXPECT_LE(drawn.max.x, page.max.x);
    EXPECT_LE(drawn.max.y, page.max.y);
    const Font regular(FontWeight::Regular);
    for (const Text& text : sheet.texts) {
      EXPECT_LE(text.at.x + regular.width(text.words, text.size_mm), page.max.x) << text.words;
      EXPECT_LE(text.at.y, page.max.y) << text.words;
    }
  }
}

TEST(InstructionSheet, GoesBeforeOrBehindTheSheetsAndNotIntoFilesForMachines) {
  const testing::TemporaryFolder folder;
  const Printed cube = printed(shapes::cube());
  const std::string pdf = (folder / "net.pdf").string();
  const auto words_of = [&](InstructionPage where, const char* page) {
    write_drawing(pdf, cube.net, cube.layout, {"Box", true, {}}, {}, {.instructions = where});
    return output_of({"pdftotext", "-f", page, "-l", page, pdf, "-"});
  };
  EXPECT_NE(words_of(InstructionPage::First, "1").find("How to build Box"), std::string::npos);
  EXPECT_NE(words_of(InstructionPage::First, "2").find("page 1 of 1"), std::string::npos);
  EXPECT_NE(words_of(InstructionPage::Last, "2").find("How to build Box"), std::string::npos);
  SheetSettings two_sided;
  two_sided.printed_side = PrintedSide::Both;
  const WrittenDrawing both =
      write_drawing(pdf, cube.net, cube.layout, {}, two_sided, {.instructions = InstructionPage::First});
  EXPECT_NE(output_of({"pdfinfo", pdf}).find("Pages:           4\n"), std::string::npos)
      << "the instructions have an empty back";
  EXPECT_EQ(pages_text(both), "4 pages with 2 backs and the instructions");
  const ExportSettings last{.instructions = InstructionPage::Last};
  EXPECT_EQ(write_drawing(folder / "net.dxf", cube.net, cube.layout, {}, {}, last).files.size(), 1U);
  EXPECT_EQ(write_drawing(folder / "net.svg", cube.net, cube.layout, {}, {}, last).files.size(), 2U);
}

}  // namespace
}  // namespace netwright
