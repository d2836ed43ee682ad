// A session whose model has no net in one piece: it says so, and offers nets of several.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/session_support.h"

namespace netwright {
namespace {

using testing::SessionTest;

class SessionPiecesTest : public SessionTest {
 protected:
  void search_hats() {
    open(shapes::to_obj(testing::with_hats(shapes::tetrahedron())));
    session_.unfold();
    ASSERT_TRUE(frames_until([this] { return session_.is_impossible(); }));
    ASSERT_TRUE(frames_until([this] { return session_.state() == RunState::Idle; }));
  }
  void look() {
    session_.look_for_pieces();
    ASSERT_TRUE(session_.trial());
    ASSERT_TRUE(frames_until([this] { return session_.pieces() != nullptr; }));
    EXPECT_EQ(session_.trial(), nullptr);
  }
};

TEST_F(SessionPiecesTest, ASearchThatCannotSucceedEndsByItselfAndSaysWhy) {
  search_hats();
  EXPECT_FALSE(session_.shown()->is_proved);
  EXPECT_FALSE(session_.project().tree);
  EXPECT_TRUE(std::any_of(messages_.begin(), messages_.end(), [](const Message& message) {
    return message.text.find("has no net in one piece: that is proved.") != std::string::npos;
  }));
  EXPECT_EQ(session_.pieces(), nullptr);
}

TEST_F(SessionPiecesTest, ANetOfPiecesIsTakenAndPrintedAndTakenBack) {
  search_hats();
  look();
  const auto found = session_.pieces();
  ASSERT_EQ(found->choices.size(), 3U);
  EXPECT_EQ(found->choices[0].net.n_pieces, 2);
  session_.take_pieces(1);
  EXPECT_EQ(session_.undo_label(), "Undo unfold into 3 pieces");
  EXPECT_TRUE(session_.shown()->is_proved);
  EXPECT_EQ(session_.shown()->net.n_pieces, 3);
  ASSERT_TRUE(frames_until([this] { return session_.sheets() != nullptr; }));
  EXPECT_FALSE(session_.is_impossible()) << "a net is shown, nothing has failed";
  session_.undo();
  EXPECT_FALSE(session_.project().tree);
  session_.redo();
  ASSERT_TRUE(session_.project().tree);
  EXPECT_EQ(*session_.project().tree, found->choices[1].net.tree);
}

TEST_F(SessionPiecesTest, PiecesAreOfTheirPinsAndANewSearchEndsTheLookForThem) {
  search_hats();
  look();
  Constraints pins;
  pins.must_cut = {EdgeId(0)};
  session_.set_pins(pins, "pin cut");
  EXPECT_EQ(session_.pieces(), nullptr);
  session_.take_pieces(0);
  EXPECT_FALSE(session_.project().tree);
  session_.unfold();
  EXPECT_EQ(session_.trial(), nullptr);
  ASSERT_TRUE(frames_until([this] { return session_.is_impossible(); }));
  look();
  for (const PiecesChoice& choice : session_.pieces()->choices)
    EXPECT_TRUE(keeps_pins(choice.net.mesh(), choice.net.tree, pins));
  session_.stop_trial();
}

TEST_F(SessionPiecesTest, WithANetThereIsNothingToLookFor) {
  open_and_unfold(testing::bumpy());
  EXPECT_FALSE(session_.is_impossible());
  session_.look_for_pieces();
  EXPECT_EQ(session_.trial(), nullptr);
}

}  // namespace
}  // namespace netwright
