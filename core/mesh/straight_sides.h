// Finds the points in the middle of straight sides that only the two polygons beside the side have, so that
// they can be dropped from both.
#pragma once

#include <set>
#include <span>
#include <utility>
#include <vector>

#include "core/base/ids.h"
#include "core/mesh/merge_pieces.h"
#include "core/mesh/mesh.h"

namespace netwright {

class StraightSides {
 public:
  /// `pieces` cover the whole mesh. Only runs of edges with one of `may_change` on a side and none of
  /// `must_stay` are looked at; both are indexed by piece.
  StraightSides(const Mesh& mesh, std::span<const MergedPiece> pieces, const std::vector<bool>& may_change,
                const std::vector<bool>& must_stay, double tolerance_rad);

  /// One flag per vertex: to be dropped. No two corners will be joined twice, and what is left of every
  /// polygon is PolygonKind::Paper.
  IdVector<VertexId, char> find();

 private:
  void look_along(std::size_t piece);
  void straighten(std::span<const HalfedgeId> run);
  [[nodiscard]] std::size_t sharpest(std::span<const HalfedgeId> loop) const;
  [[nodiscard]] std::size_t worst_bend(std::span<const HalfedgeId> run) const;
  [[nodiscard]] double bend(std::span<const HalfedgeId> run, HalfedgeId at) const;
  [[nodiscard]] double texture_shift(std::span<const HalfedgeId> run, std::size_t at) const;
  [[nodiscard]] bool may_touch(HalfedgeId h) const;
  [[nodiscard]] bool is_spoiled(std::size_t piece) const;

  const Mesh& mesh_;
  std::span<const MergedPiece> pieces_;
  const std::vector<bool>& may_change_;
  std::vector<bool> must_stay_;
  double sine_;
  double rounding_;
  IdVector<FaceId, int> piece_of_;
  IdVector<VertexId, int> n_sides_;  ///< edges between polygons, or at a border, that end here
  IdVector<VertexId, char> is_dropped_;
  IdVector<VertexId, char> is_settled_;
  std::set<std::pair<VertexId, VertexId>> sides_;  ///< from the smaller to the larger one
};

}  // namespace netwright
