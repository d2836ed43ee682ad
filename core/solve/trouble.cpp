// Sums the collisions up, and tries pins out one after the other.
#include "core/solve/trouble.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/base/counted.h"

namespace netwright {

namespace {

// So many pins are tried one by one; of a hundred pins some are so far away that they hardly matter.
constexpr std::size_t kSinglePins = 24;
// The rounding of a few added angles.
constexpr double kAngleRounding = 1e-6;

using Counts = IdVector<FaceId, std::int64_t>;

/// Collisions of the search; where it never got as far as a move, what it was left with.
Counts collisions_of(const SolveResult& result) {
  Counts counts = result.collisions;
  const std::size_t n = result.net.mesh().n_faces();
  if (counts.size() == n && std::any_of(counts.begin(), counts.end(), [](auto c) { return c > 0; }))
    return counts;
  counts.assign(n, 0);
  for (const Overlap& overlap : result.overlaps) {
    ++counts[overlap.first];
    ++counts[overlap.second];
  }
  if (result.isolated_face.is_valid()) counts[result.isolated_face] += 1;
  return counts;
}

double angle_at(const Mesh& mesh, HalfedgeId h) {
  const glm::dvec3 out = mesh.position(mesh.next(h)) - mesh.position(h);
  const glm::dvec3 in = mesh.position(mesh.prev(h)) - mesh.position(h);
  return std::atan2(glm::length(glm::cross(out, in)), glm::dot(out, in));
}

/// Notched corners of concave faces have more than half a turn.
double inner_angle(const DualGraph& dual, HalfedgeId h) {
  const Mesh& mesh = dual.mesh();
  const glm::dvec2 out = dual.flat(mesh.next(h)) - dual.flat(h);
  const glm::dvec2 in = dual.flat(mesh.prev(h)) - dual.flat(h);
  const bool is_notch = out.x * in.y - out.y * in.x < 0;
  const double angle = angle_at(mesh, h);
  return is_notch ? 2 * std::numbers::pi - angle : angle;
}

std::vector<FaceId> hottest(const Counts& counts, std::int64_t total) {
  std::vector<FaceId> faces;
  for (const FaceId f : counts.ids())
    if (counts[f] > 0) faces.push_back(f);
  std::stable_sort(faces.begin(), faces.end(), [&](FaceId a, FaceId b) { return counts[a] > counts[b]; });
  std::int64_t sum = 0;
  std::size_t n = 0;
  while (n < faces.size() && 5 * sum < 4 * total) sum += counts[faces[n++]];
  faces.resize(n);
  return faces;
}

std::vector<ExcessPoint> excess_points(const DualGraph& dual, const Counts& counts, std::int64_t total,
                                       const std::vector<FaceId>& hot) {
  const Mesh& mesh = dual.mesh();
  IdVector<VertexId, double> angle(mesh.n_vertices(), 0);
  IdVector<VertexId, std::int64_t> sum(mesh.n_vertices(), 0);
  IdVector<VertexId, char> is_near(mesh.n_vertices(), 0);
  for (const HalfedgeId h : mesh.halfedges()) {
    angle[mesh.from(h)] += inner_angle(dual, h);
    sum[mesh.from(h)] += counts[mesh.face(h)];
  }
  for (const FaceId f : hot)
    for (const HalfedgeId h : mesh.halfedges(f)) is_near[mesh.from(h)] = 1;
  std::vector<ExcessPoint> points;
  for (const VertexId v : mesh.vertices())
    if (is_near[v] != 0 && angle[v] > 2 * std::numbers::pi + kAngleRounding)
      points.push_back({v, angle[v], static_cast<double>(sum[v]) / static_cast<double>(total)});
  std::stable_sort(points.begin(), points.end(),
                   [](const ExcessPoint& a, const ExcessPoint& b) { return a.share > b.share; });
  return points;
}

double heat_of(const Mesh& mesh, const Trouble& trouble, const Pin& pin) {
  double heat = 0;
  for (const FaceId f : faces_of(mesh, pin))
    if (f.index() < trouble.heat.size()) heat = std::max(heat, static_cast<double>(trouble.heat[f]));
  return heat;
}

class ReleaseSearch {
 public:
  ReleaseSearch(std::shared_ptr<const DualGraph> dual, const SolveOptions& options, const Trouble& trouble,
                Progress& progress)
      : dual_(std::move(dual)), options_(options), progress_(progress), pins_(pins_in(options.pins)) {
    const Mesh& mesh = dual_->mesh();
    std::stable_sort(pins_.begin(), pins_.end(), [&](const Pin& a, const Pin& b) {
      return heat_of(mesh, trouble, a) > heat_of(mesh, trouble, b);
    });
    options_.tabs.reset();
    options_.polish.reset();
    options_.max_iterations = iterations_for_a_try(mesh);
  }

  Releases run() {
    Releases found;
    if (pins_.empty() || !gives_net(pins_)) {
      found.are_innocent = !progress_.is_cancelled();
    } else {
      found.ways = single_ways();
      if (found.ways.empty() && !progress_.is_cancelled()) {
        released_ = pins_;
        put_back({pins_.rbegin(), pins_.rend()});
        found.ways.push_back(released_);
      }
    }
    found.was_cancelled = progress_.is_cancelled();
    return found;
  }

