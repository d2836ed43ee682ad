// The grid is made anew whenever half of the faces are gone, so that cells grow with the faces. Faces that
// moved stay in their old cells as well; their true boxes decide.
#include "core/mesh/simplify_crossing.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace netwright::simplify {
namespace {

constexpr int kMostCells = 64;  ///< along one axis

using Triangle = std::array<glm::dvec3, 3>;

Box3 box_of(const Triangle& t) {
  Box3 box;
  for (const glm::dvec3& p : t) box.add(p);
  return box;
}

bool boxes_meet(const Box3& a, const Box3& b) {
  return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y &&
         a.min.z <= b.max.z && b.min.z <= a.max.z;
}

// Six times the volume of a tetrahedron.
double volume(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
  return glm::dot(glm::cross(b - a, c - a), d - a);
}

bool pierces(const glm::dvec3& p, const glm::dvec3& q, const Triangle& t) {
  const double at_p = volume(t[0], t[1], t[2], p);
  const double at_q = volume(t[0], t[1], t[2], q);
  if (!((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0))) return false;
  const double a = volume(p, q, t[0], t[1]);
  const double b = volume(p, q, t[1], t[2]);
  const double c = volume(p, q, t[2], t[0]);
  return (a > 0 && b > 0 && c > 0) || (a < 0 && b < 0 && c < 0);
}

// A side that starts at a common corner only touches the other face there.
bool cross_each_other(const Triangle& a, const std::array<VertexId, 3>& ids_a, const Triangle& b,
                      const std::array<VertexId, 3>& ids_b) {
  const auto is_corner = [](VertexId v, const std::array<VertexId, 3>& ids) {
    return v == ids[0] || v == ids[1] || v == ids[2];
  };
  int n_common = 0;
  for (const VertexId v : ids_a) n_common += is_corner(v, ids_b) ? 1 : 0;
  if (n_common >= 2) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (!is_corner(ids_a[i], ids_b) && !is_corner(ids_a[j], ids_b) && pierces(a[i], a[j], b)) return true;
    if (!is_corner(ids_b[i], ids_a) && !is_corner(ids_b[j], ids_a) && pierces(b[i], b[j], a)) return true;
  }
  return false;
}

std::array<VertexId, 3> ids_of(const TriangleSurface& s, FaceId f) {
  const HalfedgeId h(3 * f.value);
  return {s.from[h], s.from[s.next(h)], s.from[s.prev(h)]};
}

}  // namespace

template <class Visit>
void CrossingGuard::for_each_cell(const Box3& box, Visit&& visit) const {
  std::array<int, 3> low{};
  std::array<int, 3> high{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    const double last = size_[i] - 1;
    low[i] = static_cast<int>(std::clamp((box.min[axis] - origin_[axis]) / cell_, 0.0, last));
    high[i] = static_cast<int>(std::clamp((box.max[axis] - origin_[axis]) / cell_, 0.0, last));
  }
  for (int z = low[2]; z <= high[2]; ++z)
    for (int y = low[1]; y <= high[1]; ++y)
      for (int x = low[0]; x <= high[0]; ++x)
        visit(static_cast<std::size_t>((z * size_[1] + y) * size_[0] + x));
}

void CrossingGuard::insert(const TriangleSurface& s, FaceId f) {
  for_each_cell(box_of(s.corners(f)), [&](std::size_t cell) {
    entries_.push_back({f, head_[cell]});
    head_[cell] = static_cast<int>(entries_.size()) - 1;
  });
}

void CrossingGuard::rebuild(const TriangleSurface& s) {
  Box3 all;
  double extent = 0;
  n_live_when_new_ = 0;
  for (const FaceId f : s.faces()) {
    if (s.is_dead[f] != 0) continue;
    const Box3 box = box_of(s.corners(f));
    all.add(box);
    const glm::dvec3 size = box.size();
    extent += std::max({size.x, size.y, size.z});
    ++n_live_when_new_;
  }
  if (n_live_when_new_ == 0) return;
  origin_ = all.min;
  const glm::dvec3 size = all.size();
  const double longest = std::max({size.x, size.y, size.z});
  cell_ = std::max(extent / n_live_when_new_, longest / kMostCells);
  for (int axis = 0; axis < 3; ++axis)
    size_[static_cast<std::size_t>(axis)] = std::min(kMostCells, static_cast<int>(size[axis] / cell_) + 1);
  head_.assign(static_cast<std::size_t>(size_[0] * size_[1] * size_[2]), -1);
  entries_.clear();
  for (const FaceId f : s.faces())
    if (s.is_dead[f] == 0) insert(s, f);
  n_entries_when_new_ = entries_.size();
  if (seen_.empty()) seen_.assign(s.polygon.size(), 0);
}

void CrossingGuard::update(const TriangleSurface& s, VertexId merged, int n_live) {
  if (2 * n_live < n_live_when_new_ || entries_.size() > 3 * n_entries_when_new_ + 1000) return rebuild(s);
  s.for_each_out(merged, [&](HalfedgeId h) { insert(s, s.face(h)); });
}

void CrossingGuard::gather_near(const TriangleSurface& s, HalfedgeId h, std::span<const RingFace> ring) {
  ++query_;
  near_.clear();
  Box3 box;
  for (const RingFace& r : ring) {
    seen_[r.face] = query_;
    box.add(box_of(r.after));
  }
  seen_[s.face(h)] = query_;
  if (s.twin[h].is_valid()) seen_[s.face(s.twin[h])] = query_;
  for_each_cell(box, [&](std::size_t cell) {
    for (int e = head_[cell]; e >= 0; e = entries_[static_cast<std::size_t>(e)].next) {
      const FaceId f = entries_[static_cast<std::size_t>(e)].face;
      if (seen_[f] == query_) continue;
      seen_[f] = query_;
      if (s.is_dead[f] == 0 && boxes_meet(box, box_of(s.corners(f)))) near_.push_back(f);
    }
  });
}

bool CrossingGuard::would_cross(const TriangleSurface& s, HalfedgeId h, std::span<const RingFace> ring) {
  gather_near(s, h, ring);
  const VertexId gone = s.to(h);
  for (const RingFace& r : ring) {
    const Box3 box = box_of(r.after);
    auto ids = ids_of(s, r.face);
    std::ranges::replace(ids, gone, s.from[h]);
    for (const FaceId f : near_) {
      const Triangle other = s.corners(f);
      if (!boxes_meet(box, box_of(other)) || !cross_each_other(r.after, ids, other, ids_of(s, f))) continue;
      const bool has_crossed = std::ranges::any_of(ring, [&](const RingFace& was) {
        return cross_each_other(was.before, ids_of(s, was.face), other, ids_of(s, f));
      });
      if (!has_crossed) return true;
    }
  }
  return false;
}

}  // namespace netwright::simplify
