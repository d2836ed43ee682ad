// Whether faces that have to stay together can lie flat at all: an exact search over the ways of joining
// them, small because every overlap cuts a whole branch of it off.
#pragma once

#include <optional>
#include <vector>

#include "core/base/ids.h"
#include "core/mesh/dual_graph.h"

namespace netwright {

/// True when every tree of folds that joins these faces makes two of them overlap: of the hinges between
/// them, `may_fold` (one flag per edge) are free to be used and `must_fold` have to be. Nothing when the
/// search gives up, after `max_steps` faces laid down. The faces must hang together.
std::optional<bool> is_crowded(const DualGraph& dual, const std::vector<FaceId>& faces,
                               const IdVector<EdgeId, char>& may_fold,
                               const IdVector<EdgeId, char>& must_fold, int max_steps);

}  // namespace netwright
