// A session after a search that found no net: what it tells, and how pins that stand in the way are released.
#include <gtest/gtest.h>

#include "tests/hatted_shapes.h"
#include "tests/session_support.h"

namespace netwright {
namespace {

using testing::SessionTest;

class SessionWhyTest : public SessionTest {
 protected:
  /// Folds around the brim that leave no net.
  void pin_the_brim() {
    const Mesh& mesh = session_.project().dual->mesh();
    Constraints pins;
    for (const auto& [a, b] : {std::pair{0, 1}, {1, 6}, {6, 7}, {7, 3}, {3, 4}})
      for (const HalfedgeId h : mesh.halfedges(FaceId(a)))
        if (mesh.neighbour(h) == FaceId(b)) set_pin(pins, mesh.edge(h), EdgePin::MustFold);
    session_.set_pins(pins, "pin brim");
  }
  void search_in_vain() {
    session_.unfold();
    ASSERT_TRUE(frames_until([this] { return session_.figures().moves > 300; }));
    session_.stop();
    ASSERT_TRUE(frames_until([this] { return session_.state() == RunState::Idle; }));
    ASSERT_TRUE(session_.shown());
    ASSERT_FALSE(session_.shown()->is_proved);
  }
  void fail_with_pins() {
    open(shapes::to_obj(testing::one_hat()));
    pin_the_brim();
    search_in_vain();
  }
};

TEST_F(SessionWhyTest, TellsNothingBeforeASearchOrAfterOneThatFoundANet) {
  open_and_unfold(testing::bumpy());
  EXPECT_EQ(session_.trouble(), nullptr);
  EXPECT_EQ(session_.releases(), nullptr);
  session_.look_for_releases();
  EXPECT_EQ(session_.trial(), nullptr);
}

TEST_F(SessionWhyTest, TellsWhereAStoppedSearchWasStuck) {
  open(testing::endless());
  search_in_vain();
  ASSERT_TRUE(session_.trouble());
  EXPECT_FALSE(session_.trouble()->hot.empty());
  EXPECT_FALSE(session_.trouble()->points.empty());
  session_.unfold();
  EXPECT_EQ(session_.trouble(), nullptr) << "the next search has not failed yet";
  session_.stop();
  ASSERT_TRUE(frames_until([this] { return session_.state() == RunState::Idle; }));
  EXPECT_TRUE(session_.trouble());
}

TEST_F(SessionWhyTest, FindsThePinAndReleasesItAsOneStep) {
  fail_with_pins();
  session_.look_for_releases();
  ASSERT_TRUE(session_.trial());
  ASSERT_TRUE(frames_until([this] { return session_.releases() != nullptr; }));
  EXPECT_EQ(session_.trial(), nullptr);
  ASSERT_FALSE(session_.releases()->ways.empty());
  const std::vector<Pin> way = session_.releases()->ways.front();
  const std::size_t n_steps = session_.history().size();
  session_.release(way);
  ASSERT_TRUE(frames_until_idle());
  ASSERT_TRUE(session_.shown()->is_proved);
  EXPECT_TRUE(session_.keeps_pins());
  EXPECT_EQ(session_.history().size(), n_steps + 2) << "releasing, and the net";
  EXPECT_EQ(session_.history()[n_steps], way.size() == 1 ? "release pin" : "release pins");
  EXPECT_EQ(pins_in(session_.project().pins).size(), 5 - way.size());
  session_.undo();
  session_.undo();
  EXPECT_EQ(pins_in(session_.project().pins).size(), 5U);
}

TEST_F(SessionWhyTest, ForgetsWhatItFoundWhenPinsChange) {
  fail_with_pins();
  session_.look_for_releases();
  ASSERT_TRUE(frames_until([this] { return session_.releases() != nullptr; }));
  Constraints pins = session_.project().pins;
  pins.must_fold.pop_back();
  session_.set_pins(pins, "unpin");
  EXPECT_EQ(session_.releases(), nullptr);
  session_.undo();
}

TEST_F(SessionWhyTest, StopsTryingWhenASearchBegins) {
  fail_with_pins();
  session_.look_for_releases();
  ASSERT_TRUE(session_.trial());
  session_.unfold();
  EXPECT_EQ(session_.trial(), nullptr);
  EXPECT_EQ(session_.state(), RunState::Running);
}

TEST_F(SessionWhyTest, SoftensTheShapeAsOneStepWhenAgreed) {
  open(shapes::to_obj(testing::with_hats(shapes::tetrahedron())));
  search_in_vain();
  const auto before = session_.project().dual;
  session_.look_for_softening();
  ASSERT_TRUE(frames_until([this] { return session_.softening() != nullptr; }));
  EXPECT_EQ(session_.project().dual, before) << "nothing is changed without being asked";
  ASSERT_TRUE(session_.softening()->is_found());
  session_.take_softening();
  ASSERT_TRUE(frames_until([this] { return session_.shown() && session_.shown()->is_proved; }));
  EXPECT_FALSE(session_.recipe().moved.empty());
  ASSERT_TRUE(frames_until_idle());
  session_.undo();
  session_.undo();
  EXPECT_TRUE(session_.recipe().moved.empty());
  EXPECT_EQ(session_.project().dual, before);
}

TEST_F(SessionWhyTest, TakesANetOfSeveralPiecesThatCanBePrinted) {
  open(shapes::to_obj(testing::with_hats(shapes::tetrahedron())));
  search_in_vain();
  session_.look_for_pieces();
  ASSERT_TRUE(frames_until([this] { return session_.pieces() != nullptr; }));
  ASSERT_FALSE(session_.pieces()->choices.empty());
  ASSERT_TRUE(frames_until([this] { return !session_.pieces_cut_mm().empty(); }));
  EXPECT_EQ(session_.pieces_cut_mm().size(), session_.pieces()->choices.size());
  const int n_pieces = session_.pieces()->choices.front().net.n_pieces;
  EXPECT_GE(n_pieces, 2);
  session_.take_pieces(0);
  ASSERT_TRUE(frames_until([this] { return session_.sheets() != nullptr; }));
  EXPECT_EQ(session_.shown()->net.n_pieces, n_pieces);
  EXPECT_TRUE(session_.shown()->overlaps.empty());
  EXPECT_EQ(session_.undo_label(), "Undo unfold into " + std::to_string(n_pieces) + " pieces");
  session_.undo();
  EXPECT_EQ(session_.project().tree, nullptr);
}

}  // namespace
}  // namespace netwright
