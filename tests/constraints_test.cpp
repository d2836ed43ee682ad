// Pins: setting them, finding contradictions before a search, and nets that keep them.
#include "core/solve/constraints.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/solve/search_model.h"
#include "core/solve/solve.h"
#include "core/solve/start_tree.h"
#include "tests/pins.h"
#include "tests/support.h"

namespace netwright {
namespace {

EdgeId edge_between(const Mesh& mesh, FaceId a, FaceId b) {
  for (const HalfedgeId h : mesh.halfedges(a))
    if (mesh.neighbour(h) == b) return mesh.edge(h);
  return {};
}

// All edges at a point, in the order of the faces around it.
std::vector<EdgeId> edges_around(const Mesh& mesh, VertexId v) {
  std::vector<EdgeId> edges;
  for (const HalfedgeId first : mesh.halfedges()) {
    if (mesh.from(first) != v) continue;
    HalfedgeId h = first;
    do {
      edges.push_back(mesh.edge(h));
      h = mesh.twin(mesh.prev(h));
    } while (h != first);
    break;
  }
  return edges;
}

SolveResult solve_pinned(const std::shared_ptr<const DualGraph>& dual, const SolveOptions& options) {
  Progress progress;
  return solve(dual, options, progress);
}

TEST(Constraints, AnEdgeHasOnePinAtMost) {
  Constraints pins;
  set_pin(pins, EdgeId(7), EdgePin::MustFold);
  set_pin(pins, EdgeId(3), EdgePin::MustFold);
  set_pin(pins, EdgeId(7), EdgePin::MustCut);
  EXPECT_EQ(pin_of(pins, EdgeId(3)), EdgePin::MustFold);
  EXPECT_EQ(pin_of(pins, EdgeId(7)), EdgePin::MustCut);
  EXPECT_EQ(pin_of(pins, EdgeId(4)), EdgePin::None);
  set_pin(pins, EdgeId(7), EdgePin::None);
  set_pin(pins, EdgeId(3), EdgePin::None);
  EXPECT_TRUE(pins.are_free());
}

TEST(Constraints, AFaceBelongsToOnePatchAtMost) {
  Constraints pins;
  keep_together(pins, {FaceId(4), FaceId(1), FaceId(2)});
  keep_together(pins, {FaceId(2), FaceId(9)});
  EXPECT_EQ(pins.together.size(), 2u);
  EXPECT_EQ(patch_of(pins, FaceId(2)), patch_of(pins, FaceId(9)));
  EXPECT_EQ(patch_of(pins, FaceId(1)), patch_of(pins, FaceId(4)));
  EXPECT_NE(patch_of(pins, FaceId(1)), patch_of(pins, FaceId(2)));
  let_go(pins, {FaceId(9)});
  EXPECT_EQ(patch_of(pins, FaceId(2)), -1);
  keep_together(pins, {FaceId(3)});
  EXPECT_EQ(pins.together.size(), 1u);
}

TEST(Contradiction, MustFoldsThatCloseARingAreTheCulprits) {
  const auto dual = testing::make_dual(shapes::cube());
  const std::vector<EdgeId> ring = edges_around(dual->mesh(), VertexId(0));
  Constraints pins;
  for (const EdgeId e : ring) set_pin(pins, e, EdgePin::MustFold);
  const auto found = find_contradiction(*dual, pins);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->edges, pins.must_fold);
  EXPECT_EQ(found->faces.size(), 3u);
  EXPECT_NE(found->sentence.find("ring"), std::string::npos);
  set_pin(pins, ring[0], EdgePin::None);
  EXPECT_FALSE(find_contradiction(*dual, pins));
}

TEST(Contradiction, OnlyTheRingIsToBlameAndNotTheFoldsThatHangOnIt) {
  const auto dual = testing::make_dual(shapes::icosphere(2));
  const std::vector<EdgeId> ring = edges_around(dual->mesh(), VertexId(20));
  Constraints pins;
  for (const EdgeId e : ring) set_pin(pins, e, EdgePin::MustFold);
  for (const EdgeId e : edges_around(dual->mesh(), VertexId(3))) {
    set_pin(pins, e, EdgePin::MustFold);
    if (pins.must_fold.size() == ring.size() + 2) break;
  }
  const auto found = find_contradiction(*dual, pins);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->edges.size(), ring.size());
  for (const EdgeId e : ring)
    EXPECT_NE(std::find(found->edges.begin(), found->edges.end(), e), found->edges.end());
}

