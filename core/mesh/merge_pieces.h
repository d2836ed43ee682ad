// Joins the faces of one flat region into as few simple polygons as a plain rule finds: two parts become one
// where they meet along a single run of edges and touch nowhere else.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/base/ids.h"
#include "core/mesh/mesh.h"

namespace netwright {

/// A polygon in the making: its boundary as halfedges of the mesh, and the faces inside, ascending. The loop
/// starts with its smallest halfedge and never comes twice to one vertex.
struct MergedPiece {
  std::vector<HalfedgeId> loop;
  std::vector<FaceId> sources;
};

class PieceMerger {
 public:
  explicit PieceMerger(const Mesh& mesh);

  /// The region's polygons, in the order of their first faces. A region without holes and pinches gives one.
  std::vector<MergedPiece> merge(std::span<const FaceId> region);

 private:
  FaceId find(FaceId f);
  std::vector<HalfedgeId> inner_edges(std::span<const FaceId> region) const;
  std::vector<HalfedgeId> loop_of(const std::vector<FaceId>& sources) const;
  bool join(HalfedgeId h);
  bool meet_elsewhere(HalfedgeId first, HalfedgeId last, FaceId other);
  bool touches(HalfedgeId corner, FaceId piece);

  const Mesh& mesh_;
  IdVector<FaceId, FaceId> parent_;
  IdVector<FaceId, int> loop_size_;  ///< of roots
  IdVector<HalfedgeId, HalfedgeId> next_;
  IdVector<HalfedgeId, HalfedgeId> prev_;
  IdVector<FaceId, char> is_inside_;
};

/// What a closed run of corners is as a face: fit to unfold, not flat by kFlatness with a little to spare, or
/// otherwise no polygon (it crosses or touches itself, or has no area).
enum class PolygonKind { Paper, Uneven, NotSimple };
PolygonKind kind_of(std::span<const glm::dvec3> corners);

}  // namespace netwright
