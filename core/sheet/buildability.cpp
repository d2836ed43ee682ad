// The thinnest neck is either a fold, whose ends both lie on the outline, or leads from a corner of the
// outline straight to one of its sides. Only pairs nearer than the best so far are followed through the
// paper.
#include "core/sheet/buildability.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <numeric>

#include "core/base/counted.h"
#include "core/base/predicates.h"
#include "core/unfold/fold.h"

namespace netwright {

namespace {

constexpr double kSharp = 20 * std::numbers::pi / 180;
constexpr double kNeedle = 10 * std::numbers::pi / 180;

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

class NeckFinder {
 public:
  explicit NeckFinder(const Net& net) : net_(net), mesh_(net.mesh()) {}

  /// In model units.
  Neck find() {
    best_.width_mm = std::numeric_limits<double>::infinity();
    for (const EdgeId e : mesh_.edges()) try_fold(e);
    for (const HalfedgeId h : mesh_.halfedges())
      if (is_outline(h)) sides_.push_back(h);
    before_ = IdVector<HalfedgeId, HalfedgeId>(mesh_.n_halfedges(), HalfedgeId());
    for (const HalfedgeId h : sides_) before_[next_side(h)] = h;
    try_corners();
    if (best_.faces.empty()) best_.width_mm = 0;
    return best_;
  }

 private:
  [[nodiscard]] bool is_fold(HalfedgeId h) const {
    return !mesh_.is_border(mesh_.edge(h)) &&
           (net_.tree.is_fold(mesh_, mesh_.edge(h)) || net_.dual->is_hidden(mesh_.edge(h)));
  }
  [[nodiscard]] bool is_outline(HalfedgeId h) const { return mesh_.face(h).is_valid() && !is_fold(h); }
  [[nodiscard]] glm::dvec2 begin(HalfedgeId h) const { return net_.corner(h); }
  [[nodiscard]] glm::dvec2 end(HalfedgeId h) const { return net_.corner(mesh_.next(h)); }

  [[nodiscard]] HalfedgeId next_side(HalfedgeId side) const {
    HalfedgeId h = mesh_.next(side);
    while (is_fold(h)) h = mesh_.next(mesh_.twin(h));
    return h;
  }

  void try_fold(EdgeId e) {
    const HalfedgeId h = mesh_.halfedge(e);
    if (!is_fold(h) || mesh_.length(e) >= best_.width_mm) return;
    best_ = {mesh_.length(e), {mesh_.face(h), mesh_.neighbour(h)}};
  }

  void try_corners() {
    std::vector<HalfedgeId> by_x = sides_;
    const auto low = [&](HalfedgeId h) { return std::min(begin(h).x, end(h).x); };
    std::ranges::sort(by_x, {}, low);
    double longest = 0;
    for (const HalfedgeId h : by_x) longest = std::max(longest, std::abs(end(h).x - begin(h).x));
    for (const HalfedgeId corner : sides_) {
      const double x = begin(corner).x;
      auto at = std::ranges::lower_bound(by_x, x - longest - best_.width_mm, {}, low);
      for (; at != by_x.end() && low(*at) <= x + best_.width_mm; ++at) try_pair(corner, *at);
    }
  }

  void try_pair(HalfedgeId corner, HalfedgeId side) {
    const HalfedgeId before = before_[corner];
    const bool is_neighbour = side == corner || side == before || side == next_side(corner) ||
                              (before.is_valid() && side == before_[before]);
    if (is_neighbour || net_.piece[mesh_.face(corner)] != net_.piece[mesh_.face(side)]) return;
    const glm::dvec2 from = begin(corner);
    const glm::dvec2 along = end(side) - begin(side);
    const double t = std::clamp(glm::dot(from - begin(side), along) / glm::dot(along, along), 0.0, 1.0);
    const glm::dvec2 to = begin(side) + t * along;
    const double distance = glm::distance(from, to);
    if (!(distance > 0) || distance >= best_.width_mm) return;
    std::vector<FaceId> faces;
    if (leads_through_paper(corner, side, to, faces)) best_ = {distance, std::move(faces)};
  }

