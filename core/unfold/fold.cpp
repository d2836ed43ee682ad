// Tells mountains from valleys by the dual graph's bend.
#include "core/unfold/fold.h"

#include <cmath>

#include "core/base/predicates.h"

namespace netwright {

namespace {

EdgeKind kind_of_fold(const DualGraph& dual, EdgeId e) {
  if (dual.is_hidden(e)) return EdgeKind::Hidden;
  const double bend = dual.bend(e);
  if (std::abs(bend) < kFlatFold) return EdgeKind::Flat;
  return bend > 0 ? EdgeKind::Mountain : EdgeKind::Valley;
}

}  // namespace

IdVector<EdgeId, EdgeKind> edge_kinds(const Net& net) {
  const Mesh& mesh = net.mesh();
  IdVector<EdgeId, EdgeKind> kinds(mesh.n_edges(), EdgeKind::Cut);
  for (const EdgeId e : mesh.edges()) {
    if (mesh.is_border(e)) {
      kinds[e] = EdgeKind::Border;
    } else if (net.tree.is_fold(mesh, e)) {
      kinds[e] = kind_of_fold(*net.dual, e);
    }
  }
  return kinds;
}

}  // namespace netwright
