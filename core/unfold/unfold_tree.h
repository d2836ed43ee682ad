// The unfold tree (paper, sections 2.1 and 4.8): a spanning forest of the dual graph, one tree per piece.
// Hinges in it are folds, all others cuts. The transformation of a node is the dual graph's unroll motion.
#pragma once

#include <vector>

#include "core/mesh/mesh.h"

namespace netwright {

class UnfoldTree {
 public:
  UnfoldTree() = default;
  /// Every face its own root.
  explicit UnfoldTree(std::size_t n_faces) : to_parent_(n_faces) {}

  [[nodiscard]] std::size_t n_faces() const { return to_parent_.size(); }

  /// The halfedge of face f across which its parent lies; invalid when f is a root.
  [[nodiscard]] HalfedgeId to_parent(FaceId f) const { return to_parent_[f]; }
  void set_parent(FaceId f, HalfedgeId across) { to_parent_[f] = across; }
  [[nodiscard]] bool is_root(FaceId f) const { return !to_parent_[f].is_valid(); }
  [[nodiscard]] FaceId parent(const Mesh& mesh, FaceId f) const {
    return is_root(f) ? FaceId() : mesh.neighbour(to_parent_[f]);
  }
  [[nodiscard]] FaceId root_of(const Mesh& mesh, FaceId f) const {
    while (!is_root(f)) f = mesh.neighbour(to_parent_[f]);
    return f;
  }
  [[nodiscard]] std::vector<FaceId> roots() const;

  /// True when the hinge at this edge is in the tree.
  [[nodiscard]] bool is_fold(const Mesh& mesh, EdgeId e) const;

  /// Makes f the root of its tree by inverting the parent links on the way up (paper, section 4.5).
  void reroot(const Mesh& mesh, FaceId f);

  /// All faces, parents before children, each tree in one run, children in halfedge order.
  [[nodiscard]] std::vector<FaceId> preorder(const Mesh& mesh) const;

  /// True when parent links lead every face to a root without a cycle.
  [[nodiscard]] bool is_forest(const Mesh& mesh) const;

  bool operator==(const UnfoldTree&) const = default;

 private:
  IdVector<FaceId, HalfedgeId> to_parent_;
};

/// The forest whose folds are exactly the marked edges (one entry per edge); rooted at the smallest face of
/// each tree, or at `root` where it is valid. Throws std::logic_error when the folds contain a cycle.
UnfoldTree tree_from_folds(const Mesh& mesh, const IdVector<EdgeId, char>& is_fold, FaceId root = FaceId());

}  // namespace netwright
