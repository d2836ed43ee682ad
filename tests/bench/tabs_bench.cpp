// Glue tabs over a corpus of solved nets at one height: how many of the cuts where one side alone has room
// for a 2 mm tab get one, how wide they are, whether any covers what it must not (by the tests' own check),
// and the CPU time. Usage: tabs_bench HEIGHT_MM MODEL_OR_FOLDER…
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <numeric>
#include <vector>

#include "core/base/cpu_time.h"
#include "core/base/error.h"
#include "core/mesh/read.h"
#include "core/project/make_model.h"
#include "core/solve/solve.h"
#include "tests/bench/models.h"
#include "tests/tab_check.h"

namespace netwright {
namespace {

namespace fs = std::filesystem;

struct Figures {
  int n_runs = 0;
  std::vector<double> seconds;
  int n_models = 0;
  int n_cuts = 0;
  int n_with_room = 0;
  int n_tabbed_with_room = 0;
  int n_missing = 0;
  int n_hopeless = 0;
  int n_landing = 0;
  double faults_mm2 = 0;
  std::vector<double> widths;
  std::vector<double> milliseconds;
};

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  return values[values.size() / 2];
}

void measure(const Net& net, double height_mm, Figures& figures) {
  const Mesh& mesh = net.mesh();
  const double scale = height_mm / mesh.height();
  const double start = thread_cpu_seconds();
  const GlueTabs tabs = place_tabs(net, scale, {});
  figures.milliseconds.push_back(1000 * (thread_cpu_seconds() - start));
  ++figures.n_models;
  const testing::TabFaults faults = testing::find_faults(net, scale, tabs);
  figures.faults_mm2 += faults.over_faces_mm2 + faults.over_tabs_mm2;
  std::vector<char> has_tab(mesh.n_edges(), 0);
  for (const GlueTab& tab : tabs.tabs) {
    has_tab[mesh.edge(tab.side).index()] = 1;
    figures.widths.push_back(tab.width_mm);
    figures.n_landing += tab.lands_inside ? 1 : 0;
  }
  figures.n_missing += static_cast<int>(tabs.missing.size());
  figures.n_hopeless += static_cast<int>(tabs.n_hopeless);
  const std::vector<testing::LaidFace> faces = testing::laid_faces(net, scale);
  for (const EdgeId e : mesh.edges()) {
    if (mesh.is_border(e) || net.tree.is_fold(mesh, e)) continue;
    ++figures.n_cuts;
    const HalfedgeId h = mesh.halfedge(e);
    if (!testing::has_room(net, scale, faces, h, kLeastTabWidth) &&
        !testing::has_room(net, scale, faces, mesh.twin(h), kLeastTabWidth))
      continue;
    ++figures.n_with_room;
    figures.n_tabbed_with_room += has_tab[e.index()];
  }
}

void run(const fs::path& path, double height_mm, bool with_aim, Figures& figures) {
  try {
    Progress progress;
    const auto soup = std::make_shared<const PolygonSoup>(read_soup(path));
    const std::shared_ptr<const DualGraph> dual = make_model(soup, {}, nullptr, progress).dual;
    SolveOptions options{.seed = 0, .streams = 1, .threads = 1};
    if (with_aim) options.tabs = TabAim{{}, [&](const Net& net) { return height_mm / net.mesh().height(); }};
    const SolveResult result = solve(dual, options, progress);
    ++figures.n_runs;
    figures.seconds.push_back(result.cpu_seconds);
    if (result.is_proved) measure(result.net, height_mm, figures);
  } catch (const Error& error) {
    std::fprintf(stderr, "%s: %s\n", path.c_str(), error.what());
  }
}

void print(Figures& figures) {
  const auto share = [](double part, double whole) { return whole > 0 ? 100 * part / whole : 0; };
  std::printf("  %d of %d proved, search median %.2f ms, mean %.2f ms CPU\n", figures.n_models,
              figures.n_runs, 1000 * median(figures.seconds),
              1000 * std::accumulate(figures.seconds.begin(), figures.seconds.end(), 0.0) / figures.n_runs);
  std::printf("  %d cuts, %d with room, of these %.2f %% get a tab\n", figures.n_cuts, figures.n_with_room,
              share(figures.n_tabbed_with_room, figures.n_with_room));
  std::printf("  missing %d (%.2f %% of cuts, %d hopeless), landing inside %.2f %%, median width %.2f mm\n",
              figures.n_missing, share(figures.n_missing, figures.n_cuts), figures.n_hopeless,
              share(figures.n_landing, static_cast<double>(figures.widths.size())), median(figures.widths));
  std::printf("  covered by tabs %.3g mm2, CPU time median %.2f ms, most %.2f ms\n", figures.faults_mm2,
              median(figures.milliseconds),
              figures.milliseconds.empty() ? 0 : *std::ranges::max_element(figures.milliseconds));
}

}  // namespace
}  // namespace netwright

int main(int argc, char** argv) {
  using namespace netwright;
  if (argc < 3) {
    std::fprintf(stderr, "usage: tabs_bench HEIGHT_MM MODEL_OR_FOLDER...\n");
    return 1;
  }
  for (int i = 2; i < argc; ++i) {
    for (const bool with_aim : {false, true}) {
      Figures figures;
      for (const std::filesystem::path& model : testing::models_in(argv[i]))
        run(model, std::atof(argv[1]), with_aim, figures);
      std::printf("%s%s\n", argv[i], with_aim ? ", tabs counted in the search" : "");
      print(figures);
      std::fflush(stdout);
    }
  }
  return 0;
}