 private:
  bool gives_net(const std::vector<Pin>& released) {
    if (progress_.is_cancelled()) return false;
    SolveOptions options = options_;
    options.pins = without(options_.pins, released);
    return !find_contradiction(*dual_, options.pins) && solve(dual_, options, progress_).is_proved;
  }

  std::vector<std::vector<Pin>> single_ways() {
    std::vector<std::vector<Pin>> ways;
    const std::size_t n = std::min(pins_.size(), kSinglePins);
    for (std::size_t i = 0; i < n; ++i) {
      if (gives_net({pins_[i]})) ways.push_back({pins_[i]});
      progress_.set_fraction(static_cast<double>(i + 1) / static_cast<double>(n));
    }
    return ways;
  }

  // Halves that can stay pinned are told by one search each, so few culprits among many pins cost little.
  void put_back(const std::vector<Pin>& pins) {
    std::vector<Pin> fewer = released_;
    std::erase_if(fewer, [&](const Pin& p) { return std::find(pins.begin(), pins.end(), p) != pins.end(); });
    if (gives_net(fewer)) {
      released_ = fewer;
    } else if (pins.size() > 1) {
      const auto middle = pins.begin() + static_cast<std::ptrdiff_t>(pins.size() / 2);
      put_back({pins.begin(), middle});
      put_back({middle, pins.end()});
    }
  }

  std::shared_ptr<const DualGraph> dual_;
  SolveOptions options_;
  Progress& progress_;
  std::vector<Pin> pins_;
  std::vector<Pin> released_;
};

}  // namespace

Trouble find_trouble(const SolveResult& result) {
  Trouble trouble;
  trouble.is_impossible = result.isolated_face.is_valid() || result.impossible != nullptr;
  const Counts counts = collisions_of(result);
  trouble.heat.assign(counts.size(), 0);
  const std::int64_t most = counts.empty() ? 0 : *std::max_element(counts.begin(), counts.end());
  if (most == 0) return trouble;
  for (const FaceId f : counts.ids())
    trouble.heat[f] = static_cast<float>(static_cast<double>(counts[f]) / static_cast<double>(most));
  const std::int64_t total = std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
  trouble.hot = hottest(counts, total);
  trouble.points = excess_points(*result.net.dual, counts, total, trouble.hot);
  return trouble;
}

std::vector<Pin> pins_in(const Constraints& pins) {
  std::vector<Pin> all;
  for (const EdgeId e : pins.must_fold) all.push_back({Pin::Kind::MustFold, e, {}});
  for (const EdgeId e : pins.must_cut) all.push_back({Pin::Kind::MustCut, e, {}});
  for (const auto& patch : pins.together) all.push_back({Pin::Kind::Patch, {}, patch});
  return all;
}

Constraints without(Constraints pins, const std::vector<Pin>& released) {
  for (const Pin& pin : released) {
    if (pin.kind == Pin::Kind::Patch) {
      std::erase(pins.together, pin.faces);
    } else {
      set_pin(pins, pin.edge, EdgePin::None);
    }
  }
  return pins;
}

std::vector<FaceId> faces_of(const Mesh& mesh, const Pin& pin) {
  if (pin.kind == Pin::Kind::Patch) return pin.faces;
  const HalfedgeId h = mesh.halfedge(pin.edge);
  std::vector<FaceId> faces{mesh.face(h)};
  if (mesh.neighbour(h).is_valid()) faces.push_back(mesh.neighbour(h));
  return faces;
}

Releases find_releases(const std::shared_ptr<const DualGraph>& dual, const SolveOptions& options,
                       const Trouble& trouble, Progress& progress) {
  return ReleaseSearch(dual, options, trouble, progress).run();
}

std::int64_t iterations_for_a_try(const Mesh& mesh) {
  return 2000 + 5 * static_cast<std::int64_t>(mesh.n_faces()) / 2;
}

std::string pin_words(const Mesh& mesh, const Pin& pin, const NumberOfFace& number) {
  const std::vector<FaceId> faces = faces_of(mesh, pin);
  if (pin.kind == Pin::Kind::Patch)
    return "the patch of " + counted(static_cast<std::int64_t>(faces.size()), "face", "faces") + " at face " +
           grouped(number(faces.front()));
  const std::string what = pin.kind == Pin::Kind::MustFold ? "must-fold" : "must-cut";
  return "the " + what + " between faces " + grouped(number(faces.front())) + " and " +
         grouped(number(faces.back()));
}

std::string pins_words(const Mesh& mesh, const std::vector<Pin>& pins, const NumberOfFace& number) {
  std::string text;
  for (std::size_t i = 0; i < pins.size(); ++i) {
    if (i > 0) text += i + 1 == pins.size() ? " and " : ", ";
    text += pin_words(mesh, pins[i], number);
  }
  return text;
}

}  // namespace netwright
