// Makes what only touches in a stored net touch cleanly, so that no reader of the file, however it computes,
// sees overlaps that are nothing but rounding.
#pragma once

#include "core/unfold/flat_net.h"

namespace netwright {

/// Rounds all points to one binary grid, 2^-50 of the net's extent wide; gives corners within kSameCorner
/// mean edges the same coordinates; and moves a corner that touches the middle of a foreign cut edge a hair's
/// breadth (0.4 of that) out of it. Nothing moves by more than 2 kSameCorner mean edges. Faces must run
/// counter-clockwise.
void settle(FlatNet& net, double mean_edge);

}  // namespace netwright
