// Folding a net up in space, over the zoo: paper stays paper at every moment, and it ends on the model.
#include "core/unfold/fold_pose.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/unfold/steepest_edge.h"
#include "tests/support.h"

namespace netwright::testing {
namespace {

Net steepest_net(const PolygonSoup& soup) {
  const auto dual = make_dual(soup);
  Random random(3);
  return layout(dual, steepest_edge_tree(*dual, random));
}

using Corners = IdVector<HalfedgeId, glm::dvec3>;

glm::dvec3 normal_of(const Mesh& mesh, const Corners& at, FaceId f) {
  glm::dvec3 sum(0);
  const glm::dvec3 origin = at[mesh.first(f)];
  for (const HalfedgeId h : mesh.halfedges(f)) sum += glm::cross(at[h] - origin, at[mesh.next(h)] - origin);
  return glm::normalize(sum);
}

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

TEST(FoldPose, EndsOnTheModel) {
  for (const auto& shape : zoo()) {
    const Net net = steepest_net(shape.soup);
    const Corners at = FoldPath(net).corners(1);
    for (const HalfedgeId h : net.mesh().halfedges()) {
      ASSERT_LT(glm::distance(at[h], net.mesh().position(h)), 1e-9 * net.mesh().box().diagonal())
          << shape.soup.name << ", corner " << h.value;
    }
  }
}

TEST(FoldPose, EndsOnTheModelAfterThousandsOfFolds) {
  const Net net = steepest_net(shapes::bumpy_patch(78, 78));
  const Corners at = FoldPath(net).corners(1);
  for (const HalfedgeId h : net.mesh().halfedges())
    ASSERT_LT(glm::distance(at[h], net.mesh().position(h)), 1e-9 * net.mesh().box().diagonal());
}

TEST(FoldPose, EndsOnTheModelAlthoughItsFacesAreNotQuiteEven) {
  PolygonSoup cube = shapes::grid_cube(6);
  Random random(5);
  for (glm::dvec3& p : cube.points) p += 1e-5 * glm::dvec3(random.unit(), random.unit(), random.unit());
  const Net net = steepest_net(cube);
  double most_uneven = 0;
  for (const FaceId f : net.mesh().faces()) most_uneven = std::max(most_uneven, net.mesh().unevenness(f));
  ASSERT_GT(most_uneven, 1e-6) << "else this test is about nothing";
  const FoldPath path(net);
  const Corners at = path.corners(1);
  for (const HalfedgeId h : net.mesh().halfedges())
    ASSERT_LT(glm::distance(at[h], net.mesh().position(h)), 1e-9 * net.mesh().box().diagonal());
  const Corners flat = path.corners(0);
  const glm::dvec3 up = normal_of(net.mesh(), flat, FaceId(0));
  for (const HalfedgeId h : net.mesh().halfedges())
    ASSERT_LT(std::abs(glm::dot(up, flat[h] - flat[HalfedgeId(0)])), 1e-9 * net.mesh().box().diagonal());
}

TEST(FoldPose, BeginsAsTheFlatNet) {
  for (const auto& shape : zoo()) {
    const Net net = steepest_net(shape.soup);
    const Mesh& mesh = net.mesh();
    const Corners at = FoldPath(net).corners(0);
    const glm::dvec3 up = normal_of(mesh, at, FaceId(0));
    const double slack = 1e-9 * net.box().diagonal();
    const HalfedgeId origin(0);
    // A far corner tells whether the whole lies as in the plane, not only face by face.
    const HalfedgeId other(mesh.n_halfedges() / 2);
    for (const HalfedgeId h : mesh.halfedges()) {
      ASSERT_NEAR(glm::dot(up, at[h] - at[origin]), 0, slack) << shape.soup.name;
      ASSERT_NEAR(glm::distance(at[h], at[origin]), glm::distance(net.corner(h), net.corner(origin)), slack);
      ASSERT_NEAR(glm::distance(at[h], at[other]), glm::distance(net.corner(h), net.corner(other)), slack);
    }
    for (const FaceId f : mesh.faces())
      ASSERT_GT(glm::dot(up, normal_of(mesh, at, f)), 0.999999) << "outside up, all of it";
  }
}

TEST(FoldPose, PaperStaysPaperOnTheWay) {
  for (const auto& shape : zoo()) {
    const Net net = steepest_net(shape.soup);
    const Mesh& mesh = net.mesh();
    const FoldPath path(net);
    for (const double amount : {0.2, 0.5, 0.85}) {
      const Corners at = path.corners(amount);
      for (const HalfedgeId h : mesh.halfedges())
        ASSERT_NEAR(glm::distance(at[h], at[mesh.next(h)]), mesh.length(mesh.edge(h)),
                    1e-9 * mesh.mean_edge())
            << shape.soup.name;
      for (const EdgeId e : mesh.edges()) {
        if (!net.tree.is_fold(mesh, e)) continue;
        const HalfedgeId h = mesh.halfedge(e);
        const HalfedgeId t = mesh.twin(h);
        ASSERT_LT(glm::distance(at[h], at[mesh.next(t)]), 1e-9 * mesh.mean_edge()) << "torn at a fold";
        ASSERT_LT(glm::distance(at[mesh.next(h)], at[t]), 1e-9 * mesh.mean_edge()) << "torn at a fold";
        const double bend =
            angle_between(normal_of(mesh, at, mesh.face(h)), normal_of(mesh, at, mesh.face(t)));
        ASSERT_NEAR(bend, amount * std::abs(net.dual->bend(e)), 1e-6) << shape.soup.name;
      }
    }
  }
}

TEST(FoldPose, MountainsBendAwayFromTheOutside) {
  const Net net = steepest_net(shapes::cube());
  const Mesh& mesh = net.mesh();
  const Corners at = FoldPath(net).corners(0.3);
  for (const EdgeId e : mesh.edges()) {
    if (!net.tree.is_fold(mesh, e)) continue;
    const HalfedgeId h = mesh.halfedge(e);
    const FaceId beyond = mesh.neighbour(h);
    glm::dvec3 middle(0);
    for (const HalfedgeId k : mesh.halfedges(beyond)) middle += at[k] / 4.0;
    EXPECT_LT(glm::dot(normal_of(mesh, at, mesh.face(h)), middle - at[h]), -0.1);
  }
}

TEST(FoldPose, TheFirstRootStaysOnTheModel) {
  for (const auto& shape : zoo()) {
    const Net net = steepest_net(shape.soup);
    const FoldPath path(net);
    EXPECT_TRUE(net.tree.is_root(path.held()));
    for (const double amount : {0.0, 0.4, 1.0}) {
      const Corners at = path.corners(amount);
      for (const HalfedgeId h : net.mesh().halfedges(path.held()))
        ASSERT_LT(glm::distance(at[h], net.mesh().position(h)), 1e-9 * net.mesh().box().diagonal());
    }
  }
}

}  // namespace
}  // namespace netwright::testing
