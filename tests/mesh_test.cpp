// The laws of Mesh over the zoo: connectivity closes on itself, measures are right, and what is no oriented
// manifold is refused.
#include "core/mesh/mesh.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/support.h"

namespace netwright {
namespace {

using testing::make_mesh;
using testing::zoo;
using testing::ZooShape;

std::string refusal(const PolygonSoup& soup) {
  try {
    const Mesh mesh(soup);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Unfit);
    return error.what();
  }
  return "accepted";
}

TEST(Mesh, WalksAroundEveryFace) {
  for (const ZooShape& shape : zoo()) {
    const auto mesh = make_mesh(shape.soup);
    for (const FaceId f : mesh->faces()) {
      HalfedgeId h = mesh->first(f);
      for (int i = 0; i < mesh->degree(f); ++i) {
        EXPECT_EQ(mesh->face(h), f);
        EXPECT_EQ(mesh->prev(mesh->next(h)), h);
        EXPECT_EQ(mesh->to(h), mesh->from(mesh->next(h)));
        h = mesh->next(h);
      }
      EXPECT_EQ(h, mesh->first(f));
    }
  }
}

TEST(Mesh, PairsTheTwoSidesOfEveryEdge) {
  for (const ZooShape& shape : zoo()) {
    const auto mesh = make_mesh(shape.soup);
    std::size_t n_borders = 0;
    for (const HalfedgeId h : mesh->halfedges()) {
      const HalfedgeId twin = mesh->twin(h);
      if (!twin.is_valid()) {
        ++n_borders;
        EXPECT_TRUE(mesh->is_border(mesh->edge(h)));
        continue;
      }
      EXPECT_EQ(mesh->twin(twin), h);
      EXPECT_EQ(mesh->from(twin), mesh->to(h));
      EXPECT_EQ(mesh->edge(twin), mesh->edge(h));
      EXPECT_EQ(mesh->neighbour(h), mesh->face(twin));
    }
    EXPECT_EQ(n_borders, mesh->n_border_edges()) << shape.soup.name;
    EXPECT_EQ(2 * mesh->n_edges(), mesh->n_halfedges() + n_borders) << shape.soup.name;
  }
}

TEST(Mesh, KnowsWhatTheZooSays) {
  for (const ZooShape& shape : zoo()) {
    const auto mesh = make_mesh(shape.soup);
    EXPECT_EQ(mesh->is_closed(), shape.is_closed) << shape.soup.name;
    EXPECT_EQ(mesh->genus(), shape.genus) << shape.soup.name;
    EXPECT_EQ(static_cast<int>(mesh->n_components()), shape.n_components) << shape.soup.name;
  }
}

TEST(Mesh, SumsNormalsTimesAreasOfClosedShapesToNothing) {
  for (const ZooShape& shape : zoo()) {
    if (!shape.is_closed) continue;
    const auto mesh = make_mesh(shape.soup);
    glm::dvec3 sum(0);
    double area = 0;
    for (const FaceId f : mesh->faces()) {
      sum += mesh->area(f) * mesh->normal(f);
      area += mesh->area(f);
    }
    EXPECT_LT(glm::length(sum), 1e-12 * area) << shape.soup.name;
  }
}

TEST(Mesh, HasFlatFacesWhereTheZooHas) {
  for (const ZooShape& shape : zoo()) {
    const auto mesh = make_mesh(shape.soup);
    for (const FaceId f : mesh->faces()) EXPECT_LT(mesh->unevenness(f), 1e-12) << shape.soup.name;
  }
}

TEST(Mesh, MeasuresACube) {
  const auto mesh = make_mesh(shapes::cube(2));
  EXPECT_DOUBLE_EQ(mesh->mean_edge(), 2);
  EXPECT_DOUBLE_EQ(mesh->height(), 2);
  for (const FaceId f : mesh->faces()) {
    EXPECT_DOUBLE_EQ(mesh->area(f), 4);
    EXPECT_DOUBLE_EQ(mesh->size(f), std::sqrt(8));
  }
}

TEST(Mesh, DropsPointsThatNoFaceUses) {
  PolygonSoup soup = shapes::cube();
  soup.points.insert(soup.points.begin(), glm::dvec3(1000));
  for (int& corner : soup.corners) ++corner;
  const auto mesh = make_mesh(soup);
  EXPECT_EQ(mesh->n_vertices(), 8U);
  EXPECT_DOUBLE_EQ(mesh->box().size().x, 1);
}

TEST(Mesh, RefusesNeighboursThatRunTheSameWay) {
  PolygonSoup soup = shapes::tetrahedron();
  std::swap(soup.corners[0], soup.corners[1]);
  EXPECT_NE(refusal(soup).find("run the same way"), std::string::npos);
}

TEST(Mesh, RefusesAnEdgeOfThreeFaces) {
  PolygonSoup soup = shapes::tetrahedron();
  soup.points.emplace_back(3, 3, 3);
  soup.add_face(std::vector<int>{soup.corners[0], soup.corners[1], 4});
  EXPECT_NE(refusal(soup).find("has 3 faces"), std::string::npos);
}

TEST(Mesh, RefusesPartsThatTouchInAPoint) {
  PolygonSoup soup = shapes::combined(shapes::cube(), shapes::cube(), {1, 1, 1});
  const auto shared = static_cast<std::size_t>(
      std::find(soup.points.begin(), soup.points.begin() + 8, glm::dvec3(0.5, 1, 0.5)) - soup.points.begin());
  const auto doubled = static_cast<int>(
      std::find(soup.points.begin() + 8, soup.points.end(), glm::dvec3(0.5, 1, 0.5)) - soup.points.begin());
  ASSERT_LT(shared, 8U);
  ASSERT_LT(doubled, 16);
  std::replace(soup.corners.begin(), soup.corners.end(), doubled, static_cast<int>(shared));
  EXPECT_NE(refusal(soup).find("touch in a single point"), std::string::npos);
}

TEST(Mesh, RefusesFacesThatAreNone) {
  PolygonSoup two = shapes::cube();
  two.add_face(std::vector<int>{0, 1});
  EXPECT_NE(refusal(two).find("face 7 has fewer than three corners"), std::string::npos);
  PolygonSoup repeated = shapes::cube();
  repeated.add_face(std::vector<int>{0, 1, 0});
  EXPECT_NE(refusal(repeated).find("face 7 uses point 1 twice"), std::string::npos);
  PolygonSoup line;
  line.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  line.add_face(std::vector<int>{0, 1, 2});
  EXPECT_NE(refusal(line).find("face 1 has no area"), std::string::npos);
  EXPECT_NE(refusal(PolygonSoup{}).find("no face"), std::string::npos);
}

}  // namespace
}  // namespace netwright
