// Another version of the model in an open session, and the repair of a broken file as a step of its own.
#include <gtest/gtest.h>

#include <fstream>

#include "core/project/open_model.h"
#include "tests/pins.h"
#include "tests/session_support.h"

namespace netwright {
namespace {

using namespace testing;

class SessionReplace : public SessionTest {
 protected:
  std::filesystem::path write(const std::string& name, const std::string& text) {
    std::filesystem::path path = in_folder(name);
    std::ofstream(path) << text;
    return path;
  }
  /// The ball with one corner pulled out.
  static std::string pulled_ball() {
    PolygonSoup soup = shapes::icosphere(4);
    soup.points.back() *= 1.2;
    return shapes::to_obj(soup);
  }
  static std::string broken_ball() {
    PolygonSoup soup = shapes::icosphere(4);
    soup.add_face(std::vector<int>(soup.face(0).begin(), soup.face(0).end()));
    return shapes::to_obj(soup);
  }
  void pin_some() {
    Random random(4);
    session_.set_pins(random_pins(*session_.project().dual, 3, random), "pin");
  }
  bool until_replaced() {
    return frames_until([this] { return !session_.is_replacing(); }) && frames_until_idle();
  }
};

TEST_F(SessionReplace, IsOneStepWithItsNetAndUndoBringsTheOldModelBack) {
  open_and_unfold(ball());
  pin_some();
  session_.unfold_from_here();
  ASSERT_TRUE(frames_until_idle());
  const Project before = session_.project();
  const std::size_t n_steps = session_.history().size();
  session_.replace_model(write("ball2.obj", pulled_ball()));
  EXPECT_TRUE(session_.is_replacing());
  EXPECT_NE(session_.chore(), nullptr);
  ASSERT_TRUE(until_replaced());
  EXPECT_EQ(session_.history().size(), n_steps + 1);
  EXPECT_EQ(session_.undo_label(), "Undo replace model");
  const Project& now = session_.project();
  EXPECT_EQ(now.source->name, "ball2.obj");
  ASSERT_NE(now.tree, nullptr);
  EXPECT_TRUE(now.run->is_proved);
  EXPECT_TRUE(session_.shown()->is_proved);
  EXPECT_TRUE(session_.keeps_pins());
  EXPECT_NE(session_.sheets(), nullptr);
  ASSERT_NE(session_.replacement(), nullptr);
  EXPECT_EQ(session_.replacement()->n_lost, 0);
  EXPECT_EQ(session_.replacement()->n_folds, 319);
  EXPECT_TRUE(has_message(Message::Kind::Notice, "ball2.obj takes the place of model.obj"));
  int n_changed = 0;
  for (const EdgeId e : now.dual->mesh().edges())
    n_changed += before.tree->is_fold(before.dual->mesh(), e) != now.tree->is_fold(now.dual->mesh(), e);
  EXPECT_LE(n_changed, 16) << "only what must change moves";

  session_.undo();
  EXPECT_EQ(session_.project(), before);
  EXPECT_EQ(session_.replacement(), nullptr);
  ASSERT_TRUE(frames_until_idle());
  EXPECT_TRUE(session_.shown()->is_proved);
  session_.redo();
  EXPECT_EQ(session_.project().source->name, "ball2.obj");
  EXPECT_NE(session_.project().tree, nullptr);
  EXPECT_NE(session_.replacement(), nullptr);
}

TEST_F(SessionReplace, WithoutANetNoSearchBegins) {
  open(ball());
  session_.replace_model(write("ball2.obj", pulled_ball()));
  ASSERT_TRUE(until_replaced());
  EXPECT_EQ(session_.project().source->name, "ball2.obj");
  EXPECT_EQ(session_.project().tree, nullptr);
  EXPECT_EQ(session_.runs().size(), 0U);
}

TEST_F(SessionReplace, WhatChangesMeanwhileIsNotLost) {
  open_and_unfold(ball());
  session_.replace_model(write("ball2.obj", pulled_ball()));
  session_.pin_root(FaceId(9));
  PaperSetup paper = session_.project().paper;
  paper.format = "A3";
  session_.set_paper(paper);
  ASSERT_TRUE(until_replaced());
  EXPECT_EQ(session_.project().source->name, "ball2.obj");
  EXPECT_TRUE(session_.project().pins.root.is_valid());
  EXPECT_EQ(session_.project().paper.format, "A3");
}

TEST_F(SessionReplace, CanBeGivenUpAndRefusesWhatCannotBeRead) {
  open_and_unfold(ball());
  const Project before = session_.project();
  session_.replace_model(write("ball2.obj", pulled_ball()));
  session_.cancel_opening();
  EXPECT_FALSE(session_.is_replacing());
  for (int i = 0; i < 60; ++i) frame();
  EXPECT_EQ(session_.project(), before);
  session_.replace_model(write("text.obj", "nothing of use"));
  ASSERT_TRUE(until_replaced());
  EXPECT_TRUE(has_message(Message::Kind::Error, "text.obj"));
  EXPECT_EQ(session_.project(), before);
  session_.replace_model(in_folder("missing.obj"));
  ASSERT_TRUE(until_replaced());
  EXPECT_TRUE(has_message(Message::Kind::Error, "missing.obj"));
  EXPECT_EQ(session_.project(), before);
}

TEST_F(SessionReplace, ABrokenVersionIsAskedAboutFirst) {
  open_and_unfold(ball());
  pin_some();
  const Project before = session_.project();
  session_.replace_model(write("broken.obj", broken_ball()));
  ASSERT_TRUE(frames_until([this] { return session_.pending() != nullptr; }));
  EXPECT_EQ(session_.project(), before) << "nothing is replaced without being asked";
  session_.drop_pending();
  EXPECT_EQ(session_.project(), before);
  session_.replace_model(in_folder("broken.obj"));
  ASSERT_TRUE(frames_until([this] { return session_.pending() != nullptr; }));
  session_.repair_pending();
  ASSERT_TRUE(until_replaced());
  EXPECT_EQ(session_.undo_label(), "Undo replace model");
  EXPECT_EQ(session_.project().source->name, "broken.obj");
  EXPECT_EQ(session_.recipe().repairs, usual_repair().repairs);
  EXPECT_EQ(session_.replacement()->n_lost, 0);
  session_.undo();
  EXPECT_EQ(session_.project(), before);
}

TEST_F(SessionReplace, AnotherFileOpenedMeanwhileWins) {
  open_and_unfold(ball());
  session_.replace_model(write("ball2.obj", pulled_ball()));
  session_.open_bytes("other.obj", bumpy());
  ASSERT_TRUE(frames_until([this] { return session_.project().source->name == "other.obj"; }));
  for (int i = 0; i < 60; ++i) frame();
  EXPECT_EQ(session_.project().source->name, "other.obj");
}

class SessionRepair : public SessionTest {
 protected:
  void repair_box() {
    session_.open_bytes("box.obj", broken_box());
    ASSERT_TRUE(frames_until([this] { return session_.pending() != nullptr; }));
    session_.repair_pending();
    ASSERT_TRUE(session_.has_model());
  }
};

TEST_F(SessionRepair, IsAStepThatLeadsBackToTheQuestion) {
  repair_box();
  EXPECT_EQ(session_.undo_label(), "Undo repair");
  EXPECT_FALSE(session_.is_modified());
  session_.unfold();
  ASSERT_TRUE(frames_until_idle());
  const Project with_net = session_.project();
  session_.undo();
  session_.undo();
  EXPECT_FALSE(session_.can_undo());
  EXPECT_FALSE(session_.has_model());
  EXPECT_EQ(session_.shown(), nullptr);
  EXPECT_EQ(session_.state(), RunState::Empty);
  EXPECT_FALSE(session_.is_modified());
  ASSERT_NE(session_.pending(), nullptr);
  EXPECT_EQ(session_.pending()->name, "box.obj");
  EXPECT_FALSE(session_.pending()->refusal.empty());
  ASSERT_TRUE(session_.unrepaired());
  for (int i = 0; i < 30; ++i) frame();
  session_.redo();
  EXPECT_EQ(session_.pending(), nullptr);
  EXPECT_EQ(session_.project().dual->mesh().n_faces(), 6U);
  session_.redo();
  EXPECT_EQ(session_.project(), with_net);
}

TEST_F(SessionRepair, AgreeingAgainRedoesItAndOtherRepairsMakeAnotherStep) {
  repair_box();
  session_.pin_root(FaceId(2));
  session_.undo();
  session_.undo();
  session_.repair_pending();
  EXPECT_TRUE(session_.can_redo()) << "the same repairs keep what came after them";
  session_.undo();
  Recipe other = session_.pending()->recipe;
  other.repairs.drops_isolated_points = false;
  session_.try_pending(other);
  ASSERT_TRUE(frames_until([this] { return !session_.is_making(); }));
  session_.repair_pending();
  EXPECT_EQ(session_.recipe(), other);
  EXPECT_FALSE(session_.can_redo());
  EXPECT_EQ(session_.history().size(), 2U);
  session_.undo();
  EXPECT_EQ(session_.pending()->recipe, other);
}

TEST_F(SessionRepair, LeavingTheQuestionLeavesTheFileUnrepairedUntilItIsAskedAgain) {
  repair_box();
  session_.undo();
  session_.drop_pending();
  EXPECT_EQ(session_.pending(), nullptr);
  EXPECT_FALSE(session_.has_model());
  ASSERT_TRUE(session_.unrepaired());
  EXPECT_EQ(session_.unrepaired()->name, "box.obj");
  EXPECT_FALSE(session_.unrepaired()->refusal.empty());
  session_.unfold();
  session_.save(in_folder("nothing.netwright"));
  for (int i = 0; i < 30; ++i) frame();
  EXPECT_FALSE(std::filesystem::exists(in_folder("nothing.netwright")));
  session_.ask_again();
  ASSERT_NE(session_.pending(), nullptr);
  session_.drop_pending();
  EXPECT_TRUE(session_.can_redo());
  session_.redo();
  EXPECT_TRUE(session_.has_model());
  EXPECT_FALSE(session_.unrepaired());
}

TEST_F(SessionRepair, AnotherFileTakesTheUnrepairedOnesPlace) {
  repair_box();
  session_.undo();
  session_.drop_pending();
  open(ball());
  EXPECT_EQ(session_.project().dual->mesh().n_faces(), 320U);
  EXPECT_FALSE(session_.can_undo());
  EXPECT_FALSE(session_.unrepaired());
}

}  // namespace
}  // namespace netwright
