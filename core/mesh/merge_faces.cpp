// Grows flat regions, joins each into simple polygons, drops the points nobody needs, and does it again on
// the result until nothing changes, so that merging twice is merging once.
#include "core/mesh/merge_faces.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <memory>
#include <utility>

#include "core/base/error.h"
#include "core/mesh/flat_regions.h"
#include "core/mesh/merge_pieces.h"
#include "core/mesh/straight_sides.h"

namespace netwright {

namespace {

/// How often the tolerance is halved before an uneven group is cut in two instead.
constexpr int kMostHalvings = 10;
constexpr double kLargestTolerance = 0.17453292519943295;  // ten degrees

std::vector<glm::dvec3> corners_of(const Mesh& mesh, const MergedPiece& piece) {
  std::vector<glm::dvec3> corners;
  for (const HalfedgeId h : piece.loop) corners.push_back(mesh.position(h));
  return corners;
}

/// The polygons that a mesh's faces become in one pass.
class Pass {
 public:
  explicit Pass(const Mesh& mesh) : mesh_(mesh), regions_(mesh), merger_(mesh) {}

  void merge(std::span<const FaceId> faces, double tolerance_rad, int halvings = 0) {
    for (const std::vector<FaceId>& region : regions_.grow(faces, tolerance_rad)) {
      std::vector<MergedPiece> parts = merger_.merge(region);
      if (halvings == 0 && parts.size() > 1) ++n_split_regions;
      for (MergedPiece& piece : parts) settle(std::move(piece), tolerance_rad, halvings);
    }
  }

  void keep(FaceId f) { pieces.push_back(merger_.merge(std::span(&f, 1)).front()); }

  std::vector<MergedPiece> pieces;
  int n_split_regions = 0;

 private:
  /// Takes a polygon that paper can follow; else tries its faces again, with half the tolerance while it is
  /// not flat and as two halves where that does not help.
  void settle(MergedPiece piece, double tolerance_rad, int halvings) {
    const PolygonKind kind =
        piece.sources.size() == 1 ? PolygonKind::Paper : kind_of(corners_of(mesh_, piece));
    if (kind == PolygonKind::Paper) {
      pieces.push_back(std::move(piece));
    } else if (kind == PolygonKind::Uneven && halvings < kMostHalvings) {
      merge(piece.sources, tolerance_rad / 2, halvings + 1);
    } else {
      const auto [low, high] = halves(std::move(piece.sources));
      merge(low, tolerance_rad, std::max(halvings, 1));
      merge(high, tolerance_rad, std::max(halvings, 1));
    }
  }

  /// The faces on both sides of the middle of their longest extent.
  [[nodiscard]] std::pair<std::vector<FaceId>, std::vector<FaceId>> halves(std::vector<FaceId> faces) const {
    Box3 box;
    for (const FaceId f : faces) box.add(mesh_.centre(f));
    const glm::dvec3 size = box.size();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
    std::sort(faces.begin(), faces.end(), [&](FaceId a, FaceId b) {
      const double x = mesh_.centre(a)[axis];
      const double y = mesh_.centre(b)[axis];
      return x != y ? x < y : a < b;
    });
    const auto middle = faces.begin() + static_cast<std::ptrdiff_t>(faces.size() / 2);
    return {{faces.begin(), middle}, {middle, faces.end()}};
  }

