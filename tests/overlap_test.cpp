// The pair test and the sweep line, against brute force and on the borderline cases that mislead
// edge-crossing tests.
#include "core/unfold/overlap.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/predicates.h"
#include "core/unfold/steepest_edge.h"
#include "tests/support.h"

namespace netwright {
namespace {

using Polygon = std::vector<glm::dvec2>;

const Polygon kTriangle = {{0, 0}, {2, 0}, {0, 2}};

Polygon shifted(const Polygon& p, glm::dvec2 by) {
  Polygon q;
  for (const glm::dvec2 v : p) q.push_back(v + by);
  return q;
}

TEST(ConvexOverlap, TouchingIsNotOverlapping) {
  EXPECT_FALSE(convex_overlap(kTriangle, shifted(kTriangle, {2, 0}), 1e-10));
  EXPECT_FALSE(convex_overlap(kTriangle, Polygon{{0, 0}, {0, 2}, {-2, 0}}, 1e-10));
  EXPECT_FALSE(convex_overlap(kTriangle, Polygon{{2, 0}, {2, 2}, {0, 2}}, 1e-10));
}

TEST(ConvexOverlap, SeesContainmentCoincidenceAndCrossing) {
  EXPECT_TRUE(convex_overlap(kTriangle, Polygon{{0.2, 0.2}, {0.4, 0.2}, {0.2, 0.4}}, 1e-10));
  EXPECT_TRUE(convex_overlap(kTriangle, kTriangle, 1e-10));
  EXPECT_TRUE(convex_overlap(kTriangle, Polygon{{-1, 0.5}, {3, 0.5}, {3, 0.6}}, 1e-10));
}

TEST(ConvexOverlap, DepthDecidesBorderlineCases) {
  EXPECT_TRUE(convex_overlap(kTriangle, shifted(kTriangle, {2 - 1e-6, -1e-9}), 1e-10));
  EXPECT_FALSE(convex_overlap(kTriangle, shifted(kTriangle, {2 - 1e-12, 0}), 1e-10));
}

TEST(ConvexOverlap, SliversBesideEachOtherAreFree) {
  const Polygon sliver = {{0, 0}, {1, 0}, {0.5, 1e-7}};
  EXPECT_FALSE(convex_overlap(sliver, Polygon{{0, 0}, {0.5, -1e-7}, {1, 0}}, 2e-10));
  EXPECT_TRUE(convex_overlap(sliver, sliver, 2e-10));
}

bool brute_force_pair(const Net& net, FaceId a, FaceId b, double depth) {
  const auto part = [&](FaceId f, int k) {
    Polygon p;
    for (const int i : net.dual->part(f, k))
      p.push_back(net.corner(HalfedgeId(net.mesh().first(f).value + i)));
    return p;
  };
  for (int i = 0; i < net.dual->n_parts(a); ++i)
    for (int j = 0; j < net.dual->n_parts(b); ++j)
      if (convex_overlap(part(a, i), part(b, j), depth)) return true;
  return false;
}

TEST(FindOverlaps, EqualsBruteForceOverTheZoo) {
  for (const auto& shape : testing::zoo()) {
    const auto dual = testing::make_dual(shape.soup);
    Random random(9);
    const Net net = layout(dual, steepest_edge_tree(*dual, random));
    std::vector<Overlap> expected;
    for (const FaceId a : net.mesh().faces())
      for (const FaceId b : net.mesh().faces())
        if (a < b && net.piece[a] == net.piece[b] &&
            brute_force_pair(net, a, b, kSolveDepth * net.mesh().mean_edge()))
          expected.push_back({a, b});
    EXPECT_EQ(find_overlaps(net, kSolveDepth), expected) << shape.soup.name;
  }
}

TEST(FindOverlaps, AFlatPatchNeverOverlapsItself) {
  const auto dual = testing::make_dual(shapes::grid_patch(9, 7));
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    EXPECT_TRUE(find_overlaps(layout(dual, steepest_edge_tree(*dual, random)), kSolveDepth).empty());
  }
}

}  // namespace
}  // namespace netwright
