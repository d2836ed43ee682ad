// Cutting a piece that is larger than the paper into overlapping tiles.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <string>
#include <utility>
#include <vector>

namespace netwright {

using Segment = std::pair<glm::dvec2, glm::dvec2>;

/// A canvas cut into columns x rows windows of the page's size; neighbours share `overlap` mm.
struct TileGrid {
  glm::dvec2 window{0, 0};
  double overlap = 0;
  int columns = 1;
  int rows = 1;

  /// Just enough tiles for something of this size; `columns` and `rows` stop at 10000.
  static TileGrid covering(glm::dvec2 size, glm::dvec2 window, double overlap);

  [[nodiscard]] glm::dvec2 stride() const { return window - overlap; }
  [[nodiscard]] glm::dvec2 size() const { return glm::dvec2(columns, rows) * stride() + overlap; }
  [[nodiscard]] glm::dvec2 origin(int column, int row) const { return glm::dvec2(column, row) * stride(); }
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
};

/// Which tiles are needed for the area inside a closed outline (on the canvas, all loops as segments): the
/// tiles whose own share of the canvas, up to the middle of each overlap, meets the area. One entry per tile,
/// row by row.
std::vector<char> needed_tiles(const TileGrid& grid, const std::vector<Segment>& outline);

/// How often the outline winds around a point: 0 outside.
int winding_number(const std::vector<Segment>& outline, glm::dvec2 point);

/// "A1" is the first row and column; after row Z comes AA.
std::string tile_tag(int row, int column);

}  // namespace netwright
