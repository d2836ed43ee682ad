// How bad an overlap is, for lists that people read.
#pragma once

#include "core/unfold/overlap.h"

namespace netwright {

/// The least distance one face must move to come free of the other, in model units; for faces that aren't
/// convex that of their deepest convex parts. 0 when they don't overlap.
double overlap_depth(const Net& net, const Overlap& overlap);

}  // namespace netwright
