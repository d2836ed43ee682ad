// Builds the triangles from the polygons of a mesh and collapses edges. Everything is decided by the order of
// faces and corners in the mesh, so that the same mesh always gives the same triangles.
#include "core/mesh/simplify_surface.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "core/base/polygon2.h"

namespace netwright::simplify {
namespace {

// A triangle this thin, against its longest side, is as good as none: what comes of it later could be refused
// by Mesh.
constexpr double kThinnest = 1e-6;

struct Side {
  int low, high, halfedge;
  auto operator<=>(const Side&) const = default;
};

std::vector<Side> sorted_sides(const TriangleSurface& s) {
  std::vector<Side> sides;
  sides.reserve(s.from.size());
  for (const HalfedgeId h : s.from.ids()) {
    const int a = s.from[h].value;
    const int b = s.to(h).value;
    sides.push_back({std::min(a, b), std::max(a, b), h.value});
  }
  std::ranges::sort(sides);
  return sides;
}

double height_share(const std::array<glm::dvec3, 3>& p) {
  const double longest = std::max({glm::dot(p[1] - p[0], p[1] - p[0]), glm::dot(p[2] - p[1], p[2] - p[1]),
                                   glm::dot(p[0] - p[2], p[0] - p[2])});
  return longest > 0 ? glm::length(glm::cross(p[1] - p[0], p[2] - p[0])) / longest : 0;
}

// The corners of a face seen along its normal.
std::vector<glm::dvec2> flattened(const Mesh& mesh, FaceId f) {
  const glm::dvec3 n = mesh.normal(f);
  const glm::dvec3 helper = std::abs(n.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 u = glm::normalize(glm::cross(helper, n));
  const glm::dvec3 v = glm::cross(n, u);
  std::vector<glm::dvec2> flat;
  for (const HalfedgeId h : mesh.halfedges(f)) {
    const glm::dvec3 p = mesh.position(h) - mesh.centre(f);
    flat.emplace_back(glm::dot(p, u), glm::dot(p, v));
  }
  return flat;
}

}  // namespace

TriangleSurface::TriangleSurface(const Mesh& mesh) {
  position.raw().reserve(mesh.n_vertices());
  for (const VertexId v : mesh.vertices()) position.push_back(mesh.position(v));
  const std::size_t n_triangles = mesh.n_halfedges() - 2 * mesh.n_faces();
  from.raw().reserve(3 * n_triangles);
  corner.raw().reserve(3 * n_triangles);
  for (const FaceId f : mesh.faces()) add_polygon(mesh, f);
  replace_doubled_diagonals(mesh);
  pair_halfedges();
  is_dead.assign(polygon.size(), 0);
  out.assign(position.size(), HalfedgeId());
  for (const HalfedgeId h : from.ids())
    if (!out[from[h]].is_valid() || !twin[h].is_valid()) out[from[h]] = h;
}

void TriangleSurface::add_triangle(const Mesh& mesh, FaceId f, const std::array<int, 3>& corners_of_f) {
  for (const int i : corners_of_f) {
    const HalfedgeId h(mesh.first(f).value + i);
    corner.push_back(h);
    from.push_back(mesh.from(h));
  }
  polygon.push_back(f);
}

void TriangleSurface::add_polygon(const Mesh& mesh, FaceId f) {
  if (mesh.degree(f) == 3) return add_triangle(mesh, f, {0, 1, 2});
  const std::size_t first = polygon.size();
  for (const auto& t : triangulate(flattened(mesh, f))) {
    add_triangle(mesh, f, t);
    if (height_share(corners(FaceId(polygon.size() - 1))) > kThinnest) continue;
    polygon.resize(first);
    from.resize(3 * first);
    corner.resize(3 * first);
    return add_star(mesh, f);
  }
}

void TriangleSurface::add_star(const Mesh& mesh, FaceId f) {
  const VertexId middle = position.push_back(mesh.centre(f));
  for (const HalfedgeId h : mesh.halfedges(f)) {
    for (const HalfedgeId k : {h, mesh.next(h)}) {
      corner.push_back(k);
      from.push_back(mesh.from(k));
    }
    corner.push_back(HalfedgeId());
    from.push_back(middle);
    polygon.push_back(f);
  }
}

// Two polygons with two corners in common may each have got a diagonal between these. Stars have none.
void TriangleSurface::replace_doubled_diagonals(const Mesh& mesh) {
  IdVector<FaceId, char> is_doubled(mesh.n_faces(), 0);
  bool is_any = false;
  const std::vector<Side> sides = sorted_sides(*this);
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t j = i + 1;
    while (j < sides.size() && sides[j].low == sides[i].low && sides[j].high == sides[i].high) ++j;
    for (std::size_t k = i; k < j && j - i > 2; ++k) {
      const FaceId f = polygon[face(HalfedgeId(sides[k].halfedge))];
      if (mesh.degree(f) > 3) is_doubled[f] = 1;
      is_any = true;
    }
    i = j;
  }
  if (!is_any) return;
  const TriangleSurface before = *this;
  from = {};
  corner = {};
  polygon = {};
  for (std::size_t i = 0; i < before.polygon.size(); ++i) {
    const FaceId f = before.polygon[FaceId(i)];
    if (is_doubled[f] != 0) {
      if (i == 0 || before.polygon[FaceId(i - 1)] != f) add_star(mesh, f);
      continue;
    }
    polygon.push_back(f);
    for (const HalfedgeId h : halfedges(FaceId(i))) {
      from.push_back(before.from[h]);
      corner.push_back(before.corner[h]);
    }
  }
}

void TriangleSurface::pair_halfedges() {
  twin.assign(from.size(), HalfedgeId());
  const std::vector<Side> sides = sorted_sides(*this);
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    if (sides[i].low != sides[i + 1].low || sides[i].high != sides[i + 1].high) continue;
    twin[HalfedgeId(sides[i].halfedge)] = HalfedgeId(sides[i + 1].halfedge);
    twin[HalfedgeId(sides[i + 1].halfedge)] = HalfedgeId(sides[i].halfedge);
  }
}

