// Proofs that there is no net: found for models that have none, never for those that have one, and refused by
// the checker as soon as they show less than they claim.
#include "core/unfold/impossibility.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/predicates.h"
#include "core/base/random.h"
#include "core/solve/prove_hinges.h"
#include "core/solve/prove_impossible.h"
#include "core/solve/prove_regions.h"
#include "core/solve/solve.h"
#include "core/unfold/overlap.h"
#include "tests/hatted_shapes.h"
#include "tests/support.h"

namespace netwright {
namespace {

constexpr testing::CupRange kCups{1, 1.5, 0.1, 1, 0.4, 0.8, 0.6, 0.12, 0.3};

using testing::make_dual;
using testing::with_hats;
using testing::zoo;
using Node = ImpossibilityProof::Node;
using Step = ImpossibilityProof::Step;

constexpr ProveLimits kShort{.region_steps = 5000, .hinge_steps = 5000};

ProveResult try_to_prove(const PolygonSoup& soup, const ProveLimits& limits = {}) {
  const Progress progress;
  return prove_impossible(make_dual(soup), limits, progress);
}

std::vector<PolygonSoup> bases() {
  return {shapes::tetrahedron(), shapes::octahedron(), shapes::icosahedron(), shapes::bipyramid(3),
          shapes::bipyramid(5)};
}

/// A hat on at least as many faces as there are corners.
std::vector<PolygonSoup> hat_polyhedra() {
  std::vector<PolygonSoup> all;
  for (const PolygonSoup& base : bases()) {
    const int n_corners = static_cast<int>(base.points.size());
    for (const double height : {0.9, 1.15, 1.6, 2.5}) all.push_back(with_hats(base, {0.17, height}));
    if (base.n_faces() > n_corners) all.push_back(with_hats(base, {0.17, 1.3, n_corners}));
  }
  return all;
}

TEST(Impossibility, MoreThanTwentyHatPolyhedraAreProved) {
  int n_proved = 0;
  for (const PolygonSoup& soup : hat_polyhedra()) {
    const ProveResult result = try_to_prove(soup);
    EXPECT_EQ(result.answer, ProveAnswer::Proved) << soup.n_faces();
    EXPECT_TRUE(verify_impossible(*testing::make_mesh(soup), result.proof).is_proved);
    n_proved += result.answer == ProveAnswer::Proved ? 1 : 0;
  }
  EXPECT_GT(n_proved, 20);
}

TEST(Impossibility, HatsOnAPartOfALargeModelAreEnough) {
  const PolygonSoup soup = with_hats(shapes::icosphere(4), {0.17, 1.15, 60});
  EXPECT_EQ(try_to_prove(soup).answer, ProveAnswer::Proved);
}

TEST(Impossibility, LowerSpikesThatHaveANetAreNeverProved) {
  int n_nets = 0;
  for (const PolygonSoup& base : {shapes::tetrahedron(), shapes::octahedron(), shapes::bipyramid(3)}) {
    for (const double height : {0.2, 0.23, 0.26, 0.28, 0.3, 0.32, 0.35, 0.4}) {
      const auto dual = make_dual(with_hats(base, {0.17, height}));
      SolveOptions options;
      options.max_iterations = 2000;
      Progress progress;
      if (!solve(dual, options, progress).is_proved) continue;
      ++n_nets;
      EXPECT_NE(prove_impossible(dual, kShort, progress).answer, ProveAnswer::Proved) << height;
    }
  }
  EXPECT_GT(n_nets, 8);
}

TEST(Impossibility, FewerHatsThatHaveANetAreNeverProved) {
  int n_nets = 0;
  for (const PolygonSoup& base : bases()) {
    for (int n_hats = 1; n_hats <= std::min(base.n_faces(), 6); n_hats += 2) {
      const auto dual = make_dual(with_hats(base, {0.17, 1.15, n_hats}));
      SolveOptions options;
      options.max_iterations = 2000;
      Progress progress;
      if (!solve(dual, options, progress).is_proved) continue;
      ++n_nets;
      EXPECT_NE(prove_impossible(dual, kShort, progress).answer, ProveAnswer::Proved) << n_hats;
    }
  }
  EXPECT_GT(n_nets, 4);
}

TEST(Impossibility, NoShapeOfTheZooIsProvedAndSmallOnesGetTheirNet) {
  for (const auto& shape : zoo()) {
    if (shape.soup.n_faces() > 100) continue;
    const ProveResult result = try_to_prove(shape.soup, kShort);
    EXPECT_NE(result.answer, ProveAnswer::Proved) << shape.soup.name;
    if (shape.soup.n_faces() <= 64) {
      EXPECT_EQ(result.answer, ProveAnswer::NetFound) << shape.soup.name;
    }
  }
}

/// Goes through all trees, laid out one by one.
bool has_net(const std::shared_ptr<const DualGraph>& dual) {
  const Mesh& mesh = dual->mesh();
  std::vector<EdgeId> hinges;
  for (const EdgeId e : mesh.edges())
    if (!mesh.is_border(e)) hinges.push_back(e);
  IdVector<EdgeId, char> is_fold(mesh.n_edges(), 0);
  const auto try_from = [&](const auto& self, std::size_t next, std::size_t missing) -> bool {
    if (missing == 0) {
      UnfoldTree tree;
      try {
        tree = tree_from_folds(mesh, is_fold);
      } catch (const std::logic_error&) {
        return false;
      }
      return find_overlaps(layout(dual, tree), kProofDepth).empty();
    }
    if (hinges.size() - next < missing) return false;
    is_fold[hinges[next]] = 1;
    if (self(self, next + 1, missing - 1)) return true;
    is_fold[hinges[next]] = 0;
    return self(self, next + 1, missing);
  };
  return try_from(try_from, 0, mesh.n_faces() - 1);
}

TEST(Impossibility, AgreesWithTryingEveryTree) {
  Random random(5);
  int n_without = 0;
  int n_with = 0;
  for (int k = 0; k < 30; ++k) {
    const auto dual = make_dual(testing::random_cup(random, kCups));
    const Progress progress;
    const ProveAnswer answer = prove_impossible(dual, {}, progress).answer;
    const bool is_possible = has_net(dual);
    EXPECT_EQ(answer, is_possible ? ProveAnswer::NetFound : ProveAnswer::Proved) << k;
    (is_possible ? n_with : n_without) += 1;
  }
  EXPECT_GT(n_without, 3);
  EXPECT_GT(n_with, 3);
}

TEST(Impossibility, HingesAloneProveASpikedTetrahedronToo) {
  const auto spiked = make_dual(with_hats(shapes::tetrahedron(), {0.001, 3.0}));
  std::vector<FaceId> all;
  for (const FaceId f : spiked->mesh().faces()) all.push_back(f);
  const Progress progress;
  const HingeSearch search = search_hinges(*spiked, all, 1, 2'000'000, progress);
  ASSERT_TRUE(search.proof.has_value());
  EXPECT_TRUE(search.proof->regions.empty());
  EXPECT_TRUE(verify_impossible(spiked->mesh(), *search.proof).is_proved);
}

struct Proved {
  std::shared_ptr<const Mesh> mesh;
  ImpossibilityProof proof;
};

Proved proved(const PolygonSoup& soup) {
  ProveResult result = try_to_prove(soup);
  EXPECT_EQ(result.answer, ProveAnswer::Proved);
  return {testing::make_mesh(soup), std::move(result.proof)};
}

TEST(Impossibility, AProofThatLacksAnyOfItsStepsIsRefused) {
  const Proved whole = proved(with_hats(shapes::tetrahedron()));
  ASSERT_TRUE(verify_impossible(*whole.mesh, whole.proof).is_proved);
  for (std::size_t i = 0; i < whole.proof.nodes.size(); ++i) {
    ImpossibilityProof less = whole.proof;
    less.nodes.erase(less.nodes.begin() + static_cast<std::ptrdiff_t>(i));
    const ImpossibilityVerdict verdict = verify_impossible(*whole.mesh, less);
    EXPECT_FALSE(verdict.is_proved) << i;
    EXPECT_FALSE(verdict.fault.empty()) << i;
  }
}

TEST(Impossibility, ARegionThatKeepsAWayBackIsRefused) {
  const Proved whole = proved(with_hats(shapes::octahedron()));
  for (std::size_t r = 0; r < whole.proof.regions.size(); ++r) {
    for (std::size_t k = 0; k < whole.proof.regions[r].joins.size(); ++k) {
      ImpossibilityProof less = whole.proof;
      auto& joins = less.regions[r].joins;
      joins.erase(joins.begin() + static_cast<std::ptrdiff_t>(k));
      EXPECT_FALSE(verify_impossible(*whole.mesh, less).is_proved) << r << " " << k;
    }
    ImpossibilityProof empty = whole.proof;
    empty.regions[r].joins.clear();
    EXPECT_FALSE(verify_impossible(*whole.mesh, empty).is_proved) << r;
  }
}

TEST(Impossibility, AProofOfAnotherModelIsRefused) {
  const Proved whole = proved(with_hats(shapes::tetrahedron()));
  const auto lower = testing::make_mesh(with_hats(shapes::tetrahedron(), {0.17, 0.3}));
  ASSERT_EQ(lower->n_faces(), whole.mesh->n_faces());
  EXPECT_FALSE(verify_impossible(*lower, whole.proof).is_proved);
  EXPECT_FALSE(verify_impossible(*testing::make_mesh(shapes::cube()), whole.proof).is_proved);
}

TEST(Impossibility, ProofsThatProveNothingAreRefused) {
  const auto cube = testing::make_mesh(shapes::cube());
  const auto fault = [&](const ImpossibilityProof& proof) { return verify_impossible(*cube, proof).fault; };
  EXPECT_EQ(fault({}), "A case of the proof is missing.");
  EXPECT_EQ(fault({{}, {{Step::Topology, 0, 0}}}), "A case of the proof ends without a reason.");
  EXPECT_EQ(fault({{}, {{Step::Overlap, 0, 1}}}), "Two faces do not overlap where the proof says so.");
  EXPECT_EQ(fault({{}, {{Step::Overlap, -1, 99}}}), "Two faces do not overlap where the proof says so.");
  EXPECT_EQ(fault({{}, {{Step::Hinge, 99, 0}}}),
            "The proof decides a hinge that is not there or decided already.");
  EXPECT_EQ(fault({{}, {{Step::Hinge, 0, 0}, {Step::Hinge, 0, 0}}}),
            "The proof decides a hinge that is not there or decided already.");
  EXPECT_EQ(fault({{}, {{Step::Region, 0, 0}}}),
            "The proof decides a region that is not there or decided already.");
  std::vector<FaceId> all;
  for (const FaceId f : cube->faces()) all.push_back(f);
  EXPECT_EQ(fault({{{all, {}}}, {{Step::Region, 0, 0}}}), "A region has no way out.");
  const std::vector<FaceId> one{FaceId(0)};
  EXPECT_EQ(fault({{{one, {}}}, {{Step::Region, 0, 0}}}),
            "A region can be joined in a way that is not listed.");
  EXPECT_EQ(fault({{{one, {{0}}}, {one, {{0}}}}, {}}), "A face is in two regions of the proof.");
}

TEST(Impossibility, ACubeCutIntoTwoIsOnlyOneCase) {
  const auto cube = testing::make_mesh(shapes::cube());
  const FaceId lid(0);
  ImpossibilityProof proof;
  for (const HalfedgeId h : cube->halfedges(lid))
    proof.nodes.push_back({Step::Hinge, cube->edge(h).value, 0});
  // All four cut comes last; the cases in which one is a fold have no end that holds.
  for (std::size_t k = 0; k < 5; ++k) proof.nodes.push_back({Step::Topology, 0, 0});
  EXPECT_FALSE(verify_impossible(*cube, proof).is_proved);
}

TEST(Impossibility, CancelledAndShortOfStepsIsUnknown) {
  const auto dual = make_dual(with_hats(shapes::tetrahedron()));
  Progress cancelled;
  cancelled.cancel();
  EXPECT_EQ(prove_impossible(dual, {}, cancelled).answer, ProveAnswer::Unknown);
  const Progress progress;
  EXPECT_EQ(prove_impossible(dual, {3, 3, 64}, progress).answer, ProveAnswer::Unknown);
}

TEST(Impossibility, TheSearchTellsThatThereIsNoNet) {
  for (const PolygonSoup& base : {shapes::tetrahedron(), shapes::octahedron()}) {
    Progress progress;
    const auto dual = make_dual(with_hats(base));
    const SolveResult result = solve(dual, {}, progress);
    ASSERT_NE(result.impossible, nullptr);
    EXPECT_FALSE(result.is_proved);
    EXPECT_FALSE(result.was_cancelled);
    EXPECT_FALSE(result.overlaps.empty());
    EXPECT_TRUE(verify_impossible(dual->mesh(), *result.impossible).is_proved);
  }
}

}  // namespace
}  // namespace netwright
