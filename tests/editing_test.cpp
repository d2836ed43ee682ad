// Joining and cutting with the tool, in the real interface.
#include <gtest/gtest.h>

#include "core/unfold/hand_edits.h"
#include "tests/gui_support.h"

namespace netwright::testing {
namespace {

struct Ball : Gui {
  Ball() {
    open_sample("Icosphere");
    EXPECT_TRUE(unfold());
    key('E');
    EXPECT_TRUE(ui().editing.is_on);
  }
  [[nodiscard]] const Mesh& mesh() { return session().project().dual->mesh(); }
  [[nodiscard]] const Net& net() { return *app.workspace().scene().net(); }
  glm::dvec2 side_pixel(HalfedgeId h) {
    const PanZoomCamera& camera = app.workspace().net_view().camera();
    const WidgetRect rect = this->rect("net/picture");
    const glm::dvec2 a = camera.to_pixel(net().corner(h));
    const glm::dvec2 b = camera.to_pixel(net().corner(mesh().next(h)));
    return glm::dvec2(rect.min.x, rect.min.y) + (a + b) * 0.5;
  }
  HalfedgeId first_of(EdgeKind kind) {
    const auto& kinds = session().shown()->kinds;
    for (const EdgeId e : kinds.ids())
      if (kinds[e] == kind) return mesh().halfedge(e);
    ADD_FAILURE() << "the net has no such edge";
    return {};
  }
  void click_at(glm::dvec2 at) {
    point(at);
    frames();
    window.press_mouse(0, 0);
    frames();
    window.release_mouse();
    frames(3);
  }
};

TEST(Editing, AClickOnAFoldCutsItAndOnTheCutJoinsItAgain) {
  Ball gui;
  const HalfedgeId fold = gui.first_of(EdgeKind::Mountain);
  gui.point(gui.side_pixel(fold));
  gui.frames(2);
  ASSERT_TRUE(gui.ui().editing.edit.has_value());
  EXPECT_NE(gui.ui().hint.find("2 pieces"), std::string::npos) << gui.ui().hint;
  gui.click_at(gui.side_pixel(fold));
  EXPECT_EQ(gui.session().shown()->net.n_pieces, 2);
  EXPECT_EQ(gui.session().undo_label(), "Undo cut fold");
  gui.frames(30);
  gui.click_at(gui.side_pixel(fold));
  EXPECT_EQ(gui.session().shown()->net.n_pieces, 1);
  EXPECT_EQ(gui.session().undo_label(), "Undo join edge");
  EXPECT_TRUE(gui.until([&] { return gui.session().sheets() != nullptr; })) << "proved again";
}

TEST(Editing, WhatWouldHappenIsDrawnBeforeTheClick) {
  Ball gui;
  const HalfedgeId cut = gui.first_of(EdgeKind::Cut);
  gui.point({2, 2});
  gui.frames(2);
  const std::size_t before = gui.app.workspace().overlay().lines().plane.size();
  gui.point(gui.side_pixel(cut));
  gui.frames(2);
  ASSERT_TRUE(gui.ui().editing.edit.has_value());
  EXPECT_GT(gui.app.workspace().overlay().lines().plane.size(), before + 3);
  EXPECT_NE(gui.ui().hint.find("click joins it"), std::string::npos) << gui.ui().hint;
  EXPECT_NE(gui.ui().hint.find("overlap"), std::string::npos) << gui.ui().hint;
}

TEST(Editing, ADraggedFaceHangsElsewhere) {
  Ball gui;
  const UnfoldTree before = gui.session().shown()->net.tree;
  FaceId leaf;
  for (const FaceId f : gui.mesh().faces())
    if (branch_of(gui.mesh(), before, f).size() == 1 && !before.is_root(f)) leaf = f;
  ASSERT_TRUE(leaf.is_valid());
  const auto places = places_for(gui.mesh(), before, leaf);
  ASSERT_FALSE(places.empty());
  const HalfedgeId there = gui.mesh().twin(places.front());
  gui.drag(gui.net_pixel(leaf), gui.side_pixel(there));
  gui.frames(3);
  EXPECT_TRUE(gui.session().has_hand_edits());
  EXPECT_FALSE(gui.session().shown()->net.tree == before);
  EXPECT_EQ(gui.session().shown()->net.n_pieces, 1);
  EXPECT_EQ(gui.session().undo_label(), "Undo hang branch");
}

TEST(Editing, EscLetsGoOfTheTool) {
  Ball gui;
  gui.key(256);
  EXPECT_FALSE(gui.ui().editing.is_on);
}

}  // namespace
}  // namespace netwright::testing
