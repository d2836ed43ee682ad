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
std::vector<std::pair<int, int>> plain_overlaps(const std::shared_ptr<const DualGraph>& dual,
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

// A random exchange: a cut becomes a fold, and some fold on the way between its faces becomes a cut.
bool random_exchange(SearchState& state, Random& random, Exchange& exchange) {
  const SearchModel& m = state.model();
  for (int tries = 0; tries < 200; ++tries) {
    const int h = random.below(m.n_halfedges);
    const int t = m.twin[at(h)];
    if (t < 0 || state.is_fold(h)) continue;
    const int x = m.face_of[at(h)];
    const int beyond = m.beyond(h);
    int top = x;  // of the side that moves: x or a face above it that is not above both
    while (state.up(top) >= 0 && random.below(3) > 0 && !state.in_subtree(beyond, m.beyond(state.up(top))))
      top = m.beyond(state.up(top));
    if (state.in_subtree(beyond, top)) continue;
    exchange = {state.position(top), state.end(top),
                state.placement(beyond) * m.unroll[at(t)] * state.placement(x).inverse(), state.up(top), h};
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

// So many faces that boxes of blocks have boxes of their own.
TEST(SearchState, StoredOverlapsEqualFullDetectionOnAModelOfManyBlocks) {
  const auto dual = make_dual(shapes::torus(40, 20));
  const SearchModel model = search_models(*dual).front();
  Random random(7);
  SearchState state(model, kSolveDepth);
  state.set_tree(steepest_edge_folds(*dual, model, random));
  Exchange exchange;
  for (int k = 0; k < 100 && random_exchange(state, random, exchange); ++k) {
    state.apply(exchange);
    ASSERT_EQ(sorted(state.pairs()), plain_overlaps(dual, model, state)) << "move " << k;
  }
}

TEST(SearchState, CountsAMoveAsItTurnsOut) {
  const auto dual = make_dual(shapes::icosphere(6));
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
    EXPECT_EQ(state.count_as_paper(exchange), state.count_after(exchange, 1 << 29));
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

TEST(BoxKernels, AllFindTheSameBoxes) {
  Random random(8);
  for (const int n : {1, 15, 16, 17, 100, 1000}) {
    BoxLanes lanes;
    lanes.resize(n);
    const auto random_box = [&](double size) {
      const double x = random.unit() * 10;
      const double y = random.unit() * 10;
      return BoxF::around(x, y, x + size * random.unit(), y + size * random.unit());
    };
    for (int i = 0; i < n; ++i) lanes.set(i, random_box(1));
    for (int k = 0; k < 50; ++k) {
      const BoxF box = k == 0 ? lanes.get(0) : random_box(3);
      std::vector<int> expected;
      for (int i = 0; i < n; ++i) {
        const BoxF b = lanes.get(i);
        if (b.min_x <= box.max_x && b.max_x >= box.min_x && b.min_y <= box.max_y && b.max_y >= box.min_y)
          expected.push_back(i);
      }
      for (const BoxKernel& kernel : box_kernels()) {
        std::vector<int> found(lanes.min_x.size());
        found.resize(at(kernel.find(lanes, box, found.data())));
        ASSERT_EQ(found, expected) << kernel.name;
        for (int b = 0; 16 * b < n; ++b)
          ASSERT_EQ(kernel.hits(lanes, b, box), box_kernels()[0].hits(lanes, b, box));
      }
    }
  }
}

void expect_sound_preorder(const SearchState& state) {
  const SearchModel& m = state.model();
  EXPECT_EQ(state.position(0), 0);
  EXPECT_EQ(state.end(0), m.n_faces);
  for (int f = 0; f < m.n_faces; ++f) {
    ASSERT_EQ(state.face_at(state.position(f)), f);
    int below = 1;
    for (int h = m.face_begin[at(f)]; h < m.face_begin[at(f) + 1]; ++h) {
      if (!state.is_fold(h) || h == state.up(f)) continue;
      const int child = m.beyond(h);
      ASSERT_EQ(state.up(child), m.twin[at(h)]);
      ASSERT_GT(state.position(child), state.position(f));
      ASSERT_LE(state.end(child), state.end(f));
      below += state.end(child) - state.position(child);
    }
    ASSERT_EQ(below, state.end(f) - state.position(f));
  }
}

TEST(SearchState, MendedPreorderIsThatOfTheTreeAfterEveryMove) {
  for (const auto& soup : {shapes::icosphere(3), shapes::cuboid_with_holes(2, 2), shapes::gear(10)}) {
    const auto dual = make_dual(soup);
    const SearchModel model = search_models(*dual).front();
    Random random(4);
    SearchState state(model, kSolveDepth);
    state.set_tree(greedy_folds(model, random, kSolveDepth));
    Exchange exchange;
    for (int k = 0; k < 200 && random_exchange(state, random, exchange); ++k) {
      state.apply(exchange);
      expect_sound_preorder(state);
    }
  }
}

TEST(SearchState, PathsLeadFoldByFoldFromFaceToFace) {
  const auto dual = make_dual(shapes::icosphere(3));
  const SearchModel model = search_models(*dual).front();
  Random random(6);
  SearchState state(model, kSolveDepth);
  state.set_tree(greedy_folds(model, random, kSolveDepth));
  std::vector<PathStep> path;
  for (int k = 0; k < 200; ++k) {
    const int from = random.below(model.n_faces);
    const int to = random.below(model.n_faces);
    state.find_path(from, to, path);
    int f = from;
    for (const PathStep& step : path) {
      EXPECT_EQ(step.near, f);
      EXPECT_EQ(step.child, step.near_is_child ? step.near : step.far);
      EXPECT_EQ(model.beyond(state.up(step.child)), step.near_is_child ? step.far : step.near);
      EXPECT_EQ(state.in_subtree(from, step.child), step.near_is_child);
      EXPECT_NE(state.in_subtree(to, step.child), step.near_is_child);
      f = step.far;
    }
    EXPECT_EQ(f, to);
  }
}

TEST(StartTree, IsATreeAlsoWhenItIsCancelled) {
  Progress cancelled;
  cancelled.cancel();
  for (const auto& shape : zoo()) {
    const auto dual = make_dual(shape.soup);
    for (const SearchModel& model : search_models(*dual)) {
      Random random(9);
      SearchState state(model, kSolveDepth);
      state.set_tree(greedy_folds(model, random, kSolveDepth, &cancelled));
      expect_sound_preorder(state);
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
