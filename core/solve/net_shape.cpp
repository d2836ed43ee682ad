// Sums along the preorder make the middle and the spread of any side of the tree a subtraction, so that an
// exchange can be judged before it is made.
#include "core/solve/net_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace netwright {

namespace {

constexpr double kStep = std::numbers::pi / Supports::kDirections;

// Distance of a point from a segment.
double distance_to(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
  const glm::dvec2 along = b - a;
  const double t = std::clamp(glm::dot(p - a, along) / glm::dot(along, along), 0.0, 1.0);
  return glm::distance(p, a + t * along);
}

// Calls visit(place) for the corners of the net. A convex face has its corners in the order of its sides: of
// those on the fold towards its parent the parent tells, or the parent's parent.
template <class Visit>
void visit_corners(const SearchState& state, Visit&& visit) {
  const SearchModel& m = state.model();
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  for (int f = 0; f < m.n_faces; ++f) {
    const int first = m.first_vert(f);
    const int n = m.last_vert(f) - first;
    const bool is_convex = m.part_begin[at(f) + 1] - m.part_begin[at(f)] == 1 &&
                           n == m.face_begin[at(f) + 1] - m.face_begin[at(f)];
    const int up = is_convex ? state.up(f) : -1;
    const int begin = up < 0 ? 0 : up - m.face_begin[at(f)] + 2;
    const int n_own = up < 0 ? n : n - 2;
    for (int i = begin; i < begin + n_own; ++i) visit(state.placed(first + (i < n ? i : i - n)));
  }
}

}  // namespace

Supports::Supports(const SearchState& state) {
  std::array<double, kDirections> cos{};
  std::array<double, kDirections> sin{};
  std::array<double, kDirections> high{};
  std::array<double, kDirections> low{};
  for (std::size_t k = 0; k < kDirections; ++k) {
    cos[k] = std::cos(kStep * static_cast<double>(k));
    sin[k] = std::sin(kStep * static_cast<double>(k));
  }
  high.fill(-std::numeric_limits<double>::infinity());
  low.fill(std::numeric_limits<double>::infinity());
  visit_corners(state, [&](glm::dvec2 p) {
    for (std::size_t k = 0; k < kDirections; ++k) {
      const double reach = cos[k] * p.x + sin[k] * p.y;
      high[k] = std::max(high[k], reach);
      low[k] = std::min(low[k], reach);
    }
  });
  for (std::size_t k = 0; k < kDirections; ++k) {
    reach_[k] = high[k];
    reach_[k + kDirections] = -low[k];
  }
}

double Supports::area() const {
  // A triangle from the origin over every side; a side ends where the neighbours' lines cross its own.
  const double cos = std::cos(kStep);
  double twice = 0;
  for (std::size_t k = 0; k < kSides; ++k) {
    const double before = reach_[(k + kSides - 1) % kSides];
    const double after = reach_[(k + 1) % kSides];
    twice += reach_[k] * (before + after - 2 * cos * reach_[k]);
  }
  return 0.5 * twice / std::sin(kStep);
}

double Supports::size_in(glm::dvec2 room) const {
  constexpr std::size_t kQuarter = kDirections / 2;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < kDirections; ++k) {
    const std::size_t across = (k + kQuarter) % kSides;
    const double width = reach_[k] + reach_[k + kDirections];
    const double height = reach_[across] + reach_[(across + kDirections) % kSides];
    least = std::min(least, std::max(width / room.x, height / room.y));
  }
  return least;
}

glm::dvec2 Supports::middle() const {
  constexpr std::size_t kUp = kDirections / 2;
  return 0.5 * glm::dvec2(reach_[0] - reach_[kDirections], reach_[kUp] - reach_[kUp + kDirections]);
}

NetShape::NetShape(const DualGraph& dual, const SearchModel& model, const SearchState& state,
                   double neck_width)
    : model_(&model),
      state_(&state),
      neck_width_(neck_width),
      before_(at(model.n_faces) + 1),
      may_be_narrow_(at(model.n_faces), 0) {
  for (const HalfedgeId h : model.mesh_halfedge) corners_.push_back(dual.flat(h) / dual.mesh().mean_edge());
  for (int f = 0; f < model.n_faces; ++f) add_face(f);
  disc_ = total_area_ * total_area_ / (2 * std::numbers::pi);
  refresh();
}

