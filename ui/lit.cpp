// Reports speak of the file. Its faces are found in the mesh by their origins, its edges by where they lie;
// what the mesh has no more is drawn as it was.
#include "ui/lit.h"

#include <algorithm>
#include <map>

namespace netwright {
namespace {

using Place = std::array<double, 6>;  ///< of an edge, the same from both ends

Place place_of(const glm::dvec3& a, const glm::dvec3& b) {
  const Place there{a.x, a.y, a.z, b.x, b.y, b.z};
  const Place back{b.x, b.y, b.z, a.x, a.y, a.z};
  return std::min(there, back);
}

/// Those edges of the mesh that lie there, and the places where it has none.
void add_edges(const Mesh& mesh, const std::vector<std::array<glm::dvec3, 2>>& places, Lit& lit) {
  if (places.empty()) return;
  std::map<Place, bool> is_found;
  for (const auto& [a, b] : places) is_found[place_of(a, b)] = false;
  for (const EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e);
    const auto place = is_found.find(place_of(mesh.position(h), mesh.position(mesh.next(h))));
    if (place == is_found.end()) continue;
    place->second = true;
    lit.edges.push_back(e);
  }
  for (const auto& [a, b] : places)
    if (!is_found[place_of(a, b)]) lit.segments.push_back({a, b});
}

/// Faces of the file that are gone are shown by their sides.
void add_lost_faces(const Project& project, const std::vector<int>& faces, Lit& lit) {
  const PolygonSoup& soup = *project.source;
  for (const int f : faces) {
    if (f < 0 || f >= soup.n_faces() || !faces_made_of(project.made->origins, std::array{f}).empty())
      continue;
    const auto corners = soup.face(f);
    const auto at = [&](std::size_t k) { return soup.points[static_cast<std::size_t>(corners[k])]; };
    for (std::size_t k = 0; k < corners.size(); ++k)
      lit.segments.push_back({at(k), at((k + 1) % corners.size())});
  }
}

}  // namespace

void clear_lit(UiState& ui) { ui.lit = Lit(); }

void light(UiContext& context, std::size_t index, const MeshReport::Line& line) {
  UiState& ui = context.ui;
  const Project& project = context.session.project();
  const bool was_lit = ui.lit.line == index;
  clear_lit(ui);
  if (was_lit) return;
  ui.lit.line = index;
  ui.lit.faces = faces_made_of(project.made->origins, line.faces);
  add_edges(project.dual->mesh(), line.edge_places, ui.lit);
  ui.lit.points = line.point_places;
  add_lost_faces(project, line.faces, ui.lit);
  ui.wants_lit_in_view = true;
}

Box3 lit_box(const Lit& lit, const ModelPose& pose) {
  const Mesh& mesh = pose.mesh();
  Box3 box;
  for (const FaceId f : lit.faces)
    for (const HalfedgeId h : mesh.halfedges(f)) box.add(pose.position(h));
  for (const EdgeId e : lit.edges) {
    const HalfedgeId h = mesh.halfedge(e);
    box.add(pose.position(h));
    box.add(pose.position(mesh.next(h)));
  }
  for (const auto& [a, b] : lit.segments) {
    box.add(a);
    box.add(b);
  }
  for (const glm::dvec3& p : lit.points) box.add(p);
  return box;
}

glm::dvec3 lit_side(const Lit& lit, const ModelPose& pose) {
  const Mesh& mesh = pose.mesh();
  glm::dvec3 outward(0);
  double total = 0;
  const auto add = [&](FaceId f) {
    outward += pose.normal(f) * mesh.area(f);
    total += mesh.area(f);
  };
  for (const FaceId f : lit.faces) add(f);
  for (const EdgeId e : lit.edges) add(mesh.face(mesh.halfedge(e)));
  // Culprits all around have no side of their own: the first face, the worst, is shown then.
  if (glm::length(outward) >= 0.2 * total) return outward;
  return lit.faces.empty() ? glm::dvec3(0) : pose.normal(lit.faces.front());
}

}  // namespace netwright
