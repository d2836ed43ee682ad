// What pins cost: every model is unfolded without pins and with random ones, in one run, one stream on one
// thread, CPU time. Usage: pins_bench PINS ITERATIONS MODEL_OR_FOLDER…; PINS of each kind (must-fold,
// must-cut, patches of four faces) are drawn from a random spanning tree, besides a root.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <vector>

#include "core/base/error.h"
#include "core/mesh/read.h"
#include "core/project/make_model.h"
#include "core/solve/solve.h"
#include "tests/bench/models.h"
#include "tests/pins.h"

namespace netwright {
namespace {

namespace fs = std::filesystem;

struct Runs {
  int n = 0;
  int n_proved = 0;
  int n_broken = 0;  ///< results that do not keep their pins: has to stay 0
  std::vector<double> seconds;

  [[nodiscard]] double quantile(double share) {
    std::sort(seconds.begin(), seconds.end());
    return seconds.empty()
               ? 0
               : seconds[static_cast<std::size_t>(share * static_cast<double>(seconds.size() - 1))];
  }
};

void run(const std::shared_ptr<const DualGraph>& dual, const Constraints& pins, std::int64_t limit,
         Runs& runs) {
  SolveOptions options{.seed = 0, .streams = 1, .threads = 1, .max_iterations = limit};
  options.pins = pins;
  Progress progress;
  const SolveResult result = solve(dual, options, progress);
  ++runs.n;
  runs.n_proved += result.is_proved ? 1 : 0;
  const UnfoldTree& tree = result.net.tree;
  runs.n_broken +=
      keeps_pins(dual->mesh(), tree, pins) && (!pins.root.is_valid() || tree.is_root(pins.root)) ? 0 : 1;
  if (result.is_proved) runs.seconds.push_back(result.cpu_seconds);
}

void print(const char* name, Runs& runs, double median_free) {
  std::printf("%-10s %5d %8.1f %8d %9.3f %9.3f %9.3f %7.2f\n", name, runs.n, 100.0 * runs.n_proved / runs.n,
              runs.n_broken, 1e3 * runs.quantile(0.5), 1e3 * runs.quantile(0.95), 1e3 * runs.quantile(1),
              runs.quantile(0.5) / median_free);
}

}  // namespace
}  // namespace netwright

int main(int argc, char** argv) {
  using namespace netwright;
  if (argc < 4) {
    std::fprintf(stderr, "usage: pins_bench PINS ITERATIONS MODEL_OR_FOLDER...\n");
    return 1;
  }
  std::printf("%-10s %5s %8s %8s %9s %9s %9s %7s\n", "", "runs", "proved %", "broken", "median ms", "p95 ms",
              "max ms", "ratio");
  for (int i = 3; i < argc; ++i) {
    Runs free;
    Runs pinned;
    Random random(7);
    for (const fs::path& path : testing::models_in(argv[i])) {
      Progress progress;
      const auto soup = std::make_shared<const PolygonSoup>(read_soup(path));
      const MadeModel made = make_model(soup, {}, nullptr, progress);
      if (!made.dual) continue;
      run(made.dual, {}, std::atoll(argv[2]), free);
      run(made.dual, testing::random_pins(*made.dual, std::atoi(argv[1]), random), std::atoll(argv[2]),
          pinned);
    }
    if (free.n == 0) continue;
    const double median_free = free.quantile(0.5);
    std::printf("%s\n", argv[i]);
    print("free", free, median_free);
    print("pinned", pinned, median_free);
  }
}
