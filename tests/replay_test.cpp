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

TEST(Replay, EndsAtTheNetThatWasFound) {
  int n_proved = 0;
  for (const testing::ZooShape& shape : testing::zoo()) {
    const SolveResult result = solved(shape.soup, 1);
    if (!result.is_proved) continue;
    ++n_proved;
    Replay replay(result);
    replay.advance_to(replay.n_steps() - 1);
    EXPECT_EQ(replay.net().tree, result.net.tree) << shape.soup.name;
    EXPECT_EQ(folds_of(replay.net()), folds_of(result.net)) << shape.soup.name;
    EXPECT_EQ(replay.overlaps(), 0) << shape.soup.name;
    EXPECT_EQ(replay.moves(), result.moves) << shape.soup.name;
    EXPECT_EQ(replay.restarts(), result.restarts) << shape.soup.name;
  }
  EXPECT_GT(n_proved, 30);
}

TEST(Replay, TellsTheOverlapsThatItsNetsHave) {
  const SolveResult result = solved_with_moves();
  Replay replay(result);
  for (int i = 0; i < replay.n_steps(); ++i) {
    replay.advance_to(i);
    EXPECT_EQ(static_cast<int>(find_overlaps(replay.net(), kSolveDepth).size()), replay.overlaps()) << i;
    EXPECT_LE(replay.best_overlaps(), replay.overlaps());
  }
}

TEST(Replay, ReachesTheSameMomentInOneLeapAsStepByStep) {
  const SolveResult result = solved_with_moves();
  Replay slow(result);
  for (int i = 0; i < slow.n_steps(); ++i) {
    slow.advance_to(i);
    Replay leap(result);
    leap.advance_to(i);
    EXPECT_EQ(leap.net().tree, slow.net().tree);
    EXPECT_EQ(leap.history(), slow.history());
    EXPECT_EQ(leap.moves(), slow.moves());
  }
}

TEST(Replay, StandsStillAtTheRootsOfTheResult) {
  const SolveResult result = solved_with_moves();
  const FaceId root = result.net.tree.roots().front();
  Replay replay(result);
  for (int i = 0; i < replay.n_steps(); ++i) {
    replay.advance_to(i);
    EXPECT_EQ(replay.net().placement[root], result.net.placement[root]);
  }
}

TEST(Replay, NeverTakesLongerThanTwoSeconds) {
  SolveResult result = solved_with_moves();
  EXPECT_LE(Replay(result).seconds(), Replay::kLongest);
  const MoveRecord move = result.log.back().moves.back();
  MoveRecord back = move;
  std::swap(back.removed, back.inserted);
  for (int i = 0; i < 300; ++i) {
    result.log.back().moves.push_back(back);
    result.log.back().moves.push_back(move);
  }
  result.log.insert(result.log.begin(), result.log.front());
  result.moves = 10000;
  result.restarts = 7;
  Replay replay(result);
  EXPECT_EQ(replay.seconds(), Replay::kLongest);
  EXPECT_EQ(replay.restarts(), 7) << "only the last episode of a long run is played";
  replay.advance_to(1 << 20);
  EXPECT_EQ(replay.position(), replay.n_steps() - 1);
  EXPECT_EQ(replay.moves(), 10000);
  EXPECT_EQ(replay.net().tree, result.net.tree);
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
  Replay replay(result);
  int n_traced = 0;
  for (int i = 0; i < replay.n_steps(); ++i) {
    UnfoldTree before = replay.net().tree;
    replay.advance_to(i);
    const std::optional<MoveRecord> move = replay.last_move();
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
