// Uneven faces split into triangles: which ones, along which diagonals, and that the result is a mesh again
// with everything the faces carried.
#include "core/mesh/split_faces.h"

#include <gtest/gtest.h>

#include <array>
#include <glm/geometric.hpp>

#include "core/base/predicates.h"
#include "tests/support.h"

namespace netwright {
namespace {

using testing::make_mesh;
using testing::zoo;
using testing::ZooShape;

PolygonSoup cube_with_a_lifted_corner() {
  PolygonSoup soup = shapes::cube();
  soup.points[6] += glm::dvec3(0.1, 0.05, 0.2);
  return soup;
}

Mesh mesh_of(const SplitFaces& split) { return Mesh(split.soup, split.is_flipped, split.face_source); }

void expect_flat(const Mesh& mesh) {
  for (const FaceId f : mesh.faces()) EXPECT_LE(mesh.unevenness(f), 0.1 * kFlatness) << mesh.name();
}

TEST(SplitUnevenFaces, LeavesFlatFacesAsTheyAre) {
  for (const ZooShape& shape : zoo()) {
    const auto mesh = make_mesh(shape.soup);
    const SplitFaces split = split_uneven_faces(*mesh);
    std::vector<int> corners;
    for (const HalfedgeId h : mesh->halfedges()) corners.push_back(mesh->from(h).value);
    EXPECT_EQ(split.n_split, 0) << shape.soup.name;
    EXPECT_EQ(split.soup.face_begin, shape.soup.face_begin) << shape.soup.name;
    EXPECT_EQ(split.soup.corners, corners) << shape.soup.name;
  }
}

TEST(SplitUnevenFaces, SplitsOnlyThoseThatAreUneven) {
  const auto mesh = make_mesh(cube_with_a_lifted_corner());
  const SplitFaces split = split_uneven_faces(*mesh);
  EXPECT_EQ(split.n_split, 3);
  EXPECT_EQ(split.soup.n_faces(), 9);
  EXPECT_EQ(split.soup.points.size(), 8U);
  const Mesh result = mesh_of(split);
  EXPECT_TRUE(result.is_closed());
  expect_flat(result);
}

TEST(SplitUnevenFaces, TellsWhichFaceEachPartCameFrom) {
  const auto mesh = make_mesh(cube_with_a_lifted_corner());
  const SplitFaces split = split_uneven_faces(*mesh);
  std::vector<FaceId> expected;
  for (const FaceId f : mesh->faces()) {
    expected.insert(expected.end(), mesh->unevenness(f) > kFlatness ? 2 : 1, f);
  }
  EXPECT_EQ(split.split_from, expected);
  const Mesh turned(testing::inside_out(cube_with_a_lifted_corner()), std::vector<bool>(6, true));
  EXPECT_EQ(split_uneven_faces(turned).is_flipped, std::vector<bool>(9, true));
}

TEST(SplitUnevenFaces, CountsFacesAnewSoThatEachIsThereOnce) {
  const Mesh result = mesh_of(split_uneven_faces(*make_mesh(cube_with_a_lifted_corner())));
  for (const FaceId f : result.faces()) EXPECT_EQ(result.face_source(f), f.value);
}

TEST(SplitUnevenFaces, CarriesUvAndMaterials) {
  PolygonSoup soup = cube_with_a_lifted_corner();
  soup.materials = {{"paper", {}, nullptr}, {"card", {}, nullptr}};
  for (int f = 0; f < soup.n_faces(); ++f) soup.face_material.push_back(f % 2);
  for (const int corner : soup.corners) {
    const glm::dvec3& point = soup.points[static_cast<std::size_t>(corner)];
    soup.corner_uv.emplace_back(point.x + 2 * point.z, point.y);
  }
  const SplitFaces split = split_uneven_faces(*make_mesh(soup));
  ASSERT_EQ(split.soup.corner_uv.size(), split.soup.corners.size());
  for (std::size_t i = 0; i < split.soup.corners.size(); ++i) {
    const glm::dvec3& point = split.soup.points[static_cast<std::size_t>(split.soup.corners[i])];
    EXPECT_EQ(split.soup.corner_uv[i], glm::dvec2(point.x + 2 * point.z, point.y));
  }
  ASSERT_EQ(split.soup.face_material.size(), static_cast<std::size_t>(split.soup.n_faces()));
  for (std::size_t f = 0; f < split.soup.face_material.size(); ++f) {
    EXPECT_EQ(split.soup.face_material[f], split.split_from[f].value % 2);
  }
  EXPECT_EQ(split.soup.materials[1].name, "card");
}

/// One quad over four points, whose first corner is the odd one out.
SplitFaces split_quad(const std::array<glm::dvec3, 4>& corners) {
  PolygonSoup soup;
  soup.points.assign(corners.begin(), corners.end());
  soup.add_face(std::vector<int>{0, 1, 2, 3});
  return split_uneven_faces(*make_mesh(soup));
}

bool has_side(const SplitFaces& split, int a, int b) {
  const auto face = split.soup.face(0);
  for (std::size_t i = 0; i < 3; ++i) {
    const int from = face[i];
    const int to = face[(i + 1) % 3];
    if ((from == a && to == b) || (from == b && to == a)) return true;
  }
  return false;
}

TEST(SplitUnevenFaces, TakesTheDiagonalThatBendsLess) {
  // Two corners of a long rhombus are lifted: along its short diagonal the halves are long and bend little.
  const SplitFaces along = split_quad({{{0, 0.5, 0}, {-1, 0, 3}, {0, 0.5, 6}, {1, 0, 3}}});
  EXPECT_TRUE(has_side(along, 1, 3));
  const SplitFaces across = split_quad({{{-1, 0, 3}, {0, 0.5, 6}, {1, 0, 3}, {0, 0.5, 0}}});
  EXPECT_TRUE(has_side(across, 0, 2));
}

TEST(SplitUnevenFaces, CutsConcaveFacesWithin) {
  // A dart: corner 2 points inward, so only 0-2 lies within.
  const SplitFaces split = split_quad({{{0, 0.3, -2}, {-1, 0, 1}, {0, 0, 0}, {1, 0, 1}}});
  ASSERT_EQ(split.soup.n_faces(), 2);
  EXPECT_TRUE(has_side(split, 0, 2));
}

TEST(SplitUnevenFaces, GivesNeighboursOverTheSameCornersDifferentDiagonals) {
  PolygonSoup pillow;
  pillow.points = {{0, 0, 0}, {1, 0, 1}, {1, 1, 0}, {0, 1, 1}};
  pillow.add_face(std::vector<int>{0, 1, 2, 3});
  pillow.add_face(std::vector<int>{3, 2, 1, 0});
  const Mesh result = mesh_of(split_uneven_faces(*make_mesh(pillow)));
  EXPECT_EQ(result.n_faces(), 4U);
  EXPECT_EQ(result.n_edges(), 6U);
}

/// The torus of seven points, where every pair is joined already, with three triangles made one pentagon and
/// corners thrown at random.
PolygonSoup crowded_torus(std::uint64_t seed) {
  PolygonSoup soup;
  Random random(seed);
  for (int i = 0; i < 7; ++i) soup.points.emplace_back(random.unit(), random.unit(), random.unit());
  for (int i = 0; i < 7; ++i) {
    const int b = (i + 1) % 7;
    const int c = (i + 3) % 7;
    const int d = (i + 2) % 7;
    // Point 0 with 1, 3, 2 and then 6: (0 1 3), (0 3 2) and (6 0 2) go into the pentagon 0 1 3 2 6.
    if (i != 0 && i != 6) soup.add_face(std::vector<int>{i, b, c});
    if (i != 0) soup.add_face(std::vector<int>{i, c, d});
  }
  soup.add_face(std::vector<int>{0, 1, 3, 2, 6});
  return soup;
}

TEST(SplitUnevenFaces, PutsAPointInTheMiddleWhereEveryDiagonalIsTaken) {
  int n_centres = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const auto mesh = make_mesh(crowded_torus(seed));
    const SplitFaces split = split_uneven_faces(*mesh);
    ASSERT_EQ(split.n_split, 1);
    const Mesh result = mesh_of(split);
    EXPECT_EQ(result.genus(), 1);
    expect_flat(result);
    if (split.soup.points.size() > 7) ++n_centres;
  }
  EXPECT_GT(n_centres, 0);
}

}  // namespace
}  // namespace netwright
