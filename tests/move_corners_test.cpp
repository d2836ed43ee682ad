// Corners moved by hand or by rule: what becomes of the faces around them.
#include "core/mesh/move_corners.h"

#include <gtest/gtest.h>

#include "core/mesh/dual_graph.h"
#include "tests/support.h"

namespace netwright {
namespace {

using testing::make_mesh;

glm::dvec3 first_corner(const Mesh& mesh) { return mesh.position(mesh.first(FaceId(0))); }

TEST(MoveCorners, SplitsTheFacesThatAreNotFlatAnyMore) {
  const auto cube = make_mesh(shapes::cube());
  const glm::dvec3 from = first_corner(*cube);
  const MovedMesh moved = move_corners(*cube, {{from, from + glm::dvec3(0.1, 0.2, 0.15)}});
  ASSERT_TRUE(moved.mesh);
  EXPECT_EQ(moved.mesh->n_faces(), 9U);
  EXPECT_TRUE(moved.mesh->is_closed());
  EXPECT_NO_THROW(DualGraph{moved.mesh});
  for (const FaceId f : cube->faces())
    EXPECT_EQ(moved.mesh->face_source(FaceId(moved.heirs[f.index()])), cube->face_source(f));
}

TEST(MoveCorners, LeavesAllElseWhereItIs) {
  const auto ball = make_mesh(shapes::icosphere(2));
  const glm::dvec3 from = first_corner(*ball);
  const MovedMesh moved = move_corners(*ball, {{from, from * 1.2}});
  ASSERT_TRUE(moved.mesh);
  ASSERT_EQ(moved.mesh->n_faces(), ball->n_faces());
  int n_moved = 0;
  for (const HalfedgeId h : ball->halfedges())
    n_moved += ball->position(h) != moved.mesh->position(h) ? 1 : 0;
  int n_there = 0;
  for (const HalfedgeId h : ball->halfedges()) n_there += ball->position(h) == from ? 1 : 0;
  EXPECT_EQ(n_moved, n_there);
}

TEST(MoveCorners, MakesOneOfCornersThatGoToOnePlace) {
  const auto ball = make_mesh(shapes::icosphere(2));
  const HalfedgeId h = ball->first(FaceId(3));
  const glm::dvec3 a = ball->position(h);
  const glm::dvec3 b = ball->position(ball->next(h));
  const MovedMesh moved = move_corners(*ball, {{a, (a + b) / 2.0}, {b, (a + b) / 2.0}});
  ASSERT_TRUE(moved.mesh);
  EXPECT_EQ(moved.mesh->n_faces(), ball->n_faces() - 2);
  EXPECT_EQ(moved.mesh->n_vertices(), ball->n_vertices() - 1);
  EXPECT_TRUE(moved.mesh->is_closed());
  EXPECT_GE(moved.heirs[3], 0) << "a neighbour takes over";
}

TEST(MoveCorners, DoesNothingWhereACornerIsNotFound) {
  const auto cube = make_mesh(shapes::cube());
  EXPECT_FALSE(move_corners(*cube, {{{7, 8, 9}, {0, 0, 0}}}).mesh);
}

}  // namespace
}  // namespace netwright
