// Proofs of impossibility from small regions: what a net can join inside each of them, and that no choice of
// these leaves the model in one piece. (The argument of Bern, Demaine, Eppstein, Kuo, Mantler and Snoeyink,
// "Ununfoldable Polyhedra with Convex Faces", 2003, for hats, made mechanical.)
#pragma once

#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/dual_graph.h"
#include "core/unfold/impossibility.h"

namespace netwright {

/// The coarsest ways in which nets can join the doors of a region (see ImpossibilityProof::Region); nothing
/// when they are too many to try. `steps` counts down.
std::optional<ImpossibilityProof::Region> region_joins(const DualGraph& dual, std::vector<FaceId> faces,
                                                       std::int64_t& steps);

/// Regions that no net leaves whole, none sharing a face with another; those that force most parts first.
/// Empty when cancelled.
std::vector<ImpossibilityProof::Region> telling_regions(const DualGraph& dual, const Progress& progress);

/// At least so many pieces does every net of the whole mesh have: each telling region falls into two trees or
/// more, and there are only so many hinges outside of them to join these with.
int least_pieces(const Mesh& mesh, const std::vector<ImpossibilityProof::Region>& telling);

/// Nothing after `max_steps`, when cancelled, or when the regions allow a net. The same answer every time.
std::optional<ImpossibilityProof> search_regions(const DualGraph& dual, std::int64_t max_steps,
                                                 const Progress& progress);

}  // namespace netwright
