// Start trees for the search: the paper's steepest edge (section 4.2), and a greedy one that looks at
// overlaps while it grows and starts the search some twenty times nearer to a net.
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/base/random.h"
#include "core/solve/search_model.h"
#include "core/unfold/unfold_tree.h"

namespace netwright {

/// Folds of a tree grown from a random face: the half-edge with the largest key |place of the new face's
/// centre| / sqrt(area) + 0.5 edge / mean edge + 0.3 random goes first; a face that would overlap what is
/// placed already is put aside, and when nothing else is left the least overlapping of up to 48 sampled ones
/// is forced in. A face that must be folded to a placed one follows it at once, and a patch is grown to its
/// end before anything else. Once `progress` (may be null) is cancelled, the rest is put on without looking.
std::vector<char> greedy_folds(const SearchModel& model, Random& random, double depth,
                               const Progress* progress = nullptr);

/// A spanning tree that keeps the model's pins and as many of these folds as go with them: must-folds first,
/// then patches, then the wished folds, then whatever is missing, each in the order of halfedges. Without
/// pins a spanning tree comes back as it is. The pins must not contradict each other.
std::vector<char> pinned_folds(const SearchModel& model, const std::vector<char>& wished);

/// Folds of the paper's start tree for a random direction.
std::vector<char> steepest_edge_folds(const DualGraph& dual, const SearchModel& model, Random& random);

}  // namespace netwright
