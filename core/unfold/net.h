// A laid-out unfold tree: one rigid motion of the plane per face, true to the lengths in space.
#pragma once

#include <memory>
#include <vector>

#include "core/mesh/dual_graph.h"
#include "core/unfold/unfold_tree.h"

namespace netwright {

struct Net {
  std::shared_ptr<const DualGraph> dual;
  UnfoldTree tree;
  IdVector<FaceId, Rigid2> placement;  ///< face frame -> plane, model units
  IdVector<FaceId, int> piece;         ///< which tree of the forest, 0 … n_pieces-1
  int n_pieces = 0;

  [[nodiscard]] const Mesh& mesh() const { return dual->mesh(); }
  /// Where corner h of its face lies in the plane, in model units.
  [[nodiscard]] glm::dvec2 corner(HalfedgeId h) const { return placement[mesh().face(h)](dual->flat(h)); }
  [[nodiscard]] Box2 box() const;
  [[nodiscard]] Box2 box(FaceId f) const;
};

/// Lays a tree out: every root at the identity (its face frame), every child unrolled from its parent. Pieces
/// (trees) overlap each other in the plane; `arrange` of the sheet chapter puts them side by side.
Net layout(std::shared_ptr<const DualGraph> dual, UnfoldTree tree);

}  // namespace netwright
