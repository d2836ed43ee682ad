// The session's searches, undo, sheets and messages.
#include "core/project/session.h"

#include <atomic>
#include <cmath>
#include <fstream>

#include "core/project/open_model.h"
#include "tests/session_support.h"

namespace netwright {
namespace {

using namespace testing;

TEST_F(SessionTest, IsEmptyAtFirstAndIgnoresCommandsThatNeedAModel) {
  EXPECT_EQ(session_.state(), RunState::Empty);
  session_.unfold();
  session_.step();
  session_.stop();
  session_.new_seed();
  session_.pin_root(FaceId(0));
  session_.undo();
  session_.skip_replay();
  frame();
  EXPECT_EQ(session_.state(), RunState::Empty);
  EXPECT_EQ(session_.shown(), nullptr);
  EXPECT_EQ(session_.report(), nullptr);
  EXPECT_EQ(session_.wait_seconds(), std::numeric_limits<double>::infinity());
}

TEST_F(SessionTest, OpensAModelOnTheWorker) {
  session_.open_bytes("ball.obj", ball());
  EXPECT_EQ(session_.state(), RunState::Opening);
  EXPECT_NE(session_.chore(), nullptr);
  ASSERT_TRUE(frames_until([this] { return session_.state() == RunState::Idle; }));
  EXPECT_EQ(session_.project().dual->mesh().n_faces(), 320u);
  EXPECT_EQ(session_.figures().faces, 320);
  EXPECT_EQ(session_.report()->n_faces, 320);
  EXPECT_EQ(session_.chore(), nullptr);
  EXPECT_EQ(session_.shown(), nullptr);
  EXPECT_FALSE(session_.can_undo());
}

TEST_F(SessionTest, OpensAFileFromDisk) {
  const std::filesystem::path path = in_folder("ball.obj");
  std::ofstream(path) << ball();
  session_.open(path);
  ASSERT_TRUE(frames_until([this] { return session_.state() == RunState::Idle; }));
  EXPECT_EQ(session_.project().path, path);
}

TEST_F(SessionTest, KeepsTheModelWhenAnotherFileIsBroken) {
  open_and_unfold(bumpy());
  const Project before = session_.project();
  const auto shown = session_.shown();
  session_.open_bytes("broken.obj", "v 0 0 0\nf 1 2 3\n");
  ASSERT_TRUE(frames_until([this] { return session_.state() != RunState::Opening; }));
  EXPECT_TRUE(has_message(Message::Kind::Error, "broken.obj"));
  EXPECT_EQ(session_.project(), before);
  EXPECT_EQ(session_.shown(), shown);
  session_.open(in_folder("missing.obj"));
  ASSERT_TRUE(frames_until([this] { return session_.state() != RunState::Opening; }));
  EXPECT_TRUE(has_message(Message::Kind::Error, "missing.obj"));
  EXPECT_EQ(session_.project(), before);
}

TEST_F(SessionTest, RefusesAModelThatCannotBeRepairedAndStaysEmpty) {
  session_.open_bytes("moebius.obj",
                      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\nv 0 0 1\n"
                      "f 1 2 3\nf 2 3 4\nf 3 4 5\nf 4 5 1\nf 5 1 2\n");
  ASSERT_TRUE(frames_until([this] { return session_.state() != RunState::Opening; }));
  EXPECT_EQ(session_.state(), RunState::Empty);
  EXPECT_EQ(session_.pending(), nullptr);
  ASSERT_EQ(messages_.size(), 1u);
  EXPECT_EQ(messages_.front().kind, Message::Kind::Error);
}

TEST_F(SessionTest, AsksBeforeItRepairsAndOpensWhatTheUserAgreedTo) {
  open(ball());
  session_.open_bytes("box.obj", broken_box());
  ASSERT_TRUE(frames_until([this] { return session_.pending() != nullptr; }));
  EXPECT_EQ(session_.figures().faces, 320) << "the present model stays until the user has decided";
  EXPECT_FALSE(session_.pending()->refusal.empty());
  EXPECT_EQ(session_.pending()->recipe, usual_repair());
  ASSERT_TRUE(session_.pending()->is_fit());
  EXPECT_EQ(session_.pending()->made->dual->mesh().n_faces(), 6U);
  ASSERT_TRUE(session_.pending()->made->stages->survey);
  EXPECT_FALSE(session_.pending()->made->stages->survey->repairs.counts.empty());
  session_.repair_pending();
  EXPECT_EQ(session_.pending(), nullptr);
  EXPECT_EQ(session_.figures().faces, 6);
  EXPECT_EQ(session_.recipe(), usual_repair());
  session_.unfold();
  ASSERT_TRUE(frames_until_idle());
  EXPECT_TRUE(session_.shown()->is_proved);
}

TEST_F(SessionTest, ADroppedBrokenFileChangesNothing) {
  open(ball());
  const Project before = session_.project();
  session_.open_bytes("box.obj", broken_box());
  ASSERT_TRUE(frames_until([this] { return session_.pending() != nullptr; }));
  session_.drop_pending();
  frame();
  EXPECT_EQ(session_.pending(), nullptr);
  EXPECT_EQ(session_.project(), before);
}

TEST_F(SessionTest, FlattensUnevenFacesInsteadOfSplittingThem) {
  session_.open_bytes("bent.obj", bent_box());
  ASSERT_TRUE(frames_until([this] { return session_.pending() != nullptr; }));
  Recipe flat = session_.pending()->recipe;
  flat.uneven = UnevenFaces::Flatten;
  session_.try_pending(flat);
  EXPECT_EQ(session_.pending()->recipe, flat);
  session_.repair_pending();
  EXPECT_FALSE(session_.has_model()) << "what comes of it is not known yet";
  ASSERT_TRUE(frames_until([this] { return !session_.is_making(); }));
  session_.repair_pending();
  EXPECT_EQ(session_.pending(), nullptr);
  EXPECT_EQ(session_.figures().faces, 6);
  EXPECT_EQ(session_.recipe().uneven, UnevenFaces::Flatten);
}

TEST_F(SessionTest, DraggingTheSimplifySliderUnfoldsAsItGoesAndIsOneUndoStep) {
  open(ball());
  session_.pin_root(FaceId(7));
  for (const int faces : {300, 250, 200, 150, 100}) {
    session_.simplify_to(faces, true);
    for (int i = 0; i < 3; ++i) frame();
  }
  session_.simplify_to(80, false);
  ASSERT_TRUE(frames_until([this] {
    return session_.figures().faces <= 80 && session_.project().tree && session_.state() == RunState::Idle;
  }));
  EXPECT_EQ(session_.recipe().faces, 80);
  ASSERT_TRUE(frames_until([this] { return session_.deviation_mm().has_value(); }));
  EXPECT_GT(session_.deviation_mm(), 0);
  EXPECT_EQ(session_.undo_label(), "Undo unfold") << "a figure about the model is no change of it";
  EXPECT_EQ(session_.n_faces_before_simplifying(), 320);
  session_.undo();  // the net
  EXPECT_EQ(session_.project().tree, nullptr);
  session_.undo();  // the whole drag
  EXPECT_EQ(session_.recipe(), Recipe{});
  EXPECT_EQ(session_.project().dual->mesh().n_faces(), 320u);
  EXPECT_EQ(session_.project().pins.root, FaceId(7));
  EXPECT_EQ(session_.undo_label(), "Undo pin root");
  session_.redo();
  EXPECT_LE(session_.project().dual->mesh().n_faces(), 80u);
}

TEST_F(SessionTest, AnotherAxisUpKeepsTheNet) {
  open_and_unfold(shapes::to_obj(shapes::cuboid({2, 1, 3})));
  const auto tree = session_.project().tree;
  EXPECT_EQ(session_.project().dual->mesh().height(), 1);
  Recipe recipe = session_.recipe();
  recipe.up = UpAxis::Z;
  session_.set_recipe(recipe, "up axis");
  ASSERT_TRUE(frames_until([this] { return session_.project().dual->mesh().height() == 3; }));
  ASSERT_TRUE(frames_until_idle());
  EXPECT_EQ(session_.project().tree, tree);
  EXPECT_TRUE(session_.shown()->is_proved);
  session_.undo();
  EXPECT_EQ(session_.project().dual->mesh().height(), 1);
  EXPECT_EQ(session_.project().tree, tree);
}

TEST_F(SessionTest, MergingIsAStepThatCanBeUndone) {
  open(shapes::to_obj(shapes::grid_cube(3)));
  Recipe recipe = session_.recipe();
  recipe.merges = true;
  session_.set_recipe(recipe, "merge faces");
  ASSERT_TRUE(frames_until([this] { return session_.project().dual->mesh().n_faces() == 6; }));
  EXPECT_EQ(session_.undo_label(), "Undo merge faces");
  session_.undo();
  EXPECT_EQ(session_.project().dual->mesh().n_faces(), 54u);
}

TEST_F(SessionTest, TheNewestOpenWins) {
  for (const int n : {2, 3, 4, 5}) session_.open_bytes("ball.obj", shapes::to_obj(shapes::icosphere(n)));
  ASSERT_TRUE(frames_until([this] { return session_.state() == RunState::Idle; }));
  for (int i = 0; i < 50; ++i) frame();
  EXPECT_EQ(session_.figures().faces, 500);
  EXPECT_TRUE(messages_.empty());
}

TEST_F(SessionTest, GivesUpAnOpeningAndKeepsThePresentModel) {
  open(ball());
  session_.open_bytes("other.obj", bumpy());
  session_.cancel_opening();
  EXPECT_EQ(session_.state(), RunState::Idle);
  for (int i = 0; i < 50; ++i) frame();
  EXPECT_EQ(session_.figures().faces, 320);
  EXPECT_TRUE(messages_.empty());
}

TEST_F(SessionTest, AModelThatArrivesEndsTheSearch) {
  open(endless());
  session_.unfold();
  EXPECT_EQ(session_.state(), RunState::Running);
  session_.open_bytes("ball.obj", ball());
  ASSERT_TRUE(frames_until([this] { return session_.figures().faces == 320; }));
  EXPECT_EQ(session_.state(), RunState::Idle);
  EXPECT_EQ(session_.shown(), nullptr);
}

TEST_F(SessionTest, AModelThatCannotBeReadLeavesTheSearchAlone) {
  open(endless());
  session_.unfold();
  session_.open_bytes("broken.obj", "nothing of use");
  ASSERT_TRUE(frames_until([this] { return session_.chore() == nullptr; }));
  EXPECT_EQ(session_.state(), RunState::Running);
}

TEST_F(SessionTest, UnfoldsToAProvedNetAsOneUndoStep) {
  open_and_unfold(bumpy());
  const Project& project = session_.project();
  ASSERT_NE(project.tree, nullptr);
  EXPECT_TRUE(project.run->is_proved);
  EXPECT_EQ(project.run->overlaps, 0);
  EXPECT_EQ(session_.undo_label(), "Undo unfold");
  EXPECT_TRUE(session_.shown()->overlaps.empty());
  EXPECT_EQ(session_.shown()->net.tree, *project.tree);
  ASSERT_NE(session_.sheets(), nullptr);
  EXPECT_EQ(session_.sheets()->size(), 1u);
  EXPECT_TRUE(has_message(Message::Kind::Good, "proved"));
  const RunFigures figures = session_.figures();
  EXPECT_EQ(figures.overlaps, 0);
  EXPECT_EQ(figures.moves, project.run->moves);
  EXPECT_GT(figures.overlaps_at_start, 0);
  EXPECT_EQ(figures.history.front(), figures.overlaps_at_start);
}

TEST_F(SessionTest, FindsTheNetThatSolveFinds) {
  open(bumpy());
  for (const std::uint64_t seed : {0, 1, 2, 3}) {
    session_.set_seed(seed);
    session_.unfold();
    ASSERT_TRUE(frames_until_idle());
    EXPECT_EQ(*session_.project().tree, solved_directly().net.tree) << "seed " << seed;
    EXPECT_EQ(session_.project().run->seed, seed);
  }
}

TEST_F(SessionTest, TheSameRunAgainIsNoNewUndoStep) {
  open_and_unfold(bumpy());
  const Project before = session_.project();
  session_.unfold();
  ASSERT_TRUE(frames_until_idle());
  EXPECT_EQ(session_.project(), before);
  session_.undo();
  EXPECT_FALSE(session_.can_undo());
}

TEST_F(SessionTest, NewSeedRunsTheNextSeed) {
  open_and_unfold(bumpy());
  session_.new_seed();
  EXPECT_NE(session_.state(), RunState::Idle);
  EXPECT_EQ(session_.figures().seed, 1u);
  ASSERT_TRUE(frames_until_idle());
  EXPECT_EQ(session_.project().seed, 1u);
  EXPECT_EQ(session_.project().run->seed, 1u);
  EXPECT_EQ(*session_.project().tree, solved_directly().net.tree);
}

TEST_F(SessionTest, TellsThePaceOfALongSearchWhicheverStreamIsAhead) {
  open(endless());
  session_.unfold();
  EXPECT_TRUE(frames_until([this] { return session_.figures().moves_per_second > 0; }));
  EXPECT_EQ(session_.state(), RunState::Running);
  session_.stop();
  EXPECT_TRUE(frames_until_idle());
}

TEST_F(SessionTest, PlaysAFastRunBackWithinTwoSeconds) {
  open_and_unfold_between_two_frames(bumpy());
  const double started = now_;
  ASSERT_NE(session_.project().tree, nullptr) << "the net is safe before it is played";
  const std::int64_t first_move = session_.figures().moves;
  const int first_restart = session_.figures().restarts;
  std::vector<std::int64_t> moves;
  std::uint64_t version = 0;
  while (session_.state() == RunState::Replaying) {
    ASSERT_LT(now_ - started, 2.02);
    const RunFigures figures = session_.figures();
    EXPECT_EQ(figures.overlaps, static_cast<int>(session_.shown()->overlaps.size()));
    EXPECT_EQ(figures.moves - first_move + 1 + figures.restarts - first_restart,
              static_cast<std::int64_t>(figures.history.size()));
    EXPECT_FALSE(session_.shown()->is_proved);
    if (session_.shown()->version != version) moves.push_back(figures.moves);
    version = session_.shown()->version;
    frame();
  }
  EXPECT_TRUE(std::is_sorted(moves.begin(), moves.end()));
  EXPECT_GT(moves.size(), 10u);
  EXPECT_EQ(session_.state(), RunState::Idle);
  EXPECT_TRUE(session_.shown()->is_proved);
  EXPECT_EQ(session_.figures().moves, session_.project().run->moves);
}

TEST_F(SessionTest, SkipsAReplayToItsEnd) {
  open_and_unfold_between_two_frames(bumpy());
  session_.skip_replay();
  EXPECT_EQ(session_.state(), RunState::Idle);
  EXPECT_TRUE(session_.shown()->is_proved);
  frame();
  EXPECT_TRUE(has_message(Message::Kind::Good, "proved"));
}

TEST_F(SessionTest, KeepsThePictureStillWhileItPlays) {
  open_and_unfold_between_two_frames(bumpy());
  const FaceId root = session_.project().tree->roots().front();
  const Rigid2 place = session_.shown()->net.placement[root];
  while (session_.state() == RunState::Replaying) {
    EXPECT_EQ(session_.shown()->net.placement[root], place);
    frame();
  }
  EXPECT_EQ(session_.shown()->net.placement[root], place);
}

TEST_F(SessionTest, StepsShowOneMoveEach) {
  open(bumpy());
  session_.step();
  EXPECT_EQ(session_.state(), RunState::Paused);
  for (int i = 1; i <= 8; ++i) {
    if (i > 1) session_.step();
    ASSERT_TRUE(frames_until([&] { return session_.figures().moves == i; }));
    for (int k = 0; k < 20; ++k) frame();
    EXPECT_EQ(session_.figures().moves, i) << "nothing moves while it is paused";
    const auto shown = session_.shown();
    ASSERT_TRUE(shown->last_move.has_value());
    EXPECT_EQ(shown->climbed.front(), shown->last_move->chosen);
    EXPECT_FALSE(shown->candidates.empty());
    EXPECT_EQ(static_cast<int>(shown->overlaps.size()), shown->last_move->overlaps_after);
    EXPECT_EQ(session_.state(), RunState::Paused);
  }
}

TEST_F(SessionTest, PausesStepsAndSpeedsLeadToTheSameNet) {
  open(bumpy());
  const UnfoldTree expected = solved_directly().net.tree;
  session_.step();
  session_.step();
  ASSERT_TRUE(frames_until([&] { return session_.figures().moves == 2; }));
  session_.set_speed(2000);
  session_.unfold();
  ASSERT_TRUE(frames_until([&] { return session_.figures().moves >= 5; }));
  session_.pause();
  EXPECT_EQ(session_.state(), RunState::Paused);
  for (int i = 0; i < 5; ++i) frame();
  session_.step();
  session_.set_speed(kFullSpeed);
  session_.unfold();
  ASSERT_TRUE(frames_until_idle());
  EXPECT_EQ(*session_.project().tree, expected);
}

TEST_F(SessionTest, ARunThatWasWatchedIsNotPlayedBack) {
  open(bumpy());
  session_.set_speed(5000);
  session_.unfold();
  ASSERT_TRUE(frames_until([this] {
    EXPECT_NE(session_.state(), RunState::Replaying);
    return session_.state() == RunState::Idle;
  }));
  EXPECT_TRUE(session_.shown()->is_proved);
}

TEST_F(SessionTest, StopsAtOnceAndShowsTheBestSoFar) {
  open(endless());
  session_.unfold();
  ASSERT_TRUE(frames_until([this] { return session_.figures().moves > 0; }));
  session_.stop();
  ASSERT_TRUE(frames_until([this] { return session_.state() == RunState::Idle; }));
  EXPECT_EQ(session_.project().tree, nullptr);
  ASSERT_NE(session_.shown(), nullptr);
  EXPECT_FALSE(session_.shown()->is_proved);
  EXPECT_GT(session_.figures().overlaps, 0);
  EXPECT_EQ(session_.figures().overlaps, static_cast<int>(session_.shown()->overlaps.size()));
  EXPECT_TRUE(has_message(Message::Kind::Notice, "left when the search was stopped"));
  EXPECT_EQ(session_.sheets(), nullptr);
  EXPECT_FALSE(session_.can_undo());
}

TEST_F(SessionTest, StopsASearchThatIsPausedOrWaitsForItsNextMove) {
  open(endless());
  session_.step();
  ASSERT_TRUE(frames_until([this] { return session_.figures().moves == 1; }));
  session_.stop();
  ASSERT_TRUE(frames_until([this] { return session_.state() == RunState::Idle; }));
  session_.set_speed(kAMoveInTenSeconds);
  session_.unfold();
  ASSERT_TRUE(frames_until([this] { return session_.figures().moves == 1; }));
  session_.stop();
  ASSERT_TRUE(frames_until([this] { return session_.state() == RunState::Idle; }));
}

TEST_F(SessionTest, EndsARunAtTheTimeLimitOfItsOwnClockWithoutThePauses) {
  open(endless());
  session_.set_time_limit(5);
  session_.unfold();
  session_.pause();
  now_ += 100;
  frame();
  EXPECT_EQ(session_.state(), RunState::Paused);
  session_.unfold();
  now_ += 4.9;
  session_.poll();
  EXPECT_EQ(session_.state(), RunState::Running);
  EXPECT_NEAR(session_.figures().seconds, 4.9, 1e-9);
  now_ += 0.2;
  ASSERT_TRUE(frames_until([this] { return session_.state() == RunState::Idle; }));
  EXPECT_TRUE(has_message(Message::Kind::Notice, "left at the time limit"));
}

TEST_F(SessionTest, UndoAndRedoGoThroughNetsAndPins) {
  open_and_unfold(bumpy());
  const Project unfolded = session_.project();
  session_.pin_root(FaceId(7));
  const Project pinned = session_.project();
  ASSERT_TRUE(frames_until([this] { return session_.shown()->net.tree.is_root(FaceId(7)); }));
  EXPECT_TRUE(session_.shown()->is_proved) << "a net laid out from another face is still the same net";
  EXPECT_EQ(session_.undo_label(), "Undo pin root");
  session_.undo();
  EXPECT_EQ(session_.project(), unfolded);
  EXPECT_EQ(session_.redo_label(), "Redo pin root");
  ASSERT_TRUE(frames_until([&] { return session_.shown()->net.tree == *unfolded.tree; }));
  session_.undo();
  EXPECT_EQ(session_.project().tree, nullptr);
  EXPECT_EQ(session_.shown(), nullptr);
  EXPECT_EQ(session_.sheets(), nullptr);
  EXPECT_FALSE(session_.can_undo());
  session_.redo();
  session_.redo();
  EXPECT_EQ(session_.project(), pinned);
  EXPECT_FALSE(session_.can_redo());
  ASSERT_TRUE(frames_until([&] { return session_.shown() && session_.shown()->net.tree == *pinned.tree; }));
  EXPECT_TRUE(session_.shown()->is_proved);
}

TEST_F(SessionTest, RunsKeepThePinnedRoot) {
  open(bumpy());
  session_.pin_root(FaceId(11));
  session_.unfold();
  ASSERT_TRUE(frames_until_idle());
  EXPECT_TRUE(session_.project().tree->is_root(FaceId(11)));
  EXPECT_EQ(*session_.project().tree, solved_directly().net.tree);
}

TEST_F(SessionTest, PinningDuringARunStartsItAgainWithThePin) {
  open(endless());
  session_.unfold();
  ASSERT_TRUE(frames_until([this] { return session_.figures().moves > 0; }));
  session_.pin_root(FaceId(5));
  EXPECT_EQ(session_.state(), RunState::Running);
  ASSERT_TRUE(
      frames_until([this] { return session_.shown() && session_.shown()->net.tree.is_root(FaceId(5)); }));
  EXPECT_EQ(session_.figures().seed, 0u);
  session_.undo();
  EXPECT_EQ(session_.state(), RunState::Idle);
  EXPECT_FALSE(session_.project().pins.root.is_valid());
}

TEST_F(SessionTest, AnUnfinishedRunGoesBackToTheNetBeforeIt) {
  open_and_unfold(terrain());
  const Project before = session_.project();
  session_.set_speed(kAMoveInTenSeconds);
  session_.new_seed();
  ASSERT_TRUE(frames_until([this] { return session_.figures().moves == 1; }));
  session_.stop();
  ASSERT_TRUE(frames_until([this] { return session_.state() == RunState::Idle; }));
  EXPECT_FALSE(session_.shown()->is_proved);
  EXPECT_EQ(session_.sheets(), nullptr) << "what is shown is not what would be printed";
  EXPECT_EQ(session_.undo_label(), "Undo unfinished run");
  session_.undo();
  EXPECT_TRUE(session_.shown()->is_proved);
  EXPECT_EQ(session_.project().tree, before.tree);
  EXPECT_NE(session_.sheets(), nullptr);
}

TEST_F(SessionTest, PaperAndSizeChangeTheSheetsButNotTheNet) {
  open_and_unfold(bumpy());
  const auto net = session_.shown();
  const auto sheets = session_.sheets();
  session_.set_paper({.format = "A3"});
  ASSERT_TRUE(frames_until([&] { return session_.sheets() != sheets; }));
  EXPECT_NEAR(std::max(session_.sheets()->front().width_mm, session_.sheets()->front().height_mm), 420, 1e-6);
  EXPECT_EQ(session_.shown(), net) << "the net need not be made again";
  session_.set_size({PrintSize::Kind::Height, 300});
  ASSERT_TRUE(frames_until([&] { return session_.sheets()->size() > 1; }));
  EXPECT_EQ(session_.undo_label(), "Undo print size");
}

TEST_F(SessionTest, TellsWhereTheShownNetLiesOnItsPages) {
  open(bumpy());
  EXPECT_EQ(session_.pages(), nullptr);
  session_.unfold();
  ASSERT_TRUE(frames_until_idle());
  ASSERT_NE(session_.pages(), nullptr);
  EXPECT_EQ(session_.pages()->pages.size(), session_.sheets()->size());
  session_.step();
  EXPECT_EQ(session_.pages(), nullptr) << "another net is being made";
}

TEST_F(SessionTest, SaysWhyThereAreNoSheets) {
  open_and_unfold(bumpy());
  session_.set_paper({.format = "A6", .margin_mm = 60});
  ASSERT_TRUE(frames_until([&] { return session_.sheets() == nullptr; }));
  EXPECT_EQ(messages_.back().kind, Message::Kind::Error);
  EXPECT_TRUE(session_.shown()->is_proved);
}

TEST_F(SessionTest, SavesTheProvedNet) {
  open_and_unfold(bumpy());
  session_.export_to(in_folder("patch.pdf"));
  session_.export_to(in_folder("patch.fold"));
  session_.set_exports({.instructions = InstructionPage::First}, "instructions");
  session_.export_to(in_folder("guide.pdf"));
  ASSERT_TRUE(frames_until([this] { return session_.chore() == nullptr; }));
  EXPECT_TRUE(has_message(Message::Kind::Good, "Saved patch.pdf, 1 page"));
  EXPECT_TRUE(has_message(Message::Kind::Good, "Saved guide.pdf, 2 pages with the instructions"));
  EXPECT_TRUE(has_message(Message::Kind::Good, "Saved patch.fold"));
  EXPECT_GT(std::filesystem::file_size(folder_ / "patch.pdf"), 1000u);
  EXPECT_GT(std::filesystem::file_size(folder_ / "patch.fold"), 1000u);
}

TEST_F(SessionTest, SavesAFolderForACutterWithTheMarginsThatItsMarksNeed) {
  open_and_unfold(bumpy());
  session_.set_paper({.format = "A4", .margin_mm = 5});
  session_.export_for_cutter(in_folder("ball.silhouette"), CutterPreset::Silhouette);
  ASSERT_TRUE(frames_until([this] { return session_.chore() == nullptr; }));
  EXPECT_TRUE(has_message(Message::Kind::Good, "Saved 3 files for the cutter into ball.silhouette"));
  std::size_t n_files = 0;
  for (const auto& file : std::filesystem::directory_iterator(folder_ / "ball.silhouette"))
    n_files += file.file_size() > 500 ? 1 : 0;
  EXPECT_EQ(n_files, 3u);
}

TEST_F(SessionTest, SavesNothingWithoutAProvedNet) {
  open(endless());
  session_.export_for_cutter(in_folder("early.laser"), CutterPreset::Laser);
  session_.export_to(in_folder("early.pdf"));
  session_.unfold();
  session_.export_to(in_folder("early.pdf"));
  ASSERT_TRUE(frames_until([this] { return session_.figures().moves > 0; }));
  session_.stop();
  ASSERT_TRUE(frames_until([this] { return session_.state() == RunState::Idle; }));
  session_.export_to(in_folder("early.pdf"));
  frame();
  EXPECT_TRUE(has_message(Message::Kind::Notice, "no net without overlaps"));
  EXPECT_TRUE(has_message(Message::Kind::Notice, "still going"));
  EXPECT_EQ(session_.chore(), nullptr);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "early.pdf"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "early.laser"));
}

