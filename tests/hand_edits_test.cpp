// Editing trees by hand: what joins, what comes apart, what moves.
#include "core/unfold/hand_edits.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/unfold/steepest_edge.h"
#include "tests/support.h"

namespace netwright {
namespace {

bool always(EdgeId /*e*/) { return true; }

int n_folds(const Mesh& mesh, const UnfoldTree& tree) {
  int n = 0;
  for (const EdgeId e : mesh.edges()) n += tree.is_fold(mesh, e) ? 1 : 0;
  return n;
}

void expect_is(const Mesh& mesh, const UnfoldTree& before, const HandEdit& edit) {
  EXPECT_TRUE(edit.tree.is_forest(mesh));
  for (const EdgeId e : mesh.edges()) {
    const bool is_joined = std::find(edit.joined.begin(), edit.joined.end(), e) != edit.joined.end();
    const bool is_cut = std::find(edit.cut.begin(), edit.cut.end(), e) != edit.cut.end();
    EXPECT_EQ(edit.tree.is_fold(mesh, e), (before.is_fold(mesh, e) || is_joined) && !is_cut);
  }
}

TEST(HandEdits, CuttingMakesAPieceAndJoiningThereTakesItBack) {
  Random random(4);
  for (const auto& shape : testing::zoo()) {
    const auto dual = testing::make_dual(shape.soup);
    const Mesh& mesh = dual->mesh();
    const UnfoldTree tree = steepest_edge_tree(*dual, random);
    for (const EdgeId e : mesh.edges()) {
      const auto cut = cut_at(mesh, tree, e);
      ASSERT_EQ(cut.has_value(), tree.is_fold(mesh, e));
      if (!cut || e.value % 7 != 0) continue;
      expect_is(mesh, tree, *cut);
      EXPECT_EQ(cut->tree.roots().size(), tree.roots().size() + 1);
      const auto joined = join_at(mesh, cut->tree, mesh.halfedge(e), always, FaceId());
      ASSERT_TRUE(joined);
      expect_is(mesh, cut->tree, *joined);
      EXPECT_TRUE(joined->cut.empty());
      EXPECT_EQ(n_folds(mesh, joined->tree), n_folds(mesh, tree));
      for (const EdgeId other : mesh.edges())
        EXPECT_EQ(joined->tree.is_fold(mesh, other), tree.is_fold(mesh, other));
    }
  }
}

TEST(HandEdits, JoiningInsideAPieceCutsTheFoldByWhichTheClickedFaceHangs) {
  Random random(5);
  for (const auto& shape : testing::zoo()) {
    const auto dual = testing::make_dual(shape.soup);
    const Mesh& mesh = dual->mesh();
    const UnfoldTree tree = steepest_edge_tree(*dual, random);
    for (const HalfedgeId h : mesh.halfedges()) {
      if (h.value % 5 != 0) continue;
      const auto joined = join_at(mesh, tree, h, always, FaceId());
      const bool is_cut = mesh.twin(h).is_valid() && !tree.is_fold(mesh, mesh.edge(h));
      ASSERT_EQ(joined.has_value(), is_cut);
      if (!joined) continue;
      expect_is(mesh, tree, *joined);
      ASSERT_EQ(joined->cut.size(), 1u);
      EXPECT_EQ(joined->tree.roots().size(), tree.roots().size());
      const HalfedgeId gone = mesh.halfedge(joined->cut[0]);
      EXPECT_TRUE(mesh.face(gone) == mesh.face(h) || mesh.neighbour(gone) == mesh.face(h));
      EXPECT_EQ(std::count(joined->moved.begin(), joined->moved.end(), mesh.face(h)), 1);
      EXPECT_EQ(std::count(joined->moved.begin(), joined->moved.end(), mesh.neighbour(h)), 0);
    }
  }
}

TEST(HandEdits, PinnedFoldsAreLeftAloneAndTheFixedFaceStays) {
  const auto dual = testing::make_dual(shapes::icosphere(2));
  const Mesh& mesh = dual->mesh();
  Random random(6);
  const UnfoldTree tree = steepest_edge_tree(*dual, random);
  for (const HalfedgeId h : mesh.halfedges()) {
    const auto joined = join_at(mesh, tree, h, always, FaceId());
    if (!joined) continue;
    const EdgeId first = joined->cut[0];
    const auto other = join_at(
        mesh, tree, h, [&](EdgeId e) { return e != first; }, FaceId());
    if (other) {
      EXPECT_NE(other->cut[0], first);
    }
    EXPECT_FALSE(join_at(
        mesh, tree, h, [](EdgeId) { return false; }, FaceId()));
    const auto fixed = join_at(mesh, tree, h, always, FaceId(9));
    ASSERT_TRUE(fixed);
    EXPECT_EQ(std::count(fixed->moved.begin(), fixed->moved.end(), FaceId(9)), 0);
    EXPECT_TRUE(fixed->tree.is_root(FaceId(9)));
  }
}

TEST(HandEdits, ABranchHangsWhereItIsTold) {
  const auto dual = testing::make_dual(shapes::icosphere(2));
  const Mesh& mesh = dual->mesh();
  Random random(7);
  const UnfoldTree tree = steepest_edge_tree(*dual, random);
  for (const FaceId f : mesh.faces()) {
    for (const HalfedgeId place : places_for(mesh, tree, f)) {
      const auto hung = hang_at(mesh, tree, f, place);
      ASSERT_TRUE(hung);
      expect_is(mesh, tree, *hung);
      EXPECT_EQ(hung->tree.roots().size(), tree.is_root(f) ? tree.roots().size() : 1u);
    }
    if (!tree.is_root(f)) {
      EXPECT_FALSE(hang_at(mesh, tree, f, tree.to_parent(f)));
    }
  }
}

TEST(HandEdits, AStripGoesRoundAPrismAndAroundATorus) {
  const auto never = [](EdgeId /*e*/) { return false; };
  const auto prism = testing::make_mesh(shapes::regular_prism(7));
  for (const EdgeId e : prism->edges()) {
    const HalfedgeId h = prism->halfedge(e);
    const bool is_upright = prism->degree(prism->face(h)) == 4 && prism->degree(prism->neighbour(h)) == 4;
    if (is_upright)
      EXPECT_EQ(strip_across(*prism, e, never).size(), 7u);
    else
      EXPECT_EQ(strip_across(*prism, e, never).size(), 2u);
  }
  const auto torus = testing::make_mesh(shapes::torus(8, 6));
  for (const EdgeId e : torus->edges()) {
    const std::size_t n = strip_across(*torus, e, never).size();
    EXPECT_TRUE(torus->degree(FaceId(0)) == 3 || n == 8 || n == 6) << n;
  }
}

}  // namespace
}  // namespace netwright
