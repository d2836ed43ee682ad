// Lengths are in mean edges about the model's middle, so that steps mean the same for every model and no
// digits are lost to a place far from the origin.
#include "core/mesh/planar_model.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "core/base/polygon2.h"

namespace netwright::planarize_parts {

PlanarModel::PlanarModel(const Mesh& the_mesh)
    : mesh(the_mesh), unit(the_mesh.mean_edge()), size(the_mesh.box().diagonal() / the_mesh.mean_edge()) {
  for (const VertexId v : mesh.vertices()) start.push_back((mesh.position(v) - mesh.box().centre()) / unit);
  for (const FaceId f : mesh.faces()) {
    auto& face = faces.emplace_back();
    for (const HalfedgeId h : mesh.halfedges(f)) face.push_back(mesh.from(h).index());
    was_simple.push_back(is_simple(frame(f.index(), start).flat) ? 1 : 0);
  }
}

Points PlanarModel::corners(std::size_t f, const Points& points) const {
  Points corners;
  for (const std::size_t v : faces[f]) corners.push_back(points[v]);
  return corners;
}

PolygonFrame PlanarModel::frame(std::size_t f, const Points& points) const {
  return frame_of(corners(f, points));
}

double PlanarModel::energy(const Points& points) const {
  double sum = 0;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const std::size_t n = faces[f].size();
    if (n == 3) continue;
    const Points face = corners(f, points);
    const CornerMatrix matrix = completion(frame_of(face));
    for (std::size_t i = 0; i < n; ++i) {
      glm::dvec3 off(0);  // a row of C Cᵀ E: its squares add up without cancelling
      for (std::size_t j = 0; j < n; ++j) off += matrix(i, j) * (face[(j + 1) % n] - face[j]);
      sum += 0.5 * glm::dot(off, off);
    }
  }
  return sum;
}

PlanarModel::Measure PlanarModel::measure(const Points& points) const {
  Measure result;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const PolygonFrame now = frame(f, points);
    result.unevenness = std::max(result.unevenness, now.unevenness());
    result.off_plane = std::max(result.off_plane, now.unevenness() * now.size);
    const bool has_turned = glm::dot(now.normal, mesh.normal(FaceId(f))) <= 0;
    const bool crosses = now.flat.size() > 3 && was_simple[f] != 0 && !is_simple(now.flat);
    if (has_turned || crosses) result.folded.push_back(f);
  }
  return result;
}

PolygonSoup PlanarModel::soup(const Points& points) const {
  PolygonSoup soup;
  soup.name = mesh.name();
  soup.up_axis = mesh.up_axis();
  soup.materials = mesh.materials();
  for (const VertexId v : mesh.vertices()) {
    // Only the move is added, so that a corner that stayed keeps every digit.
    soup.points.push_back(mesh.position(v) + (points[v.index()] - start[v.index()]) * unit);
  }
  for (const FaceId f : mesh.faces()) {
    std::vector<int> face;
    for (const HalfedgeId h : mesh.halfedges(f)) {
      face.push_back(mesh.from(h).value);
      if (mesh.has_uv()) soup.corner_uv.push_back(mesh.uv(h));
    }
    soup.add_face(face);
    if (!mesh.materials().empty()) soup.face_material.push_back(mesh.material(f));
  }
  return soup;
}

double largest_move(const Points& from, const Points& to) {
  double largest = 0;
  for (std::size_t i = 0; i < from.size(); ++i) largest = std::max(largest, glm::distance(from[i], to[i]));
  return largest;
}

double worst_unevenness(const PolygonSoup& soup) {
  double worst = 0;
  Points corners;
  for (int f = 0; f < soup.n_faces(); ++f) {
    corners.clear();
    for (const int point : soup.face(f)) corners.push_back(soup.points[static_cast<std::size_t>(point)]);
    worst = std::max(worst, frame_of(corners).unevenness());
  }
  return worst;
}

}  // namespace netwright::planarize_parts
