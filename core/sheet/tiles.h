// Cutting what is larger than the paper into overlapping tiles, along seams that may lie anywhere.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <string>
#include <utility>
#include <vector>

#include "core/base/geometry.h"

namespace netwright {

using Segment = std::pair<glm::dvec2, glm::dvec2>;

/// A canvas cut into columns and rows by seams, the lines along which its sheets are joined. Each tile shows
/// a window of the page's size that reaches over its seams by half the overlap at least.
struct TileGrid {
  glm::dvec2 window{0, 0};
  double overlap = 0;
  Box2 content;                      ///< what has to be shown
  std::vector<double> column_seams;  ///< x on the canvas, ascending
  std::vector<double> row_seams;     ///< y likewise

  /// Seams that are as far apart as the windows allow.
  static TileGrid even(glm::dvec2 window, double overlap, int columns, int rows, const Box2& content);

  [[nodiscard]] int columns() const { return static_cast<int>(column_seams.size()) + 1; }
  [[nodiscard]] int rows() const { return static_cast<int>(row_seams.size()) + 1; }
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns()) +
           static_cast<std::size_t>(column);
  }
  /// Of the canvas: whatever the seams, it has room for evenly spaced ones.
  [[nodiscard]] glm::dvec2 size() const {
    return glm::dvec2(columns(), rows()) * (window - overlap) + overlap;
  }
  /// The corner of the tile's window, on the canvas.
  [[nodiscard]] glm::dvec2 origin(int column, int row) const;
  /// What of its window the tile shows: half an overlap beyond its seams, all where it has no neighbour.
  [[nodiscard]] Box2 shown(int column, int row) const;
  /// The part of the canvas that only this tile answers for: up to its seams, and beyond all bounds where it
  /// has no neighbour.
  [[nodiscard]] Box2 share(int column, int row) const;
};

/// How many columns and rows of windows it takes to show something of this size; 10000 at most.
std::pair<int, int> tiles_for(glm::dvec2 size, glm::dvec2 window, double overlap);

/// Which tiles are needed for the area inside a closed outline (on the canvas, all loops as segments): those
/// whose share meets the area. One entry per tile, row by row.
std::vector<char> needed_tiles(const TileGrid& grid, const std::vector<Segment>& outline);

/// How often the outline winds around a point: 0 outside.
int winding_number(const std::vector<Segment>& outline, glm::dvec2 point);

/// "A1" is the first row and column; after row Z comes AA.
std::string tile_tag(int row, int column);

}  // namespace netwright
