// Walks around each piece from uncovered side to uncovered side, and cuts lines at the border of a box
// (Liang and Barsky's parametric clipping).
#include "core/sheet/outline.h"

#include <algorithm>

namespace netwright {

namespace {

IdVector<HalfedgeId, char> fold_sides(const Net& net) {
  const Mesh& mesh = net.mesh();
  IdVector<HalfedgeId, char> is_fold(mesh.n_halfedges(), 0);
  for (const FaceId f : mesh.faces()) {
    if (net.tree.is_root(f)) continue;
    is_fold[net.tree.to_parent(f)] = 1;
    is_fold[mesh.twin(net.tree.to_parent(f))] = 1;
  }
  return is_fold;
}

bool is_inside(const Box2& box, glm::dvec2 p) {
  return p.x >= box.min.x && p.x <= box.max.x && p.y >= box.min.y && p.y <= box.max.y;
}

}  // namespace

std::vector<OutlineLoop> outline_loops(const Net& net) {
  const Mesh& mesh = net.mesh();
  const IdVector<HalfedgeId, char> is_fold = fold_sides(net);
  IdVector<HalfedgeId, char> is_done(mesh.n_halfedges(), 0);
  std::vector<OutlineLoop> loops;
  for (const HalfedgeId start : mesh.halfedges()) {
    if (is_fold[start] || is_done[start]) continue;
    OutlineLoop loop{net.piece[mesh.face(start)], {}};
    for (HalfedgeId h = start; !is_done[h];) {
      is_done[h] = 1;
      loop.sides.push_back(h);
      h = mesh.next(h);
      while (is_fold[h]) h = mesh.next(mesh.twin(h));
    }
    loops.push_back(std::move(loop));
  }
  std::stable_sort(loops.begin(), loops.end(),
                   [](const OutlineLoop& a, const OutlineLoop& b) { return a.piece < b.piece; });
  return loops;
}

IdVector<HalfedgeId, const GlueTab*> tabs_by_side(const Mesh& mesh, const GlueTabs& tabs) {
  IdVector<HalfedgeId, const GlueTab*> by_side(mesh.n_halfedges(), nullptr);
  for (const GlueTab& tab : tabs.tabs) by_side[tab.side] = &tab;
  return by_side;
}

std::optional<std::pair<double, double>> clip_segment(const Box2& box, glm::dvec2 a, glm::dvec2 b) {
  double enter = 0;
  double leave = 1;
  const glm::dvec2 d = b - a;
  for (int axis = 0; axis < 2; ++axis) {
    if (d[axis] == 0) {
      if (a[axis] < box.min[axis] || a[axis] > box.max[axis]) return std::nullopt;
      continue;
    }
    const double to_min = (box.min[axis] - a[axis]) / d[axis];
    const double to_max = (box.max[axis] - a[axis]) / d[axis];
    enter = std::max(enter, std::min(to_min, to_max));
    leave = std::min(leave, std::max(to_min, to_max));
  }
  if (!(enter < leave)) return std::nullopt;
  return std::pair(enter, leave);
}

int winding_number(const std::vector<Segment>& outline, glm::dvec2 p) {
  int winding = 0;
  for (const auto& [a, b] : outline) {
    if ((a.y <= p.y) == (b.y <= p.y)) continue;
    const double side = cross(b - a, p - a);
    if (a.y <= p.y && side > 0) ++winding;
    if (a.y > p.y && side < 0) --winding;
  }
  return winding;
}

ClippedLine clip_polyline(const Box2& box, const std::vector<glm::dvec2>& points, bool is_closed) {
  ClippedLine result;
  if (std::all_of(points.begin(), points.end(), [&](glm::dvec2 p) { return is_inside(box, p); })) {
    result.runs.push_back(points);
    result.is_whole = true;
    return result;
  }
  // A closed line is walked from a corner outside, so that no run straddles the start.
  std::size_t first = 0;
  while (is_closed && is_inside(box, points[first])) ++first;
  const std::size_t n_sides = is_closed ? points.size() : points.size() - 1;
  bool is_running = false;
  for (std::size_t k = 0; k < n_sides; ++k) {
    const glm::dvec2 a = points[(first + k) % points.size()];
    const glm::dvec2 b = points[(first + k + 1) % points.size()];
    const auto part = clip_segment(box, a, b);
    if (!part) {
      is_running = false;
      continue;
    }
    const auto [enter, leave] = *part;
    if (!is_running || enter > 0) result.runs.push_back({a + (b - a) * enter});
    result.runs.back().push_back(leave < 1 ? a + (b - a) * leave : b);
    is_running = leave == 1;
  }
  return result;
}

}  // namespace netwright
