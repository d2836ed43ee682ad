// Compares each moved face with itself before and with its neighbours to come.
#include "core/mesh/simplify_guards.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace netwright::simplify {
namespace {

// The normal of a thinner triangle is mostly rounding and says nothing.
constexpr double kThinShape = 1e-5;

double shape_of(const std::array<glm::dvec3, 3>& p) {
  const glm::dvec3 a = p[1] - p[0];
  const glm::dvec3 b = p[2] - p[1];
  const glm::dvec3 c = p[0] - p[2];
  const double squares = glm::dot(a, a) + glm::dot(b, b) + glm::dot(c, c);
  return squares > 0 ? 3.4641016151377544 * glm::length(glm::cross(a, b)) / squares : 0;
}

/// The faces that die when an edge collapses, and what they leave behind.
class Dying {
 public:
  Dying(const TriangleSurface& surface, HalfedgeId h) : s_(surface), sides_{h, surface.twin[h]} {}

  [[nodiscard]] bool contains(FaceId f) const { return side_of(f).is_valid(); }

  /// The halfedge of the neighbour to come: k itself, or beyond the dying face that k belongs to.
  [[nodiscard]] HalfedgeId beyond(HalfedgeId k) const {
    const HalfedgeId side = side_of(TriangleSurface::face(k));
    if (!side.is_valid()) return k;
    return s_
        .twin[k == TriangleSurface::next(side) ? TriangleSurface::prev(side) : TriangleSurface::next(side)];
  }

 private:
  [[nodiscard]] HalfedgeId side_of(FaceId f) const {
    for (const HalfedgeId side : sides_)
      if (side.is_valid() && TriangleSurface::face(side) == f) return side;
    return {};
  }

  const TriangleSurface& s_;
  std::array<HalfedgeId, 2> sides_;
};

}  // namespace

glm::dvec3 unit_normal(const std::array<glm::dvec3, 3>& p) {
  const glm::dvec3 n = glm::cross(p[1] - p[0], p[2] - p[0]);
  const double length = glm::length(n);
  return length > 0 ? n / length : glm::dvec3(0);
}

void gather_ring(const TriangleSurface& s, HalfedgeId h, const glm::dvec3& place,
                 std::vector<RingFace>& ring) {
  ring.clear();
  const Dying dying(s, h);
  for (const VertexId v : {s.from[h], s.to(h)}) {
    s.for_each_out(v, [&](HalfedgeId k) {
      const FaceId f = TriangleSurface::face(k);
      if (dying.contains(f)) return;
      RingFace face{.face = f, .before = s.corners(f), .after = s.corners(f)};
      face.after[static_cast<std::size_t>(k.value % 3)] = place;
      ring.push_back(face);
    });
  }
}

bool keeps_shape(std::span<const RingFace> ring, const Limits& limits) {
  double least = limits.shape;
  for (const RingFace& r : ring) least = std::min(least, shape_of(r.before));
  return std::ranges::all_of(ring, [&](const RingFace& r) {
    if (shape_of(r.after) < least) return false;
    return shape_of(r.before) < kThinShape ||
           glm::dot(unit_normal(r.before), unit_normal(r.after)) >= limits.turn_cosine;
  });
}

bool stays_unfolded(const TriangleSurface& s, HalfedgeId h, const glm::dvec3& place,
                    std::span<const RingFace> ring, const Limits& limits) {
  const Dying dying(s, h);
  const VertexId a = s.from[h];
  const VertexId b = s.to(h);
  const auto normal_to_come = [&](FaceId f) {
    auto p = s.corners(f);
    for (const HalfedgeId k : TriangleSurface::halfedges(f))
      if (s.from[k] == a || s.from[k] == b) p[static_cast<std::size_t>(k.value % 3)] = place;
    return unit_normal(p);
  };
  double before = 1;
  double after = 1;
  for (const RingFace& r : ring) {
    const glm::dvec3 n_before = unit_normal(r.before);
    const glm::dvec3 n_after = unit_normal(r.after);
    for (const HalfedgeId k : TriangleSurface::halfedges(r.face)) {
      const HalfedgeId now = s.twin[k];
      if (!now.is_valid()) continue;
      before = std::min(before, glm::dot(n_before, unit_normal(s.corners(TriangleSurface::face(now)))));
      const HalfedgeId then = dying.beyond(now);
      if (!then.is_valid()) continue;
      after = std::min(after, glm::dot(n_after, normal_to_come(TriangleSurface::face(then))));
    }
  }
  return after >= std::min(limits.fold_cosine, before - 1e-9);
}

}  // namespace netwright::simplify