TEST(Contradiction, CutsAllAroundAFaceSeparateIt) {
  const auto dual = testing::make_dual(shapes::icosphere(2));
  Constraints pins;
  for (const HalfedgeId h : dual->mesh().halfedges(FaceId(11)))
    set_pin(pins, dual->mesh().edge(h), EdgePin::MustCut);
  set_pin(pins, dual->mesh().edge(dual->mesh().first(FaceId(70))), EdgePin::MustCut);
  const auto found = find_contradiction(*dual, pins);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->faces, std::vector<FaceId>{FaceId(11)});
  EXPECT_EQ(found->edges.size(), 3u);
}

TEST(Contradiction, APatchOfFacesThatDoNotTouchIsFound) {
  const auto dual = testing::make_dual(shapes::cube());
  const Mesh& mesh = dual->mesh();
  FaceId opposite;
  for (const FaceId f : mesh.faces())
    if (f != FaceId(0) && !edge_between(mesh, FaceId(0), f).is_valid()) opposite = f;
  Constraints pins;
  keep_together(pins, {FaceId(0), opposite});
  ASSERT_TRUE(find_contradiction(*dual, pins));
  FaceId between = mesh.neighbour(mesh.first(FaceId(0)));
  keep_together(pins, {FaceId(0), opposite, between});
  EXPECT_FALSE(find_contradiction(*dual, pins));
  set_pin(pins, edge_between(mesh, between, opposite), EdgePin::MustCut);
  const auto found = find_contradiction(*dual, pins);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->edges, pins.must_cut);
}

TEST(Contradiction, AFoldBesideAPatchMayNotCloseARingThroughIt) {
  const auto dual = testing::make_dual(shapes::cube());
  const Mesh& mesh = dual->mesh();
  const std::vector<EdgeId> at_corner = edges_around(mesh, VertexId(0));
  const HalfedgeId h0 = mesh.halfedge(at_corner[0]);
  Constraints pins;
  keep_together(pins, {mesh.face(h0), mesh.neighbour(h0)});
  set_pin(pins, at_corner[1], EdgePin::MustFold);
  EXPECT_FALSE(find_contradiction(*dual, pins));
  set_pin(pins, at_corner[2], EdgePin::MustFold);
  const auto found = find_contradiction(*dual, pins);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->edges, pins.must_fold);
}

TEST(Contradiction, MustFoldsAroundASaddlePointCannotLieFlat) {
  // The inner corners of a tall open cylinder's waist would do; a hat's brim has such points: their angles
  // add up to more than a full turn.
  const auto dual = testing::make_dual(shapes::hat());
  const Mesh& mesh = dual->mesh();
  int n_found = 0;
  for (const VertexId v : mesh.vertices()) {
    double angles = 0;
    for (const HalfedgeId h : mesh.halfedges()) {
      if (mesh.from(h) != v) continue;
      const glm::dvec3 a = mesh.position(mesh.to(h)) - mesh.position(h);
      const glm::dvec3 b = mesh.position(mesh.prev(h)) - mesh.position(h);
      angles += std::acos(glm::dot(a, b) / (glm::length(a) * glm::length(b)));
    }
    const std::vector<EdgeId> around = edges_around(mesh, v);
    Constraints pins;
    for (std::size_t k = 1; k < around.size(); ++k) set_pin(pins, around[k], EdgePin::MustFold);
    const auto found = find_contradiction(*dual, pins);
    if (angles > 6.3) {
      ++n_found;
      ASSERT_TRUE(found);
      EXPECT_NE(found->sentence.find("around a point"), std::string::npos);
      EXPECT_GE(found->edges.size(), 2u);
    } else if (angles < 6.2) {
      EXPECT_FALSE(found) << (found ? found->sentence : "");
    }
  }
  EXPECT_GT(n_found, 0);
}

TEST(Contradiction, APatchAroundASaddlePointIsCrowdedOnlyWithoutAGap) {
  const auto dual = testing::make_dual(shapes::hat());
  const Mesh& mesh = dual->mesh();
  int n_crowded = 0;
  for (const VertexId v : mesh.vertices()) {
    const std::vector<EdgeId> around = edges_around(mesh, v);
    Constraints pins;
    std::vector<FaceId> patch;
    for (const EdgeId e : around)
      for (const HalfedgeId h : {mesh.halfedge(e), mesh.twin(mesh.halfedge(e))})
        patch.push_back(mesh.face(h));
    keep_together(pins, patch);
    const auto found = find_contradiction(*dual, pins);
    if (!found) continue;
    ++n_crowded;
    EXPECT_EQ(found->faces, pins.together.front());
    EXPECT_NE(found->sentence.find("cannot lie flat together"), std::string::npos);
    // Without one of them the rest has room.
    let_go(pins, {mesh.face(mesh.halfedge(around[0])), mesh.neighbour(mesh.halfedge(around[0]))});
    EXPECT_FALSE(find_contradiction(*dual, pins));
  }
  EXPECT_GT(n_crowded, 0);
}

