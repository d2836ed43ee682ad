// The whole job: proved nets for every shape, the same answer on any number of threads and at any watching
// pace, cancelling at any moment.
#include "core/solve/solve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <thread>

#include "core/base/predicates.h"
#include "core/base/random.h"
#include "core/unfold/obstruction.h"
#include "tests/support.h"

namespace netwright {
namespace {

using testing::make_dual;
using testing::zoo;

SolveResult solve_with(const PolygonSoup& soup, const SolveOptions& options, const SolveHooks& hooks = {}) {
  Progress progress;
  return solve(make_dual(soup), options, progress, hooks);
}

TEST(Solve, EveryShapeOfTheZooBecomesAProvedNetOfOnePiecePerComponent) {
  for (const auto& shape : zoo()) {
    const SolveResult result = solve_with(shape.soup, {});
    EXPECT_TRUE(result.is_proved) << shape.soup.name << ": "
                                  << (result.proof.faults.empty() ? "" : result.proof.faults.front());
    EXPECT_EQ(result.net.n_pieces, shape.n_components) << shape.soup.name;
    EXPECT_TRUE(result.overlaps.empty()) << shape.soup.name;
  }
}

// A prism over a random outline seen from its middle: large concave faces, narrow notches, slivers. Some of
// these have no net in one piece at all.
PolygonSoup random_prism(Random& random) {
  std::vector<glm::dvec2> outline;
  const int n = 4 + random.below(12);
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * M_PI * (i + 0.7 * random.unit()) / n;
    const double r = 0.3 + random.unit();
    outline.emplace_back(r * std::cos(angle), r * std::sin(angle));
  }
  return shapes::prism(outline, 0.1 + 2 * random.unit());
}

// A projective map keeps every face flat but changes all lengths and angles: n-gons of every kind, concave
// ones, holes and borders, none of them regular any more.
PolygonSoup distorted(PolygonSoup soup, Random& random) {
  const auto signed_unit = [&] { return 2 * random.unit() - 1; };
  const glm::dvec3 stretch(0.5 + random.unit(), 0.5 + random.unit(), 0.5 + random.unit());
  const double shear = signed_unit();
  const glm::dvec3 towards(signed_unit(), signed_unit(), signed_unit());
  double farthest = 0;
  for (const glm::dvec3& p : soup.points) farthest = std::max(farthest, glm::length(p));
  for (glm::dvec3& p : soup.points) {
    const glm::dvec3 q = stretch * glm::dvec3(p.x + shear * p.y, p.y, p.z);
    p = q / (1 + 0.3 * glm::dot(towards, p) / farthest);
  }
  return soup;
}

TEST(Solve, DistortedShapesOfTheZooAreProvedNetsToo) {
  Random random(22);
  for (const auto& shape : zoo()) {
    SolveOptions options;
    options.max_iterations = 20'000;
    const SolveResult result = solve_with(distorted(shape.soup, random), options);
    EXPECT_TRUE(result.is_proved) << shape.soup.name;
    EXPECT_TRUE(verify(to_flat_net(result.net, 1), shape.n_components).is_net) << shape.soup.name;
  }
}

TEST(Solve, RandomPrismsEndAsAProvedNetOrHonestlyWithout) {
  Random random(21);
  int n_proved = 0;
  for (int k = 0; k < 60; ++k) {
    SolveOptions options;
    options.seed = static_cast<std::uint64_t>(k);
    options.max_iterations = 400;
    const SolveResult result = solve_with(random_prism(random), options);
    EXPECT_TRUE(result.net.tree.is_forest(result.net.mesh()));
    EXPECT_EQ(result.is_proved, verify(to_flat_net(result.net, 1)).is_net) << k;
    if (!result.is_proved) {
      EXPECT_FALSE(result.overlaps.empty()) << k;
    }
    n_proved += result.is_proved ? 1 : 0;
  }
  EXPECT_GT(n_proved, 20);
}

// An upright star of seven points whose notches are `notch_radius` deep; below 0.467 of the tips' radius they
// open less than a right angle.
PolygonSoup seven_pointed_star(double notch_radius) {
  std::vector<glm::dvec2> outline;
  for (int i = 0; i < 14; ++i) {
    const double r = i % 2 == 0 ? 1 : notch_radius;
    outline.emplace_back(r * std::cos(i * M_PI / 7), r * std::sin(i * M_PI / 7));
  }
  PolygonSoup soup = shapes::prism(outline, 0.5);
  soup.name = "star.obj";
  return soup;
}

TEST(Solve, SaysWhichFaceMakesANetImpossibleInsteadOfSearching) {
  const SolveResult result = solve_with(seven_pointed_star(0.45), {});
  ASSERT_TRUE(result.isolated_face.is_valid());
  EXPECT_EQ(result.net.mesh().degree(result.isolated_face), 14);
  EXPECT_FALSE(result.is_proved);
  EXPECT_EQ(result.iterations, 0);
  const std::string words = isolated_face_sentence(result.net.mesh(), result.isolated_face);
  EXPECT_NE(words.find("star.obj has no net in one piece: face "), std::string::npos) << words;
}

TEST(Solve, NearMissesOfTheImpossibleAreUnfolded) {
  for (const double notch_radius : {0.48, 0.5, 0.6}) {
    const SolveResult result = solve_with(seven_pointed_star(notch_radius), {});
    EXPECT_FALSE(result.isolated_face.is_valid()) << notch_radius;
    EXPECT_TRUE(result.is_proved) << notch_radius;
  }
}

TEST(Solve, NoFaceOfTheZooIsIsolated) {
  for (const auto& shape : zoo())
    EXPECT_FALSE(find_isolated_face(*make_dual(shape.soup)).is_valid()) << shape.soup.name;
}

TEST(Solve, SameSeedSameNetOnAnyNumberOfThreads) {
  SolveOptions options;
  options.seed = 5;
  options.streams = 4;
  options.threads = 1;
  const SolveResult alone = solve_with(shapes::bumpy_patch(12, 12), options);
  for (const int threads : {2, 3, 4}) {
    options.threads = threads;
    const SolveResult together = solve_with(shapes::bumpy_patch(12, 12), options);
    EXPECT_EQ(together.net.tree, alone.net.tree);
    EXPECT_EQ(together.iterations, alone.iterations);
    EXPECT_EQ(together.stream, alone.stream);
  }
}

// The number was printed by a release build; sanitized and debug builds must come to the same net, so nothing
// may depend on fused multiply-add, the order of containers or the width of the vector unit.
TEST(Solve, EveryBuildFindsTheSameNet) {
  SolveOptions options;
  options.seed = 5;
  const SolveResult result = solve_with(shapes::bumpy_patch(10, 10), options);
  const Mesh& mesh = result.net.mesh();
  std::uint64_t hash = 14695981039346656037ULL;
  for (const EdgeId e : mesh.edges())
    hash = (hash ^ (result.net.tree.is_fold(mesh, e) ? 1U : 2U)) * 1099511628211ULL;
  EXPECT_EQ(hash, 10046219270673151298ULL);
}

TEST(Solve, AnotherSeedGivesAnotherNet) {
  SolveOptions options;
  const SolveResult first = solve_with(shapes::icosphere(3), options);
  options.seed = 1;
  EXPECT_NE(solve_with(shapes::icosphere(3), options).net.tree, first.net.tree);
}

TEST(Solve, PinnedRootIsWhereTreeAndLayoutStart) {
  SolveOptions options;
  options.pins.root = FaceId(41);
  const SolveResult result = solve_with(shapes::icosphere(2), options);
  EXPECT_TRUE(result.is_proved);
  EXPECT_TRUE(result.net.tree.is_root(FaceId(41)));
  EXPECT_EQ(result.net.placement[FaceId(41)], Rigid2());
}

TEST(Solve, WatchingMoveByMoveShowsEveryMoveAndChangesNothing) {
  const SolveResult unwatched = solve_with(shapes::bumpy_patch(10, 10), {});
  Mailbox<Snapshot> mailbox;
  std::vector<std::shared_ptr<const Snapshot>> seen;
  SolveHooks hooks;
  hooks.snapshots = &mailbox;
  hooks.pace = [&] {
    if (auto snapshot = mailbox.take()) seen.push_back(std::move(snapshot));
    return Pace::Move;
  };
  const SolveResult watched = solve_with(shapes::bumpy_patch(10, 10), {}, hooks);
  EXPECT_EQ(watched.net.tree, unwatched.net.tree);
  EXPECT_EQ(watched.iterations, unwatched.iterations);
  ASSERT_FALSE(seen.empty());
  for (const auto& snapshot : seen) {
    EXPECT_TRUE(snapshot->net.tree.is_forest(snapshot->net.mesh()));
    EXPECT_EQ(snapshot->overlaps, find_overlaps(snapshot->net, kSolveDepth));
    if (snapshot->last_move) {
      EXPECT_EQ(static_cast<int>(snapshot->overlaps.size()), snapshot->last_move->overlaps_after);
    }
  }
  const auto last = mailbox.take();
  ASSERT_NE(last, nullptr);
  EXPECT_TRUE(last->is_final);
  EXPECT_TRUE(last->overlaps.empty());
}

TEST(Solve, SnapshotsAtFullPaceAreTrueToo) {
  Mailbox<Snapshot> mailbox;
  SolveHooks hooks;
  hooks.snapshots = &mailbox;
  int n_seen = 0;
  hooks.pace = [&] {
    if (const auto snapshot = mailbox.take()) {
      ++n_seen;
      EXPECT_EQ(snapshot->overlaps, find_overlaps(snapshot->net, kSolveDepth));
      EXPECT_FALSE(snapshot->history.empty());
      EXPECT_LE(snapshot->history.size(), 2000U);
    }
    return Pace::Full;
  };
  const PolygonSoup two = shapes::combined(shapes::bumpy_patch(9, 9), shapes::torus(20, 14), {20, 0, 0});
  EXPECT_TRUE(solve_with(two, {}, hooks).is_proved);
  EXPECT_GT(n_seen, 0);
}

TEST(Solve, LogOfTheWinnerReplaysToItsNet) {
  const SolveResult result = solve_with(shapes::bumpy_patch(10, 10), {});
  const Mesh& mesh = result.net.mesh();
  ASSERT_FALSE(result.log.empty());
  const Episode& last = result.log.back();
  IdVector<EdgeId, char> folds(mesh.n_edges(), 0);
  for (const EdgeId e : mesh.edges()) folds[e] = last.start.is_fold(mesh, e) ? 1 : 0;
  for (const MoveRecord& move : last.moves) {
    EXPECT_TRUE(folds[mesh.edge(move.removed)]);
    EXPECT_FALSE(folds[mesh.edge(move.inserted)]);
    folds[mesh.edge(move.removed)] = 0;
    folds[mesh.edge(move.inserted)] = 1;
  }
  for (const EdgeId e : mesh.edges()) EXPECT_EQ(folds[e] != 0, result.net.tree.is_fold(mesh, e));
}

TEST(Solve, CancelAtAnyMoveLeavesAValidNet) {
  SolveOptions one_stream;
  one_stream.seed = 3;
  one_stream.streams = 1;
  for (int stop_at = 0; stop_at < 12; ++stop_at) {
    Mailbox<Snapshot> mailbox;
    SolveHooks hooks;
    hooks.snapshots = &mailbox;
    int moves = 0;
    hooks.pace = [&] { return moves++ < stop_at ? Pace::Move : Pace::Stop; };
    const SolveResult result = solve_with(shapes::bumpy_patch(10, 10), one_stream, hooks);
    EXPECT_TRUE(result.net.tree.is_forest(result.net.mesh()));
    EXPECT_EQ(result.overlaps, find_overlaps(result.net, kShownDepth));
    EXPECT_EQ(result.is_proved, result.overlaps.empty());
  }
}

TEST(Solve, ACancelledJobReturnsAtOnceWithTheStart) {
  Progress progress;
  progress.cancel();
  const SolveResult result = solve(make_dual(shapes::torus(30, 20)), {}, progress);
  EXPECT_TRUE(result.net.tree.is_forest(result.net.mesh()));
  EXPECT_EQ(result.was_cancelled, !result.is_proved);
}

TEST(Solve, CancellingTheStartLeavesAValidNet) {
  const auto dual = make_dual(shapes::torus(60, 40));
  for (const SearchStyle style : {SearchStyle::Fast, SearchStyle::Paper}) {
    for (const int microseconds : {100, 1000, 5000, 20000}) {
      Progress progress;
      std::jthread impatient([&] {
        std::this_thread::sleep_for(std::chrono::microseconds(microseconds));
        progress.cancel();
      });
      SolveOptions options;
      options.search = style;
      const SolveResult result = solve(dual, options, progress);
      EXPECT_TRUE(result.net.tree.is_forest(result.net.mesh()));
      EXPECT_EQ(result.overlaps, find_overlaps(result.net, kShownDepth));
      EXPECT_EQ(result.is_proved, result.overlaps.empty());
    }
  }
}

TEST(Solve, StepLimitEndsTheSearchWithTheBestSoFar) {
  SolveOptions options;
  options.max_iterations = 3;
  const SolveResult result = solve_with(shapes::torus(40, 30), options);
  EXPECT_LE(result.iterations, 3);
  EXPECT_FALSE(result.was_cancelled);
  EXPECT_EQ(result.overlaps, find_overlaps(result.net, kShownDepth));
}

}  // namespace
}  // namespace netwright
