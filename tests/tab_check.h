// Tabs judged by other means than those that made them: areas of polygons clipped by each other, every tab
// against every face and every other tab of its piece. For tests and benchmarks.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "core/base/polygon2.h"
#include "core/unfold/glue_tabs.h"

namespace netwright::testing {

using Polygon = std::vector<glm::dvec2>;

/// What of a polygon lies left of the line from a to b (Sutherland and Hodgman).
inline Polygon clip(const Polygon& polygon, glm::dvec2 a, glm::dvec2 b) {
  Polygon kept;
  const auto side = [&](glm::dvec2 p) { return cross(b - a, p - a); };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 p = polygon[i];
    const glm::dvec2 q = polygon[(i + 1) % polygon.size()];
    if (side(p) >= 0) kept.push_back(p);
    if ((side(p) >= 0) != (side(q) >= 0)) kept.push_back(p + (q - p) * (side(p) / (side(p) - side(q))));
  }
  return kept;
}

/// Area that two convex counter-clockwise polygons have in common.
inline double common_area(const Polygon& a, const Polygon& b) {
  Polygon rest = a;
  for (std::size_t i = 0; i < b.size() && !rest.empty(); ++i) rest = clip(rest, b[i], b[(i + 1) % b.size()]);
  return rest.size() < 3 ? 0 : signed_area(rest);
}

/// The convex parts of every face where it lies in the net, in mm.
struct LaidFace {
  int piece = 0;
  std::vector<Polygon> parts;
  Box2 box;
};

inline std::vector<LaidFace> laid_faces(const Net& net, double scale) {
  std::vector<LaidFace> faces;
  for (const FaceId f : net.mesh().faces()) {
    LaidFace laid{net.piece[f], {}, {}};
    Polygon corners;
    for (const HalfedgeId h : net.mesh().halfedges(f)) corners.push_back(net.corner(h) * scale);
    for (const glm::dvec2 p : corners) laid.box.add(p);
    for (const auto& triangle : triangulate(corners)) {
      Polygon part;
      for (const int i : triangle) part.push_back(corners[static_cast<std::size_t>(i)]);
      laid.parts.push_back(std::move(part));
    }
    faces.push_back(std::move(laid));
  }
  return faces;
}

inline bool boxes_meet(const Box2& a, const Box2& b) {
  return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y;
}

inline double area_over_faces(const Polygon& tab, int piece, const std::vector<LaidFace>& faces) {
  Box2 box;
  for (const glm::dvec2 p : tab) box.add(p);
  double area = 0;
  for (const LaidFace& face : faces) {
    if (face.piece != piece || !boxes_meet(face.box, box)) continue;
    for (const Polygon& part : face.parts) area += common_area(tab, part);
  }
  return area;
}

struct TabFaults {
  double over_faces_mm2 = 0;
  double over_tabs_mm2 = 0;
};

inline TabFaults find_faults(const Net& net, double scale, const GlueTabs& tabs) {
  TabFaults faults;
  const std::vector<LaidFace> faces = laid_faces(net, scale);
  const auto piece = [&](const GlueTab& tab) { return net.piece[net.mesh().face(tab.side)]; };
  for (std::size_t i = 0; i < tabs.tabs.size(); ++i) {
    const GlueTab& tab = tabs.tabs[i];
    faults.over_faces_mm2 += area_over_faces(tab.points, piece(tab), faces);
    for (std::size_t j = i + 1; j < tabs.tabs.size(); ++j)
      if (piece(tab) == piece(tabs.tabs[j]))
        faults.over_tabs_mm2 += common_area(tab.points, tabs.tabs[j].points);
  }
  return faults;
}

/// Has this side, with no other tab around, room for some tab of this width? Tries trapezoids of many angles.
inline bool has_room(const Net& net, double scale, const std::vector<LaidFace>& faces, HalfedgeId h,
                     double width_mm) {
  const Mesh& mesh = net.mesh();
  const glm::dvec2 a = net.corner(h) * scale;
  const glm::dvec2 b = net.corner(mesh.next(h)) * scale;
  const double length = glm::length(b - a);
  if (length < 2 * width_mm) return false;
  const glm::dvec2 along = (b - a) / length;
  const glm::dvec2 out(along.y, -along.x);
  constexpr double kDegree = 0.017453292519943295;
  for (int from = 45; from >= 3; from -= 3)
    for (int to = 45; to >= 3; to -= 3) {
      const double left = width_mm / std::tan(from * kDegree);
      const double right = length - width_mm / std::tan(to * kDegree);
      if (left > right) break;
      const Polygon tab{b, a, a + left * along + width_mm * out, a + right * along + width_mm * out};
      if (area_over_faces(tab, net.piece[mesh.face(h)], faces) < 1e-6) return true;
    }
  return false;
}

}  // namespace netwright::testing
