// The two steps that merging repeats: joining what can be joined, and opening flat regions with holes.
#pragma once

#include "core/mesh/merge_pieces.h"
#include "core/mesh/merge_stage.h"

namespace netwright {

/// Grows flat regions, joins each into simple polygons, and drops the points nobody needs. Regions that make
/// no single polygon, because they have holes, are joined by `rule`; those that `open_regions` has been over
/// and can do nothing more for stay as they are.
MergeStage join_faces(const MergeStage& from, double tolerance_rad, JoinRule rule);

/// Cuts the groups in regions with holes into parts without inward corners, along diagonals. What stands on
/// the rim of a hole must find room in the net; inside a face with a notch it would not. Every part keeps at
/// least one source of its own, so single faces are never cut.
MergeStage open_regions(const MergeStage& from, double tolerance_rad);

}  // namespace netwright
