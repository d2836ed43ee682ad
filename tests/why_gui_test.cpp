// What the window says and offers after a search that found no net.
#include <gtest/gtest.h>

#include "tests/gui_support.h"
#include "tests/hatted_shapes.h"
#include "tests/support.h"

namespace netwright {
namespace {

using namespace testing;

class WhyGui : public ::testing::Test {
 protected:
  void open(const std::string& obj) {
    gui_.session().set_time_limit(0);
    gui_.session().open_bytes("model.obj", obj);
    ASSERT_TRUE(gui_.until([this] { return gui_.session().has_model(); }));
    gui_.frames(3);
  }
  void pin_the_brim() {
    const Mesh& mesh = gui_.session().project().dual->mesh();
    Constraints pins;
    for (const auto& [a, b] : {std::pair{0, 1}, {1, 6}, {6, 7}, {7, 3}, {3, 4}})
      for (const HalfedgeId h : mesh.halfedges(FaceId(a)))
        if (mesh.neighbour(h) == FaceId(b)) set_pin(pins, mesh.edge(h), EdgePin::MustFold);
    gui_.session().set_pins(pins, "pin brim");
  }
  void search_in_vain() {
    gui_.session().unfold();
    ASSERT_TRUE(gui_.until([this] { return gui_.session().figures().moves > 300; }));
    gui_.session().stop();
    ASSERT_TRUE(gui_.until([this] { return gui_.session().state() == RunState::Idle; }));
    gui_.frames(3);
    ASSERT_TRUE(gui_.session().trouble());
  }

  Gui gui_;
};

TEST_F(WhyGui, TheBarComesWithTheFailureAndGoesWithTheNextSearch) {
  // So large that nobody asks for a proof, which would end the next search before it is looked at.
  open(shapes::to_obj(endless_search()));
  EXPECT_FALSE(gui_.widgets.find("why/bar"));
  search_in_vain();
  EXPECT_TRUE(gui_.widgets.find("why/bar"));
  EXPECT_FALSE(gui_.widgets.find("why/pins")) << "nothing is pinned";
  gui_.session().unfold();
  gui_.frames(3);
  EXPECT_FALSE(gui_.widgets.find("why/bar"));
}

TEST_F(WhyGui, ClosingTheBarLeavesThePanel) {
  open(shapes::to_obj(with_hats(shapes::tetrahedron())));
  search_in_vain();
  gui_.click("why/close");
  gui_.frames(3);
  EXPECT_FALSE(gui_.widgets.find("why/bar"));
  EXPECT_TRUE(gui_.widgets.find("section/Why not one piece?"));
}

TEST_F(WhyGui, WhyColoursTheHotFacesInBothViews) {
  open(shapes::to_obj(with_hats(shapes::tetrahedron())));
  search_in_vain();
  const FaceId hottest = gui_.session().trouble()->hot.front();
  ASSERT_FALSE(gui_.app.workspace().scene().states().has(hottest, FaceState::Hot));
  gui_.click("why/explain");
  gui_.frames(3);
  const FaceStates& states = gui_.app.workspace().scene().states();
  EXPECT_TRUE(states.has(hottest, FaceState::Hot) && states.has(hottest, FaceState::Warm));
  EXPECT_FALSE(states.has(hottest, FaceState::Overlapping)) << "one colour, one meaning";
  gui_.click("why/heat");
  gui_.frames(3);
  EXPECT_FALSE(gui_.app.workspace().scene().states().has(hottest, FaceState::Hot));
}

TEST_F(WhyGui, ACornerIsShownInBothViews) {
  open(shapes::to_obj(with_hats(shapes::tetrahedron())));
  search_in_vain();
  gui_.click("why/point/1");
  const VertexId vertex = gui_.session().trouble()->points[1].vertex;
  const Mesh& mesh = gui_.session().project().dual->mesh();
  ASSERT_EQ(gui_.ui().lit.points.size(), 1U);
  EXPECT_EQ(gui_.ui().lit.points.front(), mesh.position(vertex));
  for (const FaceId f : gui_.ui().lit.faces) {
    bool has_corner = false;
    for (const HalfedgeId h : mesh.halfedges(f)) has_corner |= mesh.from(h) == vertex;
    EXPECT_TRUE(has_corner);
  }
  gui_.click("why/point/1");
  EXPECT_TRUE(gui_.ui().lit.points.empty());
}

TEST_F(WhyGui, APinIsFoundAndReleasedWithTwoClicks) {
  open(shapes::to_obj(one_hat()));
  pin_the_brim();
  search_in_vain();
  gui_.click("why/pins");
  ASSERT_TRUE(gui_.until([this] { return gui_.session().releases() != nullptr; }));
  gui_.frames(3);
  gui_.click("why/release/0");
  ASSERT_TRUE(gui_.until(
      [this] { return gui_.session().state() == RunState::Idle && gui_.session().sheets() != nullptr; }));
  EXPECT_TRUE(gui_.session().shown()->is_proved);
  EXPECT_FALSE(gui_.widgets.find("why/bar"));
}

}  // namespace
}  // namespace netwright
