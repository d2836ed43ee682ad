// Joins and opens stage by stage until nothing changes, so that merging twice is merging once, and tells what
// was done.
#include "core/mesh/merge_faces.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "core/base/counted.h"
#include "core/base/error.h"
#include "core/mesh/flat_regions.h"
#include "core/mesh/merge_pass.h"

namespace netwright {

namespace {

constexpr double kLargestTolerance = 0.17453292519943295;  // ten degrees

MergeStage joined(MergeStage stage, double tolerance_rad, JoinRule rule) {
  for (bool is_changing = true; is_changing;) {
    MergeStage next = join_faces(stage, tolerance_rad, rule);
    is_changing =
        next.mesh->n_faces() < stage.mesh->n_faces() || next.mesh->n_vertices() < stage.mesh->n_vertices();
    stage = std::move(next);
  }
  return stage;
}

/// First as few polygons as possible, which frees the seams in regions with holes from the faces there were;
/// then new cuts in those regions, and as few polygons as possible along these.
MergeStage merged_stage(const Mesh& mesh, const MergeOptions& options) {
  const double tolerance = options.tolerance_rad;
  MergeStage few = joined(first_stage(mesh, options.left_alone), tolerance, JoinRule::Simple);
  MergeStage open = open_regions(few, tolerance);
  if (open.mesh->n_faces() == few.mesh->n_faces()) return few;
  return joined(std::move(open), tolerance, JoinRule::Convex);
}

std::vector<std::string> tell(const MergedFaces& merged, double tolerance_rad) {
  std::vector<std::string> sentences;
  if (merged.n_groups == 0) {
    char degrees[32];
    std::snprintf(degrees, sizeof degrees, "%.4g", tolerance_rad / kMergeAngle / 10);
    sentences.push_back("No faces were merged: no neighbours that look alike lie in one plane within " +
                        std::string(degrees) + " degrees.");
  } else {
    sentences.push_back(counted(merged.n_before, "face", "faces") + " became " + grouped(merged.n_after()) +
                        ": " + counted(merged.n_groups, "flat polygon was", "flat polygons were") +
                        " made of several faces each.");
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
  if (!(options.tolerance_rad >= 0 && options.tolerance_rad <= kLargestTolerance))
    throw Error(ErrorKind::Usage, "The tolerance for merging faces must lie between 0 and 10 degrees.");
  MergeStage stage = merged_stage(mesh, options);
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
