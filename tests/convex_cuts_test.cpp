// Cutting polygons with inward corners: the parts cover the polygon, and no inward corner is left.
#include "core/mesh/convex_cuts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "core/base/polygon2.h"
#include "core/base/random.h"

namespace netwright {
namespace {

std::vector<glm::dvec2> part_of(const std::vector<glm::dvec2>& polygon, const std::vector<int>& ring) {
  std::vector<glm::dvec2> part;
  for (const int i : ring) part.push_back(polygon[static_cast<std::size_t>(i)]);
  return part;
}

/// Sides of the polygon come once, diagonals once in each direction, and the areas add up.
void expect_cover(const std::vector<glm::dvec2>& polygon, const std::vector<std::vector<int>>& parts) {
  std::map<std::pair<int, int>, int> sides;
  double area = 0;
  for (const auto& ring : parts) {
    const std::vector<glm::dvec2> part = part_of(polygon, ring);
    EXPECT_TRUE(is_simple(part));
    EXPECT_GT(signed_area(part), 0);
    area += signed_area(part);
    for (std::size_t i = 0; i < ring.size(); ++i) ++sides[{ring[i], ring[(i + 1) % ring.size()]}];
  }
  EXPECT_NEAR(area, signed_area(polygon), 1e-9 * signed_area(polygon));
  const int n = static_cast<int>(polygon.size());
  for (const auto& [side, count] : sides) {
    EXPECT_EQ(count, 1);
    if (side.second == (side.first + 1) % n) continue;
    EXPECT_EQ(sides.count({side.second, side.first}), 1U);
  }
  for (int i = 0; i < n; ++i) EXPECT_EQ(sides.count({i, (i + 1) % n}), 1U);
}

TEST(ConvexCuts, LeavesAConvexPolygonWhole) {
  const std::vector<glm::dvec2> square{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}};
  EXPECT_TRUE(is_open(square));
  ASSERT_EQ(convex_cuts(square).size(), 1U);
  EXPECT_EQ(convex_cuts(square)[0], (std::vector<int>{0, 1, 2, 3, 4}));
}

TEST(ConvexCuts, CutsAnLOnceAndAUTwice) {
  const std::vector<glm::dvec2> l{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  EXPECT_FALSE(is_open(l));
  EXPECT_EQ(convex_cuts(l).size(), 2U);
  expect_cover(l, convex_cuts(l));
  const std::vector<glm::dvec2> u{{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};
  EXPECT_EQ(convex_cuts(u).size(), 3U);
  expect_cover(u, convex_cuts(u));
}

TEST(ConvexCuts, CountsCornersThatRoundingBendsInwardAsStraight) {
  const std::vector<glm::dvec2> nearly{{0, 0}, {1, 1e-9}, {2, 0}, {2, 2}, {0, 2}};
  EXPECT_FALSE(is_convex(nearly));
  EXPECT_TRUE(is_open(nearly));
  EXPECT_EQ(convex_cuts(nearly).size(), 1U);
}

TEST(ConvexCuts, OpensRandomStarShapedPolygons) {
  Random random(5);
  for (int n = 5; n < 60; ++n) {
    std::vector<glm::dvec2> star;
    for (int i = 0; i < n; ++i) {
      const double angle = 6.283185307179586 * i / n;
      star.push_back((0.3 + random.unit()) * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    SCOPED_TRACE(n);
    const auto parts = convex_cuts(star);
    expect_cover(star, parts);
    int n_inward = 0;
    for (std::size_t i = 0; i < star.size(); ++i) {
      const auto at = [&](std::size_t k) { return star[(i + k) % star.size()]; };
      if ((at(1).x - at(0).x) * (at(2).y - at(1).y) - (at(1).y - at(0).y) * (at(2).x - at(1).x) < 0)
        ++n_inward;
    }
    EXPECT_LE(static_cast<int>(parts.size()), 2 * n_inward + 1);
    int n_closed = 0;
    for (const auto& ring : parts) n_closed += is_open(part_of(star, ring)) ? 0 : 1;
    EXPECT_EQ(n_closed, 0);
  }
}

}  // namespace
}  // namespace netwright