  /// Does the segment leave the corner into one of the faces around it, and come out at the side?
  bool leads_through_paper(HalfedgeId corner, HalfedgeId side, glm::dvec2 to,
                           std::vector<FaceId>& faces) const {
    const glm::dvec2 from = begin(corner);
    HalfedgeId h = corner;
    while (!is_inside_corner(h, to - from)) {
      h = mesh_.prev(h);
      if (!is_fold(h)) return false;
      h = mesh_.twin(h);
      if (h == corner) return false;
    }
    HalfedgeId entered;
    FaceId f = mesh_.face(h);
    for (std::size_t step = 0; step < mesh_.n_faces(); ++step) {
      faces.push_back(f);
      if (f == mesh_.face(side)) return true;
      const HalfedgeId out = way_out(f, h, entered, from, to);
      if (!out.is_valid() || !is_fold(out)) return false;
      entered = mesh_.twin(out);
      f = mesh_.face(entered);
      h = HalfedgeId();
    }
    return false;
  }

  [[nodiscard]] bool is_inside_corner(HalfedgeId h, glm::dvec2 direction) const {
    const glm::dvec2 first = end(h) - begin(h);
    const glm::dvec2 last = begin(mesh_.prev(h)) - begin(h);
    const bool is_left = cross(first, direction) > 0;
    const bool is_right = cross(direction, last) > 0;
    return cross(first, last) > 0 ? is_left && is_right : is_left || is_right;
  }

  /// The side of the face that the segment crosses; not the one it came in by, nor those at its start.
  [[nodiscard]] HalfedgeId way_out(FaceId f, HalfedgeId corner, HalfedgeId entered, glm::dvec2 from,
                                   glm::dvec2 to) const {
    HalfedgeId out;
    double nearest = std::numeric_limits<double>::infinity();
    for (const HalfedgeId h : mesh_.halfedges(f)) {
      if (h == entered || (corner.is_valid() && (h == corner || h == mesh_.prev(corner)))) continue;
      const glm::dvec2 a = begin(h);
      const glm::dvec2 b = end(h);
      const double at_a = cross(to - from, a - from);
      const double at_b = cross(to - from, b - from);
      if ((at_a > 0) == (at_b > 0)) continue;
      const glm::dvec2 hit = a + (b - a) * (at_a / (at_a - at_b));
      const double t = glm::dot(hit - from, to - from) / glm::dot(to - from, to - from);
      if (t <= 0 || t >= nearest) continue;
      nearest = t;
      out = h;
    }
    return nearest <= 1 ? out : HalfedgeId();
  }

