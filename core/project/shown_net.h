// What both views draw: a net with all that is worked out for the eye, made in one place from any net, be it
// the project's own, a search's snapshot or a moment of a replay.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/solve/snapshot.h"
#include "core/unfold/fold.h"
#include "core/unfold/net.h"
#include "core/unfold/overlap.h"

namespace netwright {

/// What both views draw: the running search's latest snapshot, or the project's own net. Replaced as a whole.
struct ShownNet {
  std::uint64_t version = 0;  ///< changes whenever anything below does
  Net net;                    ///< several pieces stand side by side
  std::vector<Overlap> overlaps;
  std::vector<bool> is_overlapping;  ///< one per face
  IdVector<EdgeId, EdgeKind> kinds;
  std::optional<MoveRecord> last_move;  ///< while stepping or replaying
  std::vector<FaceId> climbed;          ///< faces on the path climbed by last_move, chosen face first
  std::vector<EdgeId> candidates;       ///< cuts that the climb could have turned into folds
  bool is_proved = false;
};

/// Works out kinds and overlapping faces.
ShownNet make_shown_net(Net net, std::vector<Overlap> overlaps, bool is_proved);

/// Fills in last_move, climbed and candidates; `shown.net` is the net after the move.
void trace_move(ShownNet& shown, const MoveRecord& move);

/// Lays a tree out with these faces as the roots of their pieces, whatever its own roots are: two nets of one
/// model then agree there, and the picture holds still while a search goes on.
Net layout_from(std::shared_ptr<const DualGraph> dual, UnfoldTree tree, const std::vector<FaceId>& roots);

}  // namespace netwright
