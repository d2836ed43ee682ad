// Ways of softening are tried at full strength first, then weaker and weaker by bisection; what was found
// bounds how far later ones may go, so that most of them are over after a single try.
#include "core/project/soften.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/mesh/deviation.h"
#include "core/project/carry_pins.h"

namespace netwright {

namespace {

constexpr int kBisections = 5;
// Too much of a good thing can turn the surface inside out: half and a quarter may help where all does not.
constexpr double kWeakestFirst = 4;
constexpr int kMostJoined = 8;
// A corner with less than this missing from a full turn is no peak.
constexpr double kPeakAngle = 0.3;

/// Corners and where they go at full strength.
struct Way {
  std::vector<VertexId> corners;
  std::vector<glm::dvec3> targets;
  bool is_whole = false;  ///< at full strength or not at all
};

class Softener {
 public:
  Softener(std::shared_ptr<const PolygonSoup> source, const Recipe& recipe, const MadeModel& made,
           const SolveOptions& options, const Trouble& trouble, double most, Progress& progress)
      : source_(std::move(source)),
        recipe_(recipe),
        made_(made),
        mesh_(made.dual->mesh()),
        options_(options),
        most_(most),
        progress_(progress) {
    options_.tabs.reset();
    options_.polish.reset();
    options_.from = nullptr;
    options_.stays_near = false;
    options_.max_iterations = iterations_for_a_try(mesh_);
    look_around(trouble);
  }

  Softening run() {
    const std::vector<Way> ways = all_ways();
    for (std::size_t i = 0; i < ways.size() && !progress_.is_cancelled(); ++i) {
      weaken(ways[i]);
      progress_.set_fraction(static_cast<double>(i + 1) / static_cast<double>(ways.size()));
    }
    const Progress measuring;
    if (best_.is_found())
      best_.deviation =
          hausdorff_distance(SurfaceTree(mesh_), SurfaceTree(best_.made->dual->mesh()), measuring);
    best_.was_cancelled = progress_.is_cancelled();
    return std::move(best_);
  }

 private:
  /// Heat, missing angle and the neighbours' mean of every corner.
  void look_around(const Trouble& trouble) {
    heat_.assign(mesh_.n_vertices(), 0);
    missing_.assign(mesh_.n_vertices(), 2 * std::numbers::pi);
    mean_.assign(mesh_.n_vertices(), glm::dvec3(0));
    IdVector<VertexId, int> n_neighbours(mesh_.n_vertices(), 0);
    for (const HalfedgeId h : mesh_.halfedges()) {
      const VertexId v = mesh_.from(h);
      heat_[v] += static_cast<double>(trouble.heat[mesh_.face(h)]);
      const glm::dvec3 out = mesh_.position(mesh_.next(h)) - mesh_.position(h);
      const glm::dvec3 in = mesh_.position(mesh_.prev(h)) - mesh_.position(h);
      missing_[v] -= std::atan2(glm::length(glm::cross(out, in)), glm::dot(out, in));
      for (const VertexId next : {mesh_.to(h), mesh_.from(mesh_.prev(h))}) {
        mean_[v] += mesh_.position(next);
        ++n_neighbours[v];
      }
    }
    for (const VertexId v : mesh_.vertices()) mean_[v] /= n_neighbours[v];
  }

  /// Corners of warm faces, those with the most heat and curvature first.
  template <class Wanted>
  [[nodiscard]] std::vector<VertexId> corners(const Wanted& is_wanted) const {
    std::vector<VertexId> found;
    for (const VertexId v : mesh_.vertices())
      if (heat_[v] > 0 && is_wanted(v)) found.push_back(v);
    std::stable_sort(found.begin(), found.end(), [&](VertexId a, VertexId b) {
      return heat_[a] * std::abs(missing_[a]) > heat_[b] * std::abs(missing_[b]);
    });
    return found;
  }

  [[nodiscard]] Way towards_mean(std::vector<VertexId> corners) const {
    Way way{std::move(corners), {}, false};
    for (const VertexId v : way.corners) way.targets.push_back(mean_[v]);
    return way;
  }

  /// The shortest edges of warm faces, apart from each other.
  [[nodiscard]] Way joined(int n) const {
    std::vector<EdgeId> edges;
    for (const EdgeId e : mesh_.edges())
      if (heat_[mesh_.from(mesh_.halfedge(e))] > 0 && heat_[mesh_.to(mesh_.halfedge(e))] > 0)
        edges.push_back(e);
    std::stable_sort(edges.begin(), edges.end(),
                     [&](EdgeId a, EdgeId b) { return mesh_.length(a) < mesh_.length(b); });
    Way way{{}, {}, true};
    IdVector<VertexId, char> is_taken(mesh_.n_vertices(), 0);
    for (const EdgeId e : edges) {
      const VertexId a = mesh_.from(mesh_.halfedge(e));
      const VertexId b = mesh_.to(mesh_.halfedge(e));
      if (is_taken[a] != 0 || is_taken[b] != 0 || n-- <= 0) continue;
      is_taken[a] = is_taken[b] = 1;
      const glm::dvec3 middle = (mesh_.position(a) + mesh_.position(b)) / 2.0;
      way.corners.insert(way.corners.end(), {a, b});
      way.targets.insert(way.targets.end(), {middle, middle});
    }
    return way;
  }