  const Net& net_;
  const Mesh& mesh_;
  Neck best_;
  std::vector<HalfedgeId> sides_;
  IdVector<HalfedgeId, HalfedgeId> before_;
};

void judge_edges(const Net& net, double scale, Buildability& judged) {
  const Mesh& mesh = net.mesh();
  judged.smallest_edge_mm = std::numeric_limits<double>::infinity();
  const IdVector<EdgeId, EdgeKind> kinds = edge_kinds(net);
  for (const EdgeId e : mesh.edges()) {
    const EdgeKind kind = kinds[e];
    if (kind == EdgeKind::Hidden) continue;
    const double length = mesh.length(e) * scale;
    if (length < judged.smallest_edge_mm) {
      judged.smallest_edge_mm = length;
      judged.smallest_edge = e;
    }
    judged.n_small_edges += length < kSmallEdge ? 1 : 0;
    judged.n_tiny_edges += length < kTinyEdge ? 1 : 0;
    const bool is_cut = kind == EdgeKind::Cut;
    if (is_cut || kind == EdgeKind::Border) judged.cuts_mm += is_cut ? 2 * length : length;
    if (is_cut) ++judged.n_cuts;
    if (kind == EdgeKind::Mountain || kind == EdgeKind::Valley) {
      ++judged.n_folds;
      judged.folds_mm += length;
    }
  }
}

void judge_corners(const Net& net, Buildability& judged) {
  const Mesh& mesh = net.mesh();
  judged.sharpest_corner_rad = std::numbers::pi;
  for (const HalfedgeId h : mesh.halfedges()) {
    const glm::dvec2 a = net.corner(mesh.next(h)) - net.corner(h);
    const glm::dvec2 b = net.corner(mesh.prev(h)) - net.corner(h);
    double angle = std::atan2(cross(a, b), glm::dot(a, b));
    if (angle < 0) angle += 2 * std::numbers::pi;
    if (angle >= judged.sharpest_corner_rad) continue;
    judged.sharpest_corner_rad = angle;
    judged.sharpest_corner = h;
  }
}

std::string mm_text(double mm) {
  char text[32];
  std::snprintf(text, sizeof text, mm < 100 ? "%.1f mm" : "%.0f mm", mm);
  return text;
}

std::string metres_text(double mm) {
  char text[32];
  std::snprintf(text, sizeof text, mm < 1000 ? "%.0f cm" : "%.1f m", mm < 1000 ? mm / 10 : mm / 1000);
  return text;
}

BuildLine::Grade grade_of(double value, double warned, double trouble) {
  using Grade = BuildLine::Grade;
  return value < trouble ? Grade::Trouble : value < warned ? Grade::Warning : Grade::Fact;
}

}  // namespace

Buildability judge(const Net& net, const PageLayout& layout) {
  Buildability judged;
  judge_edges(net, layout.scale, judged);
  judge_corners(net, judged);
  judged.neck = NeckFinder(net).find();
  judged.neck.width_mm *= layout.scale;
  judged.n_tabs = static_cast<int>(layout.tabs.tabs.size());
  judged.without_tab = layout.tabs.missing;
  judged.n_sheets = static_cast<int>(layout.pages.size());
  return judged;
}

std::vector<BuildLine> lines_of(const Buildability& judged, const Net& net) {
  using Grade = BuildLine::Grade;
  std::vector<BuildLine> lines;
  const Grade of_edge = grade_of(judged.smallest_edge_mm, kSmallEdge, kTinyEdge);
  lines.push_back({of_edge, "Smallest edge " + mm_text(judged.smallest_edge_mm), {judged.smallest_edge}, {}});
  if (judged.n_small_edges > 1)
    lines.push_back({Grade::Warning,
                     grouped(judged.n_small_edges) + " edges under " + mm_text(kSmallEdge),
                     {judged.smallest_edge},
                     {}});
  if (judged.sharpest_corner.is_valid()) {
    char degrees[32];
    std::snprintf(degrees, sizeof degrees, "%.0f°", judged.sharpest_corner_rad * 180 / std::numbers::pi);
    lines.push_back({grade_of(judged.sharpest_corner_rad, kSharp, kNeedle),
                     "Sharpest corner " + std::string(degrees),
                     {},
                     {net.mesh().face(judged.sharpest_corner)}});
  }
  if (!judged.neck.faces.empty())
    lines.push_back({grade_of(judged.neck.width_mm, kSmallEdge, kTinyEdge),
                     "Thinnest neck " + mm_text(judged.neck.width_mm),
                     {},
                     judged.neck.faces});
  std::string tabs = counted(judged.n_tabs, "tab", "tabs");
  const auto n_missing = static_cast<std::int64_t>(judged.without_tab.size());
  if (n_missing > 0) tabs += ", " + counted(n_missing, "cut", "cuts") + " without";
  lines.push_back({n_missing > 0 ? Grade::Warning : Grade::Fact, tabs, judged.without_tab, {}});
  lines.push_back(
      {Grade::Fact, counted(judged.n_folds, "fold", "folds") + ", " + metres_text(judged.folds_mm), {}, {}});
  lines.push_back({Grade::Fact,
                   counted(judged.n_cuts, "cut", "cuts") + ", " + metres_text(judged.cuts_mm) + " of outline",
                   {},
                   {}});
  lines.push_back({Grade::Fact, counted(judged.n_sheets, "sheet", "sheets") + " of paper", {}, {}});
  return lines;
}

}  // namespace netwright
