// Which tiles a piece needs: those its outline runs through, and those that lie wholly inside it.
#include "core/sheet/tiles.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/geometry.h"
#include "core/sheet/outline.h"

namespace netwright {

namespace {

constexpr int kMostPerSide = 10000;

int count_for(double size, double window, double overlap) {
  // A billionth of a page more is no reason for another page.
  const double count = std::ceil((size - overlap) / (window - overlap) - 1e-9);
  return static_cast<int>(std::clamp(count, 1.0, static_cast<double>(kMostPerSide)));
}

/// The share of the canvas that only this tile answers for.
Box2 own_share(const TileGrid& grid, int column, int row) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  const glm::dvec2 low = grid.origin(column, row) + grid.overlap / 2;
  const glm::dvec2 high = grid.origin(column + 1, row + 1) + grid.overlap / 2;
  return {{column == 0 ? -kFar : low.x, row == 0 ? -kFar : low.y},
          {column + 1 == grid.columns ? kFar : high.x, row + 1 == grid.rows ? kFar : high.y}};
}

}  // namespace

int winding_number(const std::vector<Segment>& outline, glm::dvec2 p) {
  int winding = 0;
  for (const auto& [a, b] : outline) {
    if ((a.y <= p.y) == (b.y <= p.y)) continue;
    const double side = cross(b - a, p - a);
    if (a.y <= p.y && side > 0) ++winding;
    if (a.y > p.y && side < 0) --winding;
  }
  return winding;
}

TileGrid TileGrid::covering(glm::dvec2 size, glm::dvec2 window, double overlap) {
  return {window, overlap, count_for(size.x, window.x, overlap), count_for(size.y, window.y, overlap)};
}

std::vector<char> needed_tiles(const TileGrid& grid, const std::vector<Segment>& outline) {
  std::vector<char> is_needed(grid.index(0, grid.rows), 0);
  const auto cell = [&](double at, double stride, int count) {
    return std::clamp(static_cast<int>(std::floor((at - grid.overlap / 2) / stride)), 0, count - 1);
  };
  const auto column_at = [&](double x) { return cell(x, grid.stride().x, grid.columns); };
  const auto row_at = [&](double y) { return cell(y, grid.stride().y, grid.rows); };
  for (const auto& [a, b] : outline)
    for (int row = row_at(std::min(a.y, b.y)); row <= row_at(std::max(a.y, b.y)); ++row)
      for (int column = column_at(std::min(a.x, b.x)); column <= column_at(std::max(a.x, b.x)); ++column)
        if (clip_segment(own_share(grid, column, row), a, b)) is_needed[grid.index(column, row)] = 1;
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      const glm::dvec2 centre = grid.origin(column, row) + grid.window * 0.5;
      char& needed = is_needed[grid.index(column, row)];
      if (needed == 0 && winding_number(outline, centre) != 0) needed = 1;
    }
  return is_needed;
}

std::string tile_tag(int row, int column) {
  std::string letters;
  for (int rest = row; rest >= 0; rest = rest / 26 - 1)
    letters.insert(letters.begin(), static_cast<char>('A' + rest % 26));
  return letters + std::to_string(column + 1);
}

}  // namespace netwright
