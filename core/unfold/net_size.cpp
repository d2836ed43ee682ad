// Measures are taken from convex hulls, whose few corners stand for thousands of faces.
#include "core/unfold/net_size.h"

#include "core/base/best_angle.h"

namespace netwright {

double cut_length(const Net& net) {
  const Mesh& mesh = net.mesh();
  double length = 0;
  for (const EdgeId e : mesh.edges())
    if (!mesh.is_border(e) && !net.tree.is_fold(mesh, e)) length += mesh.length(e);
  return length;
}

std::vector<std::vector<glm::dvec2>> piece_hulls(const Net& net) {
  std::vector<std::vector<glm::dvec2>> pieces(static_cast<std::size_t>(net.n_pieces));
  for (const FaceId f : net.mesh().faces()) {
    auto& corners = pieces[static_cast<std::size_t>(net.piece[f])];
    for (const HalfedgeId h : net.mesh().halfedges(f)) corners.push_back(net.corner(h));
  }
  for (auto& corners : pieces) corners = convex_hull(std::move(corners));
  return pieces;
}

double paper_area(const std::vector<std::vector<glm::dvec2>>& hulls) {
  const auto area_of = [](glm::dvec2 size) { return size.x * size.y; };
  double area = 0;
  for (const auto& hull : hulls) area += area_of(turned_box(hull, best_angle(hull, area_of)).size());
  return area;
}

}  // namespace netwright
