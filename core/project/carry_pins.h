// Pins from one mesh to another of the same model, simplified, merged or changed in the meantime: by the
// nearest face and the nearest edge.
#pragma once

#include <string>

#include "core/mesh/dual_graph.h"
#include "core/solve/constraints.h"

namespace netwright {

struct CarriedPins {
  Constraints pins;  ///< of the new mesh
  int n_lost = 0;    ///< pins that found no place
  /// What was lost, one sentence; empty when nothing was.
  [[nodiscard]] std::string sentence() const;
};

/// The edge of `to` in the place of one of `from`, by the rule of carry_pins(); invalid when there is none.
EdgeId nearest_edge(const Mesh& from, EdgeId edge, const Mesh& to);

/// An edge's pin goes to the edge whose middle is nearest among those that run the same way (within 30
/// degrees), no farther than half of the longer one; the root to the nearest face that looks the same way,
/// first of all the one that comes from the same face of the file. A patch goes to the faces that lie in it.
/// Both meshes stand in the same place.
CarriedPins carry_pins(const Constraints& pins, const Mesh& from, const Mesh& to);

}  // namespace netwright