void NetShape::add_face(int f) {
  const SearchModel& m = *model_;
  Sums sums;
  for (int part = m.part_begin[at(f)]; part < m.part_begin[at(f) + 1]; ++part)
    for (int v = m.vert_begin[at(part)] + 1; v + 1 < m.vert_begin[at(part) + 1]; ++v) {
      const glm::dvec2 a = m.verts[at(m.vert_begin[at(part)])];
      const glm::dvec2 b = m.verts[at(v)];
      const glm::dvec2 c = m.verts[at(v) + 1];
      const double area = 0.5 * cross(b - a, c - a);
      const glm::dvec2 sum = a + b + c;
      sums.area += area;
      sums.first += area / 3 * sum;
      sums.second += area / 12 * (glm::dot(a, a) + glm::dot(b, b) + glm::dot(c, c) + glm::dot(sum, sum));
    }
  const glm::dvec2 middle = sums.first / sums.area;
  faces_.push_back({sums.area, middle, sums.second - sums.area * glm::dot(middle, middle)});
  total_area_ += sums.area;
  for (int corner = m.face_begin[at(f)]; corner < m.face_begin[at(f) + 1]; ++corner)
    for (int side = m.face_begin[at(f)]; side < m.face_begin[at(f) + 1]; ++side)
      if (is_narrow(f, corner, side)) may_be_narrow_[at(f)] = 1;
}

void NetShape::refresh() {
  for (int i = 0; i < model_->n_faces; ++i) {
    const int f = state_->face_at(i);
    const Sums& face = faces_[at(f)];
    const glm::dvec2 place = state_->placement(f)(face.first);
    Sums sums = before_[at(i)];
    sums.area += face.area;
    sums.first += face.area * place;
    sums.second += face.area * glm::dot(place, place) + face.second;
    before_[at(i) + 1] = sums;
  }
  const Sums& all = before_.back();
  moment_ = all.second - glm::dot(all.first, all.first) / all.area;
}

glm::dvec2 NetShape::middle() const { return before_.back().first / before_.back().area; }
glm::dvec2 NetShape::middle_of(int face) const { return state_->placement(face)(faces_[at(face)].first); }

double NetShape::spread_after(const Exchange& exchange) const {
  // Both sides stay as they are; only the distance of their middles changes.
  const Sums& all = before_.back();
  const double area = before_[at(exchange.last)].area - before_[at(exchange.first)].area;
  const glm::dvec2 first = before_[at(exchange.last)].first - before_[at(exchange.first)].first;
  const glm::dvec2 side = first / area;
  const glm::dvec2 rest = (all.first - first) / (all.area - area);
  const glm::dvec2 now = side - rest;
  const glm::dvec2 then = exchange.motion(side) - rest;
  const double change = glm::dot(then, then) - glm::dot(now, now);
  return (moment_ + area * (all.area - area) / all.area * change) / disc_;
}

bool NetShape::is_fold(int h, Swapped swapped) const {
  const int twin = model_->twin[at(h)];
  if (twin < 0) return false;
  if (h == swapped.removed || twin == swapped.removed) return false;
  return state_->is_fold(h) || h == swapped.inserted || twin == swapped.inserted;
}

// Is the corner nearer to the side than a neck is wide?
bool NetShape::is_narrow(int f, int corner, int side) const {
  const int first = model_->face_begin[at(f)];
  const int last = model_->face_begin[at(f) + 1];
  const int end = side + 1 < last ? side + 1 : first;
  if (corner == side || corner == end) return false;
  return distance_to(corners_[at(corner)], corners_[at(side)], corners_[at(end)]) < neck_width_;
}

// Does paper hang on both sides of a narrow place of the face? There has to be a fold on either way from the
// corner to the open side.
bool NetShape::is_neck(int f, Swapped swapped) const {
  if (may_be_narrow_[at(f)] == 0) return false;
  const int first = model_->face_begin[at(f)];
  const int n = model_->face_begin[at(f) + 1] - first;
  for (int side = 0; side < n; ++side) {
    if (is_fold(first + side, swapped)) continue;
    bool has_fold_before = false;
    for (int corner = (side + 2) % n; corner != side; corner = (corner + 1) % n) {
      has_fold_before = has_fold_before || is_fold(first + (corner + n - 1) % n, swapped);
      if (!has_fold_before || !is_narrow(f, first + corner, first + side)) continue;
      for (int after = corner; after != side; after = (after + 1) % n)
        if (is_fold(first + after, swapped)) return true;
    }
  }
  return false;
}

int NetShape::necks() const {
  int n = 0;
  for (int h = 0; h < model_->n_halfedges; ++h)
    if (model_->twin[at(h)] > h && state_->is_fold(h) && model_->edge_length[at(h)] < neck_width_) ++n;
  for (int f = 0; f < model_->n_faces; ++f) n += is_neck(f, {}) ? 1 : 0;
  return n;
}

int NetShape::neck_change(int removed, int inserted) const {
  int change = (model_->edge_length[at(inserted)] < neck_width_ ? 1 : 0) -
               (model_->edge_length[at(removed)] < neck_width_ ? 1 : 0);
  std::array<int, 4> faces{model_->face_of[at(removed)], model_->beyond(removed),
                           model_->face_of[at(inserted)], model_->beyond(inserted)};
  std::ranges::sort(faces);
  for (std::size_t i = 0; i < faces.size(); ++i)
    if (i == 0 || faces[i] != faces[i - 1])
      change += (is_neck(faces[i], {removed, inserted}) ? 1 : 0) - (is_neck(faces[i], {}) ? 1 : 0);
  return change;
}

}  // namespace netwright
