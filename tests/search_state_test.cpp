// The laws of the incremental search state: after any sequence of exchanges it equals what a fresh layout
// gives.
#include "core/solve/search_state.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/predicates.h"
#include "core/solve/showing.h"
#include "core/solve/start_tree.h"
#include "core/unfold/overlap.h"
#include "tests/support.h"

namespace netwright {
namespace {

using testing::make_dual;
using testing::zoo;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Overlaps by the plain detection on a fresh layout of the state's folds, in the model's numbering.
std::vector<std::pair<int, int>> plain_overlaps(std::shared_ptr<const DualGraph> dual,
                                                const SearchModel& model, const SearchState& state) {
  WholeTree whole(dual, FaceId());
  whole.set(model, state.folds());
  std::vector<int> local(dual->mesh().n_faces(), -1);
  for (int f = 0; f < model.n_faces; ++f) local[model.mesh_face[at(f)].index()] = f;
  std::vector<std::pair<int, int>> result;
  for (const Overlap& o : find_overlaps(whole.net(), kSolveDepth)) {
    const int a = local[o.first.index()];
    const int b = local[o.second.index()];
    if (a >= 0 && b >= 0) result.emplace_back(std::min(a, b), std::max(a, b));
  }
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<std::pair<int, int>> sorted(std::vector<std::pair<int, int>> pairs) {
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

// A random exchange at a random root: some face with a cut to the far side is re-attached there.
bool random_exchange(SearchState& state, Random& random, Exchange& exchange) {
  const SearchModel& m = state.model();
  state.root_at(random.below(m.n_faces));
  for (int tries = 0; tries < 200; ++tries) {
    const int h = random.below(m.n_halfedges);
    const int x = m.face_of[at(h)];
    if (m.twin[at(h)] < 0 || state.is_fold(h) || state.up(x) < 0) continue;
    const int g = state.position(m.beyond(h));
    if (g >= state.position(x) && g < state.end(x)) continue;
    const int t = m.twin[at(h)];
    exchange = {state.position(x), state.end(x),
                state.placement(m.face_of[at(t)]) * m.unroll[at(t)] * state.placement(x).inverse(),
                state.up(x), h};
    return true;
  }
  return false;
}

TEST(SearchState, StoredOverlapsEqualFullDetectionAfterAnyMoves) {
  for (const auto& shape : zoo()) {
    const auto dual = make_dual(shape.soup);
    for (const SearchModel& model : search_models(*dual)) {
      Random random(1);
      SearchState state(model, kSolveDepth);
      state.set_tree(greedy_folds(model, random, kSolveDepth));
      ASSERT_EQ(sorted(state.pairs()), plain_overlaps(dual, model, state)) << shape.soup.name;
      Exchange exchange;
      for (int k = 0; k < 60 && random_exchange(state, random, exchange); ++k) {
        state.apply(exchange);
        ASSERT_EQ(sorted(state.pairs()), plain_overlaps(dual, model, state))
            << shape.soup.name << " move " << k;
      }
    }
  }
}

TEST(SearchState, CountsAMoveAsItTurnsOut) {
  const auto dual = make_dual(shapes::icosphere(4));
  const SearchModel model = search_models(*dual).front();
  Random random(2);
  SearchState state(model, kSolveDepth);
  state.set_tree(steepest_edge_folds(*dual, model, random));
  Exchange exchange;
  for (int k = 0; k < 300 && random_exchange(state, random, exchange); ++k) {
    int crossing = 0;
    for (const auto& [a, b] : state.pairs()) {
      const auto inside = [&](int f) {
        return state.position(f) >= exchange.first && state.position(f) < exchange.last;
      };
      crossing += inside(a) != inside(b) ? 1 : 0;
    }
    const int expected = state.overlaps() - crossing + state.count_after(exchange, 1 << 29);
    const int limit = 1 + random.below(5);
    const int bounded = state.count_after(exchange, limit);
    EXPECT_EQ(bounded, std::min(limit, state.count_after(exchange, 1 << 29)));
    state.apply(exchange);
    EXPECT_EQ(state.overlaps(), expected);
  }
}

TEST(SearchState, PlacementsDriftLessThanTheToleranceOverThousandsOfMoves) {
  const auto dual = make_dual(shapes::torus(10, 8));
  const SearchModel model = search_models(*dual).front();
  Random random(3);
  SearchState state(model, kSolveDepth);
  state.set_tree(greedy_folds(model, random, kSolveDepth));
  Exchange exchange;
  for (int k = 0; k < 2000 && random_exchange(state, random, exchange); ++k) state.apply(exchange);
  const Rigid2 anchor = state.placement(0);
  std::vector<Rigid2> drifted;
  for (int f = 0; f < model.n_faces; ++f) drifted.push_back(state.placement(f));
  state.recompute();
  ASSERT_EQ(state.placement(0), anchor);
  for (int f = 0; f < model.n_faces; ++f) {
    EXPECT_NEAR(state.placement(f).x, drifted[at(f)].x, 0.1 * kSolveDepth);
    EXPECT_NEAR(state.placement(f).cos, drifted[at(f)].cos, 0.1 * kSolveDepth);
  }
}

TEST(SearchState, PreorderViewIsConsistentForEveryRoot) {
  const auto dual = make_dual(shapes::cuboid_with_holes(2, 2));
  const SearchModel model = search_models(*dual).front();
  Random random(4);
  SearchState state(model, kSolveDepth);
  state.set_tree(greedy_folds(model, random, kSolveDepth));
  for (int root = 0; root < model.n_faces; ++root) {
    state.root_at(root);
    EXPECT_EQ(state.position(root), 0);
    EXPECT_EQ(state.end(root), model.n_faces);
    for (int f = 0; f < model.n_faces; ++f) {
      EXPECT_EQ(state.face_at(state.position(f)), f);
      if (f == root) continue;
      const int parent = model.beyond(state.up(f));
      EXPECT_LT(state.position(parent), state.position(f));
      EXPECT_LE(state.end(f), state.end(parent));
    }
  }
}

TEST(StartTree, GreedyTreesSpanAndOverlapFarLessThanSteepestEdges) {
  int greedy = 0;
  int steepest = 0;
  for (const auto& shape : zoo()) {
    const auto dual = make_dual(shape.soup);
    for (const SearchModel& model : search_models(*dual)) {
      Random random(5);
      SearchState state(model, kSolveDepth);
      for (int k = 0; k < 5; ++k) {
        auto folds = greedy_folds(model, random, kSolveDepth);
        EXPECT_EQ(std::count(folds.begin(), folds.end(), 1), 2 * (model.n_faces - 1)) << shape.soup.name;
        state.set_tree(std::move(folds));
        greedy += state.overlaps();
        state.set_tree(steepest_edge_folds(*dual, model, random));
        steepest += state.overlaps();
      }
    }
  }
  EXPECT_LT(4 * greedy, steepest);
}

}  // namespace
}  // namespace netwright
