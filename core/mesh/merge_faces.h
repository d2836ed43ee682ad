// Makes one polygon of the faces that lie in one plane and are neighbours, and drops the points that nobody
// needs afterwards. Fewer faces, fewer useless folds; the shape stays what it was.
#pragma once

#include <string>
#include <vector>

#include "core/base/ids.h"
#include "core/base/predicates.h"
#include "core/mesh/mesh.h"
#include "core/mesh/soup.h"

namespace netwright {

struct MergeOptions {
  /// How far faces may be bent against the plane of their group, in radians; 0 merges what is coplanar up to
  /// rounding. Tightened group by group where the polygon would not be flat (kFlatness) otherwise.
  double tolerance_rad = kMergeAngle;
  /// Faces of the mesh that stay exactly as they are: the groups a user has undone (see
  /// MergedFaces::sources).
  std::vector<FaceId> left_alone;
};

struct MergedFaces {
  /// One polygon per group and every other face as it was, in the order of each polygon's first source.
  /// Corners keep their texture coordinates, faces their material. With the two lists below the Mesh
  /// constructor accepts it: Mesh(soup, is_flipped, face_source).
  PolygonSoup soup;
  std::vector<bool> is_flipped;
  std::vector<int> face_source;  ///< index in the file of the group's first face
  /// Faces of the mesh that became this one, ascending. Each is in one list only; of a region that was cut
  /// anew, every part has the faces that it lies nearest to.
  std::vector<std::vector<FaceId>> sources;
  std::vector<VertexId> point_source;  ///< vertex of the mesh that became this point
  int n_before = 0;                    ///< faces of the mesh
  int n_groups = 0;                    ///< polygons made of several faces
  int n_points_dropped = 0;            ///< vertices of the mesh that are gone
  int n_split_regions = 0;             ///< flat regions with a hole or a pinch that had to stay in parts
  std::vector<std::string> sentences;  ///< the same for people; says so when there was nothing to do
  [[nodiscard]] int n_after() const { return soup.n_faces(); }
};

/// Merges neighbouring faces of one plane, one material and one smooth piece of texture (uv an affine map of
/// the plane within kSameUv) into simple polygons that are flat by kFlatness; those with inward corners have
/// to be flatter still, so that laying them flat shortens no side. Regions with holes, or that touch
/// themselves, become several polygons, as few as easily found and without inward corners, for what stands on
/// the rim of a hole must find room in the net; their seams may run where the mesh has no edge. Points in the
/// middle of a straight side that only the two faces beside it have are dropped from both. Borders, genus and
/// components stay; a second call changes nothing. The same mesh always gives the same result. Throws
/// Error(Usage) when the tolerance is negative or over ten degrees, or a face to be left alone does not
/// exist.
MergedFaces merge_coplanar_faces(const Mesh& mesh, const MergeOptions& options = {});

/// Inner edges bent by no more than the tolerance, ascending: on a merged mesh the folds that stayed because
/// merging there would make a hole, bend a face, or cross a material or texture seam. They can be hidden.
std::vector<EdgeId> unmerged_flat_edges(const Mesh& mesh, double tolerance_rad = kMergeAngle);

}  // namespace netwright
