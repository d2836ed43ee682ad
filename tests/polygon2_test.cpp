// Simple polygons: area, convexity, crossings, triangles, convex parts.
#include "core/base/polygon2.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"

namespace netwright {
namespace {

using Polygon = std::vector<glm::dvec2>;

const Polygon kSquare = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
const Polygon kLetterL = {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
const Polygon kWithCollinearCorners = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {0, 2}};
const Polygon kBowTie = {{0, 0}, {2, 2}, {2, 0}, {0, 2}};

// A star-shaped polygon around the origin: simple by construction, usually concave.
Polygon random_polygon(Random& random, int n) {
  Polygon p;
  for (int i = 0; i < n; ++i) {
    const double angle = 6.283185307179586 * (i + 0.8 * random.unit()) / n;
    const double r = 0.2 + random.unit();
    p.emplace_back(r * std::cos(angle), r * std::sin(angle));
  }
  return p;
}

double area_of(const Polygon& p, const std::vector<int>& corners) {
  Polygon part;
  for (const int c : corners) part.push_back(p[static_cast<std::size_t>(c)]);
  return signed_area(part);
}

TEST(Polygon2, KnowsAreaConvexityAndCrossings) {
  EXPECT_DOUBLE_EQ(signed_area(kSquare), 4);
  EXPECT_DOUBLE_EQ(signed_area(Polygon(kSquare.rbegin(), kSquare.rend())), -4);
  EXPECT_TRUE(is_convex(kSquare));
  EXPECT_TRUE(is_convex(kWithCollinearCorners));
  EXPECT_FALSE(is_convex(kLetterL));
  EXPECT_FALSE(is_convex(kBowTie));
  EXPECT_TRUE(is_simple(kLetterL));
  EXPECT_FALSE(is_simple(kBowTie));
}

TEST(Polygon2, DoesNotTakeADoublyWoundPolygonForConvex) {
  Polygon pentagram;
  for (int i = 0; i < 5; ++i) pentagram.emplace_back(std::cos(i * 4 * M_PI / 5), std::sin(i * 4 * M_PI / 5));
  EXPECT_FALSE(is_convex(pentagram));
  EXPECT_FALSE(is_simple(pentagram));
}

TEST(Polygon2, RefusesASpikeThatRunsBackOnItself) {
  EXPECT_FALSE(is_simple(Polygon{{0, 0}, {2, 0}, {2, 2}, {2, 1}, {0, 1}}));
}

TEST(Polygon2, ContainsItsInsideOnly) {
  EXPECT_TRUE(contains(kLetterL, {0.5, 2.5}));
  EXPECT_FALSE(contains(kLetterL, {2, 2}));
}

TEST(Polygon2, TrianglesAndConvexPartsCoverThePolygon) {
  Random random(11);
  for (int k = 0; k < 300; ++k) {
    const Polygon p = random_polygon(random, 4 + random.below(14));
    ASSERT_TRUE(is_simple(p));
    double triangles = 0;
    for (const auto& t : triangulate(p)) {
      const double area = area_of(p, {t[0], t[1], t[2]});
      EXPECT_GE(area, 0);
      triangles += area;
    }
    EXPECT_NEAR(triangles, signed_area(p), 1e-12);
    double parts = 0;
    for (const auto& part : convex_parts(p)) {
      Polygon corners;
      for (const int c : part) corners.push_back(p[static_cast<std::size_t>(c)]);
      EXPECT_TRUE(is_convex(corners));
      parts += signed_area(corners);
    }
    EXPECT_NEAR(parts, signed_area(p), 1e-12);
  }
}

TEST(Polygon2, LeavesAConvexPolygonWhole) {
  EXPECT_EQ(convex_parts(kSquare).size(), 1U);
  EXPECT_EQ(convex_parts(kWithCollinearCorners).size(), 1U);
  EXPECT_EQ(convex_parts(kLetterL).size(), 2U);
}

}  // namespace
}  // namespace netwright
