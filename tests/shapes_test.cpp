// The shapes made by rule: closed where they say so, oriented outward, with the textbook's counts of corners
// and faces.
#include "core/mesh/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "tests/support.h"

namespace netwright {
namespace {

using testing::zoo;
using testing::ZooShape;

struct Counts {
  int points = 0;
  int edges = 0;
  int faces = 0;
  int border_edges = 0;
  bool has_doubled_side = false;
};

Counts count(const PolygonSoup& soup) {
  std::set<std::pair<int, int>> sides;
  Counts counts;
  for (int f = 0; f < soup.n_faces(); ++f) {
    const auto face = soup.face(f);
    for (std::size_t i = 0; i < face.size(); ++i) {
      counts.has_doubled_side |= !sides.emplace(face[i], face[(i + 1) % face.size()]).second;
    }
  }
  for (const auto& [from, to] : sides) {
    const bool has_twin = sides.contains({to, from});
    if (!has_twin) ++counts.border_edges;
    if (!has_twin || from < to) ++counts.edges;
  }
  counts.points = static_cast<int>(soup.points.size());
  counts.faces = soup.n_faces();
  return counts;
}

double volume(const PolygonSoup& soup) {
  double six_volumes = 0;
  const auto at = [&](int i) { return soup.points[static_cast<std::size_t>(i)]; };
  for (int f = 0; f < soup.n_faces(); ++f) {
    const auto face = soup.face(f);
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
      six_volumes += glm::dot(at(face[0]), glm::cross(at(face[i]), at(face[i + 1])));
    }
  }
  return six_volumes / 6;
}

/// How many faces have how many corners, for instance {{3, 8}, {4, 6}}.
std::map<int, int> face_kinds(const PolygonSoup& soup) {
  std::map<int, int> kinds;
  for (int f = 0; f < soup.n_faces(); ++f) ++kinds[static_cast<int>(soup.face(f).size())];
  return kinds;
}

TEST(Shapes, RunTheSameWayOverEveryEdge) {
  for (const ZooShape& shape : zoo()) EXPECT_FALSE(count(shape.soup).has_doubled_side) << shape.soup.name;
}

TEST(Shapes, AreClosedOrOpenAsTheySay) {
  for (const ZooShape& shape : zoo()) {
    EXPECT_EQ(count(shape.soup).border_edges == 0, shape.is_closed) << shape.soup.name;
  }
}

TEST(Shapes, HaveTheGenusTheySay) {
  for (const ZooShape& shape : zoo()) {
    if (!shape.is_closed) continue;
    const Counts counts = count(shape.soup);
    EXPECT_EQ(counts.points - counts.edges + counts.faces, 2 * shape.n_components - 2 * shape.genus)
        << shape.soup.name;
  }
}

TEST(Shapes, FaceOutward) {
  for (const ZooShape& shape : zoo()) {
    EXPECT_TRUE(!shape.is_closed || volume(shape.soup) > 0) << shape.soup.name;
  }
}

TEST(Shapes, HaveExactVolumesWhereTheyAreKnown) {
  EXPECT_DOUBLE_EQ(volume(shapes::cube(2)), 8);
  EXPECT_DOUBLE_EQ(volume(shapes::cuboid({1, 2, 3})), 6);
  EXPECT_NEAR(volume(shapes::grid_cube(4)), 1, 1e-12);
  EXPECT_NEAR(volume(shapes::letter_l()), 6, 1e-12);
  EXPECT_NEAR(volume(shapes::cuboid_with_holes(1, 1, 2)), 16, 1e-12);
}

TEST(Shapes, AreTheThirteenArchimedeanSolids) {
  const std::map<std::string, std::map<int, int>> expected{
      {"truncated tetrahedron", {{3, 4}, {6, 4}}},
      {"cuboctahedron", {{3, 8}, {4, 6}}},
      {"truncated cube", {{3, 8}, {8, 6}}},
      {"truncated octahedron", {{4, 6}, {6, 8}}},
      {"rhombicuboctahedron", {{3, 8}, {4, 18}}},
      {"truncated cuboctahedron", {{4, 12}, {6, 8}, {8, 6}}},
      {"snub cube", {{3, 32}, {4, 6}}},
      {"icosidodecahedron", {{3, 20}, {5, 12}}},
      {"truncated dodecahedron", {{3, 20}, {10, 12}}},
      {"truncated icosahedron", {{5, 12}, {6, 20}}},
      {"rhombicosidodecahedron", {{3, 20}, {4, 30}, {5, 12}}},
      {"truncated icosidodecahedron", {{4, 30}, {6, 20}, {10, 12}}},
      {"snub dodecahedron", {{3, 80}, {5, 12}}},
  };
  std::map<std::string, std::map<int, int>> made;
  for (const PolygonSoup& solid : shapes::archimedean_solids()) made[solid.name] = face_kinds(solid);
  EXPECT_EQ(made, expected);
}

TEST(Shapes, HaveEdgesOfOneLengthWhenRegular) {
  std::vector<PolygonSoup> solids = shapes::platonic_solids();
  for (PolygonSoup& solid : shapes::archimedean_solids()) solids.push_back(std::move(solid));
  for (const PolygonSoup& solid : solids) {
    double shortest = 1e300;
    double longest = 0;
    for (int f = 0; f < solid.n_faces(); ++f) {
      const auto face = solid.face(f);
      for (std::size_t i = 0; i < face.size(); ++i) {
        const auto from = static_cast<std::size_t>(face[i]);
        const auto to = static_cast<std::size_t>(face[(i + 1) % face.size()]);
        const double length = glm::length(solid.points[to] - solid.points[from]);
        shortest = std::min(shortest, length);
        longest = std::max(longest, length);
      }
    }
    EXPECT_NEAR(shortest / longest, 1, 1e-9) << solid.name;
  }
}

TEST(Shapes, CountAnIcospheresFaces) {
  for (const int n : {1, 2, 3, 5}) {
    const Counts counts = count(shapes::icosphere(n));
    EXPECT_EQ(counts.faces, 20 * n * n);
    EXPECT_EQ(counts.points, 10 * n * n + 2);
  }
}

TEST(Shapes, GiveEveryGlobeCornerItsPlaceOnTheMap) {
  const PolygonSoup globe = shapes::globe();
  ASSERT_EQ(globe.corner_uv.size(), globe.corners.size());
  for (const glm::dvec2 uv : globe.corner_uv) {
    EXPECT_GE(std::min(uv.x, uv.y), 0);
    EXPECT_LE(std::max(uv.x, uv.y), 1);
  }
}

TEST(Shapes, KeepBothPartsWhenCombined) {
  const PolygonSoup both = shapes::combined(shapes::cube(), shapes::tetrahedron(), {3, 0, 0});
  EXPECT_EQ(both.n_faces(), 10);
  EXPECT_EQ(both.points.size(), 12U);
}

}  // namespace
}  // namespace netwright
