// The sections Check and Assembly, and the print dialog.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/sheet/labels.h"
#include "tests/gui_support.h"
#include "ui/assembly.h"

namespace netwright::testing {
namespace {

struct Opened : Gui {
  Opened() {
    for (bool& is_open : ui().settings.open_sections) is_open = false;
    ui().settings.is_open(Section::Check) = true;
    ui().settings.is_open(Section::Assembly) = true;
    open_sample("Globe");
    EXPECT_TRUE(unfold());
    EXPECT_TRUE(until([&] { return session().sheets() != nullptr; }));
    frames(4);
  }
};

TEST(CheckPanel, LeadsToThePlaceOfEachLine) {
  Opened gui;
  const auto judged = gui.session().buildability();
  ASSERT_TRUE(judged);
  gui.click("check/0");
  ASSERT_EQ(gui.ui().selected_edges.size(), 1U);
  EXPECT_EQ(gui.ui().selected_edges.front(), judged->smallest_edge);
  const auto lines = lines_of(*judged, gui.session().shown()->net);
  const auto neck =
      std::ranges::find_if(lines, [](const BuildLine& line) { return line.text.starts_with("Thinnest"); });
  gui.click("check/" + std::to_string(neck - lines.begin()));
  std::vector<FaceId> faces = judged->neck.faces;
  std::ranges::sort(faces);
  EXPECT_EQ(gui.ui().selected_faces, faces);
}

TEST(AssemblyPanel, GoesFromSeamToSeamAndKeepsWhatIsGlued) {
  Opened gui;
  UiContext context{gui.session(), gui.ui()};
  const std::vector<EdgeId> order = assembly_order(context);
  ASSERT_GT(order.size(), 3U);
  gui.click("assembly/on");
  EXPECT_EQ(gui.ui().selected_edges, std::vector<EdgeId>{order[0]})
      << "the first press shows the seam in hand";
  gui.frames(2);
  EXPECT_FALSE(gui.app.workspace().overlay().lines().space.empty()) << "and it is lit on the model";
  EXPECT_FALSE(gui.app.workspace().overlay().lines().plane.empty()) << "and in the net";
  gui.click("assembly/on");
  EXPECT_EQ(gui.ui().selected_edges, std::vector<EdgeId>{order[1]});
  gui.click("assembly/back");
  EXPECT_EQ(gui.ui().selected_edges, std::vector<EdgeId>{order[0]});
  gui.click("assembly/tick");
  EXPECT_EQ(gui.session().project().glued, std::vector<EdgeId>{order[0]});
  EXPECT_EQ(gui.session().undo_label(), "Undo glue seam");
  EXPECT_EQ(gui.ui().selected_edges, std::vector<EdgeId>{order[1]}) << "on to the next one";
  gui.frames(20);
  gui.session().undo();
  EXPECT_TRUE(gui.session().project().glued.empty());
}

TEST(AssemblyPanel, NamesTheNumbersThatAreOnThePaperNow) {
  Gui gui;
  gui.open_sample("Cube");
  ASSERT_TRUE(gui.unfold());
  UiContext context{gui.session(), gui.ui()};
  const auto printed = [&] {
    const SheetSettings& sheet = gui.session().project().sheet;
    return cut_numbers(gui.session().shown()->net, sheet.labels.skips_obvious,
                       strip_cuts(*gui.session().pages(), sheet));
  };
  const auto shown = [&] {
    gui.frames(3);
    IdVector<EdgeId, int> numbers(gui.session().project().dual->mesh().n_edges(), 0);
    for (const EdgeId e : assembly_order(context)) numbers[e] = assembly_number(context, e);
    return numbers;
  };
  const IdVector<EdgeId, int> before = shown();
  EXPECT_EQ(before, printed());
  SheetSettings sheet = gui.session().project().sheet;
  sheet.labels.skips_obvious = false;
  gui.session().set_sheet(sheet, "obvious numbers");
  EXPECT_EQ(shown(), printed()) << "the net is the same, its numbers are not";
  EXPECT_NE(shown(), before);
  sheet.labels.edge_numbers = false;
  gui.session().set_sheet(sheet, "numbers");
  EXPECT_EQ(shown(), (IdVector<EdgeId, int>(before.size(), 0))) << "no numbers are printed";
}

TEST(AssemblyPanel, ListsTheNumbersThatHadNoRoom) {
  Opened gui;
  const auto print = [&](double height_mm) {
    const auto before = gui.session().sheets();
    gui.session().set_size({PrintSize::Kind::Height, height_mm});
    EXPECT_TRUE(gui.until([&] { return gui.session().sheets() && gui.session().sheets() != before; }));
    gui.frames(3);
  };
  print(250);
  EXPECT_TRUE(gui.session().unnumbered()->empty());
  EXPECT_FALSE(gui.widgets.find("assembly/unnumbered"));
  print(12);
  EXPECT_FALSE(gui.session().unnumbered()->empty());
  EXPECT_TRUE(gui.widgets.find("assembly/unnumbered"));
  SheetSettings sheet = gui.session().project().sheet;
  sheet.labels.edge_numbers = false;
  gui.session().set_sheet(sheet, "numbers");
  ASSERT_TRUE(gui.until([&] { return gui.session().unnumbered() && gui.session().unnumbered()->empty(); }));
  gui.frames(3);
  EXPECT_FALSE(gui.widgets.find("assembly/unnumbered")) << "none are wanted";
}

TEST(PrintDialog, OpensFromItsKeyAndExportsWhereThereIsNoPrinter) {
  Opened gui;
  gui.key('I', 2);
  gui.frames(3);
  EXPECT_EQ(gui.ui().dialog, Dialog::Print);
  EXPECT_TRUE(gui.widgets.find("dialog/title").has_value());
  ASSERT_TRUE(gui.until([&] { return gui.session().printers() != nullptr; }));
  gui.frames(3);
  if (gui.session().printers()->empty()) {
    gui.key(keys::kEnter);
    gui.frames(3);
    EXPECT_EQ(gui.ui().dialog, Dialog::Export);
  } else {
    EXPECT_TRUE(gui.widgets.find("print-dialog/sheets").has_value());
  }
}

}  // namespace
}  // namespace netwright::testing
