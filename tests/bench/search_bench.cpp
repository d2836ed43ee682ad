// What watching a search costs it: ten seeds on a bumpy patch of 800 faces, alone and with a
// reader who takes a snapshot sixty times a second. Compare the two CPU times of one run; the second may be
// at most 5 % more.
#include <benchmark/benchmark.h>

#include <chrono>

#include "core/base/cpu_time.h"
#include "core/base/random.h"
#include "core/base/worker.h"
#include "core/solve/solve.h"
#include "tests/support.h"

namespace netwright {
namespace {

constexpr auto kFrame = std::chrono::milliseconds(16);

// CPU seconds of one solver thread for a fixed amount of search.
double search_seconds(const std::shared_ptr<const DualGraph>& dual, bool is_watched,
                      std::int64_t& iterations) {
  Mailbox<Snapshot> mailbox;
  double seconds = 0;
  Worker worker;
  worker.submit(Worker::Lane::Search, [&](Progress& progress) {
    SolveOptions options;
    options.streams = 1;
    options.threads = 1;
    SolveHooks hooks;
    if (is_watched) hooks.snapshots = &mailbox;
    const double before = thread_cpu_seconds();
    iterations = 0;
    for (options.seed = 0; options.seed < 10; ++options.seed)
      iterations += solve(dual, options, progress, hooks).iterations;
    seconds = thread_cpu_seconds() - before;
  });
  while (!worker.is_idle(Worker::Lane::Search)) {
    std::this_thread::sleep_for(kFrame);
    benchmark::DoNotOptimize(mailbox.take());
  }
  return seconds;
}

// A patch of 800 faces with tiny random heights: full of saddles, so that the search takes thousands of
// iterations.
std::shared_ptr<const DualGraph> bumpy_terrain() {
  PolygonSoup soup = shapes::bumpy_patch(20, 20);
  Random random(1);
  for (glm::dvec3& p : soup.points) p.y = 0.05 * random.unit();
  return testing::make_dual(soup);
}

void search(benchmark::State& state, bool is_watched) {
  const auto dual = bumpy_terrain();
  std::int64_t iterations = 0;
  for (auto _ : state) state.SetIterationTime(search_seconds(dual, is_watched, iterations));
  state.counters["iterations"] = static_cast<double>(iterations);
}

BENCHMARK_CAPTURE(search, alone, false)->UseManualTime()->Unit(benchmark::kMillisecond)->Repetitions(5);
BENCHMARK_CAPTURE(search, watched_at_60_hz, true)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond)
    ->Repetitions(5);

}  // namespace
}  // namespace netwright

BENCHMARK_MAIN();
