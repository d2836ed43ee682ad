// What moved seams save: every model is unfolded and printed 300 mm high on A4, and the folds, labels
// (middles of glued edges) and tabs are counted that seams run through, with seams on a fixed grid at the
// angle that takes the fewest sheets, and as arrange() lays them. Usage: tiles_bench [--each]
// MODEL_OR_FOLDER…
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/base/best_angle.h"
#include "core/base/error.h"
#include "core/mesh/read.h"
#include "core/project/make_model.h"
#include "core/sheet/pages.h"
#include "core/solve/solve.h"
#include "tests/fixed_grid.h"

namespace netwright {
namespace {

namespace fs = std::filesystem;

constexpr double kHeight_mm = 300;
struct Count {
  std::size_t n_sheets = 0;
  long n_cut = 0;
};

struct Totals {
  std::size_t n_models = 0;
  Count fixed;
  Count moved;
  std::vector<double> seconds;
};

void measure(const fs::path& file, bool tells_each, Totals& totals) {
  Progress progress;
  const MadeModel made =
      make_model(std::make_shared<const PolygonSoup>(read_soup(file)), {}, nullptr, progress);
  if (!made.dual) return;
  const SolveResult result = solve(made.dual, {.seed = 0, .streams = 1, .threads = 1}, progress, {});
  if (!result.is_proved || result.net.n_pieces != 1) return;
  const auto start = std::chrono::steady_clock::now();
  const PageLayout layout = arrange(result.net, {}, {PrintSize::Kind::Height, kHeight_mm}, TabSettings());
  totals.seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  if (layout.pages.size() < 2) return;
  const PieceShapes shapes = piece_shapes(result.net, layout.scale, layout.tabs);
  const testing::FixedGrid grid = testing::on_a_fixed_grid(shapes.pieces.front(), possible_frames({}));
  const Count fixed{grid.n_sheets, grid.n_cut_marks};
  const Count moved{layout.pages.size(), testing::marks_cut(shapes, layout)};
  if (tells_each)
    std::printf("%-40s fixed %3zu sheets %5ld cut   moved %3zu sheets %5ld cut\n", file.filename().c_str(),
                fixed.n_sheets, fixed.n_cut, moved.n_sheets, moved.n_cut);
  ++totals.n_models;
  totals.fixed.n_sheets += fixed.n_sheets;
  totals.fixed.n_cut += fixed.n_cut;
  totals.moved.n_sheets += moved.n_sheets;
  totals.moved.n_cut += moved.n_cut;
}

}  // namespace
}  // namespace netwright

int main(int argc, char** argv) {
  using namespace netwright;
  Totals totals;
  bool tells_each = false;
  std::vector<std::filesystem::path> files;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--each") {
      tells_each = true;
    } else if (std::filesystem::is_directory(word)) {
      for (const auto& entry : std::filesystem::directory_iterator(word)) files.push_back(entry.path());
    } else {
      files.emplace_back(word);
    }
  }
  std::sort(files.begin(), files.end());
  for (const auto& file : files) {
    try {
      measure(file, tells_each, totals);
    } catch (const Error& error) {
      std::fprintf(stderr, "%s\n", error.what());
    }
  }
  std::sort(totals.seconds.begin(), totals.seconds.end());
  if (totals.n_models == 0) return 1;
  std::printf(
      "%zu tiled models: fixed grid %zu sheets, %ld marks cut; moved seams %zu sheets, %ld marks cut "
      "(%.0f %% fewer); arranging takes %.0f ms in the median, %.0f ms at most\n",
      totals.n_models, totals.fixed.n_sheets, totals.fixed.n_cut, totals.moved.n_sheets, totals.moved.n_cut,
      100.0 * (1 - static_cast<double>(totals.moved.n_cut) / static_cast<double>(totals.fixed.n_cut)),
      1000 * totals.seconds[totals.seconds.size() / 2], 1000 * totals.seconds.back());
  return 0;
}