  /// What moves many corners first: it is the most likely to help.
  [[nodiscard]] std::vector<Way> all_ways() const {
    const auto is_peak = [&](VertexId v) { return missing_[v] > kPeakAngle; };
    const auto is_pit = [&](VertexId v) { return missing_[v] < 0; };
    std::vector<Way> ways;
    ways.push_back(towards_mean(corners([](VertexId /*v*/) { return true; })));
    ways.push_back(towards_mean(corners([&](VertexId v) { return is_peak(v) || is_pit(v); })));
    for (const auto& all : {corners(is_peak), corners(is_pit)}) {
      for (std::size_t n = all.size(); n > 0; n /= 2)
        ways.push_back(towards_mean({all.begin(), all.begin() + static_cast<std::ptrdiff_t>(n)}));
    }
    for (int n = 1; n <= kMostJoined; n *= 2) ways.push_back(joined(n));
    std::erase_if(ways, [](const Way& way) { return way.corners.empty(); });
    return ways;
  }

  [[nodiscard]] double reach(const Way& way) const {
    double farthest = 0;
    for (std::size_t i = 0; i < way.corners.size(); ++i)
      farthest = std::max(farthest, glm::distance(mesh_.position(way.corners[i]), way.targets[i]));
    return farthest;
  }

  /// The least strength at which this way helps, if it beats what was found before.
  void weaken(const Way& way) {
    const double farthest = reach(way);
    if (farthest <= 0 || (way.is_whole && farthest > most_)) return;
    double high = way.is_whole ? 1 : std::min(1.0, most_ / farthest);
    const double least = way.is_whole ? high : high / kWeakestFirst;
    while (high >= least && !helps(way, high)) high /= 2;
    if (high < least || progress_.is_cancelled()) return;
    most_ = high * farthest;
    double low = way.is_whole ? high : 0;
    for (int i = 0; i < kBisections && low < high && !progress_.is_cancelled(); ++i) {
      const double middle = (low + high) / 2;
      if (helps(way, middle)) {
        high = middle;
        most_ = high * farthest;
      } else {
        low = middle;
      }
    }
  }

  bool helps(const Way& way, double strength) {
    Recipe recipe = recipe_;
    for (std::size_t i = 0; i < way.corners.size(); ++i) {
      const glm::dvec3& from = mesh_.position(way.corners[i]);
      add_move(recipe.moved, from, from + strength * (way.targets[i] - from), way.targets[i], way.is_whole);
    }
    Progress making;
    auto made = std::make_shared<const MadeModel>(make_model(source_, recipe, made_.stages, making));
    if (!made->dual || made->n_moved != static_cast<int>(recipe.moved.size())) return false;
    SolveOptions options = options_;
    options.pins = carry_pins(options_.pins, mesh_, made->dual->mesh()).pins;
    if (find_contradiction(*made->dual, options.pins)) return false;
    if (!solve(made->dual, options, progress_).is_proved) return false;
    best_.recipe = std::move(recipe);
    best_.made = std::move(made);
    best_.n_moved = static_cast<int>(way.corners.size());
    return true;
  }

  /// A corner that was moved before goes on from where its file has it. Joined corners go to the very same
  /// place.
  static void add_move(std::vector<MovedCorner>& moved, const glm::dvec3& from, const glm::dvec3& there,
                       const glm::dvec3& target, bool is_whole) {
    const glm::dvec3 to = is_whole ? target : there;
    bool was_moved = false;
    for (MovedCorner& before : moved) {
      if (before.to != from) continue;
      before.to = to;
      was_moved = true;
    }
    if (!was_moved) moved.push_back({from, to});
  }

  std::shared_ptr<const PolygonSoup> source_;
  const Recipe& recipe_;
  const MadeModel& made_;
  const Mesh& mesh_;
  SolveOptions options_;
  double most_;
  Progress& progress_;
  IdVector<VertexId, double> heat_;
  IdVector<VertexId, double> missing_;  ///< from a full turn, radians
  IdVector<VertexId, glm::dvec3> mean_;
  Softening best_;
};

}  // namespace

Softening soften(const std::shared_ptr<const PolygonSoup>& source, const Recipe& recipe,
                 const MadeModel& made, const SolveOptions& options, const Trouble& trouble, double most,
                 Progress& progress) {
  return Softener(source, recipe, made, options, trouble, most, progress).run();
}

}  // namespace netwright