  const Mesh& mesh_;
  FlatRegions regions_;
  PieceMerger merger_;
};

/// A mesh on its way, and where its faces and vertices come from in the mesh that was given.
struct Stage {
  const Mesh* mesh = nullptr;
  std::shared_ptr<const Mesh> owner;  ///< null for the given mesh
  std::vector<std::vector<FaceId>> sources;
  std::vector<VertexId> point_source;
  std::vector<bool> is_left_alone;
  PolygonSoup soup;
  std::vector<bool> is_flipped;
  std::vector<int> face_source;
  int n_split_regions = 0;
};

/// Appends a polygon to the next stage; points are numbered as they come, as the Mesh numbers its vertices.
void add_polygon(const Stage& from, const MergedPiece& piece, const IdVector<VertexId, char>& is_dropped,
                 IdVector<VertexId, int>& point_of, Stage& to) {
  const Mesh& mesh = *from.mesh;
  std::vector<int> corners;
  for (const HalfedgeId h : piece.loop) {
    const VertexId v = mesh.from(h);
    if (is_dropped[v] != 0) continue;
    if (point_of[v] < 0) {
      point_of[v] = static_cast<int>(to.soup.points.size());
      to.soup.points.push_back(mesh.position(v));
      to.point_source.push_back(from.point_source[v.index()]);
    }
    corners.push_back(point_of[v]);
    if (mesh.has_uv()) to.soup.corner_uv.push_back(mesh.uv(h));
  }
  to.soup.add_face(corners);
  const FaceId first = piece.sources.front();
  if (!mesh.materials().empty()) to.soup.face_material.push_back(mesh.material(first));
  to.is_flipped.push_back(mesh.is_flipped(first));
  to.face_source.push_back(mesh.face_source(first));
  to.is_left_alone.push_back(from.is_left_alone[first.index()]);
  std::vector<FaceId>& sources = to.sources.emplace_back();
  for (const FaceId f : piece.sources) {
    const std::vector<FaceId>& old = from.sources[f.index()];
    sources.insert(sources.end(), old.begin(), old.end());
  }
  std::sort(sources.begin(), sources.end());
}

Stage next_stage(const Stage& from, double tolerance_rad) {
  const Mesh& mesh = *from.mesh;
  Pass pass(mesh);
  std::vector<FaceId> free;
  for (const FaceId f : mesh.faces()) {
    if (from.is_left_alone[f.index()]) {
      pass.keep(f);
    } else {
      free.push_back(f);
    }
  }
  pass.merge(free, tolerance_rad);
  std::sort(pass.pieces.begin(), pass.pieces.end(), [&](const MergedPiece& a, const MergedPiece& b) {
    return a.sources.front() < b.sources.front();
  });
  std::vector<bool> is_group;
  std::vector<bool> is_left_alone;
  for (const MergedPiece& piece : pass.pieces) {
    const std::size_t first = piece.sources.front().index();
    is_group.push_back(piece.sources.size() > 1 || from.sources[first].size() > 1);
    is_left_alone.push_back(from.is_left_alone[first]);
  }
  const IdVector<VertexId, char> is_dropped =
      StraightSides(mesh, pass.pieces, is_group, is_left_alone, tolerance_rad).find();
  Stage to;
  to.n_split_regions = pass.n_split_regions;
  to.soup.name = mesh.name();
  to.soup.up_axis = mesh.up_axis();
  to.soup.materials = mesh.materials();
  IdVector<VertexId, int> point_of(mesh.n_vertices(), -1);
  for (const MergedPiece& piece : pass.pieces) add_polygon(from, piece, is_dropped, point_of, to);
  to.owner = std::make_shared<const Mesh>(to.soup, to.is_flipped, to.face_source);
  to.mesh = to.owner.get();
  return to;
}

Stage first_stage(const Mesh& mesh, const MergeOptions& options) {
  if (!(options.tolerance_rad >= 0 && options.tolerance_rad <= kLargestTolerance))
    throw Error(ErrorKind::Usage, "The tolerance for merging faces must lie between 0 and 10 degrees.");
  Stage stage;
  stage.mesh = &mesh;
  for (const FaceId f : mesh.faces()) stage.sources.push_back({f});
  for (const VertexId v : mesh.vertices()) stage.point_source.push_back(v);
  stage.is_left_alone.assign(mesh.n_faces(), false);
  for (const FaceId f : options.left_alone) {
    if (!f.is_valid() || f.index() >= mesh.n_faces())
      throw Error(ErrorKind::Usage, "There is no face " + std::to_string(f.value + 1) +
                                        " to leave alone; the model has " + std::to_string(mesh.n_faces()) +
                                        " faces.");
    stage.is_left_alone[f.index()] = true;
  }
  return stage;
}

std::string counted(int n, const std::string& one, const std::string& many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

std::vector<std::string> tell(const MergedFaces& merged, double tolerance_rad) {
  std::vector<std::string> sentences;
  if (merged.n_groups == 0) {
    char degrees[32];
    std::snprintf(degrees, sizeof degrees, "%.4g", tolerance_rad / kMergeAngle / 10);
    sentences.push_back("No faces were merged: no neighbours that look alike lie in one plane within " +
                        std::string(degrees) + " degrees.");
  } else {
    sentences.push_back(
        counted(merged.n_before, "face", "faces") + " became " + std::to_string(merged.n_after()) + ": " +
        counted(merged.n_groups, "flat polygon was", "flat polygons were") + " made of several faces each.");
  }
  if (merged.n_points_dropped > 0)
    sentences.push_back(counted(merged.n_points_dropped, "point", "points") +
                        (merged.n_points_dropped == 1 ? " that no face needs any more was dropped."
                                                      : " that no face needs any more were dropped."));
  if (merged.n_split_regions > 0)
    sentences.push_back(counted(merged.n_split_regions, "flat region", "flat regions") +
                        (merged.n_split_regions == 1
                             ? " has a hole or touches itself and stays in parts."
                             : " have a hole or touch themselves and stay in parts."));
  return sentences;
}

}  // namespace

MergedFaces merge_coplanar_faces(const Mesh& mesh, const MergeOptions& options) {
  Stage stage = first_stage(mesh, options);
  for (bool is_changing = true; is_changing;) {
    Stage next = next_stage(stage, options.tolerance_rad);
    is_changing =
        next.mesh->n_faces() < stage.mesh->n_faces() || next.mesh->n_vertices() < stage.mesh->n_vertices();
    stage = std::move(next);
  }
  MergedFaces merged;
  merged.n_before = static_cast<int>(mesh.n_faces());
  merged.n_points_dropped = static_cast<int>(mesh.n_vertices() - stage.mesh->n_vertices());
  merged.n_split_regions = stage.n_split_regions;
  merged.n_groups = static_cast<int>(
      std::count_if(stage.sources.begin(), stage.sources.end(), [](const auto& s) { return s.size() > 1; }));
  merged.soup = std::move(stage.soup);
  merged.is_flipped = std::move(stage.is_flipped);
  merged.face_source = std::move(stage.face_source);
  merged.sources = std::move(stage.sources);
  merged.point_source = std::move(stage.point_source);
  merged.sentences = tell(merged, options.tolerance_rad);
  return merged;
}

std::vector<EdgeId> unmerged_flat_edges(const Mesh& mesh, double tolerance_rad) {
  const PlaneTest test(mesh, tolerance_rad);
  std::vector<EdgeId> edges;
  for (const EdgeId e : mesh.edges()) {
    if (mesh.is_border(e)) continue;
    const FaceId f = mesh.face(mesh.halfedge(e));
    const FaceId g = mesh.neighbour(mesh.halfedge(e));
    if (test.holds(f, {mesh.centre(g), mesh.normal(g)}) || test.holds(g, {mesh.centre(f), mesh.normal(f)}))
      edges.push_back(e);
  }
  return edges;
}

}  // namespace netwright
