// Pins in the session: kept by every run, told when they contradict, one undo step each.
#include <gtest/gtest.h>

#include "tests/pins.h"
#include "tests/session_support.h"

namespace netwright {
namespace {

using namespace testing;

class SessionPins : public SessionTest {
 protected:
  [[nodiscard]] const Mesh& mesh() const { return session_.project().dual->mesh(); }
  [[nodiscard]] bool is_fold(EdgeId e) const { return session_.project().tree->is_fold(mesh(), e); }
  /// Pins an edge to be what it is not in the present net.
  EdgeId pin_otherwise(int number) {
    const EdgeId e(number);
    Constraints pins = session_.project().pins;
    set_pin(pins, e, is_fold(e) ? EdgePin::MustCut : EdgePin::MustFold);
    session_.set_pins(pins, "pin 1 edge");
    return e;
  }
  [[nodiscard]] Constraints ring() const {
    Constraints pins;
    const VertexId v = mesh().from(mesh().first(FaceId(0)));
    for (const HalfedgeId h : mesh().halfedges())
      if (mesh().from(h) == v) set_pin(pins, mesh().edge(h), EdgePin::MustFold);
    return pins;
  }
};

TEST_F(SessionPins, APinIsAStepAndTheNextRunKeepsIt) {
  open_and_unfold(ball());
  const EdgeId e = pin_otherwise(5);
  const bool was_fold = is_fold(e);
  EXPECT_EQ(session_.undo_label(), "Undo pin 1 edge");
  EXPECT_FALSE(session_.keeps_pins());
  EXPECT_TRUE(session_.shown()->is_proved) << "the old net stays until there is a new one";
  session_.unfold();
  ASSERT_TRUE(frames_until_idle());
  EXPECT_TRUE(session_.keeps_pins());
  EXPECT_NE(is_fold(e), was_fold);
  session_.undo();
  session_.undo();
  EXPECT_TRUE(session_.project().pins.are_free());
}

TEST_F(SessionPins, FromHereOnlyLittleChanges) {
  open_and_unfold(ball());
  const UnfoldTree before = *session_.project().tree;
  pin_otherwise(40);
  session_.unfold_from_here();
  ASSERT_TRUE(frames_until_idle());
  EXPECT_TRUE(session_.keeps_pins());
  EXPECT_TRUE(session_.shown()->is_proved);
  int n_changed = 0;
  for (const EdgeId e : mesh().edges()) n_changed += before.is_fold(mesh(), e) != is_fold(e) ? 1 : 0;
  EXPECT_GE(n_changed, 2);
  EXPECT_LE(n_changed, 10);
}

TEST_F(SessionPins, ContradictionsAreToldBeforeASearchStarts) {
  open(ball());
  session_.set_pins(ring(), "pin folds");
  ASSERT_NE(session_.contradiction(), nullptr);
  session_.unfold();
  frame();
  EXPECT_EQ(session_.state(), RunState::Idle);
  EXPECT_TRUE(has_message(Message::Kind::Error, "ring"));
  session_.undo();
  EXPECT_EQ(session_.contradiction(), nullptr);
  session_.unfold();
  EXPECT_TRUE(frames_until_idle());
}

TEST_F(SessionPins, APinSetWhileItSearchesIsKeptByTheResult) {
  open(terrain());
  session_.set_speed(kAMoveInTenSeconds);
  session_.unfold();
  ASSERT_TRUE(frames_until([&] { return session_.shown() != nullptr; }));
  const EdgeId e = mesh().edge(mesh().first(FaceId(100)));
  Constraints pins;
  set_pin(pins, e, session_.shown()->net.tree.is_fold(mesh(), e) ? EdgePin::MustCut : EdgePin::MustFold);
  session_.set_pins(pins, "pin");
  EXPECT_EQ(session_.state(), RunState::Running);
  ASSERT_TRUE(frames_until([&] { return session_.shown() != nullptr; }));
  EXPECT_TRUE(session_.keeps_pins());
  session_.set_speed(kFullSpeed);
  ASSERT_TRUE(frames_until_idle());
  EXPECT_TRUE(session_.keeps_pins());
}

TEST_F(SessionPins, ContradictingPinsEndARunningSearch) {
  open(endless());
  session_.unfold();
  ASSERT_TRUE(frames_until([&] { return session_.shown() != nullptr; }));
  session_.set_pins(ring(), "pin");
  EXPECT_EQ(session_.state(), RunState::Idle);
  frame();
  EXPECT_TRUE(has_message(Message::Kind::Error, "ring"));
}

TEST_F(SessionPins, SimplifyingCarriesPinsToTheNearestEdgesAndUndoBringsThemBack) {
  open(shapes::to_obj(shapes::icosphere(6)));
  Constraints pins;
  for (const int e : {3, 90, 200, 333}) set_pin(pins, EdgeId(e), EdgePin::MustCut);
  session_.set_pins(pins, "pin");
  session_.simplify_to(400, false);
  ASSERT_TRUE(frames_until([&] { return !session_.is_making() && mesh().n_faces() <= 400; }));
  ASSERT_TRUE(frames_until_idle());
  EXPECT_GE(session_.project().pins.must_cut.size(), 2u);
  EXPECT_EQ(session_.project().pins.must_cut.size() < 4, has_message(Message::Kind::Notice, "no place"));
  EXPECT_TRUE(session_.keeps_pins());
  while (session_.can_undo() && mesh().n_faces() <= 400) session_.undo();
  EXPECT_EQ(session_.project().pins, pins);
}

TEST_F(SessionPins, SimplifyingDownAndBackUpInOneDragBringsEveryPinBack) {
  open_and_unfold(ball());
  Random random(3);
  const Constraints pins = random_pins(*session_.project().dual, 4, random);
  session_.set_pins(pins, "pin");
  session_.unfold_from_here();
  ASSERT_TRUE(frames_until_idle());
  const Project before = session_.project();
  ASSERT_TRUE(before.tree);
  bool has_lost_some = false;
  for (const int faces : {200, 60, 24, 100, 0}) {
    session_.simplify_to(faces, true);
    ASSERT_TRUE(frames_until([&] { return !session_.is_making() && session_.recipe().faces == faces; }));
    const Constraints& now = session_.project().pins;
    has_lost_some |= now.must_fold.size() + now.must_cut.size() < 8;
  }
  session_.simplify_to(0, false);
  ASSERT_TRUE(frames_until_idle());
  EXPECT_TRUE(has_lost_some) << "a few faces have no place for all pins";
  EXPECT_EQ(session_.project().pins, before.pins);
  EXPECT_EQ(session_.project().tree, before.tree) << "nor has the net any reason to be another one";
  EXPECT_TRUE(session_.shown()->is_proved);
  session_.undo();
  EXPECT_EQ(session_.project(), before) << "the whole drag is one step";
}

TEST_F(SessionPins, AStopOfADragHasThePinsThatTheFirstMeshWouldGiveIt) {
  open(ball());
  Random random(5);
  session_.set_pins(random_pins(*session_.project().dual, 4, random), "pin");
  const auto pins_at = [&](const std::vector<int>& stops) {
    for (const int faces : stops) {
      session_.simplify_to(faces, true);
      EXPECT_TRUE(frames_until([&] { return !session_.is_making() && session_.recipe().faces == faces; }));
    }
    Constraints pins = session_.project().pins;
    session_.simplify_to(stops.back(), false);
    EXPECT_TRUE(frames_until_idle());
    while (session_.recipe().faces > 0) session_.undo();
    return pins;
  };
  EXPECT_EQ(pins_at({240, 120, 40, 160}), pins_at({160}));
}

}  // namespace
}  // namespace netwright