TEST(StartTree, KeepsPinsOverTheZoo) {
  Random random(3);
  for (const auto& shape : testing::zoo()) {
    const auto dual = testing::make_dual(shape.soup);
    const Constraints pins = testing::random_pins(*dual, 4, random);
    const auto models = search_models(*dual, pins);
    IdVector<EdgeId, char> greedy(dual->mesh().n_edges(), 0);
    IdVector<EdgeId, char> steepest = greedy;
    for (const SearchModel& model : models) {
      const auto one = greedy_folds(model, random, 1e-9);
      const auto other = pinned_folds(model, steepest_edge_folds(*dual, model, random));
      for (std::size_t h = 0; h < one.size(); ++h) {
        if (one[h] != 0) greedy[dual->mesh().edge(model.mesh_halfedge[h])] = 1;
        if (other[h] != 0) steepest[dual->mesh().edge(model.mesh_halfedge[h])] = 1;
      }
    }
    for (const auto& folds : {greedy, steepest}) {
      const UnfoldTree tree = tree_from_folds(dual->mesh(), folds);
      EXPECT_EQ(tree.roots().size(), dual->mesh().n_components()) << shape.soup.name;
      EXPECT_TRUE(keeps_pins(dual->mesh(), tree, pins)) << shape.soup.name;
    }
  }
}

TEST(Solve, NetsKeepEveryPinOverTheZoo) {
  Random random(8);
  for (const auto& shape : testing::zoo()) {
    const auto dual = testing::make_dual(shape.soup);
    for (const SearchStyle style : {SearchStyle::Fast, SearchStyle::Paper}) {
      SolveOptions options;
      options.pins = testing::random_pins(*dual, dual->mesh().n_faces() > 40 ? 3 : 1, random);
      options.search = style;
      options.max_iterations = style == SearchStyle::Fast ? 20000 : 1000;
      const SolveResult result = solve_pinned(dual, options);
      EXPECT_TRUE(keeps_pins(dual->mesh(), result.net.tree, options.pins)) << shape.soup.name;
      EXPECT_TRUE(result.net.tree.is_root(options.pins.root)) << shape.soup.name;
    }
  }
}

TEST(Solve, ContradictingPinsAreRefusedWithTheReason) {
  const auto dual = testing::make_dual(shapes::cube());
  SolveOptions options;
  for (const EdgeId e : edges_around(dual->mesh(), VertexId(0))) set_pin(options.pins, e, EdgePin::MustFold);
  EXPECT_THROW(solve_pinned(dual, options), Error);
}

TEST(Solve, FromANetNothingChangesThatNeedNot) {
  const auto dual = testing::make_dual(shapes::bumpy_patch(10, 10));
  SolveOptions options;
  const SolveResult first = solve_pinned(dual, options);
  ASSERT_TRUE(first.is_proved);
  options.from = std::make_shared<const UnfoldTree>(first.net.tree);
  options.stays_near = true;
  options.seed = 9;
  const SolveResult again = solve_pinned(dual, options);
  EXPECT_EQ(again.iterations, 0);
  EXPECT_EQ(again.net.tree, first.net.tree);
}

TEST(Solve, FromANetWithANewPinLittleChanges) {
  const auto dual = testing::make_dual(shapes::icosphere(7));
  const Mesh& mesh = dual->mesh();
  SolveOptions options;
  const SolveResult first = solve_pinned(dual, options);
  ASSERT_TRUE(first.is_proved);
  options.from = std::make_shared<const UnfoldTree>(first.net.tree);
  options.stays_near = true;
  int n_changed_most = 0;
  for (const int number : {0, 77, 301}) {
    const EdgeId e(number);
    options.pins = {};
    set_pin(options.pins, e, first.net.tree.is_fold(mesh, e) ? EdgePin::MustCut : EdgePin::MustFold);
    const SolveResult result = solve_pinned(dual, options);
    EXPECT_TRUE(result.is_proved);
    EXPECT_TRUE(keeps_pins(mesh, result.net.tree, options.pins));
    int n_changed = 0;
    for (const EdgeId other : mesh.edges())
      n_changed += first.net.tree.is_fold(mesh, other) != result.net.tree.is_fold(mesh, other) ? 1 : 0;
    n_changed_most = std::max(n_changed_most, n_changed);
  }
  EXPECT_LE(n_changed_most, 12);  // of 1470 edges; two is the least
}

TEST(Solve, AForestOfPiecesCanBeTheStart) {
  const auto dual = testing::make_dual(shapes::icosphere(2));
  SolveOptions options;
  options.from = std::make_shared<const UnfoldTree>(dual->mesh().n_faces());
  const SolveResult result = solve_pinned(dual, options);
  EXPECT_TRUE(result.is_proved);
  EXPECT_EQ(result.net.n_pieces, 1);
}

}  // namespace
}  // namespace netwright
