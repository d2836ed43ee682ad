// In which order the cuts of a net are glued.
#pragma once

#include <vector>

#include "core/unfold/net.h"

namespace netwright {

/// All cuts, each once. The last seam is the one with the most room around it, the faces at its ends being
/// the largest, so that fingers still get at it; the others are walked from there along the cuts, and each is
/// glued after everything beyond it. So when a seam is glued, the point at its far end is closed with it: all
/// other seams there are done, and those that only close the gap between neighbours of folds come first. One
/// region is finished before the next one begins. Where the cuts do not hang together each part has its own
/// last seam. The same net gives the same order.
std::vector<EdgeId> gluing_order(const Net& net);

}  // namespace netwright
