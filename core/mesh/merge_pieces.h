// Joins the faces of one flat region into as few simple polygons as a plain rule finds: two parts become one
// where they meet along a single run of edges and touch nowhere else.
#pragma once

#include <glm/vec2.hpp>
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

enum class JoinRule {
  Simple,  ///< the union has to be a simple polygon
  Convex,  ///< and no inward corner may arise (see convex_cuts.h)
};

class PieceMerger {
 public:
  explicit PieceMerger(const Mesh& mesh);

  /// The region's polygons, in the order of their first faces. By the simple rule a region without holes and
  /// pinches gives one.
  std::vector<MergedPiece> merge(std::span<const FaceId> region, JoinRule rule);

 private:
  FaceId find(FaceId f);
  std::vector<HalfedgeId> inner_edges(std::span<const FaceId> region) const;
  std::vector<HalfedgeId> loop_of(const std::vector<FaceId>& sources) const;
  bool join(HalfedgeId h, JoinRule rule);
  [[nodiscard]] bool turns_inward(HalfedgeId in, HalfedgeId out) const;
  bool meet_elsewhere(HalfedgeId first, HalfedgeId last, FaceId other);
  bool touches(HalfedgeId corner, FaceId piece);

  const Mesh& mesh_;
  IdVector<FaceId, FaceId> parent_;
  IdVector<FaceId, int> loop_size_;  ///< of roots
  IdVector<HalfedgeId, HalfedgeId> next_;
  IdVector<HalfedgeId, HalfedgeId> prev_;
  IdVector<FaceId, char> is_inside_;
};

/// The corners in the polygon's own plane, counter-clockwise; lengths are those of the projection.
std::vector<glm::dvec2> laid_flat(std::span<const glm::dvec3> corners);

/// What a closed run of corners is as a face: fit to unfold, not flat, or otherwise no polygon (it crosses or
/// touches itself, or has no area). Flat is kFlatness with a little to spare; where the polygon has inward
/// corners no side may lose so much length by laying it flat that a neighbour would stick out into it, in
/// terms of the mesh's mean edge.
enum class PolygonKind { Paper, Uneven, NotSimple };
PolygonKind kind_of(std::span<const glm::dvec3> corners, double mean_edge);

}  // namespace netwright