TEST_F(SessionTest, TellsWhenAFileCannotBeSaved) {
  open_and_unfold(bumpy());
  session_.export_to(in_folder("no") / "such" / "folder" / "net.pdf");
  session_.export_to(in_folder("net.doc"));
  ASSERT_TRUE(frames_until([this] { return session_.chore() == nullptr; }));
  EXPECT_TRUE(has_message(Message::Kind::Error, "net.pdf"));
  EXPECT_TRUE(has_message(Message::Kind::Error, ".pdf, "));
}

TEST_F(SessionTest, WakesTheLoopWhenThereIsSomethingToPoll) {
  std::atomic<int> n_rings{0};
  session_.set_wake([&n_rings] { ++n_rings; });
  session_.open_bytes("ball.obj", ball());
  while (n_rings == 0) std::this_thread::yield();
  EXPECT_TRUE(session_.poll());
  EXPECT_EQ(session_.state(), RunState::Idle);
  const int after_opening = n_rings;
  session_.unfold();
  EXPECT_LT(session_.wait_seconds(), 1);
  while (n_rings == after_opening) std::this_thread::yield();
  EXPECT_TRUE(session_.poll());
  session_.set_wake({});
}

TEST_F(SessionTest, UnfoldsEveryPartOfAModelIntoAPieceOfItsOwn) {
  open(shapes::to_obj(shapes::combined(shapes::cube(), shapes::bumpy_patch(6, 6), {9, 0, 0})));
  session_.unfold();
  ASSERT_TRUE(frames_until_idle());
  EXPECT_EQ(session_.shown()->net.n_pieces, 2);
  EXPECT_TRUE(has_message(Message::Kind::Good, "2 pieces"));
}

TEST(Session, MayGoWhileEverythingIsGoingOn) {
  double now = 0;
  for (const double speed : {kFullSpeed, 0.1}) {
    Session session([&now] { return now; });
    session.open_bytes("endless.obj", endless());
    while (session.state() != RunState::Idle) session.poll();
    session.set_speed(speed);
    session.unfold();
    session.open_bytes("ball.obj", ball());
  }
  Session paused([&now] { return now; });
  paused.open_bytes("endless.obj", endless());
  while (paused.state() != RunState::Idle) paused.poll();
  paused.step();
}

}  // namespace
}  // namespace netwright
