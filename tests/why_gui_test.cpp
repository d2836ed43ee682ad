// What the window says and offers after a search that found no net.
#include <gtest/gtest.h>

#include "core/sheet/pages.h"
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

TEST_F(WhyGui, ASofterShapeIsOfferedTakenAndTakenBack) {
  open(shapes::to_obj(with_hats(shapes::tetrahedron())));
  search_in_vain();
  const auto before = gui_.session().project().dual;
  const std::size_t n_steps = gui_.session().history().size();
  gui_.click("why/soften");
  EXPECT_TRUE(gui_.widgets.find("section/Why not one piece?"));
  ASSERT_TRUE(gui_.until([this] { return gui_.session().softening() != nullptr; }));
  gui_.frames(3);
  EXPECT_EQ(gui_.session().project().dual, before) << "nothing is changed without being asked";
  EXPECT_FALSE(gui_.widgets.find("why/stop")) << "nothing is tried any more";
  gui_.click("why/take-softening");
  ASSERT_TRUE(gui_.until([this] {
    const auto shown = gui_.session().shown();
    return gui_.session().state() == RunState::Idle && shown && shown->is_proved;
  }));
  gui_.frames(3);
  EXPECT_NE(gui_.session().project().dual, before);
  EXPECT_FALSE(gui_.widgets.find("why/bar"));
  while (gui_.session().history_position() >= n_steps) gui_.key('Z', kControl);
  EXPECT_EQ(gui_.session().project().dual, before);
  EXPECT_EQ(gui_.session().project().tree, nullptr);
}

TEST_F(WhyGui, NetsOfSeveralPiecesAreOfferedTakenAndTakenBack) {
  open(shapes::to_obj(with_hats(shapes::tetrahedron())));
  search_in_vain();
  gui_.click("why/pieces");
  ASSERT_TRUE(gui_.until([this] { return gui_.session().pieces() != nullptr; }));
  gui_.frames(3);
  EXPECT_EQ(gui_.session().project().tree, nullptr) << "nothing is taken without being asked";
  const auto& choices = gui_.session().pieces()->choices;
  ASSERT_GE(choices.size(), 2U);
  const int n_pieces = choices[1].net.n_pieces;
  gui_.click("why/take-pieces/1");
  ASSERT_TRUE(gui_.until([this] { return gui_.session().sheets() != nullptr; }));
  gui_.frames(3);
  EXPECT_EQ(gui_.session().shown()->net.n_pieces, n_pieces);
  EXPECT_FALSE(gui_.widgets.find("why/bar"));
  gui_.key('Z', kControl);
  EXPECT_EQ(gui_.session().project().tree, nullptr);
}

TEST_F(WhyGui, TellsTheCutsOfSeveralPiecesAsTheyWouldBePrinted) {
  open(shapes::to_obj(with_hats(shapes::tetrahedron())));
  search_in_vain();
  gui_.session().look_for_pieces();
  const auto lengths = [this] {
    EXPECT_TRUE(gui_.until([this] { return !gui_.session().pieces_cut_mm().empty(); }));
    return gui_.session().pieces_cut_mm();
  };
  const std::vector<double> fitted = lengths();
  const auto& choices = gui_.session().pieces()->choices;
  ASSERT_EQ(fitted.size(), choices.size());
  for (std::size_t i = 0; i < choices.size(); ++i) {
    const Project& project = gui_.session().project();
    const double scale = arrange(choices[i].net, project.paper, project.size, project.tabs).scale;
    EXPECT_DOUBLE_EQ(fitted[i], choices[i].cut_length * scale);
  }
  const double height = gui_.session().project().dual->mesh().height();
  gui_.session().set_size({PrintSize::Kind::Height, 300});
  EXPECT_TRUE(gui_.session().pieces_cut_mm().empty()) << "those of another size count no more";
  EXPECT_DOUBLE_EQ(lengths().front(), choices.front().cut_length * 300 / height);
}

TEST_F(WhyGui, ATrialCanBeStoppedAndMadeAgain) {
  // So large that the trial goes on until it is stopped.
  open(shapes::to_obj(endless_search()));
  search_in_vain();
  for (const char* const wish : {"why/soften", "why/pieces"}) {
    gui_.click(wish);
    ASSERT_TRUE(gui_.session().trial()) << wish;
    gui_.click("why/stop");
    EXPECT_FALSE(gui_.session().trial()) << wish;
    EXPECT_FALSE(gui_.widgets.find("why/stop"));
    EXPECT_TRUE(gui_.widgets.find(wish)) << "offered again";
  }
  EXPECT_FALSE(gui_.session().softening());
  EXPECT_FALSE(gui_.session().pieces());
}

}  // namespace
}  // namespace netwright
