// Unfold trees: they span, reroot without changing the net, and come from steepest edges for any direction.
#include "core/unfold/unfold_tree.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "core/unfold/steepest_edge.h"
#include "tests/support.h"

namespace netwright {
namespace {

using testing::make_dual;
using testing::zoo;

IdVector<EdgeId, char> folds_of(const Mesh& mesh, const UnfoldTree& tree) {
  IdVector<EdgeId, char> folds(mesh.n_edges(), 0);
  for (const EdgeId e : mesh.edges()) folds[e] = tree.is_fold(mesh, e) ? 1 : 0;
  return folds;
}

TEST(UnfoldTree, SteepestEdgeTreesSpanEveryShapeForManyDirections) {
  for (const auto& shape : zoo()) {
    const auto dual = make_dual(shape.soup);
    Random random(1);
    for (int k = 0; k < 20; ++k) {
      const UnfoldTree tree = steepest_edge_tree(*dual, random);
      ASSERT_TRUE(tree.is_forest(dual->mesh())) << shape.soup.name;
      ASSERT_EQ(tree.roots().size(), dual->mesh().n_components()) << shape.soup.name;
    }
  }
}

TEST(UnfoldTree, DifferentDirectionsGiveDifferentTrees) {
  const auto dual = make_dual(shapes::icosphere(2));
  Random random(4);
  EXPECT_NE(folds_of(dual->mesh(), steepest_edge_tree(*dual, random)),
            folds_of(dual->mesh(), steepest_edge_tree(*dual, random)));
}

TEST(UnfoldTree, PreorderMeetsParentsFirstAndEveryFaceOnce) {
  const auto dual = make_dual(shapes::torus(8, 6));
  Random random(2);
  const UnfoldTree tree = steepest_edge_tree(*dual, random);
  IdVector<FaceId, char> seen(tree.n_faces(), 0);
  for (const FaceId f : tree.preorder(dual->mesh())) {
    EXPECT_FALSE(seen[f]);
    seen[f] = 1;
    if (!tree.is_root(f)) {
      EXPECT_TRUE(seen[tree.parent(dual->mesh(), f)]);
    }
  }
}

TEST(UnfoldTree, RerootingKeepsTheFolds) {
  const auto dual = make_dual(shapes::icosphere(2));
  const Mesh& mesh = dual->mesh();
  Random random(3);
  UnfoldTree tree = steepest_edge_tree(*dual, random);
  const auto folds = folds_of(mesh, tree);
  for (int k = 0; k < 50; ++k) {
    const FaceId root(random.below(static_cast<int>(mesh.n_faces())));
    tree.reroot(mesh, root);
    EXPECT_TRUE(tree.is_root(root));
    EXPECT_TRUE(tree.is_forest(mesh));
    EXPECT_EQ(folds_of(mesh, tree), folds);
    EXPECT_EQ(tree.root_of(mesh, FaceId(0)), root);
  }
}

TEST(UnfoldTree, IsRebuiltFromItsFoldsAndRefusesACycle) {
  const auto dual = make_dual(shapes::cube());
  const Mesh& mesh = dual->mesh();
  Random random(5);
  const UnfoldTree tree = steepest_edge_tree(*dual, random);
  auto folds = folds_of(mesh, tree);
  EXPECT_EQ(folds_of(mesh, tree_from_folds(mesh, folds, FaceId(3))), folds);
  EXPECT_TRUE(tree_from_folds(mesh, folds, FaceId(3)).is_root(FaceId(3)));
  for (const EdgeId e : mesh.edges()) {
    if (folds[e]) continue;
    folds[e] = 1;
    EXPECT_THROW(tree_from_folds(mesh, folds), std::logic_error);
    folds[e] = 0;
  }
}

TEST(UnfoldTree, NoticesALoopOfParents) {
  const auto dual = make_dual(shapes::tetrahedron());
  const Mesh& mesh = dual->mesh();
  UnfoldTree tree(mesh.n_faces());
  const HalfedgeId h = mesh.first(FaceId(0));
  tree.set_parent(FaceId(0), h);
  tree.set_parent(mesh.neighbour(h), mesh.twin(h));
  EXPECT_FALSE(tree.is_forest(mesh));
}

}  // namespace
}  // namespace netwright
