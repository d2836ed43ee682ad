// The search's inner parts one by one, on a torus of 800 faces: start trees, trying exchanges, moves,
// comparing boxes, full detection, layout and the proof. For finding out what a change costs; compare figures
// of one run only.
#include <benchmark/benchmark.h>

#include "core/base/predicates.h"
#include "core/base/random.h"
#include "core/solve/search_state.h"
#include "core/solve/showing.h"
#include "core/solve/start_tree.h"
#include "core/solve/tabu_solver.h"
#include "core/unfold/overlap.h"
#include "core/unfold/verify.h"
#include "tests/support.h"

namespace netwright {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

struct Scene {
  std::shared_ptr<const DualGraph> dual = testing::make_dual(shapes::torus(25, 16));
  SearchModel model = std::move(search_models(*dual).front());
  Random random{1};
  SearchState state{model, kSolveDepth};
  Scene() { state.set_tree(steepest_edge_folds(*dual, model, random)); }

  // Some cut whose face can be swung over to the other side of the fold above it.
  Exchange exchange() {
    while (true) {
      const int h = random.below(model.n_halfedges);
      const int x = model.face_of[at(h)];
      if (state.is_fold(h) || state.up(x) < 0 || state.in_subtree(model.beyond(h), x)) continue;
      const int t = model.twin[at(h)];
      return {state.position(x), state.end(x),
              state.placement(model.face_of[at(t)]) * model.unroll[at(t)] * state.placement(x).inverse(),
              state.up(x), h};
    }
  }
};

void greedy_start(benchmark::State& state) {
  Scene scene;
  for (auto _ : state) benchmark::DoNotOptimize(greedy_folds(scene.model, scene.random, kSolveDepth));
}
BENCHMARK(greedy_start);

void steepest_edge_start(benchmark::State& state) {
  Scene scene;
  for (auto _ : state) benchmark::DoNotOptimize(steepest_edge_folds(*scene.dual, scene.model, scene.random));
}
BENCHMARK(steepest_edge_start);

void try_exchange(benchmark::State& state, int limit) {
  Scene scene;
  for (auto _ : state) benchmark::DoNotOptimize(scene.state.count_after(scene.exchange(), limit));
}
BENCHMARK_CAPTURE(try_exchange, bounded, 3);
BENCHMARK_CAPTURE(try_exchange, full, 1 << 29);

void move(benchmark::State& state) {
  Scene scene;
  for (auto _ : state) scene.state.apply(scene.exchange());
}
BENCHMARK(move);

void compare_boxes(benchmark::State& state) {
  const BoxKernel& kernel = box_kernels()[static_cast<std::size_t>(state.range(0)) % box_kernels().size()];
  Random random(2);
  BoxLanes lanes;
  lanes.resize(800);
  for (int i = 0; i < 800; ++i) {
    const double x = 100 * random.unit();
    const double y = 100 * random.unit();
    lanes.set(i, BoxF::around(x, y, x + 1, y + 1));
  }
  std::vector<int> found(lanes.min_x.size());
  for (auto _ : state) benchmark::DoNotOptimize(kernel.find(lanes, lanes.get(7), found.data()));
  state.SetLabel(kernel.name);
}
BENCHMARK(compare_boxes)->DenseRange(0, 2);

void detect_all(benchmark::State& state) {
  Scene scene;
  for (auto _ : state) scene.state.recompute();
}
BENCHMARK(detect_all);

Net solved_net() {
  Scene scene;
  TabuSolver solver(*scene.dual, scene.model, SearchSettings::fast(), 1, 0);
  while (!solver.is_solved()) solver.step();
  WholeTree whole(scene.dual, FaceId());
  whole.set(scene.model, solver.best_folds());
  return whole.net();
}

void plain_detection(benchmark::State& state) {
  const Net net = solved_net();
  for (auto _ : state) benchmark::DoNotOptimize(find_overlaps(net, kSolveDepth));
}
BENCHMARK(plain_detection);

void lay_out(benchmark::State& state) {
  const Net net = solved_net();
  for (auto _ : state) benchmark::DoNotOptimize(layout(net.dual, net.tree));
}
BENCHMARK(lay_out);

void prove(benchmark::State& state) {
  const FlatNet net = to_flat_net(solved_net(), 1);
  for (auto _ : state) benchmark::DoNotOptimize(verify(net));
}
BENCHMARK(prove);

}  // namespace
}  // namespace netwright

BENCHMARK_MAIN();
