// What every edge of a net is: a mountain, a valley, a flat fold, a cut or a border. The one source for
// screen and paper.
#pragma once

#include "core/unfold/net.h"

namespace netwright {

enum class EdgeKind {
  Mountain,  ///< folds away from the printed (outer) side: convex on the model
  Valley,    ///< folds towards it: reflex on the model
  Flat,      ///< bent less than kFlatFold: not printed
  Hidden,    ///< as good as flat, and not even hinted at (DualGraph::is_hidden)
  Cut,
  Border,  ///< the model is open here; cut too, but nothing is glued to it
};

/// One kind per edge of the mesh.
IdVector<EdgeId, EdgeKind> edge_kinds(const Net& net);

}  // namespace netwright
