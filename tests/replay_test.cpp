// Replays of recorded runs and the trace of a single move, on runs of the real search.
#include "core/project/replay.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/predicates.h"
#include "core/project/shown_net.h"
#include "tests/support.h"

namespace netwright {
namespace {

SolveResult solved(const PolygonSoup& soup, std::uint64_t seed) {
  Progress progress;
  SolveOptions options;
  options.seed = seed;
  options.max_iterations = 5000;
  return solve(testing::make_dual(soup), options, progress);
}

/// A run with some moves in it: the first seed that needs them.
SolveResult solved_with_moves() {
  for (std::uint64_t seed = 0;; ++seed) {
    SolveResult result = solved(shapes::bumpy_patch(6, 6), seed);
    if (result.is_proved && result.moves >= 10 && result.moves <= 500) return result;
  }
}

std::vector<EdgeId> folds_of(const Net& net) {
  std::vector<EdgeId> folds;
  for (const EdgeId e : net.mesh().edges())
    if (net.tree.is_fold(net.mesh(), e)) folds.push_back(e);
  return folds;
}

std::shared_ptr<const RunLog> log_of(SolveResult result) { return std::make_shared<const RunLog>(result); }

/// A run of three episodes, the last of which goes back and forth so long that it cannot be followed.
SolveResult long_run() {
  SolveResult result = solved_with_moves();
  const Episode first = result.log.front();
  const MoveRecord move = result.log.back().moves.back();
  MoveRecord back = move;
  std::swap(back.removed, back.inserted);
  back.overlaps_after = 3;
  for (int i = 0; i < 300; ++i) {
    result.log.back().moves.push_back(back);
    result.log.back().moves.push_back(move);
  }
  result.log.insert(result.log.begin(), 2, first);
  result.moves = 10000;
  result.restarts = 7;
  return result;
}

TEST(Replay, EndsAtTheNetThatWasFound) {
  int n_proved = 0;
  for (const testing::ZooShape& shape : testing::zoo()) {
    const SolveResult result = solved(shape.soup, 1);
    if (!result.is_proved) continue;
    ++n_proved;
    Replay replay(log_of(result));
    const int last = replay.log().n_steps() - 1;
    replay.seek(last);
    EXPECT_EQ(replay.net().tree, result.net.tree) << shape.soup.name;
    EXPECT_EQ(folds_of(replay.net()), folds_of(result.net)) << shape.soup.name;
    EXPECT_EQ(replay.log().overlaps(last), 0) << shape.soup.name;
    EXPECT_EQ(replay.log().moves(last), result.moves) << shape.soup.name;
    EXPECT_EQ(replay.log().restarts(last), result.restarts) << shape.soup.name;
  }
  EXPECT_GT(n_proved, 30);
}

TEST(Replay, TellsTheOverlapsThatItsNetsHave) {
  Replay replay(log_of(solved_with_moves()));
  const RunLog& log = replay.log();
  int fewest = log.overlaps(0);
  for (int i = 0; i < log.n_steps(); ++i) {
    replay.seek(i);
    EXPECT_EQ(static_cast<int>(find_overlaps(replay.net(), kSolveDepth).size()), log.overlaps(i)) << i;
    fewest = std::min(fewest, log.overlaps(i));
    EXPECT_EQ(log.fewest_overlaps(i), fewest);
  }
  EXPECT_EQ(log.best_position(), log.n_steps() - 1) << "a proved net is where the search ends";
}

TEST(Replay, ReachesTheSameMomentFromEverywhere) {
  const auto log = log_of(long_run());
  std::vector<UnfoldTree> trees;
  for (int i = 0; i < log->n_steps(); i += 7) {
    Replay fresh(log);
    fresh.seek(i);
    trees.push_back(fresh.net().tree);
  }
  Replay replay(log);
  Random random(5);
  for (int k = 0; k < 300; ++k) {
    const int i = random.below(static_cast<int>(trees.size()));
    replay.seek(7 * i);
    ASSERT_EQ(replay.position(), 7 * i);
    ASSERT_EQ(replay.net().tree, trees[static_cast<std::size_t>(i)]) << "position " << 7 * i;
  }
}

TEST(Replay, GoesBackMoveByMove) {
  const auto log = log_of(solved_with_moves());
  Replay replay(log);
  replay.seek(log->n_steps() - 1);
  for (int i = log->n_steps() - 1; i >= 0; --i) {
    replay.seek(i);
    Replay forward(log);
    forward.seek(i);
    EXPECT_EQ(replay.net().tree, forward.net().tree) << i;
  }
}

TEST(Replay, StopsAtBothEnds) {
  const auto log = log_of(long_run());
  Replay replay(log);
  replay.seek(1 << 20);
  EXPECT_EQ(replay.position(), log->n_steps() - 1);
  replay.seek(-3);
  EXPECT_EQ(replay.position(), 0);
  EXPECT_FALSE(log->move(0).has_value());
}

TEST(Replay, StandsStillAtTheRootsOfTheResult) {
  const SolveResult result = solved_with_moves();
  const FaceId root = result.net.tree.roots().front();
  Replay replay(log_of(result));
  for (int i = 0; i < replay.log().n_steps(); ++i) {
    replay.seek(i);
    EXPECT_EQ(replay.net().placement[root], result.net.placement[root]);
  }
}

TEST(Replay, NeverTakesLongerThanTwoSecondsByItself) {
  EXPECT_LE(Replay(log_of(solved_with_moves())).seconds(), Replay::kLongest);
  const SolveResult result = long_run();
  const auto whole = log_of(result);
  const auto log = std::make_shared<const RunLog>(*whole, RunLog::Extent::Followable);
  Replay replay(log);
  EXPECT_EQ(replay.seconds(), Replay::kLongest);
  EXPECT_LT(log->n_steps(), whole->n_steps());
  EXPECT_EQ(log->restarts(0), 7) << "only the last episode of a long run is played";
  replay.seek(log->n_steps() - 1);
  EXPECT_EQ(log->moves(replay.position()), 10000);
  EXPECT_EQ(replay.net().tree, result.net.tree);
}

TEST(RunLog, CountsMovesAndRestartsOverItsEpisodes) {
  const SolveResult result = long_run();
  const auto log = log_of(result);
  const auto n_first = static_cast<int>(result.log.front().moves.size());
  EXPECT_EQ(log->begin_of(1), n_first + 1);
  EXPECT_EQ(log->restarts(0), 5);
  EXPECT_EQ(log->restarts(n_first), 5);
  EXPECT_EQ(log->restarts(n_first + 1), 6);
  EXPECT_EQ(log->moves(n_first), log->moves(0) + n_first);
  EXPECT_EQ(log->moves(n_first + 1), log->moves(n_first)) << "a restart is no move";
  EXPECT_EQ(log->overlaps(n_first + 1), result.log[1].overlaps_at_start);
  EXPECT_EQ(log->n_moves(), log->n_steps() - 3);
  EXPECT_EQ(log->overlaps(log->best_position()), 0);
  EXPECT_GT(log->bytes(), 600 * sizeof(MoveRecord));
}

TEST(RunLog, ThinsItsHistoryButKeepsTheEnds) {
  const auto log = log_of(long_run());
  std::int64_t stride = 0;
  const std::vector<int> whole = log->history(1 << 20, stride);
  EXPECT_EQ(stride, 1);
  EXPECT_EQ(static_cast<std::int64_t>(whole.size()), log->n_moves() + 1);
  const std::vector<int> thin = log->history(50, stride);
  EXPECT_LE(thin.size(), 51U);
  EXPECT_GE(static_cast<std::int64_t>(thin.size()) * stride, log->n_moves());
  EXPECT_EQ(thin.front(), whole.front());
  EXPECT_EQ(thin.back(), whole.back());
}

/// Does taking this edge for one of the folds on the climb give a tree again?
bool reconnects(const Mesh& mesh, const UnfoldTree& before, const std::vector<FaceId>& climbed, EdgeId cut) {
  for (std::size_t i = 0; i + 1 < climbed.size(); ++i) {
    IdVector<EdgeId, char> is_fold(mesh.n_edges(), 0);
    for (const EdgeId e : mesh.edges()) is_fold[e] = before.is_fold(mesh, e) ? 1 : 0;
    is_fold[mesh.edge(before.to_parent(climbed[i]))] = 0;
    is_fold[cut] = 1;
    try {
      if (tree_from_folds(mesh, is_fold).roots().size() == 1) return true;
    } catch (const std::logic_error&) {
      continue;
    }
  }
  return false;
}

TEST(ShownNet, TracesTheClimbOfAMoveInTheTreeBeforeIt) {
  const SolveResult result = solved_with_moves();
  const Mesh& mesh = result.net.mesh();
  Replay replay(log_of(result));
  int n_traced = 0;
  for (int i = 0; i < replay.log().n_steps(); ++i) {
    UnfoldTree before = replay.net().tree;
    replay.seek(i);
    const std::optional<MoveRecord> move = replay.log().move(i);
    if (!move) continue;
    before.reroot(mesh, move->root);
    ShownNet shown = make_shown_net(replay.net(), {}, false);
    trace_move(shown, *move);
    ASSERT_EQ(shown.climbed.front(), move->chosen);
    ASSERT_EQ(shown.climbed.back(), move->root);
    for (std::size_t k = 0; k + 1 < shown.climbed.size(); ++k)
      EXPECT_EQ(before.parent(mesh, shown.climbed[k]), shown.climbed[k + 1]);
    for (const EdgeId e : shown.candidates) EXPECT_TRUE(reconnects(mesh, before, shown.climbed, e));
    const EdgeId inserted = mesh.edge(move->inserted);
    if (shown.candidates.size() < 200) {
      EXPECT_EQ(std::count(shown.candidates.begin(), shown.candidates.end(), inserted), 1);
    }
    ++n_traced;
  }
  EXPECT_GT(n_traced, 0);
}

TEST(ShownNet, MarksBothFacesOfEveryOverlap) {
  const SolveResult result = solved(shapes::cube(), 0);
  const ShownNet shown = make_shown_net(result.net, {{FaceId(1), FaceId(4)}, {FaceId(1), FaceId(5)}}, false);
  EXPECT_EQ(shown.is_overlapping, (std::vector<bool>{false, true, false, false, true, true}));
  EXPECT_EQ(shown.kinds.size(), result.net.mesh().n_edges());
}

TEST(ShownNet, LaysOutFromTheGivenRootWhateverTheTreesOwn) {
  const SolveResult result = solved(shapes::icosphere(2), 0);
  for (const FaceId root : {FaceId(0), FaceId(17), FaceId(79)}) {
    const Net net = layout_from(result.net.dual, result.net.tree, {root});
    EXPECT_TRUE(net.tree.is_root(root));
    EXPECT_EQ(net.placement[root], Rigid2());
    EXPECT_EQ(folds_of(net), folds_of(result.net));
  }
}

}  // namespace
}  // namespace netwright
