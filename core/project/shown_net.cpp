// Works out what the views need beside a net's placements. The trace of a move is taken from the tree as it
// was before the move, which is found by taking the exchange of hinges back.
#include "core/project/shown_net.h"

#include <algorithm>

namespace netwright {

namespace {

/// More dashed lines than this are a tangle, not an explanation.
constexpr std::size_t kMostCandidates = 200;

/// Which faces lie below which: positions in preorder, so that a subtree is one run.
struct Subtrees {
  IdVector<FaceId, int> begin;
  IdVector<FaceId, int> end;

  Subtrees(const Mesh& mesh, const UnfoldTree& tree) : begin(mesh.n_faces()), end(mesh.n_faces()) {
    const std::vector<FaceId> order = tree.preorder(mesh);
    for (std::size_t i = 0; i < order.size(); ++i) {
      begin[order[i]] = static_cast<int>(i);
      end[order[i]] = static_cast<int>(i) + 1;
    }
    for (auto f = order.rbegin(); f != order.rend(); ++f)
      if (const FaceId up = tree.parent(mesh, *f); up.is_valid()) end[up] = std::max(end[up], end[*f]);
  }

  [[nodiscard]] bool holds(FaceId top, FaceId f) const {
    return begin[f] >= begin[top] && begin[f] < end[top];
  }
};

UnfoldTree tree_before(const Net& after, const MoveRecord& move) {
  const Mesh& mesh = after.mesh();
  IdVector<EdgeId, char> is_fold(mesh.n_edges(), 0);
  for (const FaceId f : mesh.faces())
    if (!after.tree.is_root(f)) is_fold[mesh.edge(after.tree.to_parent(f))] = 1;
  is_fold[mesh.edge(move.inserted)] = 0;
  is_fold[mesh.edge(move.removed)] = 1;
  return tree_from_folds(mesh, is_fold, move.root);
}

/// The cuts at face `at` that lead to the other side of the hinge above `top`: from inside its subtree out,
/// or from outside in.
void add_candidates(const Mesh& mesh, const UnfoldTree& tree, const Subtrees& subtrees, FaceId top, FaceId at,
                    std::vector<char>& is_taken, std::vector<EdgeId>& candidates) {
  const bool is_inside = subtrees.holds(top, at);
  for (const HalfedgeId h : mesh.halfedges(at)) {
    const FaceId beyond = mesh.neighbour(h);
    const EdgeId e = mesh.edge(h);
    if (!beyond.is_valid() || is_taken[e.index()] != 0 || tree.is_fold(mesh, e)) continue;
    if (subtrees.holds(top, beyond) == is_inside || candidates.size() >= kMostCandidates) continue;
    is_taken[e.index()] = 1;
    candidates.push_back(e);
  }
}

}  // namespace

ShownNet make_shown_net(Net net, std::vector<Overlap> overlaps, bool is_proved) {
  ShownNet shown;
  shown.kinds = edge_kinds(net);
  shown.is_overlapping.assign(net.mesh().n_faces(), false);
  for (const Overlap& overlap : overlaps) {
    shown.is_overlapping[overlap.first.index()] = true;
    shown.is_overlapping[overlap.second.index()] = true;
  }
  shown.net = std::move(net);
  shown.overlaps = std::move(overlaps);
  shown.is_proved = is_proved;
  return shown;
}

void trace_move(ShownNet& shown, const MoveRecord& move) {
  const Mesh& mesh = shown.net.mesh();
  const UnfoldTree before = tree_before(shown.net, move);
  const Subtrees subtrees(mesh, before);
  shown.last_move = move;
  shown.climbed = {move.chosen};
  shown.candidates.clear();
  std::vector<char> is_taken(mesh.n_edges(), 0);
  for (FaceId f = move.chosen; !before.is_root(f);) {
    const FaceId up = before.parent(mesh, f);
    add_candidates(mesh, before, subtrees, f, f, is_taken, shown.candidates);
    add_candidates(mesh, before, subtrees, f, up, is_taken, shown.candidates);
    shown.climbed.push_back(up);
    f = up;
  }
  // The search also samples cuts away from the path; of those, only the one it took is known.
  if (const EdgeId taken = mesh.edge(move.inserted); is_taken[taken.index()] == 0)
    shown.candidates.push_back(taken);
}

Net layout_from(std::shared_ptr<const DualGraph> dual, UnfoldTree tree, const std::vector<FaceId>& roots) {
  for (const FaceId root : roots) tree.reroot(dual->mesh(), root);
  return layout(std::move(dual), std::move(tree));
}

}  // namespace netwright
