// Edits and history: undo then redo is identity, labels follow, and no edit touches what it was given.
#include "core/project/history.h"

#include <gtest/gtest.h>

#include "core/project/commands.h"
#include "core/unfold/steepest_edge.h"
#include "tests/support.h"

namespace netwright {
namespace {

Project cube_project() {
  Project project = new_project({}, "cube.obj", testing::make_dual(shapes::cube()));
  Random random(3);
  RunSummary run;
  run.seed = 3;
  run.is_proved = true;
  return accept_tree(project, steepest_edge_tree(*project.dual, random), run);
}

TEST(History, HasNothingToUndoAtFirst) {
  History history;
  EXPECT_FALSE(history.can_undo());
  EXPECT_FALSE(history.can_redo());
  EXPECT_EQ(history.undo_label(), "");
  EXPECT_EQ(history.redo_label(), "");
  history.undo();
  history.redo();
  EXPECT_EQ(history.present(), Project());
}

TEST(History, UndoneThenRedoneIsTheSame) {
  History history(cube_project());
  std::vector<Project> states{history.present()};
  history.push("seed", set_seed(history.present(), 5));
  states.push_back(history.present());
  history.push("pin root", pin_root(history.present(), FaceId(4)));
  states.push_back(history.present());
  history.push("print size", set_size(history.present(), {PrintSize::Kind::Height, 80}));
  states.push_back(history.present());
  for (std::size_t i = 3; i > 0; --i) {
    EXPECT_EQ(history.present(), states[i]);
    history.undo();
  }
  EXPECT_EQ(history.present(), states[0]);
  EXPECT_FALSE(history.can_undo());
  for (std::size_t i = 1; i < states.size(); ++i) {
    history.redo();
    EXPECT_EQ(history.present(), states[i]);
  }
  EXPECT_FALSE(history.can_redo());
}

TEST(History, NamesTheEditsOnBothSides) {
  History history(cube_project());
  history.push("paper", set_paper(history.present(), {.format = "A3"}));
  history.push("pin root", pin_root(history.present(), FaceId(1)));
  EXPECT_EQ(history.undo_label(), "pin root");
  history.undo();
  EXPECT_EQ(history.undo_label(), "paper");
  EXPECT_EQ(history.redo_label(), "pin root");
}

TEST(History, ForgetsWhatCouldBeRedoneWhenSomethingNewIsDone) {
  History history(cube_project());
  history.push("paper", set_paper(history.present(), {.format = "A3"}));
  history.undo();
  history.push("pin root", pin_root(history.present(), FaceId(1)));
  EXPECT_FALSE(history.can_redo());
  history.undo();
  EXPECT_EQ(history.redo_label(), "pin root");
}

TEST(History, AmendsThePresentWithoutAStep) {
  History history(cube_project());
  history.push("paper", set_paper(history.present(), {.format = "A3"}));
  history.undo();
  history.amend(set_seed(history.present(), 9));
  EXPECT_EQ(history.present().seed, 9u);
  EXPECT_FALSE(history.can_undo());
  EXPECT_TRUE(history.can_redo());
}

TEST(Commands, PinningARootTurnsTheTreeAndKeepsItsFolds) {
  const Project before = cube_project();
  const Mesh& mesh = before.dual->mesh();
  for (const FaceId face : mesh.faces()) {
    const Project after = pin_root(before, face);
    EXPECT_EQ(after.pins.root, face);
    EXPECT_TRUE(after.tree->is_root(face));
    EXPECT_TRUE(after.tree->is_forest(mesh));
    for (const EdgeId e : mesh.edges()) {
      EXPECT_EQ(after.tree->is_fold(mesh, e), before.tree->is_fold(mesh, e));
    }
  }
  EXPECT_FALSE(before.pins.root.is_valid());
}

TEST(Commands, RemovingThePinKeepsTheTree) {
  const Project pinned = pin_root(cube_project(), FaceId(2));
  const Project free = pin_root(pinned, FaceId());
  EXPECT_FALSE(free.pins.root.is_valid());
  EXPECT_EQ(free.tree, pinned.tree);
}

TEST(Commands, ANewProjectKeepsThePaperOfTheDesk) {
  Project before = set_paper(cube_project(), {.format = "Letter"});
  before = set_seed(before, 8);
  const Project after = new_project(before, "ball.obj", testing::make_dual(shapes::icosphere(1)));
  EXPECT_EQ(after.paper.format, "Letter");
  EXPECT_EQ(after.seed, 0u);
  EXPECT_EQ(after.tree, nullptr);
  EXPECT_FALSE(after.run.has_value());
}

}  // namespace
}  // namespace netwright
