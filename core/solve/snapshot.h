// An immutable picture of the search at one moment, made for showing: what the window draws while it runs.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/unfold/net.h"
#include "core/unfold/overlap.h"

namespace netwright {

/// One move of the search, as an exchange of hinges (paper, figure 3): face `chosen` overlapped something,
/// the climb from it went towards `root`, and `removed` left the tree for `inserted`.
struct MoveRecord {
  FaceId chosen;
  FaceId root;
  HalfedgeId removed;   ///< halfedge of the moved side towards its old parent
  HalfedgeId inserted;  ///< halfedge of the moved side towards its new parent
  int overlaps_after = 0;
};

/// Moves between two (re)starts, with the tree they started from. Polish adds episodes without moves, one for
/// each better net.
struct Episode {
  UnfoldTree start;
  int overlaps_at_start = 0;
  std::vector<MoveRecord> moves;
  bool is_polish = false;
  double polish_fraction = 0;  ///< see PolishStation; only of polish
};

/// A net that polish started from or came to, all components together.
struct PolishStation {
  double fraction = 0;    ///< of the work that was done by then
  double cut_length = 0;  ///< see net_size.h; model units
  double paper = 0;       ///< area of the smallest rectangles
};

/// How far polish is.
struct PolishView {
  double fraction = 0;        ///< of the work it may do
  std::vector<double> costs;  ///< what was left to wish for (see aims.h), at the start and after each round
  std::vector<PolishStation> stations;  ///< the first net and every better one; only for a watcher
};

struct Snapshot {
  Net net;
  std::vector<Overlap> overlaps;
  std::int64_t iterations = 0;  ///< moves tried, of all streams
  std::int64_t moves = 0;       ///< moves made by the stream shown
  std::int64_t moves_of_all =
      0;             ///< moves made by all streams up to now, shown or not: the search's true pace
  int restarts = 0;  ///< of the stream shown
  int stream = 0;
  int best_overlaps = 0;     ///< fewest so far, over all streams
  std::vector<int> history;  ///< overlaps after each move of the stream shown, thinned to at most 2000 values
  std::int64_t history_stride = 1;
  std::optional<MoveRecord> last_move;
  std::optional<PolishView> polish;  ///< set from the first net on; every net shown then is a proved one
  bool is_final = false;
};

}  // namespace netwright
