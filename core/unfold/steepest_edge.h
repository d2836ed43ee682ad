// The initial unfolder of the paper's section 4.2: steepest edge unfolding (Schlickenrieder 1997). Fast,
// different for every direction, and usually full of overlaps: the search removes those.
#pragma once

#include "core/base/random.h"
#include "core/mesh/dual_graph.h"
#include "core/unfold/unfold_tree.h"

namespace netwright {

/// Draws a random direction; every vertex cuts the edge that climbs most steeply along it; a breadth-first
/// walk over what is left uncut makes the tree (where the cuts leave several parts, or a cycle of folds on a
/// higher genus, the walk decides). One tree per component of the mesh.
UnfoldTree steepest_edge_tree(const DualGraph& dual, Random& random);

}  // namespace netwright
