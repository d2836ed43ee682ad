// Corners of one point with the same texture coordinates share a texture point; several of them make a seam.
#include "core/mesh/simplify_looks.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "core/mesh/deviation.h"

namespace netwright::simplify {
namespace {

// Shares of the three corners in a point of their plane.
std::array<double, 3> shares(const std::array<glm::dvec3, 3>& t, const glm::dvec3& p) {
  const glm::dvec3 n = glm::cross(t[1] - t[0], t[2] - t[0]);
  const double square = glm::dot(n, n);
  if (!(square > 0)) return {1, 0, 0};
  const double second = glm::dot(glm::cross(t[2] - p, t[0] - p), n) / square;
  const double third = glm::dot(glm::cross(t[0] - p, t[1] - p), n) / square;
  return {1 - second - third, second, third};
}

}  // namespace

Looks::Looks(const Mesh& mesh, const TriangleSurface& surface) : mesh_(mesh) {
  if (!mesh.has_uv()) return;
  point_.assign(surface.from.size(), -1);
  const auto uv_of = [&](HalfedgeId h) {
    if (surface.corner[h].is_valid()) return mesh.uv(surface.corner[h]);
    const FaceId f = surface.polygon[surface.face(h)];
    glm::dvec2 mean(0);
    for (const HalfedgeId k : mesh.halfedges(f)) mean += mesh.uv(k) / static_cast<double>(mesh.degree(f));
    return mean;
  };
  for (const VertexId v : surface.position.ids()) {
    const std::size_t begin = first_uv_.size();
    surface.for_each_out(v, [&](HalfedgeId h) {
      const glm::dvec2 uv = uv_of(h);
      const auto same =
          std::find(first_uv_.begin() + static_cast<std::ptrdiff_t>(begin), first_uv_.end(), uv);
      point_[h] = static_cast<int>(same - first_uv_.begin());
      if (same == first_uv_.end()) first_uv_.push_back(uv);
    });
  }
}

bool Looks::is_seam(const TriangleSurface& s, HalfedgeId h) const {
  const HalfedgeId t = s.twin[h];
  if (!t.is_valid()) return false;
  if (mesh_.material(s.polygon[s.face(h)]) != mesh_.material(s.polygon[s.face(t)])) return true;
  return !point_.empty() && (point_[h] != point_[s.next(t)] || point_[s.next(h)] != point_[t]);
}

void Looks::begin(CollapseHistory& history) const {
  history.uv_leaf = point_.raw();
  history.uv = first_uv_;
  history.uv_parent.assign(first_uv_.size(), -1);
  history.n_uv_at.push_back(static_cast<int>(first_uv_.size()));
}

int Looks::find(int point) const {
  const auto at = std::ranges::find(groups_, point, &Group::point);
  return at == groups_.end() ? -1 : at->group;
}

void Looks::unite(int a, int b) {
  const int keep = std::min(find(a), find(b));
  const int drop = std::max(find(a), find(b));
  for (Group& g : groups_)
    if (g.group == drop) g.group = keep;
}

void Looks::gather_groups(const TriangleSurface& s, HalfedgeId h) {
  groups_.clear();
  for (const VertexId v : {s.from[h], s.to(h)})
    s.for_each_out(v, [&](HalfedgeId k) {
      if (find(point_[k]) < 0) groups_.push_back({point_[k], static_cast<int>(groups_.size())});
    });
  unite(point_[h], point_[s.next(h)]);
  const HalfedgeId t = s.twin[h];
  if (t.is_valid()) unite(point_[t], point_[s.next(t)]);
}

glm::dvec2 Looks::uv_at(const TriangleSurface& s, HalfedgeId h, int group, const glm::dvec3& place,
                        const CollapseHistory& history) const {
  double best = std::numeric_limits<double>::infinity();
  glm::dvec2 uv(0);
  for (const VertexId v : {s.from[h], s.to(h)})
    s.for_each_out(v, [&](HalfedgeId k) {
      if (find(point_[k]) != group) return;
      const auto corners = s.corners(s.face(k));
      const glm::dvec3 nearest = nearest_in_triangle(corners, place);
      const double distance = glm::distance(nearest, place);
      if (distance >= best) return;
      best = distance;
      const auto share = shares(corners, nearest);
      uv = glm::dvec2(0);
      for (const HalfedgeId c : s.halfedges(s.face(k)))
        uv += share[static_cast<std::size_t>(c.value % 3)] * history.uv[static_cast<std::size_t>(point_[c])];
    });
  return uv;
}

void Looks::merge(const TriangleSurface& s, HalfedgeId h, const glm::dvec3& place, CollapseHistory& history) {
  if (point_.empty()) return;
  gather_groups(s, h);
  const int n_before = static_cast<int>(history.uv.size());
  std::vector<glm::dvec2> made;
  for (std::size_t g = 0; g < groups_.size(); ++g)
    if (groups_[g].group == static_cast<int>(g)) {
      const int point = n_before + static_cast<int>(made.size());
      made.push_back(uv_at(s, h, static_cast<int>(g), place, history));
      for (const Group& member : groups_)
        if (member.group == static_cast<int>(g))
          history.uv_parent[static_cast<std::size_t>(member.point)] = point;
    }
  for (const VertexId v : {s.from[h], s.to(h)})
    s.for_each_out(v, [&](HalfedgeId k) {
      if (point_[k] < n_before) point_[k] = history.uv_parent[static_cast<std::size_t>(point_[k])];
    });
  for (const glm::dvec2& uv : made) {
    history.uv.push_back(uv);
    history.uv_parent.push_back(-1);
  }
  history.n_uv_at.push_back(static_cast<int>(history.uv.size()));
}

}  // namespace netwright::simplify
