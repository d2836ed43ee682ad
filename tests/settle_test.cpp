// Contacts in stored nets: corners that touch come to one place or a hair apart, and nothing else moves.
#include "core/unfold/settle.h"

#include <gtest/gtest.h>

#include "core/base/geometry.h"
#include "core/base/predicates.h"
#include "core/unfold/verify.h"

namespace netwright {
namespace {

// Two unit triangles; the second one's corner 3 lies where the test puts it.
FlatNet two_triangles(glm::dvec2 corner) {
  FlatNet net;
  net.points = {{0, 0}, {1, 0}, {0, 1}, corner, corner + glm::dvec2(1, 0.5), corner + glm::dvec2(0.2, 1)};
  net.faces = {{0, 1, 2}, {3, 4, 5}};
  for (int face = 0; face < 2; ++face)
    for (int i = 0; i < 3; ++i) net.edges.push_back({3 * face + i, 3 * face + (i + 1) % 3});
  return net;
}

TEST(Settle, CornersThatDifferByRoundingBecomeOnePlace) {
  FlatNet net = two_triangles({1 + 1e-14, -3e-15});
  settle(net, 1);
  EXPECT_EQ(net.points[3], net.points[1]);
}

TEST(Settle, ACornerOnTheMiddleOfAForeignEdgeEndsJustOutside) {
  for (const double inside : {-1e-14, 0.0, 1e-14, 2e-11}) {
    FlatNet net = two_triangles(glm::dvec2(0.5, 0.5) - glm::dvec2(inside));
    settle(net, 1);
    const double outside =
        -cross(net.points[2] - net.points[1], net.points[3] - net.points[1]) / std::sqrt(2.0);
    EXPECT_GT(outside, 0.2 * kSameCorner) << inside;
    EXPECT_LT(outside, kSameCorner) << inside;
  }
}

TEST(Settle, LeavesEverythingElseWhereItIs) {
  const FlatNet before = two_triangles({0.6, 0.5});
  FlatNet after = before;
  settle(after, 1);
  for (std::size_t i = 0; i < before.points.size(); ++i)
    EXPECT_LT(glm::distance(after.points[i], before.points[i]), 1e-14);
}

TEST(Settle, DoesNotHideARealOverlap) {
  FlatNet net = two_triangles({0.5 - 1e-8, 0.5 - 1e-8});
  settle(net, 1);
  EXPECT_GT(cross(net.points[2] - net.points[1], net.points[3] - net.points[1]), 1e-9);
}

TEST(Settle, KeepsDifferencesOfCoordinatesExact) {
  FlatNet net = two_triangles({1.0 / 3, 200.1});
  settle(net, 1);
  for (const glm::dvec2 p : net.points)
    for (const glm::dvec2 q : net.points) EXPECT_EQ(p + (q - p), q);
}

}  // namespace
}  // namespace netwright
