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

std::vector<double> even_seams(double window, double overlap, int count) {
  std::vector<double> seams;
  for (int i = 1; i < count; ++i) seams.push_back(i * (window - overlap) + overlap / 2);
  return seams;
}

/// Where a window begins that shows all from `low` to `high`: what is left over lies on both sides.
double window_start(double low, double high, double window, double size) {
  return std::clamp((low + high - window) / 2, 0.0, std::max(0.0, size - window));
}

/// Where the outline crosses the level line at this height, upwards (1) or downwards (-1).
std::vector<std::pair<double, int>> crossings_at(const std::vector<Segment>& outline, double y) {
  std::vector<std::pair<double, int>> crossings;
  for (const auto& [a, b] : outline)
    if ((a.y <= y) != (b.y <= y))
      crossings.emplace_back(a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)), a.y <= y ? 1 : -1);
  return crossings;
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

TileGrid TileGrid::even(glm::dvec2 window, double overlap, int columns, int rows, const Box2& content) {
  return {window, overlap, content, even_seams(window.x, overlap, columns),
          even_seams(window.y, overlap, rows)};
}

Box2 TileGrid::share(int column, int row) const {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  const auto before = [](const std::vector<double>& seams, int i) {
    return i == 0 ? -kFar : seams[static_cast<std::size_t>(i) - 1];
  };
  const auto behind = [](const std::vector<double>& seams, int i) {
    return static_cast<std::size_t>(i) == seams.size() ? kFar : seams[static_cast<std::size_t>(i)];
  };
  return {{before(column_seams, column), before(row_seams, row)},
          {behind(column_seams, column), behind(row_seams, row)}};
}

glm::dvec2 TileGrid::origin(int column, int row) const {
  Box2 shown = share(column, row);
  shown.min -= overlap / 2;
  shown.max += overlap / 2;
  shown.min = glm::max(shown.min, content.min);
  shown.max = glm::min(shown.max, content.max);
  return {window_start(shown.min.x, shown.max.x, window.x, size().x),
          window_start(shown.min.y, shown.max.y, window.y, size().y)};
}

Box2 TileGrid::shown(int column, int row) const {
  const glm::dvec2 corner = origin(column, row);
  const Box2 own = share(column, row);
  return {glm::max(own.min - overlap / 2, corner), glm::min(own.max + overlap / 2, corner + window)};
}

std::pair<int, int> tiles_for(glm::dvec2 size, glm::dvec2 window, double overlap) {
  return {count_for(size.x, window.x, overlap), count_for(size.y, window.y, overlap)};
}

std::vector<char> needed_tiles(const TileGrid& grid, const std::vector<Segment>& outline) {
  std::vector<char> is_needed(grid.index(0, grid.rows()), 0);
  const auto cell = [](double at, const std::vector<double>& seams) {
    return static_cast<int>(std::upper_bound(seams.begin(), seams.end(), at) - seams.begin());
  };
  for (const auto& [a, b] : outline) {
    const int last_row = cell(std::max(a.y, b.y), grid.row_seams);
    const int last_column = cell(std::max(a.x, b.x), grid.column_seams);
    for (int row = cell(std::min(a.y, b.y), grid.row_seams); row <= last_row; ++row)
      for (int column = cell(std::min(a.x, b.x), grid.column_seams); column <= last_column; ++column) {
        char& needed = is_needed[grid.index(column, row)];
        if (needed == 0 && clip_segment(grid.share(column, row), a, b)) needed = 1;
      }
  }
  // Where no outline runs through a tile, one point of its share speaks for all of it.
  for (int row = 0; row < grid.rows(); ++row) {
    const auto middle_of = [&](int column) {
      const Box2 share = grid.share(column, row);
      return (glm::max(share.min, grid.content.min) + glm::min(share.max, grid.content.max)) * 0.5;
    };
    const std::vector<std::pair<double, int>> crossings = crossings_at(outline, middle_of(0).y);
    for (int column = 0; column < grid.columns(); ++column) {
      char& needed = is_needed[grid.index(column, row)];
      if (needed != 0) continue;
      int winding = 0;
      for (const auto& [x, turn] : crossings) winding += x > middle_of(column).x ? turn : 0;
      if (winding != 0) needed = 1;
    }
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
