// Looks the corners up by their place, puts the faces together anew, and lets the mesh's own constructor say
// whether that is one.
#include "core/mesh/move_corners.h"

#include <algorithm>
#include <optional>

#include "core/base/error.h"
#include "core/base/predicates.h"
#include "core/mesh/split_faces.h"

namespace netwright {

namespace {

// A place that was stored and read back is the same to the last digits.
constexpr double kSamePlace = 1e-9;

struct Rebuilt {
  PolygonSoup soup;
  std::vector<bool> is_flipped;
  std::vector<int> source;
  std::vector<int> heirs;
};

VertexId corner_at(const Mesh& mesh, const glm::dvec3& place) {
  VertexId best;
  double least = kSamePlace * glm::length(mesh.box().size());
  for (const VertexId v : mesh.vertices()) {
    const double distance = glm::distance(mesh.position(v), place);
    if (distance > least) continue;
    best = v;
    least = distance;
  }
  return best;
}

/// Number of each vertex's point; those that go to one place share it. Nothing when a corner is missing.
std::optional<std::vector<int>> place_points(const Mesh& mesh, const std::vector<MovedCorner>& moved,
                                             PolygonSoup& soup) {
  std::vector<int> point(mesh.n_vertices(), -1);
  for (std::size_t i = 0; i < moved.size(); ++i) {
    const VertexId v = corner_at(mesh, moved[i].from);
    if (!v.is_valid()) return std::nullopt;
    const auto same = std::find(soup.points.begin(), soup.points.end(), moved[i].to);
    point[v.index()] = static_cast<int>(same - soup.points.begin());
    if (same == soup.points.end()) soup.points.push_back(moved[i].to);
  }
  for (const VertexId v : mesh.vertices()) {
    if (point[v.index()] >= 0) continue;
    point[v.index()] = static_cast<int>(soup.points.size());
    soup.points.push_back(mesh.position(v));
  }
  return point;
}

void add_face(const Mesh& mesh, FaceId f, const std::vector<int>& point, Rebuilt& to) {
  std::vector<HalfedgeId> kept;
  for (const HalfedgeId h : mesh.halfedges(f))
    if (point[mesh.from(h).index()] != point[mesh.to(h).index()]) kept.push_back(h);
  if (kept.size() < 3) {
    to.heirs.push_back(-1);
    return;
  }
  to.heirs.push_back(to.soup.n_faces());
  std::vector<int> corners;
  for (const HalfedgeId h : kept) {
    corners.push_back(point[mesh.from(h).index()]);
    if (mesh.has_uv()) to.soup.corner_uv.push_back(mesh.uv(h));
  }
  to.soup.add_face(corners);
  if (!mesh.materials().empty()) to.soup.face_material.push_back(mesh.material(f));
  to.is_flipped.push_back(mesh.is_flipped(f));
  to.source.push_back(mesh.face_source(f));
}

/// What is gone went into a neighbour.
void find_other_heirs(const Mesh& mesh, std::vector<int>& heirs) {
  const std::vector<int> direct = heirs;
  for (const FaceId f : mesh.faces()) {
    for (const HalfedgeId h : mesh.halfedges(f)) {
      const FaceId next = mesh.neighbour(h);
      if (heirs[f.index()] < 0 && next.is_valid()) heirs[f.index()] = direct[next.index()];
    }
  }
}

MovedMesh split_where_bent(MovedMesh moved) {
  const Mesh& mesh = *moved.mesh;
  bool is_flat = true;
  for (const FaceId f : mesh.faces()) is_flat = is_flat && mesh.side_unevenness(f) <= kFlatness / 10;
  if (is_flat) return moved;
  const SplitFaces split = split_uneven_faces(mesh);
  std::vector<int> sources;
  std::vector<int> first(mesh.n_faces(), -1);
  for (std::size_t f = 0; f < split.split_from.size(); ++f) {
    const FaceId before = split.split_from[f];
    sources.push_back(mesh.face_source(before));
    if (first[before.index()] < 0) first[before.index()] = static_cast<int>(f);
  }
  for (int& heir : moved.heirs) heir = heir < 0 ? -1 : first[static_cast<std::size_t>(heir)];
  moved.mesh = std::make_shared<const Mesh>(split.soup, split.is_flipped, sources);
  return moved;
}

}  // namespace

MovedMesh move_corners(const Mesh& mesh, const std::vector<MovedCorner>& moved) {
  Rebuilt rebuilt;
  rebuilt.soup.name = mesh.name();
  rebuilt.soup.up_axis = mesh.up_axis();
  rebuilt.soup.materials = mesh.materials();
  const auto point = place_points(mesh, moved, rebuilt.soup);
  if (!point) return {};
  for (const FaceId f : mesh.faces()) add_face(mesh, f, *point, rebuilt);
  find_other_heirs(mesh, rebuilt.heirs);
  try {
    return split_where_bent(
        {std::make_shared<const Mesh>(rebuilt.soup, rebuilt.is_flipped, rebuilt.source), rebuilt.heirs});
  } catch (const Error&) {
    return {};  // collapsed to what is no surface
  }
}

}  // namespace netwright
