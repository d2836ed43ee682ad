// What polish brings over a corpus: cuts, outline, necks and fill before and after, and how many nets fit a
// page at the largest size such that four fifths of the first nets do not. Usage: polish_bench HEIGHT_MM
// EFFORT MODEL_OR_FOLDER…, or polish_bench page EFFORT MODEL_OR_FOLDER….
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/base/cpu_time.h"
#include "core/base/error.h"
#include "core/base/polygon2.h"
#include "core/mesh/read.h"
#include "core/project/make_model.h"
#include "core/project/net_measures.h"
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

struct Measures {
  double cuts = 0;
  double hull_fill = 0;
  double box_fill = 0;
};

Measures measures_of(const Net& net) {
  const NetMeasures measured = measure(net);
  double paper = 0;
  for (const FaceId f : net.mesh().faces()) paper += net.mesh().area(f);
  double hulls = 0;
  for (const std::vector<glm::dvec2>& hull : measured.hulls) hulls += std::abs(signed_area(hull));
  return {measured.cut_length, paper / hulls, measured.fill};
}

struct Figures {
  int n_models = 0;
  int n_proved = 0;
  int necks_before = 0;
  int necks_after = 0;
  std::vector<double> cuts;
  std::vector<double> hull;
  std::vector<double> box;
  std::vector<double> area;
  std::vector<double> seconds;
};

std::shared_ptr<const DualGraph> model_in(const fs::path& path) {
  Progress progress;
  const auto soup = std::make_shared<const PolygonSoup>(read_soup(path));
  return make_model(soup, {}, nullptr, progress).dual;
}

void add(const fs::path& path, double height_mm, double effort, Figures& figures) {
  const auto dual = model_in(path);
  SolveOptions options{.seed = 0, .streams = 1, .threads = 1};
  const double scale = height_mm / dual->mesh().height();
  options.polish = PolishAim{{.effort = effort}, [=](const Net&) { return scale; }, {}, {}};
  Progress progress;
  const SolveResult result = solve(dual, options, progress);
  ++figures.n_models;
  if (!result.is_proved) return;
  ++figures.n_proved;
  const Measures before = measures_of(layout(dual, result.polished->first));
  const Measures after = measures_of(result.net);
  figures.cuts.push_back(after.cuts / before.cuts);
  figures.hull.push_back(after.hull_fill / before.hull_fill);
  figures.box.push_back(after.box_fill / before.box_fill);
  figures.area.push_back(before.box_fill / after.box_fill);
  figures.seconds.push_back(result.finish_seconds);
  figures.necks_before += result.polished->necks_before;
  figures.necks_after += result.polished->necks_after;
}

void print(const Figures& figures) {
  std::printf(
      "  %d of %d proved; medians, after by before: cuts %.3f, hull filled %.2f, rectangle filled %.2f, "
      "paper %.2f\n",
      figures.n_proved, figures.n_models, median(figures.cuts), median(figures.hull), median(figures.box),
      median(figures.area));
  std::printf("  necks under %.0f mm, all models: %d before, %d after; CPU time median %.2f s, most %.2f s\n",
              kNeckWidth, figures.necks_before, figures.necks_after, median(figures.seconds),
              figures.seconds.empty() ? 0 : *std::ranges::max_element(figures.seconds));
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
  if (argc < 4) {
    std::fprintf(stderr, "usage: polish_bench HEIGHT_MM|page EFFORT MODEL_OR_FOLDER...\n");
    return 1;
  }
  for (int i = 3; i < argc; ++i) {
    std::printf("%s\n", argv[i]);
    const std::vector<std::filesystem::path> models = testing::models_in(argv[i]);
    if (std::strcmp(argv[1], "page") == 0) {
      run_page(models, std::atof(argv[2]));
      continue;
    }
    Figures figures;
    for (const std::filesystem::path& model : models) {
      try {
        add(model, std::atof(argv[1]), std::atof(argv[2]), figures);
      } catch (const Error& error) {
        std::fprintf(stderr, "%s: %s\n", model.c_str(), error.what());
      }
    }
    print(figures);
  }
  return 0;
}
