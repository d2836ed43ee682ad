// A mesh on its way from the one that was given to the merged one, with where everything in it came from.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/base/ids.h"
#include "core/mesh/mesh.h"

namespace netwright {

/// One face of the next stage: corners of one face or group of this stage's mesh, in order.
struct Outline {
  std::vector<HalfedgeId> corners;
  std::vector<FaceId> sources;  ///< faces of the given mesh, ascending; in no other outline
  bool is_left_alone = false;
};

struct MergeStage {
  const Mesh* given = nullptr;        ///< the mesh to be merged
  std::shared_ptr<const Mesh> owner;  ///< null for the first stage
  const Mesh* mesh = nullptr;
  std::vector<std::vector<FaceId>> sources;  ///< per face of `mesh`: faces of `given`
  std::vector<VertexId> point_source;        ///< per vertex of `mesh`: vertex of `given`
  std::vector<bool> is_left_alone;           ///< per face of `mesh`
  PolygonSoup soup;                          ///< what `mesh` was made of; empty in the first stage
  std::vector<bool> is_flipped;
  std::vector<int> face_source;
  int n_split_regions = 0;  ///< met on the way to this stage
};

MergeStage first_stage(const Mesh& given, std::span<const FaceId> left_alone);

/// The stage with these faces, in the order of their first sources. Together they must make a mesh.
MergeStage stage_of(const MergeStage& from, std::vector<Outline> outlines);

}  // namespace netwright
