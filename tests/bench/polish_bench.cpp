// How many nets fit a page when they are polished for it, at the largest size such that four fifths of the
// first nets do not. Usage: polish_bench EFFORT MODEL_OR_FOLDER…; what else polish brings, netwright-cli
// bench --polish tells.
#include <algorithm>
#include <cmath>
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

namespace netwright {
namespace {

namespace fs = std::filesystem;

constexpr glm::dvec2 kPage{190, 255};  ///< mm: what A4 leaves between its title and its legend

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  return values[values.size() / 2];
}

std::shared_ptr<const DualGraph> model_in(const fs::path& path) {
  Progress progress;
  const auto soup = std::make_shared<const PolygonSoup>(read_soup(path));
  return make_model(soup, {}, nullptr, progress).dual;
}

/// mm per model unit at which the model's whole surface takes this share of the page's area.
double scale_for(const Mesh& mesh, double share) {
  double area = 0;
  for (const FaceId f : mesh.faces()) area += mesh.area(f);
  return std::sqrt(share * kPage.x * kPage.y / area);
}

SolveResult polished_for_page(const std::shared_ptr<const DualGraph>& dual, double share, double effort) {
  SolveOptions options{.seed = 0, .streams = 1, .threads = 1};
  const double scale = scale_for(dual->mesh(), share);
  options.polish =
      PolishAim{{.effort = effort, .fits_paper = 1}, [=](const Net&) { return scale; }, {kPage}, {}};
  Progress progress;
  return solve(dual, options, progress);
}

/// The share of the page that the first net covers when it just fits it.
double fitting_share(const std::shared_ptr<const DualGraph>& dual) {
  const SolveResult result = polished_for_page(dual, 1, 1e-9);
  return result.is_proved ? 1 / (result.polished->size_before * result.polished->size_before) : 0;
}

/// All models at one size: the share of the page that their paper covers, such that it is too large for four
/// fifths of the first nets.
void run_page(const std::vector<fs::path>& models, double effort) {
  std::vector<double> shares;
  for (const fs::path& model : models) shares.push_back(fitting_share(model_in(model)));
  std::vector<double> sorted = shares;
  std::ranges::sort(sorted);
  const double share = sorted[sorted.size() * 4 / 5];
  int n_plain = 0;
  int n_fitting = 0;
  std::vector<double> seconds;
  for (std::size_t i = 0; i < models.size(); ++i) {
    const SolveResult result = polished_for_page(model_in(models[i]), share, effort);
    n_plain += shares[i] >= share ? 1 : 0;
    n_fitting += result.is_proved && result.polished->size_after <= 1 ? 1 : 0;
    seconds.push_back(result.finish_seconds);
  }
  std::printf(
      "  covering %.0f %% of the page %d of %zu first nets fit it, polished for it %d; CPU time "
      "median %.1f s, most %.1f s\n",
      100 * share, n_plain, models.size(), n_fitting, median(seconds), *std::ranges::max_element(seconds));
}

}  // namespace
}  // namespace netwright

int main(int argc, char** argv) {
  using namespace netwright;
  if (argc < 3) {
    std::fprintf(stderr, "usage: polish_bench EFFORT MODEL_OR_FOLDER...\n");
    return 1;
  }
  for (int i = 2; i < argc; ++i) {
    std::printf("%s\n", argv[i]);
    try {
      run_page(testing::models_in(argv[i]), std::atof(argv[1]));
    } catch (const Error& error) {
      std::fprintf(stderr, "%s\n", error.what());
    }
  }
  return 0;
}
