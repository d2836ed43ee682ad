// Layout, fold kinds and the stored form of nets, over the zoo.
#include "core/unfold/net.h"

#include <gtest/gtest.h>

#include "core/base/predicates.h"
#include "core/unfold/flat_net.h"
#include "core/unfold/fold.h"
#include "core/unfold/overlap.h"
#include "core/unfold/steepest_edge.h"
#include "tests/support.h"

namespace netwright {
namespace {

using testing::make_dual;
using testing::zoo;

Net steepest_net(const PolygonSoup& soup, std::uint64_t seed = 1) {
  const auto dual = make_dual(soup);
  Random random(seed);
  return layout(dual, steepest_edge_tree(*dual, random));
}

TEST(Net, FacesAtAFoldShareItInThePlane) {
  for (const auto& shape : zoo()) {
    const Net net = steepest_net(shape.soup);
    const Mesh& mesh = net.mesh();
    for (const EdgeId e : mesh.edges()) {
      if (!net.tree.is_fold(mesh, e)) continue;
      const HalfedgeId h = mesh.halfedge(e);
      const HalfedgeId t = mesh.twin(h);
      EXPECT_LT(glm::distance(net.corner(h), net.corner(mesh.next(t))), 1e-9 * mesh.mean_edge())
          << shape.soup.name;
      EXPECT_LT(glm::distance(net.corner(mesh.next(h)), net.corner(t)), 1e-9 * mesh.mean_edge())
          << shape.soup.name;
    }
  }
}

TEST(Net, RootsStayInTheirOwnFrame) {
  Net net = steepest_net(shapes::icosphere(2));
  UnfoldTree tree = net.tree;
  tree.reroot(net.mesh(), FaceId(17));
  const Net turned = layout(net.dual, tree);
  EXPECT_EQ(turned.placement[FaceId(17)], Rigid2());
  EXPECT_EQ(find_overlaps(net, kSolveDepth).size(), find_overlaps(turned, kSolveDepth).size());
}

TEST(Net, PiecesLieBesideEachOther) {
  const Net net = steepest_net(shapes::combined(shapes::cube(), shapes::tetrahedron(), {5, 0, 0}));
  ASSERT_EQ(net.n_pieces, 2);
  std::vector<Box2> boxes(2);
  for (const FaceId f : net.mesh().faces()) boxes[static_cast<std::size_t>(net.piece[f])].add(net.box(f));
  EXPECT_LT(boxes[0].max.x, boxes[1].min.x);
}

TEST(Fold, KindsFollowTheModel) {
  const Net cube = steepest_net(shapes::cube());
  int mountains = 0;
  int cuts = 0;
  for (const EdgeKind kind : edge_kinds(cube)) {
    mountains += kind == EdgeKind::Mountain ? 1 : 0;
    cuts += kind == EdgeKind::Cut ? 1 : 0;
  }
  EXPECT_EQ(mountains, 5);
  EXPECT_EQ(cuts, 7);

  const Net patch = steepest_net(shapes::grid_patch(5, 4));
  int flat = 0;
  int border = 0;
  for (const EdgeKind kind : edge_kinds(patch)) {
    flat += kind == EdgeKind::Flat ? 1 : 0;
    border += kind == EdgeKind::Border ? 1 : 0;
  }
  EXPECT_EQ(flat, 19);
  EXPECT_EQ(border, 18);
}

TEST(FlatNet, JoinsFoldsAndPartsCuts) {
  for (const auto& shape : zoo()) {
    const Net net = steepest_net(shape.soup);
    const FlatNet flat = to_flat_net(net, 2.5);
    const Mesh& mesh = net.mesh();
    ASSERT_EQ(flat.faces.size(), mesh.n_faces());
    std::size_t folds = 0;
    for (const EdgeId e : mesh.edges()) folds += net.tree.is_fold(mesh, e) ? 1 : 0;
    EXPECT_EQ(folds, mesh.n_faces() - static_cast<std::size_t>(net.n_pieces));
    EXPECT_EQ(flat.edges.size(), mesh.n_halfedges() - folds) << shape.soup.name;
    EXPECT_NEAR(mean_edge(flat), 2.5 * mesh.mean_edge(), 1e-6 * mesh.mean_edge());
    for (const FaceId f : mesh.faces()) {
      std::size_t i = 0;
      for (const HalfedgeId h : mesh.halfedges(f)) {
        const auto p = static_cast<std::size_t>(flat.faces[f.index()][i++]);
        EXPECT_EQ(flat.folded[p], mesh.position(h));
        EXPECT_LT(glm::distance(flat.points[p], 2.5 * net.corner(h)), 1e-6 * mesh.mean_edge());
      }
    }
  }
}

TEST(FlatNet, SaysMountainsWithNegativeAngles) {
  const FlatNet flat = to_flat_net(steepest_net(shapes::cube()), 1);
  int mountains = 0;
  for (const auto& edge : flat.edges) {
    if (edge.assignment != Assignment::Mountain) continue;
    ++mountains;
    EXPECT_NEAR(edge.fold_angle_rad, -M_PI / 2, 1e-12);
  }
  EXPECT_EQ(mountains, 5);
}

}  // namespace
}  // namespace netwright
