// The sections Tabs and Print, and the tool for tabs: what they show is what the project says, and each
// change is one step.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/gui_support.h"
#include "ui/actions.h"
#include "ui/selection.h"
#include "ui/tab_tool.h"

namespace netwright::testing {
namespace {

struct Opened : Gui {
  Opened() {
    for (bool& is_open : ui().settings.open_sections) is_open = false;
    open_sample("Globe");
    EXPECT_TRUE(unfold());
    settle();
  }
  /// Until what follows from the last change is there.
  void settle() {
    frames(3);
    EXPECT_TRUE(until([&] { return session().pages() != nullptr && session().sheets() != nullptr; }));
    frames(3);
  }
  void open(Section section) {
    ui().settings.is_open(section) = true;
    frames(3);
  }
  [[nodiscard]] EdgeId some_cut() {
    const auto shown = session().shown();
    for (const EdgeId e : session().project().dual->mesh().edges())
      if (shown->kinds[e] == EdgeKind::Cut) return e;
    return {};
  }
  [[nodiscard]] EdgeId some_fold() {
    const auto shown = session().shown();
    for (const EdgeId e : session().project().dual->mesh().edges())
      if (shown->kinds[e] == EdgeKind::Mountain) return e;
    return {};
  }
};

TEST(TabsPanel, SetsKindAndWidthAndCountsWhatCame) {
  Opened gui;
  gui.open(Section::Tabs);
  gui.enter("tabs/width", "7");
  EXPECT_EQ(gui.session().project().tabs.width_mm, 7);
  EXPECT_EQ(gui.session().undo_label(), "Undo tab width");
  gui.click("tabs/kind");
  gui.frames(2);
  gui.click("tabs/kind/For children");
  EXPECT_EQ(gui.session().project().tabs.width_mm, kChildTabWidth);
  gui.settle();
  gui.click("tabs/on");
  EXPECT_FALSE(gui.session().project().tabs.is_on);
  gui.settle();
  EXPECT_FALSE(gui.widgets.find("tabs/width").has_value()) << "without tabs there is nothing to set";
  EXPECT_TRUE(gui.until([&] { return gui.session().pages() && gui.session().pages()->tabs.tabs.empty(); }));
  gui.session().undo();
  gui.session().undo();
  EXPECT_EQ(gui.session().project().tabs.width_mm, 7);
}

TEST(TabsPanel, MakesRoomWhereCutsHaveNoTab) {
  Opened gui;
  const auto at_first = gui.session().pages();
  gui.session().set_size({PrintSize::Kind::Height, 200});
  ASSERT_TRUE(gui.until([&] { return gui.session().pages() && gui.session().pages() != at_first; }));
  gui.settle();
  gui.open(Section::Tabs);
  const std::size_t before = gui.session().pages()->tabs.missing.size();
  ASSERT_GT(before, 0U);
  gui.click("tabs/make-room");
  EXPECT_TRUE(gui.session().project().tabs.in_search);
  ASSERT_TRUE(gui.until([&] {
    if (gui.session().state() == RunState::Replaying) gui.session().skip_replay();
    return gui.session().state() == RunState::Idle;
  }));
  gui.settle();
  EXPECT_LT(gui.session().pages()->tabs.missing.size(), before);
  EXPECT_TRUE(gui.session().shown()->is_proved);
  gui.click("tabs/in-search");
  EXPECT_FALSE(gui.session().project().tabs.in_search);
}

TEST(PaperPanel, SplitsWhatIsLargerThanThePaper) {
  Opened gui;
  gui.open(Section::Paper);
  EXPECT_FALSE(gui.widgets.find("paper/split").has_value()) << "the net fits its page";
  gui.session().set_size({PrintSize::Kind::Height, 250});
  ASSERT_TRUE(gui.until([&] { return gui.widgets.find("paper/split").has_value(); }));
  gui.frames(3);
  gui.click("paper/split");
  ASSERT_TRUE(gui.until([&] {
    const auto pages = gui.session().pages();
    return pages != nullptr && pages->pieces.size() > 1 && gui.session().sheets() != nullptr;
  }));
  gui.frames(3);
  EXPECT_FALSE(gui.widgets.find("paper/split").has_value()) << "every piece fits a page now";
  const UiContext context{gui.session(), gui.ui()};
  EXPECT_TRUE(is_possible(context, ActionId::PrintPages)) << "pieces cut on purpose are printed, too";
  EXPECT_TRUE(is_possible(context, ActionId::ExportLaser));
  gui.session().undo();
  EXPECT_TRUE(gui.until([&] { return gui.session().pages() && gui.session().pages()->pieces.size() == 1; }));
}

TEST(TabsPanel, SaysOfSelectedEdgesWhatHoldsForThemAlone) {
  Opened gui;
  gui.open(Section::Tabs);
  const EdgeId cut = gui.some_cut();
  const Mesh& mesh = gui.session().project().dual->mesh();
  EXPECT_FALSE(gui.widgets.find("tabs/edge-width").has_value());
  select_side(gui.ui(), mesh, mesh.halfedge(cut), false);
  gui.frames(3);
  gui.enter("tabs/edge-width", "3");
  gui.enter("tabs/first-angle", "60");
  ASSERT_EQ(gui.session().project().tabs.edits.size(), 1U);
  const TabEdit edit = gui.session().project().tabs.edits.front();
  EXPECT_EQ(edit.edge, cut);
  EXPECT_EQ(edit.width_mm, 3);
  EXPECT_NEAR(edit.first_angle_rad.value_or(0), 1.0472, 1e-3);
  gui.click("tabs/side/None");
  EXPECT_EQ(gui.session().project().tabs.edits.front().side, TabSide::None);
  gui.click("tabs/as-others");
  EXPECT_TRUE(gui.session().project().tabs.edits.empty());
  EXPECT_EQ(gui.session().undo_label(), "Undo reset tabs");
}

TEST(TabTool, SendsTheTabOfAClickedCutRound) {
  Opened gui;
  gui.key('B', 1);
  ASSERT_TRUE(gui.ui().tabbing.is_on);
  const EdgeId cut = gui.some_cut();
  const Mesh& mesh = gui.session().project().dual->mesh();
  const HalfedgeId side = mesh.halfedge(cut);
  std::vector<TabSide> seen;
  for (int i = 0; i < 5; ++i) {
    const Net& net = *gui.app.workspace().scene().net();
    const WidgetRect view = gui.rect("net/picture");
    const glm::dvec2 middle = 0.5 * (net.corner(side) + net.corner(mesh.next(side)));
    const glm::dvec2 at = gui.app.workspace().net_view().camera().to_pixel(middle);
    gui.point(at + glm::dvec2(view.min.x, view.min.y));
    gui.frames(2);
    EXPECT_FALSE(gui.app.workspace().overlay().lines().plane.empty()) << "what a click brings is shown";
    gui.window.press_mouse(0);
    gui.frames(2);
    gui.window.release_mouse(0);
    gui.frames(2);
    seen.push_back(tab_wish(gui.session().project().tabs, cut).side);
    gui.settle();
  }
  for (const TabSide wanted : {TabSide::First, TabSide::Second, TabSide::Both, TabSide::None})
    EXPECT_NE(std::find(seen.begin(), seen.end(), wanted), seen.end()) << static_cast<int>(wanted);
  gui.key(keys::kEscape);
  EXPECT_FALSE(gui.ui().tabbing.is_on);
}

TEST(TabTool, HidesAndShowsTheLineOfAFold) {
  Opened gui;
  const EdgeId fold = gui.some_fold();
  const Mesh& mesh = gui.session().project().dual->mesh();
  select_side(gui.ui(), mesh, mesh.halfedge(fold), false);
  const auto n_before = gui.session().sheets()->front().strokes.size();
  gui.key('H');
  EXPECT_EQ(gui.session().project().sheet.hidden_folds, std::vector<EdgeId>{fold});
  EXPECT_EQ(gui.session().undo_label(), "Undo hide fold line");
  gui.settle();
  EXPECT_LT(gui.session().sheets()->front().strokes.size(), n_before);
  gui.key('H');
  EXPECT_TRUE(gui.session().project().sheet.hidden_folds.empty());
}

TEST(PrintPanel, KeepsLinesWordsAndSwitches) {
  Opened gui;
  gui.open(Section::Print);
  EXPECT_FALSE(gui.widgets.find("print/title").has_value()) << "rare things are behind More";
  gui.click("print/lines");
  gui.frames(2);
  gui.click("print/lines/Kit (reversed)");
  EXPECT_EQ(gui.session().project().sheet.lines, line_styles(LinePreset::Kit));
  gui.click("print/numbers");
  EXPECT_FALSE(gui.session().project().sheet.labels.edge_numbers);
  gui.click("print/more");
  gui.frames(3);
  ASSERT_TRUE(gui.widgets.find("print/title").has_value());
  gui.ui().is_more_print_open = true;
  gui.enter("print/cut-width", "0.4");
  EXPECT_EQ(gui.session().project().sheet.lines.cut.width_mm, 0.4);
  gui.enter("print/cut-dash", "3 1");
  EXPECT_EQ(gui.session().project().sheet.lines.cut.dash_mm, (std::vector<double>{3, 1}));
  gui.enter("print/cut-dash", "often");
  EXPECT_EQ(gui.session().project().sheet.lines.cut.dash_mm, (std::vector<double>{3, 1})) << "no pattern";
  gui.settle();
}

TEST(ExportPanel, ShowsForEachFormatWhatCanBeSetOfItAndKeepsItInTheProject) {
  Opened gui;
  gui.open(Section::Export);
  EXPECT_FALSE(gui.widgets.find("export/one-file").has_value()) << "a PDF is one file always";
  gui.click("export/instructions/Last");
  EXPECT_EQ(gui.session().project().exports.instructions, InstructionPage::Last);
  EXPECT_EQ(gui.session().undo_label(), "Undo instructions");
  const auto choose = [&](const char* format) {
    gui.click("export/target");
    gui.frames(2);
    gui.click(std::string("export/target/") + format);
    gui.frames(2);
  };
  choose("SVG drawing");
  gui.click("export/one-file");
  gui.click("export/real-dashes");
  gui.click("export/live-text");
  choose("PNG pictures");
  EXPECT_FALSE(gui.widgets.find("export/one-file").has_value());
  gui.enter("export/dpi", "9000");
  const ExportSettings wanted{true, true, true, kMostDpi, InstructionPage::Last};
  EXPECT_EQ(gui.session().project().exports, wanted) << "and dots per inch are held to their limits";
  gui.session().undo();
  EXPECT_EQ(gui.session().project().exports.png_dpi, 300);
  choose("Laser cutter folder");
  EXPECT_FALSE(gui.widgets.find("export/instructions").has_value());
  gui.settle();
  gui.click("export/write");
  EXPECT_EQ(gui.ui().dialog, Dialog::Export);
  EXPECT_EQ(gui.ui().export_extension, "laser");
}

TEST(ExportDialog, HasTheSameSettings) {
  Opened gui;
  gui.key('P', 2);
  gui.frames(3);
  gui.click("export/format/SVG");
  gui.frames(3);
  gui.click("export/one-file");
  EXPECT_TRUE(gui.session().project().exports.is_one_file);
  EXPECT_FALSE(gui.widgets.find("export/dpi").has_value());
  gui.click("export/format/PNG");
  gui.frames(3);
  EXPECT_TRUE(gui.widgets.find("export/dpi").has_value());
}

TEST(PaperPanel, TakesPaperOfOnesOwnSize) {
  Opened gui;
  gui.open(Section::Paper);
  EXPECT_FALSE(gui.widgets.find("paper/own-width").has_value());
  gui.click("paper/format");
  gui.frames(2);
  gui.click("paper/format/Own size");
  gui.frames(2);
  gui.enter("paper/own-width", "180");
  gui.enter("paper/own-height", "9999");
  EXPECT_EQ(gui.session().project().paper.format, custom_paper(180, kMostPaperSide));
  gui.enter("paper/own-height", "240");
  ASSERT_TRUE(gui.until([&] {
    const auto pages = gui.session().pages();
    return pages && std::max(pages->frame.width_mm, pages->frame.height_mm) == 240;
  }));
  EXPECT_EQ(std::min(gui.session().pages()->frame.width_mm, gui.session().pages()->frame.height_mm), 180);
}

TEST(TabsPanel, LeavesLooseStripsOutWhenTold) {
  Opened gui;
  gui.open(Section::Tabs);
  gui.click("tabs/more");
  gui.frames(2);
  ASSERT_TRUE(gui.session().project().sheet.loose_strips);
  gui.click("tabs/strips");
  EXPECT_FALSE(gui.session().project().sheet.loose_strips);
  EXPECT_EQ(gui.session().undo_label(), "Undo loose strips");
}

TEST(PaperPanel, KnowsSizesByEdgeScaleAndSheets) {
  Opened gui;
  gui.open(Section::Paper);
  gui.click("paper/size/Other");
  EXPECT_EQ(gui.session().project().size.kind, PrintSize::Kind::FitSheets);
  gui.settle();
  gui.enter("paper/sheets", "3");
  EXPECT_EQ(gui.session().project().size.sheets, 3);
  gui.settle();
  const double scale = gui.session().pages()->scale;
  gui.click("paper/by");
  gui.frames(2);
  gui.click("paper/by/Scale");
  EXPECT_NEAR(gui.session().project().size.scale, scale, 1e-9) << "nothing jumps";
  gui.settle();
  gui.click("paper/by");
  gui.frames(2);
  gui.click("paper/by/Length of an edge");
  EXPECT_TRUE(gui.session().project().size.edge.is_valid());
  gui.settle();
  EXPECT_NEAR(gui.session().pages()->scale, scale, 1e-6);
  gui.enter("paper/edge", "20");
  EXPECT_EQ(gui.session().project().size.edge_mm, 20);
}

}  // namespace
}  // namespace netwright::testing
