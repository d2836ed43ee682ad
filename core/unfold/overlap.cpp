// The sweep line of the paper's Algorithm 2 over the faces' boxes, and the separating-axis test behind it.
#include "core/unfold/overlap.h"

#include <algorithm>
#include <cmath>

namespace netwright {

namespace {

struct SweptFace {
  Box2 box;
  FaceId face;
  int piece = 0;
};

// Convex parts of every face, placed in the plane, back to back.
struct PlacedParts {
  std::vector<int> face_begin{0};
  std::vector<int> part_begin{0};
  std::vector<glm::dvec2> corners;

  explicit PlacedParts(const Net& net) {
    const Mesh& mesh = net.mesh();
    for (const FaceId f : mesh.faces()) {
      for (int k = 0; k < net.dual->n_parts(f); ++k) {
        for (const int i : net.dual->part(f, k))
          corners.push_back(net.corner(HalfedgeId(mesh.first(f).value + i)));
        part_begin.push_back(static_cast<int>(corners.size()));
      }
      face_begin.push_back(static_cast<int>(part_begin.size()) - 1);
    }
  }
  [[nodiscard]] std::span<const glm::dvec2> part(int k) const {
    const auto i = static_cast<std::size_t>(k);
    return std::span(corners).subspan(static_cast<std::size_t>(part_begin[i]),
                                      static_cast<std::size_t>(part_begin[i + 1] - part_begin[i]));
  }
  [[nodiscard]] bool overlap(FaceId a, FaceId b, double depth) const {
    for (int i = face_begin[a.index()]; i < face_begin[a.index() + 1]; ++i)
      for (int j = face_begin[b.index()]; j < face_begin[b.index() + 1]; ++j)
        if (convex_overlap(part(i), part(j), depth)) return true;
    return false;
  }
};

// Does b reach more than depth to the inner side of every edge line of a?
bool reaches_into(std::span<const glm::dvec2> a, std::span<const glm::dvec2> b, double depth) {
  for (std::size_t i = 0, n = a.size(); i < n; ++i) {
    const glm::dvec2 p = a[i];
    const glm::dvec2 d = a[i + 1 < n ? i + 1 : 0] - p;
    double reach = -std::numeric_limits<double>::infinity();
    for (const glm::dvec2 q : b) reach = std::max(reach, cross(d, q - p));
    if (reach <= depth * (std::abs(d.x) + std::abs(d.y))) return false;
  }
  return true;
}

}  // namespace

bool convex_overlap(std::span<const glm::dvec2> a, std::span<const glm::dvec2> b, double depth) {
  return reaches_into(a, b, depth) && reaches_into(b, a, depth);
}

std::vector<Overlap> find_overlaps(const Net& net, double depth) {
  const Mesh& mesh = net.mesh();
  const double eps = depth * mesh.mean_edge();
  const PlacedParts parts(net);
  std::vector<SweptFace> swept;
  swept.reserve(mesh.n_faces());
  for (const FaceId f : mesh.faces()) swept.push_back({net.box(f), f, net.piece[f]});
  std::sort(swept.begin(), swept.end(), [](const SweptFace& a, const SweptFace& b) {
    return a.box.min.x != b.box.min.x ? a.box.min.x < b.box.min.x : a.face < b.face;
  });
  std::vector<Overlap> result;
  for (std::size_t i = 0; i < swept.size(); ++i) {
    const SweptFace& a = swept[i];
    for (std::size_t j = i + 1; j < swept.size() && swept[j].box.min.x < a.box.max.x; ++j) {
      const SweptFace& b = swept[j];
      if (a.piece != b.piece || b.box.min.y >= a.box.max.y || a.box.min.y >= b.box.max.y) continue;
      if (parts.overlap(a.face, b.face, eps))
        result.push_back({std::min(a.face, b.face), std::max(a.face, b.face)});
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

bool faces_overlap(const DualGraph& dual, FaceId f, const Rigid2& f_placement, FaceId g,
                   const Rigid2& g_placement, double depth) {
  const auto part = [&](FaceId face, int k, const Rigid2& placement) {
    std::vector<glm::dvec2> corners;
    for (const int corner : dual.part(face, k))
      corners.push_back(placement(dual.flat(HalfedgeId(dual.mesh().first(face).value + corner))));
    return corners;
  };
  for (int i = 0; i < dual.n_parts(f); ++i)
    for (int j = 0; j < dual.n_parts(g); ++j)
      if (convex_overlap(part(f, i, f_placement), part(g, j, g_placement), depth)) return true;
  return false;
}

}  // namespace netwright
