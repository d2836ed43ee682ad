// Cutting what is larger than the paper into overlapping tiles: rows of sheets, each row with seams of its
// own, where they run through few folds, labels and tabs.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <string>
#include <utility>
#include <vector>

#include "core/base/geometry.h"
#include "core/sheet/cut_strip.h"
#include "core/sheet/piece_shapes.h"

namespace netwright {

/// How many columns and rows of windows it takes to show something of this size; 10000 at most.
std::pair<int, int> tiles_for(glm::dvec2 size, glm::dvec2 window, double overlap);

/// What so many columns and rows show.
glm::dvec2 tiled_size(glm::dvec2 window, double overlap, int columns, int rows);

/// What lies on a canvas, in mm, y down.
struct TiledArea {
  std::vector<Segment> outline;  ///< closed
  std::vector<NetMark> marks;    ///< what a seam should not run through
  Box2 box;                      ///< of the outline
};

/// The pieces' shapes as a motion (y up) puts them on the canvas.
void add_to_area(TiledArea& area, const PieceShape& piece, const Rigid2& turn);

/// How far a mark reaches between two levels along the other axis (0: x); empty (low > high) where it has
/// nothing there.
Span reach_of(const NetMark& mark, int axis, Span between);

struct Tiling {
  struct Tile {
    int row = 0;
    int column = 0;     ///< counted in its row: columns need not lie below each other
    Box2 share;         ///< what only this sheet answers for: up to its seams, or to where there is no paper
    Box2 shown;         ///< half an overlap more on every side, as far as the window reaches
    glm::dvec2 origin;  ///< the corner of its window
  };
  std::vector<Tile> tiles;  ///< row by row, each from left to right
  int n_rows = 0;
  std::vector<Segment> seams;  ///< the lines along which sheets are joined
  int n_cut_marks = 0;         ///< how often a seam runs through a mark
};

/// Rows, and in each of them sheets where that row has paper, each with seams of its own.
Tiling tile_area(const TiledArea& area, glm::dvec2 window, double overlap);

/// Fewer sheets and marks cut, as kMarksPerSheet weighs them.
bool is_better(const Tiling& a, const Tiling& b);

/// "A1" is the first row and column; after row Z comes AA.
std::string tile_tag(int row, int column);

}  // namespace netwright