bool TriangleSurface::may_collapse(HalfedgeId h) const {
  const VertexId a = from[h];
  const VertexId b = to(h);
  const HalfedgeId t = twin[h];
  if (t.is_valid() && is_border(a) && is_border(b)) return false;
  for (const HalfedgeId side : {h, t}) {
    if (!side.is_valid()) continue;
    const HalfedgeId left = twin[next(side)];
    const HalfedgeId right = twin[prev(side)];
    if (!left.is_valid() && !right.is_valid()) return false;  // an ear, or all of its component
    // An apex with three faces would be left with two, back to back.
    if (left.is_valid() && right.is_valid() && twin[prev(left)] == next(right)) return false;
  }
  int common = 0;
  for_each_neighbour(a, [&](VertexId v) {
    bool is_shared = false;
    for_each_neighbour(b, [&](VertexId w) { is_shared |= v == w; });
    common += is_shared ? 1 : 0;
  });
  return common == (t.is_valid() ? 2 : 1);
}

void TriangleSurface::collapse(HalfedgeId h) {
  const VertexId kept = from[h];
  const VertexId gone = to(h);
  const HalfedgeId t = twin[h];
  const VertexId apex = from[prev(h)];
  const VertexId other_apex = t.is_valid() ? from[prev(t)] : VertexId();
  // A halfedge of each that lives on, found before the links change: beyond one side of its dying face or
  // beyond the other.
  const auto survivor = [&](HalfedgeId beyond, HalfedgeId otherwise) {
    return beyond.is_valid() ? beyond : next(otherwise);
  };
  const HalfedgeId start = survivor(twin[prev(h)], twin[next(h)]);
  const HalfedgeId apex_start = survivor(twin[next(h)], twin[prev(h)]);
  const HalfedgeId other_start = t.is_valid() ? survivor(twin[next(t)], twin[prev(t)]) : HalfedgeId();
  for_each_out(gone, [&](HalfedgeId k) { from[k] = kept; });
  close_gap(h);
  if (t.is_valid()) close_gap(t);
  out[gone] = HalfedgeId();
  set_out(kept, start);
  set_out(apex, apex_start);
  if (t.is_valid()) set_out(other_apex, other_start);
}

void TriangleSurface::close_gap(HalfedgeId h) {
  is_dead[face(h)] = 1;
  const HalfedgeId a = twin[next(h)];
  const HalfedgeId b = twin[prev(h)];
  if (a.is_valid()) twin[a] = b;
  if (b.is_valid()) twin[b] = a;
}

void TriangleSurface::set_out(VertexId v, HalfedgeId start) {
  HalfedgeId h = start;
  while (twin[h].is_valid()) {
    h = next(twin[h]);
    if (h == start) break;
  }
  out[v] = h;
}

}  // namespace netwright::simplify
