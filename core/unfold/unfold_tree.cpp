// Walking, rerooting and rebuilding unfold trees.
#include "core/unfold/unfold_tree.h"

#include <algorithm>
#include <stdexcept>

namespace netwright {

std::vector<FaceId> UnfoldTree::roots() const {
  std::vector<FaceId> result;
  for (const FaceId f : to_parent_.ids())
    if (is_root(f)) result.push_back(f);
  return result;
}

bool UnfoldTree::is_fold(const Mesh& mesh, EdgeId e) const {
  const HalfedgeId h = mesh.halfedge(e);
  const HalfedgeId t = mesh.twin(h);
  return t.is_valid() && (to_parent_[mesh.face(h)] == h || to_parent_[mesh.face(t)] == t);
}

void UnfoldTree::reroot(const Mesh& mesh, FaceId f) {
  HalfedgeId across;  // what f's parent link becomes
  while (f.is_valid()) {
    const HalfedgeId up = to_parent_[f];
    to_parent_[f] = across;
    if (!up.is_valid()) return;
    across = mesh.twin(up);
    f = mesh.face(across);
  }
}

std::vector<FaceId> UnfoldTree::preorder(const Mesh& mesh) const {
  std::vector<FaceId> order;
  order.reserve(n_faces());
  std::vector<FaceId> stack;
  std::vector<FaceId> children;
  for (const FaceId root : roots()) {
    stack.push_back(root);
    while (!stack.empty()) {
      const FaceId f = stack.back();
      stack.pop_back();
      order.push_back(f);
      children.clear();
      for (const HalfedgeId h : mesh.halfedges(f)) {
        const HalfedgeId t = mesh.twin(h);
        if (t.is_valid() && to_parent_[mesh.face(t)] == t) children.push_back(mesh.face(t));
      }
      stack.insert(stack.end(), children.rbegin(), children.rend());
    }
  }
  return order;
}

bool UnfoldTree::is_forest(const Mesh& mesh) const {
  if (n_faces() != mesh.n_faces()) return false;
  for (const FaceId f : to_parent_.ids())
    if (to_parent_[f].is_valid() && (mesh.face(to_parent_[f]) != f || !mesh.twin(to_parent_[f]).is_valid()))
      return false;
  return preorder(mesh).size() == n_faces();
}

UnfoldTree tree_from_folds(const Mesh& mesh, const IdVector<EdgeId, char>& is_fold, FaceId root) {
  UnfoldTree tree(mesh.n_faces());
  IdVector<FaceId, char> seen(mesh.n_faces(), 0);
  std::vector<FaceId> stack;
  const auto grow_from = [&](FaceId start) {
    if (seen[start]) return;
    seen[start] = 1;
    stack.push_back(start);
    while (!stack.empty()) {
      const FaceId f = stack.back();
      stack.pop_back();
      for (const HalfedgeId h : mesh.halfedges(f)) {
        const HalfedgeId t = mesh.twin(h);
        if (!t.is_valid() || !is_fold[mesh.edge(h)] || tree.to_parent(f) == h) continue;
        const FaceId g = mesh.face(t);
        if (seen[g]) throw std::logic_error("The folds contain a cycle.");
        seen[g] = 1;
        tree.set_parent(g, t);
        stack.push_back(g);
      }
    }
  };
  if (root.is_valid()) grow_from(root);
  for (const FaceId f : mesh.faces()) grow_from(f);
  return tree;
}

}  // namespace netwright
