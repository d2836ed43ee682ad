// The net's page mode shows the finished sheets: the same ink that the writers put into files.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/gui_support.h"
#include "tests/support.h"
#include "ui/actions.h"
#include "ui/printed.h"

namespace netwright::testing {
namespace {

/// Pixels of the window near a place on the sheet, in its mm, that are darker than paper.
int n_inked(Gui& gui, glm::dvec2 on_sheet_mm, int reach) {
  const auto& scene = gui.app.workspace().scene();
  const auto pages = gui.session().pages();
  const auto placed = place_sheets(*gui.session().sheets(), *pages, PrintedSide::Outside);
  const glm::dvec2 mm = placed.front().corner_mm + on_sheet_mm;
  const glm::dvec2 world = glm::dvec2(mm.x, -mm.y) / pages->scale;
  EXPECT_TRUE(scene.is_printed());
  const WidgetRect view = gui.rect("net/picture");
  const glm::dvec2 at =
      gui.app.workspace().net_view().camera().to_pixel(world) + glm::dvec2(view.min.x, view.min.y);
  const Image picture = gui.window.read_pixels();
  int n = 0;
  for (int y = static_cast<int>(at.y) - reach; y <= static_cast<int>(at.y) + reach; ++y)
    for (int x = static_cast<int>(at.x) - reach; x <= static_cast<int>(at.x) + reach; ++x) {
      const auto i = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                          static_cast<std::size_t>(x));
      n += picture.rgba[i] + picture.rgba[i + 1] + picture.rgba[i + 2] < 3 * 200 ? 1 : 0;
    }
  return n;
}

const Text* title_of(const Sheet& sheet) {
  const Text* largest = nullptr;
  for (const Text& text : sheet.texts)
    if (largest == nullptr || text.size_mm > largest->size_mm) largest = &text;
  return largest;
}

TEST(PrintedView, ShowsTitleAndLinesWhereTheSheetHasThem) {
  Gui gui;
  gui.open_sample("Globe");
  ASSERT_TRUE(gui.unfold());
  gui.frames(5);
  ASSERT_TRUE(gui.session().sheets());
  EXPECT_TRUE(gui.app.workspace().scene().is_printed());
  const Sheet& sheet = gui.session().sheets()->front();
  const Text* title = title_of(sheet);
  ASSERT_NE(title, nullptr);
  EXPECT_GT(n_inked(gui, title->at + glm::dvec2(0.3 * title->size_mm, -0.3 * title->size_mm), 3), 0);
  EXPECT_GT(gui.app.workspace().sheets().n_letters(), 0);
  int n_seen = 0;
  int n_lines = 0;
  for (const Stroke& stroke : sheet.strokes) {
    if (stroke.layer != Layer::Cut || stroke.points.size() < 2) continue;
    ++n_lines;
    n_seen += n_inked(gui, (stroke.points[0] + stroke.points[1]) * 0.5, 2) > 0 ? 1 : 0;
    if (n_lines == 20) break;
  }
  ASSERT_GT(n_lines, 0);
  EXPECT_EQ(n_seen, n_lines) << "every cut of the sheet is on the screen";
}

TEST(PrintedView, TakesTurnsWithTheNetsOwnDrawing) {
  Gui gui;
  gui.open_sample("Cube");
  ASSERT_TRUE(gui.unfold());
  gui.frames(5);
  const auto is_printed = [&] {
    gui.frames(3);
    return gui.app.workspace().scene().is_printed();
  };
  EXPECT_TRUE(is_printed());
  gui.key('P');
  EXPECT_FALSE(is_printed()) << "without pages there is nothing printed";
  EXPECT_EQ(gui.app.workspace().sheets().is_empty(), gui.session().pages()->tabs.tabs.empty())
      << "but the tabs are there";
  gui.key('B');
  gui.frames(3);
  EXPECT_TRUE(gui.app.workspace().sheets().is_empty());
  gui.key('P');
  EXPECT_FALSE(is_printed()) << "tabs are hidden, so it is not what will be printed";
  gui.key('B');
  EXPECT_TRUE(is_printed());
  gui.key('E');
  EXPECT_FALSE(is_printed()) << "while the net is edited";
  gui.key('E');
  EXPECT_TRUE(is_printed());
}

TEST(PrintedView, LettersTooSmallToReadAreLeftOut) {
  Gui gui;
  gui.open_sample("Globe");
  ASSERT_TRUE(gui.unfold());
  gui.frames(5);
  const int n_before = gui.app.workspace().sheets().n_letters();
  const WidgetRect view = gui.rect("net/picture");
  gui.point({(view.min.x + view.max.x) / 2, (view.min.y + view.max.y) / 2});
  for (int i = 0; i < 14; ++i) {
    gui.window.scroll({0, -1});
    gui.frames(1);
  }
  gui.frames(2);
  EXPECT_LT(gui.app.workspace().sheets().n_letters(), n_before);
}

TEST(PrintedView, RestsTheSwitchOfTheTreeThatIsNotPrinted) {
  Gui gui;
  gui.open_sample("Cube");
  ASSERT_TRUE(gui.unfold());
  gui.frames(5);
  EXPECT_FALSE(gui.rect("net/Unfold tree").is_enabled);
  EXPECT_TRUE(gui.rect("model/Unfold tree").is_enabled) << "the model shows it";
  gui.key('P');
  EXPECT_TRUE(gui.rect("net/Unfold tree").is_enabled);
}

TEST(PrintedView, StaysOnItsPagesUntilThoseOfTheNextNetAreThere) {
  Gui gui;
  gui.open_sample("Globe");
  ASSERT_TRUE(gui.unfold());
  gui.session().set_seed(gui.session().project().seed + 1);
  ASSERT_TRUE(gui.unfold());
  gui.frames(5);
  const auto& scene = gui.app.workspace().scene();
  const auto before = gui.session().shown();
  ASSERT_TRUE(scene.is_printed());
  gui.session().undo();
  // The clock stands still: patience has an end.
  bool was_on_pages = true;
  for (int i = 0; i < 4000 && (gui.session().is_laying_out() || gui.session().shown() == before); ++i) {
    gui.window.wait_events(0.002);
    gui.app.turn(0);
    gui.app.draw();
    was_on_pages = was_on_pages && scene.is_on_pages();
  }
  EXPECT_TRUE(was_on_pages);
  gui.frames(2);
  EXPECT_NE(gui.session().shown(), before);
  EXPECT_EQ(scene.shown(), gui.session().shown());
  EXPECT_TRUE(scene.is_printed());
}

TEST(PrintedView, ShowsTilesWholeBelowTheNet) {
  Gui gui;
  gui.open_sample("Globe");
  ASSERT_TRUE(gui.unfold());
  const auto before = gui.session().pages();
  gui.session().set_size({PrintSize::Kind::Height, 250});
  ASSERT_TRUE(gui.until([&] { return gui.session().pages() && gui.session().pages() != before; }));
  gui.frames(5);
  const auto pages = gui.session().pages();
  const auto& sheets = *gui.session().sheets();
  ASSERT_TRUE(pages->canvases.front().is_tiled());
  const auto placed = place_sheets(sheets, *pages, PrintedSide::Outside);
  const auto spread = spread_tiles(sheets, *pages, PrintedSide::Outside, placed);
  ASSERT_EQ(spread.size(), pages->pages.size());
  for (std::size_t i = 0; i < spread.size(); ++i) {
    const Box2 page = box_of(spread[i], pages->scale);
    EXPECT_LT(page.max.y, -pages->canvases.front().height_mm / pages->scale) << "below the joined tiles";
    for (std::size_t k = 0; k < i; ++k) {
      const Box2 other = box_of(spread[k], pages->scale);
      EXPECT_TRUE(page.min.x >= other.max.x || page.max.x <= other.min.x || page.min.y >= other.max.y ||
                  page.max.y <= other.min.y);
    }
  }
  const auto& camera = gui.app.workspace().net_view().camera();
  const glm::dvec2 first = box_of(spread.back(), pages->scale).centre();
  EXPECT_GT(camera.to_pixel(first).y, camera.size_px().y) << "the net comes first";
  gui.key(keys::kHome);
  gui.frames(5);
  EXPECT_LT(camera.to_pixel(first).y, camera.size_px().y) << "Home shows all sheets";
  const auto mirrored = spread_tiles(sheets, *pages, PrintedSide::Inside, placed);
  double sum = 0;
  for (std::size_t i = 0; i < spread.size(); ++i)
    sum += std::abs(spread[i].corner_mm.x - mirrored[i].corner_mm.x);
  EXPECT_GT(sum, 0) << "mirrored sheets stand in mirrored order";
}

TEST(PlaceSheets, PutsAPageUnderTheNetThatLiesOnIt) {
  Gui gui;
  gui.open_sample("Cube");
  ASSERT_TRUE(gui.unfold());
  gui.frames(5);
  const auto pages = gui.session().pages();
  const auto& sheets = *gui.session().sheets();
  const auto placed = place_sheets(sheets, *pages, PrintedSide::Outside);
  ASSERT_EQ(placed.size(), sheets.size());
  const Net& net = *gui.app.workspace().scene().net();
  const Box2 page = box_of(placed.front(), pages->scale);
  const Box2 drawn = net.box();
  EXPECT_GE(drawn.min.x, page.min.x);
  EXPECT_LE(drawn.max.x, page.max.x);
  EXPECT_GE(drawn.min.y, page.min.y);
  EXPECT_LE(drawn.max.y, page.max.y);
  const auto backs = place_sheets(sheets, *pages, PrintedSide::Inside);
  EXPECT_LT(box_of(backs.front(), pages->scale).max.y, page.min.y) << "what is mirrored stands apart";
}

TEST(PrintedView, ThePageWithInstructionsStandsBeforeOrBehindTheOthers) {
  Gui gui;
  gui.open_sample("Globe");
  ASSERT_TRUE(gui.unfold());
  gui.frames(5);
  const Scene& scene = gui.app.workspace().scene();
  const Box2 plain = scene.net_box();
  const auto set = [&](InstructionPage where) {
    ExportSettings exports = gui.session().project().exports;
    exports.instructions = where;
    gui.session().set_exports(exports, "instructions");
    const bool is_wanted = where != InstructionPage::None;
    EXPECT_TRUE(gui.until([&] {
      return !gui.session().is_laying_out() && (gui.session().instructions() != nullptr) == is_wanted;
    }));
    gui.frames(3);
    EXPECT_TRUE(scene.is_printed());
  };
  set(InstructionPage::Last);
  const double width = gui.session().instructions()->width_mm / gui.session().pages()->scale;
  EXPECT_GT(scene.net_box().max.x, plain.max.x + width);
  EXPECT_DOUBLE_EQ(scene.net_box().min.x, plain.min.x);
  set(InstructionPage::First);
  EXPECT_LT(scene.net_box().min.x, plain.min.x - width);
  EXPECT_DOUBLE_EQ(scene.net_box().max.x, plain.max.x);
  EXPECT_NEAR(scene.net_box().max.y, plain.max.y, 1e-9) << "level with them";
  set(InstructionPage::None);
  EXPECT_DOUBLE_EQ(scene.net_box().min.x, plain.min.x);
  EXPECT_DOUBLE_EQ(scene.net_box().max.x, plain.max.x);
}

}  // namespace
}  // namespace netwright::testing
