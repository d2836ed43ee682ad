// The collapses themselves: a queue of edges by cost, the rules that say which of them may go, and the record
// of what was done. Works on coordinates scaled to a diagonal of 1, so that its limits are shares of that.
#include "core/mesh/simplify_collapse.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <queue>
#include <tuple>

#include "core/mesh/simplify_crossing.h"
#include "core/mesh/simplify_guards.h"
#include "core/mesh/simplify_looks.h"
#include "core/mesh/simplify_quadric.h"
#include "core/mesh/simplify_surface.h"

namespace netwright::simplify {
namespace {

// What it costs, besides the error, that a point stands for faces far away from it. It spreads the points of
// flat regions evenly and is outweighed by the slightest slope.
constexpr double kSpread = 1e-5;

// Planes that stand on borders and kept edges, per squared length of the edge, against area for faces.
constexpr double kBorderWeight = 4.0;
constexpr double kSeamWeight = 0.5;

// When nothing more is possible the next, weaker limits are tried. The last ones still refuse what Mesh would
// refuse and what turns over.
constexpr std::array<Limits, 4> kLimits{
    {{0.4, 0.08, -0.8}, {0.2, 0.03, -0.9}, {0.05, 0.01, -0.97}, {0.0, 0.002, -0.995}}};

class Collapser {
 public:
  Collapser(const Mesh& mesh, const SimplifyOptions& options, Progress& progress)
      : mesh_(mesh), options_(options), progress_(progress), s_(mesh), looks_(mesh, s_) {
    scale_to_one();
    mark_kept_edges();
    add_quadrics();
    crossing_.rebuild(s_);
    begin_history();
  }

  CollapseHistory run();

 private:
  struct Candidate {
    double cost;
    int halfedge;
    int version;
    bool operator>(const Candidate& o) const {
      return std::tie(cost, halfedge, version) > std::tie(o.cost, o.halfedge, o.version);
    }
  };
  struct Plan {
    glm::dvec3 position{0};
    double cost = 0;
    bool is_allowed = false;
  };

  void scale_to_one();
  void mark_kept_edges();
  void add_quadrics();
  void begin_history();
  void add_standing_plane(HalfedgeId h, double weight);

  [[nodiscard]] HalfedgeId canonical(HalfedgeId h) const {
    const HalfedgeId t = s_.twin[h];
    return t.is_valid() && t < h ? t : h;
  }
  [[nodiscard]] Plan plan(HalfedgeId h) const;
  [[nodiscard]] bool find_place(HalfedgeId h, glm::dvec3& place) const;
  void push(HalfedgeId h);
  bool refill();
  bool is_good(HalfedgeId h, const glm::dvec3& place);
  void collapse(HalfedgeId h, const glm::dvec3& place);
  void record(HalfedgeId h, const glm::dvec3& place);
  void break_polygons(VertexId v);
  void wake(VertexId v);

  const Mesh& mesh_;
  const SimplifyOptions& options_;
  Progress& progress_;
  TriangleSurface s_;
  Looks looks_;
  CrossingGuard crossing_;
  glm::dvec3 centre_{0};
  double scale_ = 1;
  IdVector<VertexId, Quadric> quadric_;
  IdVector<VertexId, Spread> spread_;
  IdVector<VertexId, int> n_kept_edges_;  ///< kept edges that end at the point
  IdVector<HalfedgeId, char> is_kept_;
  IdVector<HalfedgeId, int> version_;
  IdVector<HalfedgeId, char> is_blocked_;
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> queue_;
  std::vector<RingFace> ring_;
  std::size_t stage_ = 0;
  int steps_at_refill_ = 0;
  int n_live_triangles_ = 0;

