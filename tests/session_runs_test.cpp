// The session's finished runs as the window uses them: looking, accepting, deleting, saving, scrubbing
// through the moves; and the list of undo steps.
#include <gtest/gtest.h>

#include <filesystem>

#include "core/base/predicates.h"
#include "core/project/replay.h"
#include "core/project/session.h"
#include "tests/session_support.h"
#include "tests/support.h"

namespace netwright {
namespace {

/// Nearly flat terrain, full of saddles: a search of many moves.
std::string terrain() {
  PolygonSoup soup = shapes::bumpy_patch(12, 12);
  Random random(1);
  for (glm::dvec3& p : soup.points) p.y = 0.05 * random.unit();
  return shapes::to_obj(soup);
}

class SessionRunsTest : public testing::SessionTest {
 protected:
  SessionRunsTest() { skips_replays_ = true; }

  void run(std::uint64_t seed) {
    session_.set_seed(seed);
    session_.unfold();
    ASSERT_TRUE(frames_until_idle());
  }
  /// Three runs on a bumpy patch, the last one accepted.
  void open_and_run_thrice() {
    open(shapes::to_obj(shapes::bumpy_patch(6, 6)));
    for (std::uint64_t seed = 0; seed < 3; ++seed) run(seed);
    ASSERT_EQ(session_.runs().size(), 3U);
  }
  [[nodiscard]] bool frames_until_shown(const UnfoldTree& tree) {
    return frames_until([&] { return session_.shown() && session_.shown()->net.tree == tree; });
  }
};

TEST_F(SessionRunsTest, KeepsEveryFinishedRunWithItsFigures) {
  open_and_run_thrice();
  const auto runs = session_.runs();
  for (int i = 0; i < 3; ++i) {
    const FinishedRun& run = *runs[static_cast<std::size_t>(i)];
    EXPECT_EQ(run.number, i + 1);
    EXPECT_EQ(run.summary.seed, static_cast<std::uint64_t>(i));
    EXPECT_TRUE(run.summary.is_proved);
    EXPECT_EQ(run.measures.n_pieces, 1);
    EXPECT_GT(run.score(), 0);
    EXPECT_GT(run.picture.width, run.picture.height);
    ASSERT_NE(run.log, nullptr);
    EXPECT_EQ(run.log->n_moves(), run.summary.moves);
  }
  EXPECT_EQ(session_.accepted_run(), 3);
  EXPECT_EQ(*session_.project().tree, *runs[2]->tree);
  int best = 1;
  for (const auto& run : runs)
    if (run->measures.fill > runs[static_cast<std::size_t>(best) - 1]->measures.fill) best = run->number;
  EXPECT_EQ(session_.best_run(), best);
}

TEST_F(SessionRunsTest, LookingAtARunChangesNothing) {
  open_and_run_thrice();
  const Project before = session_.project();
  session_.view_run(1);
  EXPECT_EQ(session_.viewed_run(), 1);
  ASSERT_TRUE(frames_until_shown(*session_.runs()[0]->tree));
  EXPECT_TRUE(session_.shown()->is_proved);
  EXPECT_EQ(session_.figures().seed, 0U);
  EXPECT_EQ(session_.project(), before);
  EXPECT_EQ(session_.pages(), nullptr) << "the pages are those of the project's net";
  session_.view_run(0);
  EXPECT_EQ(session_.viewed_run(), 0);
  EXPECT_EQ(session_.shown()->net.tree, *before.tree);
  EXPECT_EQ(session_.figures().seed, 2U);
  EXPECT_TRUE(frames_until([this] { return session_.pages() != nullptr; }));
}

TEST_F(SessionRunsTest, TheProjectsOwnRunIsLookedAtOnItsPages) {
  open_and_run_thrice();
  session_.view_run(3);
  EXPECT_TRUE(frames_until([this] { return session_.pages() != nullptr; }));
}

TEST_F(SessionRunsTest, AcceptingIsOneUndoStep) {
  open_and_run_thrice();
  session_.view_run(1);
  session_.accept_run(1);
  EXPECT_EQ(session_.viewed_run(), 0);
  EXPECT_EQ(session_.accepted_run(), 1);
  EXPECT_EQ(session_.undo_label(), "Undo accept run 1");
  EXPECT_EQ(session_.figures().history, session_.runs()[0]->figures.history);
  ASSERT_TRUE(frames_until_idle());
  EXPECT_EQ(session_.shown()->net.tree, *session_.runs()[0]->tree);
  session_.undo();
  EXPECT_EQ(session_.accepted_run(), 3);
  EXPECT_EQ(session_.figures().history, session_.runs()[2]->figures.history) << "the chart comes back, too";
  ASSERT_TRUE(frames_until_shown(*session_.runs()[2]->tree));
  session_.redo();
  EXPECT_EQ(session_.accepted_run(), 1);
  session_.accept_run(1);
  EXPECT_FALSE(session_.can_redo());
  EXPECT_EQ(session_.history().size(), 5U) << "taking the net that is there already is no step";
}

TEST_F(SessionRunsTest, AnAcceptedRunKeepsThePinnedRoot) {
  open_and_run_thrice();
  session_.pin_root(FaceId(5));
  session_.accept_run(2);
  EXPECT_TRUE(session_.project().tree->is_root(FaceId(5)));
  EXPECT_EQ(session_.project().pins.root, FaceId(5));
}

TEST_F(SessionRunsTest, ANetThatBreaksAPinCannotBeAccepted) {
  open_and_run_thrice();
  const Mesh& mesh = session_.project().dual->mesh();
  const UnfoldTree& first = *session_.runs()[0]->tree;
  Constraints pins;
  for (const EdgeId e : mesh.edges())
    if (!mesh.is_border(e) && first.is_fold(mesh, e) && pins.must_cut.empty()) pins.must_cut.push_back(e);
  EXPECT_EQ(session_.why_not_accept(1), "");
  session_.set_pins(pins, "forbid a fold");
  EXPECT_NE(session_.why_not_accept(1), "");
  session_.accept_run(1);
  EXPECT_EQ(session_.accepted_run(), 3);
  session_.undo();
  session_.accept_run(1);
  EXPECT_EQ(session_.accepted_run(), 1);
}

TEST_F(SessionRunsTest, AStoppedRunIsKeptButCannotBeAccepted) {
  open(shapes::to_obj(testing::endless_search()));
  session_.unfold();
  ASSERT_TRUE(frames_until([this] { return session_.figures().moves > 0; }));
  session_.stop();
  ASSERT_TRUE(frames_until([this] { return session_.state() == RunState::Idle; }));
  ASSERT_EQ(session_.runs().size(), 1U);
  const auto run = session_.runs()[0];
  EXPECT_FALSE(run->summary.is_proved);
  session_.accept_run(1);
  EXPECT_EQ(session_.project().tree, nullptr);
  session_.export_run(1, folder_ / "net.pdf");
  EXPECT_EQ(session_.chore(), nullptr);
  session_.view_run(1);
  ASSERT_TRUE(frames_until_shown(*run->tree));
  ASSERT_TRUE(session_.timeline().has_value());
  EXPECT_EQ(run->log->overlaps(session_.timeline()->home), run->figures.best_overlaps);
}

TEST_F(SessionRunsTest, DeletingARunLeavesTheNetAlone) {
  open_and_run_thrice();
  session_.view_run(3);
  session_.delete_run(3);
  EXPECT_EQ(session_.viewed_run(), 0);
  EXPECT_EQ(session_.runs().size(), 2U);
  EXPECT_EQ(session_.accepted_run(), 0);
  EXPECT_NE(session_.project().tree, nullptr);
  session_.view_run(3);
  EXPECT_EQ(session_.viewed_run(), 0);
}

TEST_F(SessionRunsTest, RunsBelongToTheirMesh) {
  open_and_run_thrice();
  session_.simplify_to(50, false);
  ASSERT_TRUE(frames_until([this] { return !session_.is_making(); }));
  ASSERT_TRUE(frames_until_idle());
  ASSERT_EQ(session_.runs().size(), 1U) << "the slider unfolds the new mesh";
  EXPECT_EQ(session_.runs()[0]->number, 4);
  while (session_.project().dual->mesh().n_faces() < 70 && session_.can_undo()) session_.undo();
  EXPECT_EQ(session_.runs().size(), 3U) << "those of the old mesh come back with it";
  open(shapes::to_obj(shapes::cube()));
  ASSERT_TRUE(frames_until([this] { return session_.project().dual->mesh().n_faces() == 6; }));
  EXPECT_TRUE(session_.runs().empty());
}

TEST_F(SessionRunsTest, TheBestRunCanBeSavedWhileASearchGoesOn) {
  std::filesystem::create_directories(folder_);
  open_and_run_thrice();
  session_.set_speed(0.1);
  session_.new_seed();
  ASSERT_EQ(session_.state(), RunState::Running);
  session_.export_run(session_.best_run(), folder_ / "best.fold");
  ASSERT_TRUE(frames_until([this] { return std::filesystem::exists(folder_ / "best.fold"); }));
  session_.stop();
}

TEST_F(SessionRunsTest, ScrubsThroughTheMovesBackAndForth) {
  open(terrain());
  run(0);
  session_.view_run(1);
  auto line = session_.timeline();
  ASSERT_TRUE(line.has_value());
  ASSERT_GT(line->n_steps, 10);
  EXPECT_EQ(line->position, line->n_steps - 1);
  const RunLog& log = *session_.runs()[0]->log;
  for (const int position : {line->n_steps / 2, 3, 0, line->n_steps - 2}) {
    session_.seek(position);
    Replay replay(session_.runs()[0]->log);
    replay.seek(position);
    ASSERT_TRUE(frames_until_shown(replay.net().tree)) << position;
    EXPECT_EQ(session_.timeline()->position, position);
    EXPECT_EQ(session_.figures().overlaps, log.overlaps(position));
    EXPECT_EQ(session_.figures().moves, log.moves(position));
    EXPECT_EQ(session_.figures().at_move, log.moves(position) - log.moves(0));
    EXPECT_FALSE(session_.shown()->is_proved);
  }
  session_.seek(1 << 30);
  ASSERT_TRUE(frames_until_shown(*session_.runs()[0]->tree));
  EXPECT_EQ(session_.figures().at_move, -1);
}

TEST_F(SessionRunsTest, TheLatestOfManyWishesIsShown) {
  open(terrain());
  run(0);
  session_.view_run(1);
  const int n = session_.timeline()->n_steps;
  for (int i = 0; i < 200; ++i) session_.seek((i * 7919) % n);
  Replay replay(session_.runs()[0]->log);
  replay.seek(session_.timeline()->position);
  EXPECT_TRUE(frames_until_shown(replay.net().tree));
}

TEST_F(SessionRunsTest, PlaysAtTheSpeedThatIsAskedForAndStopsAtTheEnd) {
  open(terrain());
  run(0);
  session_.view_run(1);
  const int n = session_.timeline()->n_steps;
  session_.set_play_speed(100);
  session_.play();
  EXPECT_EQ(session_.timeline()->position, 0) << "from the beginning, since it was at the end";
  EXPECT_LT(session_.wait_seconds(), 0.1);
  for (int i = 0; i < 5; ++i) frame();
  EXPECT_NEAR(session_.timeline()->position, 5, 1) << "0.05 s";
  session_.hold();
  const int held = session_.timeline()->position;
  for (int i = 0; i < 5; ++i) frame();
  EXPECT_EQ(session_.timeline()->position, held);
  session_.set_play_speed(100 * n);
  session_.play();
  ASSERT_TRUE(frames_until([this] { return !session_.timeline()->is_playing; }));
  EXPECT_EQ(session_.timeline()->position, n - 1);
  ASSERT_TRUE(frames_until_shown(*session_.runs()[0]->tree));
  EXPECT_EQ(session_.wait_seconds(), std::numeric_limits<double>::infinity());
}

TEST_F(SessionRunsTest, EveryChangeEndsTheLook) {
  open_and_run_thrice();
  session_.view_run(1);
  session_.pin_root(FaceId(3));
  EXPECT_EQ(session_.viewed_run(), 0);
  session_.view_run(1);
  session_.undo();
  EXPECT_EQ(session_.viewed_run(), 0);
  session_.view_run(1);
  session_.unfold();
  EXPECT_EQ(session_.viewed_run(), 0);
  session_.view_run(1);
  EXPECT_EQ(session_.viewed_run(), 0) << "the search is what is shown while it runs";
  ASSERT_TRUE(frames_until_idle());
}

TEST_F(SessionRunsTest, GoesToAnyStepOfTheHistory) {
  open_and_run_thrice();
  session_.pin_root(FaceId(2));
  EXPECT_EQ(session_.history(), (std::vector<std::string>{"", "unfold", "unfold", "unfold", "pin root"}));
  EXPECT_EQ(session_.history_position(), 4U);
  session_.go_to_step(1);
  EXPECT_EQ(session_.accepted_run(), 1);
  EXPECT_FALSE(session_.project().pins.root.is_valid());
  ASSERT_TRUE(frames_until_shown(*session_.runs()[0]->tree));
  session_.go_to_step(0);
  EXPECT_EQ(session_.project().tree, nullptr);
  EXPECT_FALSE(session_.can_undo());
  EXPECT_EQ(session_.shown(), nullptr);
  session_.go_to_step(4);
  EXPECT_EQ(session_.project().pins.root, FaceId(2));
  EXPECT_FALSE(session_.can_redo());
  session_.go_to_step(99);
  EXPECT_EQ(session_.history_position(), 4U);
}

TEST_F(SessionRunsTest, TheDesksPaperIsThatOfNewModels) {
  session_.set_desk_paper("Letter");
  EXPECT_EQ(session_.project().paper.format, "Letter");
  open(shapes::to_obj(shapes::cube()));
  EXPECT_EQ(session_.project().paper.format, "Letter");
  session_.set_desk_paper("A3");
  EXPECT_EQ(session_.project().paper.format, "Letter") << "what is open stays";
  EXPECT_FALSE(session_.can_undo());
  session_.open_bytes("ball.obj", shapes::to_obj(shapes::icosphere(1)));
  ASSERT_TRUE(frames_until([this] { return session_.project().dual->mesh().n_faces() > 6; }));
  EXPECT_EQ(session_.project().paper.format, "A3");
}

}  // namespace
}  // namespace netwright
