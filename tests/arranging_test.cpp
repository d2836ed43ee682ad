// Pieces arranged on their pages with the mouse, in the real interface.
#include "ui/arranging.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/mesh/shapes.h"
#include "tests/gui_support.h"
#include "ui/desk.h"

namespace netwright::testing {
namespace {

constexpr int kShift = 1;
constexpr int kCtrl = 2;
constexpr int kEscape = 256;

struct Pair : Gui {
  TemporaryFolder folder;

  explicit Pair(glm::ivec2 size = {1440, 900}) : Gui(size) {
    const PolygonSoup both = shapes::combined(shapes::cuboid({1, 2, 1}), shapes::tetrahedron(), {5, 0, 0});
    session().open(folder.write("pair.obj", shapes::to_obj(both)));
    EXPECT_TRUE(until([&] { return session().has_model(); }));
    session().set_size({PrintSize::Kind::Height, 50});  // leaves room on the sheet
    session().set_tabs(no_tabs(), "no tabs");           // what is measured here are faces
    EXPECT_TRUE(unfold());
    EXPECT_TRUE(until([&] { return session().pages() != nullptr; }));
    frames(30);
    key('A');
    EXPECT_TRUE(ui().arranging.is_on);
  }
  [[nodiscard]] const Net& drawn() { return *app.workspace().scene().net(); }
  [[nodiscard]] const PanZoomCamera& camera() { return app.workspace().net_view().camera(); }
  /// A face of the piece, and the pixel in its middle.
  FaceId face_of(int piece) {
    for (const FaceId f : drawn().mesh().faces())
      if (drawn().piece[f] == piece) return f;
    return {};
  }
  glm::dvec2 pixel_of(int piece) { return net_pixel(face_of(piece)); }
  glm::dvec2 window_pixel(glm::dvec2 inside) {
    const WidgetRect rect = this->rect("net/picture");
    return glm::dvec2(rect.min.x, rect.min.y) + inside;
  }
  glm::dvec2 handle() { return window_pixel(*turn_handle({session(), ui()}, drawn(), camera())); }
  Box2 box_of(int piece) { return box_on_canvas(session().shown()->net, *session().pages(), piece); }
  double angle_of(int piece) {
    const Rigid2& turn = session().pages()->pieces[static_cast<std::size_t>(piece)].turn;
    return std::atan2(turn.sin, turn.cos);
  }
  double mm_per_pixel() { return session().pages()->scale / camera().pixels_per_unit(); }
  /// Drags, and waits for the pages that come of it.
  void drag_and_wait(glm::dvec2 from, glm::dvec2 to, int modifiers = 0) {
    const auto before = session().pages();
    point(from);
    window.press_mouse();
    frames();
    window.hold_modifiers(modifiers);
    for (int i = 1; i <= 4; ++i) point(from + (to - from) * (i / 4.0));
    window.release_mouse();
    frames(2);
    window.hold_modifiers(0);
    EXPECT_TRUE(until([&] { return session().pages() && session().pages() != before; }));
    frames(3);
  }
  void click_at(glm::dvec2 at, int modifiers = 0) {
    window.hold_modifiers(modifiers);
    point(at);
    window.press_mouse(0, modifiers);
    frames();
    window.release_mouse();
    frames(3);
    window.hold_modifiers(0);
    frames(2);
  }
};

TEST(Arranging, ADraggedPieceLiesWhereItWasDropped) {
  Pair gui;
  const Box2 was = gui.box_of(0);
  const Box2 other = gui.box_of(1);
  const glm::dvec2 way(-23, 31);
  const double scale = gui.mm_per_pixel();
  gui.drag_and_wait(gui.pixel_of(0), gui.pixel_of(0) + way, kCtrl);
  EXPECT_NEAR(gui.box_of(0).min.x, was.min.x + way.x * scale, 1e-3);
  EXPECT_NEAR(gui.box_of(0).min.y, was.min.y + way.y * scale, 1e-3);
  EXPECT_NEAR(gui.box_of(1).min.x, other.min.x, 1e-9);
  EXPECT_EQ(gui.session().undo_label(), "Undo move piece");
  EXPECT_FALSE(gui.ui().arranging.has_motion);
  // What is drawn is what is on the pages.
  const PagedNet paged = on_pages(gui.session().shown()->net, *gui.session().pages());
  for (const HalfedgeId h : gui.drawn().mesh().halfedges())
    ASSERT_NEAR(glm::distance(gui.drawn().corner(h), paged.net.corner(h)), 0, 1e-9);
  const auto moved = gui.session().pages();
  gui.key('Z', kCtrl);
  ASSERT_TRUE(gui.until([&] { return gui.session().pages() && gui.session().pages() != moved; }));
  EXPECT_NEAR(gui.box_of(0).min.x, was.min.x, 1e-9);
}

TEST(Arranging, SidesSnapToTheRoomOnTheSheet) {
  Pair gui;
  const Box2 was = gui.box_of(0);
  // Not quite to the left edge, but near enough.
  const glm::dvec2 way(-was.min.x / gui.mm_per_pixel() + 4, 0);
  gui.drag_and_wait(gui.pixel_of(0), gui.pixel_of(0) + way);
  EXPECT_NEAR(gui.box_of(0).min.x, 0, 1e-6);
  EXPECT_EQ(gui.session().misplaced(), nullptr);
}

TEST(Arranging, TabsSnapToTheRoomOnTheSheet) {
  Pair gui;
  const auto bare = gui.session().pages();
  gui.session().set_tabs(TabSettings(), "tabs");
  ASSERT_TRUE(gui.until([&] { return gui.session().pages() && gui.session().pages() != bare; }));
  gui.frames(3);
  const Box2 was = gui.box_of(0);
  const glm::dvec2 way(-was.min.x / gui.mm_per_pixel() + 4, 0);
  gui.drag_and_wait(gui.pixel_of(0), gui.pixel_of(0) + way);
  EXPECT_NEAR(gui.box_of(0).min.x, 0, 1e-6);
  const Misplaced* const wrong = gui.session().misplaced();
  EXPECT_TRUE(wrong == nullptr || wrong->over_edge.empty());
}

TEST(Arranging, TheHandleTurnsInStepsAndToEdgesAndFreelyWithCtrl) {
  Pair gui;
  gui.click_at(gui.pixel_of(1));
  ASSERT_EQ(chosen_pieces({gui.session(), gui.ui()}), std::vector{1});
  Box2 box;
  for (const FaceId f : gui.drawn().mesh().faces())
    if (gui.drawn().piece[f] == 1) box.add(gui.drawn().box(f));
  const glm::dvec2 centre = gui.window_pixel(gui.camera().to_pixel(box.centre()));
  const auto turned = [&](double degrees) {
    const glm::dvec2 arm = gui.handle() - centre;
    const double angle = -degrees * std::numbers::pi / 180;  // pixels point down
    return centre + Rigid2::rotation(angle).rotate(arm);
  };
  const auto levels = level_turns(gui.session().shown()->net, *gui.session().pages(), {1});
  const double before = gui.angle_of(1);
  gui.drag_and_wait(gui.handle(), turned(-38));
  const double snapped = gui.angle_of(1) - before;
  EXPECT_NEAR(
      std::remainder(snapped - snapped_turn(-38 * std::numbers::pi / 180, levels), 2 * std::numbers::pi), 0,
      1e-6);
  EXPECT_EQ(gui.session().undo_label(), "Undo turn piece");
  gui.key('Z', kCtrl);
  ASSERT_TRUE(gui.until([&] { return gui.session().pages() && std::abs(gui.angle_of(1) - before) < 1e-9; }));
  gui.frames(3);
  gui.drag_and_wait(gui.handle(), turned(-38), kCtrl);
  EXPECT_NEAR(std::remainder((gui.angle_of(1) - before) * 180 / std::numbers::pi + 38, 360), 0, 0.2);
}

TEST(Arranging, ABandSelectsPiecesThatAreAlignedAndMovedTogether) {
  Pair gui;
  const WidgetRect picture = gui.rect("net/picture");
  gui.drag(glm::dvec2(picture.min.x + 3, picture.min.y + 3),
           glm::dvec2(picture.max.x - 3, picture.max.y - 3));
  ASSERT_EQ(chosen_pieces({gui.session(), gui.ui()}), (std::vector{0, 1}));
  EXPECT_NE(gui.ui().hint.find("2 pieces selected"), std::string::npos) << gui.ui().hint;
  auto before = gui.session().pages();
  gui.click("menu/Paper");
  gui.click("menu/Align");
  gui.click("menu/Align top");
  ASSERT_TRUE(gui.until([&] { return gui.session().pages() && gui.session().pages() != before; }));
  EXPECT_NEAR(gui.box_of(0).min.y, gui.box_of(1).min.y, 1e-9);
  EXPECT_EQ(gui.session().undo_label(), "Undo align 2 pieces");
  gui.frames(3);
  const Box2 first = gui.box_of(0);
  const Box2 second = gui.box_of(1);
  gui.drag_and_wait(gui.pixel_of(0), gui.pixel_of(0) + glm::dvec2(0, 17), kCtrl);
  EXPECT_EQ(gui.session().undo_label(), "Undo move 2 pieces");
  EXPECT_NEAR(gui.box_of(0).min.y - first.min.y, gui.box_of(1).min.y - second.min.y, 1e-9);
  EXPECT_GT(gui.box_of(1).min.y, second.min.y + 1);
  before = gui.session().pages();
  gui.key('A', kShift);
  ASSERT_TRUE(gui.until([&] { return gui.session().pages() && gui.session().pages() != before; }));
  EXPECT_FALSE(gui.session().has_placed_pieces());
}

TEST(Arranging, ShiftAddsAndLetsGoAgain) {
  Pair gui;
  gui.click_at(gui.pixel_of(0));
  EXPECT_EQ(chosen_pieces({gui.session(), gui.ui()}), std::vector{0});
  gui.click_at(gui.pixel_of(1), kShift);
  EXPECT_EQ(chosen_pieces({gui.session(), gui.ui()}), (std::vector{0, 1}));
  gui.click_at(gui.pixel_of(0), kShift);
  EXPECT_EQ(chosen_pieces({gui.session(), gui.ui()}), std::vector{1});
}

TEST(Arranging, WhatLiesBadlyIsRedAndNotPrinted) {
  Pair gui;
  const glm::dvec2 onto = gui.pixel_of(1) - gui.pixel_of(0);
  gui.drag_and_wait(gui.pixel_of(0), gui.pixel_of(0) + onto, kCtrl);
  ASSERT_NE(gui.session().misplaced(), nullptr);
  const FaceStates& states = gui.app.workspace().scene().states();
  for (const FaceId f : gui.session().misplaced()->faces) EXPECT_TRUE(states.has(f, FaceState::Overlapping));
  EXPECT_EQ(gui.session().sheets(), nullptr);
  EXPECT_FALSE(is_possible({gui.session(), gui.ui()}, ActionId::ExportPdf));
  EXPECT_NE(action(ActionId::ExportPdf).why_not({gui.session(), gui.ui()}).find("overlap"),
            std::string::npos);
}

TEST(Arranging, BesideTheLastSheetThereIsANewOne) {
  Pair gui({1800, 900});
  const PageLayout& layout = *gui.session().pages();
  ASSERT_EQ(layout.canvases.size(), 1U);
  const Box2 fresh = sheet_on_desk(layout, 1);
  const glm::dvec2 goal = gui.window_pixel(gui.camera().to_pixel(fresh.centre()));
  gui.drag_and_wait(gui.pixel_of(1), goal, kCtrl);
  EXPECT_EQ(gui.session().pages()->canvases.size(), 2U);
  EXPECT_EQ(gui.session().pages()->pages.size(), 2U);
  EXPECT_EQ(gui.session().misplaced(), nullptr);
  ASSERT_TRUE(gui.session().sheets());
  EXPECT_EQ(gui.session().sheets()->size(), 2U);
}

TEST(Arranging, EscLetsGoOfTheDragThenTheSelectionThenTheTool) {
  Pair gui;
  const auto before = gui.session().pages();
  gui.point(gui.pixel_of(0));
  gui.window.press_mouse();
  gui.frames();
  gui.point(gui.pixel_of(0) + glm::dvec2(40, 0));
  EXPECT_TRUE(gui.ui().arranging.has_motion);
  gui.key(kEscape);
  EXPECT_FALSE(gui.ui().arranging.has_motion);
  gui.window.release_mouse();
  gui.frames(3);
  EXPECT_EQ(gui.session().pages(), before);
  EXPECT_FALSE(gui.session().has_placed_pieces());
  EXPECT_FALSE(chosen_pieces({gui.session(), gui.ui()}).empty());
  gui.key(kEscape);
  EXPECT_TRUE(chosen_pieces({gui.session(), gui.ui()}).empty());
  EXPECT_TRUE(gui.ui().arranging.is_on);
  gui.key(kEscape);
  EXPECT_FALSE(gui.ui().arranging.is_on);
}

TEST(Arranging, PiecesCutByHandAreArrangedTooAndKeepTheirPlaces) {
  Pair gui;
  gui.drag_and_wait(gui.pixel_of(0), gui.pixel_of(0) + glm::dvec2(-10, 10), kCtrl);
  const Mesh& mesh = gui.session().project().dual->mesh();
  const UnfoldTree tree = *gui.session().project().tree;
  EdgeId fold;
  for (const EdgeId e : mesh.edges())
    if (tree.is_fold(mesh, e)) fold = e;
  const Net before = gui.drawn();
  const auto pages = gui.session().pages();
  gui.session().edit_by_hand(*cut_at(mesh, tree, fold), "cut fold");
  ASSERT_TRUE(gui.until([&] { return gui.session().pages() && gui.session().pages() != pages; }));
  gui.frames(30);
  EXPECT_EQ(gui.session().shown()->net.n_pieces, 3);
  for (const HalfedgeId h : mesh.halfedges())
    ASSERT_NEAR(glm::distance(gui.drawn().corner(h), before.corner(h)), 0, 1e-6);
  EXPECT_TRUE(gui.ui().arranging.is_on);
}

}  // namespace
}  // namespace netwright::testing
