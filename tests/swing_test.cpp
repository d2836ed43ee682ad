// The swing of a join: from where the net was drawn to where it is, rigid all the way, and only as long as it
// lasts.
#include "ui/swing.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/unfold/hand_edits.h"
#include "core/unfold/steepest_edge.h"
#include "tests/gui_support.h"
#include "tests/support.h"

namespace netwright::testing {
namespace {

Net net_of(const PolygonSoup& soup) {
  const auto dual = make_dual(soup);
  Random random(7);
  return layout(dual, steepest_edge_tree(*dual, random));
}

/// A net, one of its cuts joined, and what comes over.
struct Joined {
  Net before = net_of(shapes::icosphere(2));
  HandEdit edit;
  SwingWish wish;
  Net after;

  Joined() {
    const Mesh& mesh = before.mesh();
    for (const HalfedgeId h : mesh.halfedges()) {
      auto made = join_at(
          mesh, before.tree, h, [](EdgeId) { return true; }, FaceId());
      if (!made || made->moved.size() < 3) continue;
      edit = *made;
      const FaceId near = mesh.face(h);
      const bool near_moves = std::find(edit.moved.begin(), edit.moved.end(), near) != edit.moved.end();
      wish = {mesh.edge(h), near_moves ? mesh.neighbour(h) : near, near_moves ? near : mesh.neighbour(h)};
      break;
    }
    after = layout(before.dual, edit.tree);
  }
  [[nodiscard]] bool moves(FaceId f) const {
    return std::find(edit.moved.begin(), edit.moved.end(), f) != edit.moved.end();
  }
};

TEST(Swing, BeginsWhereTheNetWasDrawn) {
  const Joined join;
  const Swing swing(join.before, join.after, join.wish, 10);
  for (const HalfedgeId h : join.before.mesh().halfedges())
    ASSERT_NEAR(glm::distance(swing.net().corner(h), join.before.corner(h)), 0, 1e-9);
}

TEST(Swing, EndsWithTheSidesJoinedAndAllElseWhereItWas) {
  const Joined join;
  Swing swing(join.before, join.after, join.wish, 10);
  EXPECT_FALSE(swing.advance(10 + Swing::kSeconds));
  const Mesh& mesh = join.before.mesh();
  for (const FaceId f : mesh.faces()) {
    if (join.moves(f)) continue;
    for (const HalfedgeId h : mesh.halfedges(f))
      ASSERT_NEAR(glm::distance(swing.net().corner(h), join.before.corner(h)), 0, 1e-9);
  }
  for (const EdgeId e : mesh.edges()) {
    if (!join.edit.tree.is_fold(mesh, e)) continue;
    const HalfedgeId h = mesh.halfedge(e);
    ASSERT_NEAR(glm::distance(swing.net().corner(h), swing.net().corner(mesh.next(mesh.twin(h)))), 0, 1e-9);
  }
}

TEST(Swing, KeepsThePartThatMovesInOnePieceOnItsWay) {
  const Joined join;
  Swing swing(join.before, join.after, join.wish, 10);
  const Mesh& mesh = join.before.mesh();
  const Net before = swing.net();
  double far = 0;
  for (int step = 1; step < 5; ++step) {
    EXPECT_TRUE(swing.advance(10 + Swing::kSeconds * step / 5));
    for (const EdgeId e : mesh.edges()) {
      const HalfedgeId h = mesh.halfedge(e);
      const bool is_inside = join.edit.tree.is_fold(mesh, e) && join.before.tree.is_fold(mesh, e);
      if (is_inside) {
        ASSERT_NEAR(glm::distance(swing.net().corner(h), swing.net().corner(mesh.next(mesh.twin(h)))), 0,
                    1e-9);
      }
    }
    const HalfedgeId corner = mesh.first(join.edit.moved.back());
    const double way = glm::distance(swing.net().corner(corner), before.corner(corner));
    EXPECT_GT(way, far) << "it goes on at every step";
    far = way;
  }
}

struct Ball : Gui {
  HalfedgeId cut;

