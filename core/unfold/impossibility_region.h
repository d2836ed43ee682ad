// How the checker of impossibility proofs judges a region: by trying every forest of it.
#pragma once

#include <string>
#include <vector>

#include "core/unfold/certain_overlap.h"
#include "core/unfold/impossibility.h"

namespace netwright::proof {

/// Those faces of a region (ascending) that have a hinge to a face outside it.
std::vector<FaceId> region_doors(const Mesh& mesh, const std::vector<FaceId>& faces);

/// Empty when every forest of the region without a certain overlap, whose every tree has a door, joins its
/// doors as one of `joins` does or finer; else what is wrong. Each step of the trial is taken from `steps`.
std::string region_fault(const RolledFaces& rolled, const ImpossibilityProof::Region& region,
                         std::int64_t& steps);

}  // namespace netwright::proof
