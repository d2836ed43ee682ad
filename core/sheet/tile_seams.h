// Where to join the sheets of a net that is larger than the paper: seams that run through few folds, labels
// and tabs, on no more sheets than evenly spaced ones take.
#pragma once

#include <optional>
#include <vector>

#include "core/sheet/piece_shapes.h"
#include "core/sheet/tiles.h"

namespace netwright {

/// What lies on a canvas, in mm, y down.
struct TiledArea {
  std::vector<Segment> outline;  ///< closed
  std::vector<Box2> marks;       ///< boxes of what a seam should not run through
  Box2 box;                      ///< of the outline
};

/// The pieces' shapes as a motion (y up) puts them on the canvas.
void add_to_area(TiledArea& area, const PieceShape& piece, const Rigid2& turn);

struct Tiling {
  TileGrid grid;
  std::vector<char> is_needed;  ///< one entry per tile, row by row
  std::size_t n_sheets = 0;
  int n_cut_marks = 0;  ///< how often a seam runs through a mark
};

/// Evenly spaced seams.
Tiling even_tiling(const TiledArea& area, glm::dvec2 window, double overlap, int columns, int rows);

/// Seams wherever they cut the fewest marks on at most so many sheets; the windows follow, and overlap more
/// where paper is left over. Nothing when that takes more sheets, or cuts `cuts_too_many` marks or more.
std::optional<Tiling> best_tiling(const TiledArea& area, glm::dvec2 window, double overlap, int columns,
                                  int rows, std::size_t most_sheets, int cuts_too_many);

/// Fewer sheets, then fewer marks cut.
bool is_better(const Tiling& a, const Tiling& b);

}  // namespace netwright