  explicit Ball(bool is_calm = false) {
    ui().settings.show_pages = false;  // there the net stays where it is laid out from its root
    ui().is_motion_reduced = is_calm;
    open_sample("Icosphere");
    EXPECT_TRUE(unfold());
    key('E');
    const Mesh& mesh = session().project().dual->mesh();
    for (const EdgeId e : mesh.edges())
      if (session().shown()->kinds[e] == EdgeKind::Cut) cut = mesh.halfedge(e);
  }
  const Scene& scene() { return app.workspace().scene(); }
  void join() {
    const Net& net = *scene().net();
    const PanZoomCamera& camera = app.workspace().net_view().camera();
    const glm::dvec2 a = camera.to_pixel(net.corner(cut));
    const glm::dvec2 b = camera.to_pixel(net.corner(net.mesh().next(cut)));
    const WidgetRect rect = this->rect("net/picture");
    point(glm::dvec2(rect.min.x, rect.min.y) + (a + b) * 0.5);
    frames();
    window.press_mouse();
    frames();
    window.release_mouse();
    frames(2);
  }
};

TEST(Swing, AGlideGoesFromAnyNetToAnyOtherWithPartsOfBothInOnePiece) {
  const Net before = net_of(shapes::icosphere(2));
  Random random(8);
  const Net after = layout(before.dual, steepest_edge_tree(*before.dual, random));
  ASSERT_FALSE(before.tree == after.tree);
  Swing glide(before, after, 10);
  const Mesh& mesh = before.mesh();
  for (const HalfedgeId h : mesh.halfedges())
    ASSERT_NEAR(glm::distance(glide.net().corner(h), before.corner(h)), 0, 1e-9);
  EXPECT_TRUE(glide.advance(10 + Swing::kSeconds / 2));
  int n_kept = 0;
  double way = 0;
  for (const EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e);
    way = std::max(way, glm::distance(glide.net().corner(h), before.corner(h)));
    if (!before.tree.is_fold(mesh, e) || !after.tree.is_fold(mesh, e)) continue;
    ++n_kept;
    ASSERT_NEAR(glm::distance(glide.net().corner(h), glide.net().corner(mesh.next(mesh.twin(h)))), 0, 1e-9);
  }
  EXPECT_GT(n_kept, 50);
  EXPECT_GT(way, mesh.mean_edge());
  // The next goal comes while it is on its way: it goes on from where it is drawn.
  const Net drawn = glide.net();
  Swing next(drawn, before, 20);
  for (const HalfedgeId h : mesh.halfedges())
    ASSERT_NEAR(glm::distance(next.net().corner(h), drawn.corner(h)), 0, 1e-9);
  EXPECT_FALSE(next.advance(20 + Swing::kSeconds));
  for (const HalfedgeId h : mesh.halfedges())
    ASSERT_NEAR(glm::distance(next.net().corner(h), before.corner(h)), 0, 1e-9);
}

TEST(Swing, ANetThatOnlyLiesElsewhereGlidesThereInOnePiece) {
  const Net before = net_of(shapes::icosphere(2));
  Net after = before;
  const Rigid2 motion = Rigid2{1, 0, 5, -3} * Rigid2::rotation(2.5);
  for (const FaceId f : after.mesh().faces()) after.placement[f] = motion * after.placement[f];
  const Net back = laid_over(after, before);
  Swing glide(before, after, 10);
  EXPECT_TRUE(glide.advance(10 + Swing::kSeconds / 3));
  const Mesh& mesh = before.mesh();
  const HalfedgeId first = mesh.first(FaceId(0));
  for (const HalfedgeId h : mesh.halfedges()) {
    ASSERT_NEAR(glm::distance(back.corner(h), before.corner(h)), 0, 1e-9);
    ASSERT_NEAR(glm::distance(glide.net().corner(h), glide.net().corner(first)),
                glm::distance(before.corner(h), before.corner(first)), 1e-9);
  }
  EXPECT_FALSE(glide.advance(10 + Swing::kSeconds));
  for (const HalfedgeId h : mesh.halfedges())
    ASSERT_NEAR(glm::distance(glide.net().corner(h), after.corner(h)), 0, 1e-9);
}

TEST(Swing, AJoinedPartSwingsAndThenTheNetIsDrawnAsItIs) {
  Ball gui;
  const Net before = *gui.scene().net();
  gui.join();
  ASSERT_EQ(gui.session().undo_label(), "Undo join edge");
  ASSERT_TRUE(gui.scene().is_swinging());
  const Net& now = gui.session().shown()->net;
  EXPECT_TRUE(now.tree.is_fold(now.mesh(), now.mesh().edge(gui.cut))) << "the project has changed at once";
  gui.frames(5);
  EXPECT_TRUE(gui.scene().is_swinging());
  Net last = *gui.scene().net();
  for (int i = 0; i < 60 && gui.scene().is_swinging(); ++i) {
    last = *gui.scene().net();
    gui.frames();
  }
  EXPECT_FALSE(gui.scene().is_swinging());
  const double edge = before.mesh().mean_edge();
  for (const HalfedgeId h : now.mesh().halfedges()) {
    ASSERT_NEAR(glm::distance(gui.scene().net()->corner(h), gui.session().shown()->net.corner(h)), 0, 1e-12);
    ASSERT_LT(glm::distance(gui.scene().net()->corner(h), last.corner(h)), 0.2 * edge) << "and ends there";
  }
}

TEST(Swing, UndoEndsIt) {
  Ball gui;
  gui.join();
  ASSERT_TRUE(gui.scene().is_swinging());
  gui.key('Z', 2);
  EXPECT_FALSE(gui.scene().is_swinging());
}

TEST(Swing, NothingSwingsWhereTheDesktopAsksForLessMotion) {
  Ball gui(true);
  gui.join();
  EXPECT_EQ(gui.session().undo_label(), "Undo join edge");
  EXPECT_FALSE(gui.scene().is_swinging());
}

}  // namespace
}  // namespace netwright::testing