  CollapseHistory history_;
  IdVector<VertexId, int> point_;       ///< of the history, for each point of the surface
  IdVector<FaceId, int> triangles_of_;  ///< how many the mesh's face was cut into
};

void Collapser::scale_to_one() {
  centre_ = mesh_.box().centre();
  scale_ = mesh_.box().diagonal();
  history_.position = s_.position.raw();
  for (glm::dvec3& p : s_.position) p = (p - centre_) / scale_;
}

void Collapser::mark_kept_edges() {
  is_kept_.assign(s_.from.size(), 0);
  n_kept_edges_.assign(s_.position.size(), 0);
  const double sharp_cosine = std::cos(options_.sharp_angle_rad);
  for (const HalfedgeId h : s_.from.ids()) {
    const HalfedgeId t = s_.twin[h];
    bool is_kept = !t.is_valid() || (options_.keep_uv_seams && looks_.is_seam(s_, h));
    if (!is_kept && options_.keep_sharp_edges)
      is_kept =
          glm::dot(unit_normal(s_.corners(s_.face(h))), unit_normal(s_.corners(s_.face(t)))) <= sharp_cosine;
    is_kept_[h] = is_kept ? 1 : 0;
    if (!is_kept || (t.is_valid() && t < h)) continue;
    ++n_kept_edges_[s_.from[h]];
    ++n_kept_edges_[s_.to(h)];
  }
}

// A plane on the edge, upright on its face, so that points of the edge stay on its line.
void Collapser::add_standing_plane(HalfedgeId h, double weight) {
  const glm::dvec3 a = s_.position[s_.from[h]];
  const glm::dvec3 side = s_.position[s_.to(h)] - a;
  const glm::dvec3 upright = glm::cross(side, unit_normal(s_.corners(s_.face(h))));
  const double length = glm::length(upright);
  if (!(length > 0)) return;
  const Quadric q = Quadric::plane(upright / length, a, weight * glm::dot(side, side));
  quadric_[s_.from[h]] += q;
  quadric_[s_.to(h)] += q;
}

void Collapser::add_quadrics() {
  quadric_.assign(s_.position.size(), Quadric());
  spread_.assign(s_.position.size(), Spread());
  for (const FaceId f : s_.faces()) {
    const auto p = s_.corners(f);
    const glm::dvec3 n = glm::cross(p[1] - p[0], p[2] - p[0]);
    const double twice_area = glm::length(n);
    if (!(twice_area > 0)) continue;
    const Quadric q = Quadric::plane(n / twice_area, p[0], twice_area / 2);
    const Spread spread = Spread::point((p[0] + p[1] + p[2]) / 3.0, twice_area / 2);
    for (const HalfedgeId h : s_.halfedges(f)) {
      quadric_[s_.from[h]] += q;
      spread_[s_.from[h]] += spread;
    }
  }
  for (const HalfedgeId h : s_.from.ids()) {
    if (!s_.twin[h].is_valid())
      add_standing_plane(h, kBorderWeight);
    else if (looks_.is_seam(s_, h))
      add_standing_plane(h, kSeamWeight);
  }
}

void Collapser::begin_history() {
  const std::size_t n = s_.polygon.size();
  triangles_of_.assign(mesh_.n_faces(), 0);
  for (const FaceId f : s_.faces()) {
    history_.polygon.push_back(s_.polygon[f].value);
    ++triangles_of_[s_.polygon[f]];
  }
  for (const VertexId v : s_.from) history_.leaf.push_back(v.value);
  history_.death.assign(n, CollapseHistory::kNever);
  history_.heir.assign(n, -1);
  history_.n_leaves = static_cast<int>(s_.position.size());
  history_.parent.assign(s_.position.size(), -1);
  history_.broken_at.assign(mesh_.n_faces(), CollapseHistory::kNever);
  for (const FaceId f : mesh_.faces())
    if (mesh_.degree(f) == 3) history_.broken_at[f.index()] = 0;
  history_.n_faces_at.push_back(static_cast<int>(mesh_.n_faces()));
  looks_.begin(history_);
  point_.resize(s_.position.size());
  for (const VertexId v : s_.position.ids()) point_[v] = v.value;
  version_.assign(s_.from.size(), 0);
  is_blocked_.assign(s_.from.size(), 0);
  n_live_triangles_ = static_cast<int>(n);
}

// Where the merged point goes: a corner of kept edges stays, a point of one only moves along it, and what is
// free takes the place of least error.
bool Collapser::find_place(HalfedgeId h, glm::dvec3& place) const {
  const VertexId a = s_.from[h];
  const VertexId b = s_.to(h);
  const bool a_is_fixed = n_kept_edges_[a] != 0 && (n_kept_edges_[a] != 2 || is_kept_[h] == 0);
  const bool b_is_fixed = n_kept_edges_[b] != 0 && (n_kept_edges_[b] != 2 || is_kept_[h] == 0);
  if (a_is_fixed && b_is_fixed) return false;
  const glm::dvec3 pa = s_.position[a];
  const glm::dvec3 pb = s_.position[b];
  if (a_is_fixed || b_is_fixed) {
    place = a_is_fixed ? pa : pb;
    return true;
  }
  Quadric q = quadric_[a];
  q += quadric_[b];
  const glm::dvec3 middle = (pa + pb) / 2.0;
  const double reach = 2 * glm::distance(pa, pb);
  place = q.minimise(middle);
  if (glm::distance(place, middle) <= reach) return true;
  place = middle;
  for (const glm::dvec3& end : {pa, pb})
    if (q(end) < q(place)) place = end;
  return true;
}

Collapser::Plan Collapser::plan(HalfedgeId h) const {
  Plan result;
  result.is_allowed = find_place(h, result.position);
  if (!result.is_allowed) return result;
  Quadric q = quadric_[s_.from[h]];
  q += quadric_[s_.to(h)];
  Spread spread = spread_[s_.from[h]];
  spread += spread_[s_.to(h)];
  const double error = std::max(0.0, q(result.position)) + kSpread * std::max(0.0, spread(result.position));
  // Between the sum of the errors, which lets small features go early, and their mean, which forgets how much
  // surface there is: over the power 3/4 of the area, which gave the least deviations.
  const double root = std::sqrt(spread.weight);
  result.cost = root > 0 ? error / (root * std::sqrt(root)) : 0;
  return result;
}

void Collapser::push(HalfedgeId h) {
  const HalfedgeId c = canonical(h);
  ++version_[c];
  is_blocked_[c] = 0;
  const Plan p = plan(c);
  if (p.is_allowed) queue_.push({p.cost, c.value, version_[c]});
}

// When the queue has run dry: all edges once more, with weaker limits when the last round changed nothing.
bool Collapser::refill() {
  if (history_.n_steps == steps_at_refill_ && ++stage_ == kLimits.size()) return false;
  steps_at_refill_ = history_.n_steps;
  for (const HalfedgeId h : s_.from.ids())
    if (s_.is_dead[s_.face(h)] == 0 && canonical(h) == h) push(h);
  return true;
}

bool Collapser::is_good(HalfedgeId h, const glm::dvec3& place) {
  if (!s_.may_collapse(h)) return false;
  // A face between three kept edges would make one line of two.
  for (const HalfedgeId side : {h, s_.twin[h]})
    if (side.is_valid() && is_kept_[s_.next(side)] != 0 && is_kept_[s_.prev(side)] != 0) return false;
  gather_ring(s_, h, place, ring_);
  if (ring_.empty() || !keeps_shape(ring_, kLimits[stage_]) ||
      !stays_unfolded(s_, h, place, ring_, kLimits[stage_]))
    return false;
  return !crossing_.would_cross(s_, h, ring_);
}

void Collapser::break_polygons(VertexId v) {
  s_.for_each_out(v, [&](HalfedgeId k) {
    const FaceId f = s_.polygon[s_.face(k)];
    int& broken = history_.broken_at[f.index()];
    if (broken != CollapseHistory::kNever) return;
    broken = history_.n_steps + 1;
    history_.n_faces_at.back() += triangles_of_[f] - 1;
  });
}

void Collapser::record(HalfedgeId h, const glm::dvec3& place) {
  const VertexId a = s_.from[h];
  const VertexId b = s_.to(h);
  history_.n_faces_at.push_back(history_.n_faces_at.back());
  break_polygons(a);
  break_polygons(b);
  for (const HalfedgeId side : {h, s_.twin[h]}) {
    if (!side.is_valid()) continue;
    const FaceId f = s_.face(side);
    const HalfedgeId left = s_.twin[s_.next(side)];
    const HalfedgeId right = s_.twin[s_.prev(side)];
    const glm::dvec3 n = unit_normal(s_.corners(f));
    const auto likeness = [&](HalfedgeId k) {
      return k.is_valid() ? glm::dot(n, unit_normal(s_.corners(s_.face(k)))) : -2.0;
    };
    const HalfedgeId heir = likeness(left) >= likeness(right) ? left : right;
    history_.death[f.index()] = history_.n_steps;
    history_.heir[f.index()] = s_.face(heir).value;
    --history_.n_faces_at.back();
    --n_live_triangles_;
  }
  const int made = static_cast<int>(history_.parent.size());
  for (const VertexId v : {a, b}) history_.parent[static_cast<std::size_t>(point_[v])] = made;
  history_.parent.push_back(-1);
  glm::dvec3 model_place = place * scale_ + centre_;
  for (const VertexId v : {a, b})
    if (place == s_.position[v]) model_place = history_.position[static_cast<std::size_t>(point_[v])];
  history_.position.push_back(model_place);
  point_[a] = made;
  looks_.merge(s_, h, place, history_);
  ++history_.n_steps;
}

// Edges around a neighbour of what changed may be possible now that were not before.
void Collapser::wake(VertexId v) {
  s_.for_each_neighbour(v, [&](VertexId w) {
    s_.for_each_out(w, [&](HalfedgeId k) {
      for (const HalfedgeId side : {k, s_.prev(k)})
        if (is_blocked_[canonical(side)] != 0) push(side);
    });
  });
  s_.for_each_out(v, [&](HalfedgeId k) {
    push(k);
    if (!s_.twin[s_.prev(k)].is_valid()) push(s_.prev(k));
  });
}

void Collapser::collapse(HalfedgeId h, const glm::dvec3& place) {
  record(h, place);
  const VertexId a = s_.from[h];
  const VertexId b = s_.to(h);
  for (const HalfedgeId side : {h, s_.twin[h]}) {
    if (!side.is_valid()) continue;
    const HalfedgeId left = s_.twin[s_.next(side)];
    const HalfedgeId right = s_.twin[s_.prev(side)];
    const char is_kept = is_kept_[s_.next(side)] | is_kept_[s_.prev(side)];
    if (left.is_valid()) is_kept_[left] = is_kept;
    if (right.is_valid()) is_kept_[right] = is_kept;
  }
  n_kept_edges_[a] += n_kept_edges_[b] - (is_kept_[h] != 0 ? 2 : 0);
  quadric_[a] += quadric_[b];
  spread_[a] += spread_[b];
  s_.position[a] = place;
  s_.collapse(h);
  crossing_.update(s_, a, n_live_triangles_);
  wake(a);
}

CollapseHistory Collapser::run() {
  const int least = std::max(4, options_.least_faces);
  const int first = history_.n_faces_at.front();
  for (const HalfedgeId h : s_.from.ids())
    if (canonical(h) == h) push(h);
  int n_tries = 0;
  while (history_.n_faces_at.back() > least) {
    if (++n_tries % 64 == 0) {
      if (progress_.is_cancelled()) break;
      progress_.set_fraction(static_cast<double>(first - history_.n_faces_at.back()) /
                             static_cast<double>(first - least));
    }
    if (queue_.empty() && !refill()) break;
    if (queue_.empty()) continue;
    const Candidate candidate = queue_.top();
    queue_.pop();
    const HalfedgeId h(candidate.halfedge);
    if (s_.is_dead[s_.face(h)] != 0 || version_[h] != candidate.version || canonical(h) != h) continue;
    const Plan p = plan(h);
    if (p.is_allowed && is_good(h, p.position))
      collapse(h, p.position);
    else
      is_blocked_[h] = 1;
  }
  return std::move(history_);
}

}  // namespace

CollapseHistory collapse_all(const Mesh& mesh, const SimplifyOptions& options, Progress& progress) {
  return Collapser(mesh, options, progress).run();
}

}  // namespace netwright::simplify
