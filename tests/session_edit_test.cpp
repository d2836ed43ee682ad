// Editing by hand in the session: pieces, overlaps, proofs, and solving the rest around what was done.
#include <gtest/gtest.h>

#include "tests/session_support.h"

namespace netwright {
namespace {

using namespace testing;

class SessionEdit : public SessionTest {
 protected:
  [[nodiscard]] const Mesh& mesh() const { return session_.project().dual->mesh(); }
  [[nodiscard]] const UnfoldTree& tree() const { return *session_.project().tree; }
  [[nodiscard]] EdgeId a_fold(int skip = 0) const {
    for (const EdgeId e : mesh().edges())
      if (tree().is_fold(mesh(), e) && skip-- == 0) return e;
    return {};
  }
  void cut(EdgeId e) {
    const auto edit = cut_at(mesh(), tree(), e);
    ASSERT_TRUE(edit);
    session_.edit_by_hand(*edit, "cut fold");
  }
  void join(HalfedgeId h) {
    const auto edit = join_at(
        mesh(), tree(), h, [this](EdgeId e) { return session_.may_cut(e); }, session_.project().pins.root);
    ASSERT_TRUE(edit);
    session_.edit_by_hand(*edit, "join edge");
  }
  [[nodiscard]] bool until_derived() {
    return frames_until([this] { return session_.sheets() != nullptr; });
  }
};

TEST_F(SessionEdit, ACutFoldMakesTwoPiecesAndJoiningItAgainANetThatIsProvedAnew) {
  open_and_unfold(ball());
  const EdgeId e = a_fold(20);
  cut(e);
  EXPECT_EQ(session_.undo_label(), "Undo cut fold");
  ASSERT_NE(session_.shown(), nullptr);
  EXPECT_EQ(session_.shown()->net.n_pieces, 2);
  EXPECT_FALSE(session_.shown()->is_proved);
  ASSERT_TRUE(until_derived()) << "two sound pieces can be printed";
  EXPECT_FALSE(session_.shown()->is_proved) << "which is not the one piece that was asked for";
  join(mesh().halfedge(e));
  ASSERT_TRUE(until_derived());
  EXPECT_TRUE(session_.shown()->is_proved);
  EXPECT_TRUE(session_.project().run->is_proved);
  session_.undo();
  session_.undo();
  ASSERT_TRUE(until_derived());
  EXPECT_FALSE(session_.has_hand_edits());
  session_.redo();
  session_.redo();
  ASSERT_TRUE(until_derived());
  EXPECT_TRUE(session_.shown()->is_proved);
}

TEST_F(SessionEdit, SplittingToFitIsOneStepAndThePiecesArePrinted) {
  open_and_unfold(ball());
  session_.set_size({PrintSize::Kind::Height, 300});
  ASSERT_TRUE(frames_until([this] { return session_.pages() && session_.pages()->canvases[0].is_tiled(); }));
  session_.split_to_fit();
  ASSERT_TRUE(frames_until([this] { return session_.shown()->net.n_pieces > 1; }));
  EXPECT_EQ(session_.undo_label(), "Undo split to fit");
  ASSERT_TRUE(until_derived());
  for (const PageLayout::Canvas& canvas : session_.pages()->canvases) EXPECT_FALSE(canvas.is_tiled());
  EXPECT_EQ(session_.project().edits.must_cut.size() + 1,
            static_cast<std::size_t>(session_.shown()->net.n_pieces));
  session_.undo();
  EXPECT_EQ(session_.project().edits.must_cut.size(), 0U);
  ASSERT_TRUE(until_derived());
  EXPECT_EQ(session_.shown()->net.n_pieces, 1);
}

TEST_F(SessionEdit, SolvingTheRestMakesOnePieceAroundTheCut) {
  open_and_unfold(ball());
  const EdgeId e = a_fold(33);
  cut(e);
  session_.unfold_from_here();
  ASSERT_TRUE(frames_until_idle());
  EXPECT_TRUE(session_.shown()->is_proved);
  EXPECT_EQ(session_.shown()->net.n_pieces, 1);
  EXPECT_FALSE(tree().is_fold(mesh(), e)) << "what was cut by hand stays cut";
  EXPECT_FALSE(session_.has_hand_edits());
}

TEST_F(SessionEdit, SolvingTheRestRepairsOverlapsAndKeepsTheJoin) {
  open_and_unfold(bumpy());
  // Some join on bumpy ground overlaps; it is allowed, shown, not printed, and repaired.
  bool was_repaired = false;
  for (const HalfedgeId h : mesh().halfedges()) {
    const auto edit = join_at(
        mesh(), tree(), h, [](EdgeId) { return true; }, FaceId());
    if (!edit || session_.preview(*edit)->overlaps.empty()) continue;
    session_.edit_by_hand(*edit, "join edge");
    EXPECT_FALSE(session_.shown()->overlaps.empty());
    for (int i = 0; i < 20; ++i) frame();
    EXPECT_EQ(session_.sheets(), nullptr);
    session_.unfold_from_here();
    ASSERT_TRUE(frames_until_idle());
    EXPECT_TRUE(session_.shown()->is_proved);
    EXPECT_TRUE(tree().is_fold(mesh(), mesh().edge(h)));
    was_repaired = true;
    break;
  }
  EXPECT_TRUE(was_repaired);
}

TEST_F(SessionEdit, JoiningNeverCutsAPinnedFold) {
  open_and_unfold(ball());
  Constraints pins;
  for (const EdgeId e : mesh().edges())
    if (tree().is_fold(mesh(), e) && e.value % 2 == 0) set_pin(pins, e, EdgePin::MustFold);
  session_.set_pins(pins, "pin");
  for (const HalfedgeId h : mesh().halfedges()) {
    const auto edit = join_at(
        mesh(), tree(), h, [this](EdgeId e) { return session_.may_cut(e); }, FaceId());
    if (edit) {
      EXPECT_TRUE(keeps_pins(mesh(), edit->tree, pins));
    }
  }
}

}  // namespace
}  // namespace netwright
