// Tells mountains from valleys by the dual graph's bend.
#include "core/unfold/fold.h"

#include <cmath>

#include "core/base/predicates.h"

namespace netwright {

IdVector<EdgeId, EdgeKind> edge_kinds(const Net& net) {
  const Mesh& mesh = net.mesh();
  IdVector<EdgeId, EdgeKind> kinds(mesh.n_edges(), EdgeKind::Cut);
  for (const EdgeId e : mesh.edges()) {
    if (mesh.is_border(e)) {
      kinds[e] = EdgeKind::Border;
    } else if (net.tree.is_fold(mesh, e)) {
      const double bend = net.dual->bend(e);
      kinds[e] =
          std::abs(bend) < kFlatFold ? EdgeKind::Flat : (bend > 0 ? EdgeKind::Mountain : EdgeKind::Valley);
    }
  }
  return kinds;
}

}  // namespace netwright
