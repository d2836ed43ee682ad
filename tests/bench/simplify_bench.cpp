// Simplifying and flattening, with times and deviations, beside OpenMesh's decimater in the same run (Debian
// package libopenmesh-apps; its columns stay empty where it is not installed). Usage:
// simplify_bench FACES MODEL…, each model simplified to FACES faces, or flattened where its faces are uneven.
// FACES 0 measures the slider instead: how long the next mesh takes once the simplifier is there.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/cpu_time.h"
#include "core/base/error.h"
#include "core/base/subprocess.h"
#include "core/mesh/deviation.h"
#include "core/mesh/planarize.h"
#include "core/mesh/read.h"
#include "core/mesh/repair.h"
#include "core/mesh/simplify.h"
#include "core/project/make_model.h"

namespace netwright {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPeer = "/usr/bin/OpenMesh-commandlineDecimater";
constexpr double kPeerSeconds = 300;

struct Figures {
  int faces = 0;
  double seconds = 0;
  double deviation_percent = 0;  ///< Hausdorff distance, share of the diagonal
};

double percent_of(const Mesh& mesh, double distance) {
  return 100 * distance / glm::length(mesh.box().size());
}

Figures our_figures(const std::shared_ptr<const Mesh>& mesh, int faces) {
  Progress progress;
  const double before = thread_cpu_seconds();
  SimplifyOptions options;
  options.least_faces = faces;
  const Simplifier simplifier(mesh, options, progress);
  const PolygonSoup soup = simplifier.soup_at(faces);
  Figures figures{soup.n_faces(), thread_cpu_seconds() - before, 0};
  figures.deviation_percent = percent_of(*mesh, hausdorff_distance(SurfaceTree(*mesh), SurfaceTree(soup)));
  return figures;
}

// Its goal is a number of points: a triangle mesh has V = F/2 + its Euler characteristic (closed ones).
std::optional<Figures> peer_figures(const fs::path& model, const Mesh& mesh, int faces) {
  if (!fs::exists(kPeer)) return std::nullopt;
  const fs::path out = fs::temp_directory_path() / "netwright_simplify_bench.obj";
  fs::remove(out);
  const int points = faces / 2 + 2 - 2 * mesh.genus();
  const auto before = std::chrono::steady_clock::now();
  const ChildResult child = run_child(
      kPeer, {"-M", "Q", "-M", "NF", "-n", std::to_string(-points), "-i", model.string(), "-o", out.string()},
      "", {.seconds = kPeerSeconds});
  // With reading and writing its files.
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
  if (child.end != ChildResult::End::Exited || !fs::exists(out)) return std::nullopt;
  const PolygonSoup soup = read_soup(out);
  fs::remove(out);
  return Figures{soup.n_faces(), seconds,
                 percent_of(mesh, hausdorff_distance(SurfaceTree(mesh), SurfaceTree(soup)))};
}

void flatten(const Mesh& mesh) {
  Progress progress;
  const double before = thread_cpu_seconds();
  const PlanarizeResult flat = planarize(mesh, {}, progress);
  std::printf(
      "%-28s %6zu faces flattened: unevenness %.2g to %.2g, %.3f s, moved %.2f %%, surface %.2f %%%s\n",
      mesh.name().c_str(), mesh.n_faces(), flat.unevenness_before, flat.unevenness_after,
      thread_cpu_seconds() - before, 100 * flat.moved_share, 100 * flat.hausdorff_share,
      flat.has_converged ? "" : " (not converged)");
}

struct Sums {
  int n = 0;
  double ours = 0;
  double peer = 0;
};

void simplify(const fs::path& path, const std::shared_ptr<const Mesh>& mesh, int faces, Sums& sums) {
  const Figures ours = our_figures(mesh, faces);
  std::printf("%-28s %6zu -> %4d faces %7.3f s %6.3f %%", mesh->name().c_str(), mesh->n_faces(), ours.faces,
              ours.seconds, ours.deviation_percent);
  if (const auto peer = peer_figures(path, *mesh, faces)) {
    std::printf("   OpenMesh -> %4d faces %7.3f s %6.3f %%", peer->faces, peer->seconds,
                peer->deviation_percent);
    ++sums.n;
    sums.ours += ours.deviation_percent;
    sums.peer += peer->deviation_percent;
  }
  std::printf("\n");
}

/// Stops of the slider all over its range, each as the editor makes it.
void slide(const fs::path& path, double& slowest) {
  constexpr int kStops = 60;
  const auto soup = std::make_shared<const PolygonSoup>(read_soup(path));
  Progress progress;
  Recipe recipe;
  recipe.faces = 20;
  const MadeModel first = make_model(soup, recipe, nullptr, progress);
  if (!first.dual) return;
  const auto all = static_cast<double>(first.stages->mesh->n_faces());
  std::vector<double> seconds;
  double measuring = 0;
  for (int i = 0; i < kStops; ++i) {
    recipe.faces = static_cast<int>(20 * std::pow(all / 20, static_cast<double>(i) / kStops));
    const double before = thread_cpu_seconds();
    const MadeModel next = make_model(soup, recipe, first.stages, progress);
    seconds.push_back(thread_cpu_seconds() - before);
    const double then = thread_cpu_seconds();
    static_cast<void>(measure_deviation(next, progress));
    measuring = std::max(measuring, thread_cpu_seconds() - then);
  }
  std::sort(seconds.begin(), seconds.end());
  slowest = std::max(slowest, seconds.back());
  std::printf("%-28s %6.0f faces: next mesh median %5.1f ms, slowest %5.1f ms; deviation up to %5.1f ms\n",
              soup->name.c_str(), all, 1e3 * seconds[kStops / 2], 1e3 * seconds.back(), 1e3 * measuring);
}

int slide_all(const std::vector<std::string>& paths) {
  double slowest = 0;
  for (const std::string& path : paths) {
    slide(path, slowest);
    std::fflush(stdout);
  }
  std::printf("slowest next mesh of all: %.1f ms\n", 1e3 * slowest);
  return 0;
}

int run(int faces, const std::vector<std::string>& paths) {
  Sums sums;
  for (const std::string& path : paths) {
    const PreparedModel model = prepare(read_soup(path));
    if (model.mesh == nullptr) {
      std::printf("%s\n", model.refusal.c_str());
    } else if (!model.is_fit()) {
      flatten(*model.mesh);
    } else if (static_cast<int>(model.mesh->n_faces()) > faces) {
      simplify(path, model.mesh, faces, sums);
    }
    std::fflush(stdout);
  }
  if (sums.n > 0)
    std::printf("mean deviation of %d models: %.3f %%, OpenMesh %.3f %%\n", sums.n, sums.ours / sums.n,
                sums.peer / sums.n);
  return 0;
}

}  // namespace
}  // namespace netwright

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.size() < 2) {
    std::fputs("Usage: simplify_bench FACES MODEL...\n", stderr);
    return 1;
  }
  try {
    const std::vector<std::string> models(arguments.begin() + 1, arguments.end());
    if (arguments[0] == "0") return netwright::slide_all(models);
    return netwright::run(std::stoi(arguments[0]), models);
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "%s\n", failure.what());
    return 1;
  }
}
