// What moved seams are measured against, in tests and in tiles_bench: a net in the middle of evenly spaced
// columns and rows that all have the same seams, turned to the angle that takes the fewest sheets.
#pragma once

#include <algorithm>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "core/base/best_angle.h"
#include "core/sheet/outline.h"
#include "core/sheet/page_frame.h"
#include "core/sheet/pages.h"
#include "core/sheet/tiles.h"

namespace netwright::testing {

struct FixedGrid {
  std::size_t n_sheets = std::numeric_limits<std::size_t>::max();
  int n_cut_marks = 0;
};

inline constexpr double kGridOverlap_mm = 10;

/// The sheets that a net's outline runs through, and those wholly inside of it.
inline std::size_t sheets_on_grid(const TiledArea& area, glm::dvec2 pitch, int columns, int rows) {
  std::size_t n_sheets = 0;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      constexpr double kFar = 1e9;
      const glm::dvec2 low = glm::dvec2(column, row) * pitch + kGridOverlap_mm / 2;
      const Box2 share{
          {column == 0 ? -kFar : low.x, row == 0 ? -kFar : low.y},
          {column == columns - 1 ? kFar : low.x + pitch.x, row == rows - 1 ? kFar : low.y + pitch.y}};
      const bool is_touched = std::any_of(area.outline.begin(), area.outline.end(), [&](const Segment& side) {
        return clip_segment(share, side.first, side.second).has_value();
      });
      n_sheets += is_touched || winding_number(area.outline, low + pitch / 2.0) != 0 ? 1 : 0;
    }
  return n_sheets;
}

/// How often evenly spaced seams along one axis run through marks.
inline int cuts_on_grid(const TiledArea& area, int axis, double pitch, int count) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  int n_cuts = 0;
  for (const NetMark& mark : area.marks) {
    const Span reach = reach_of(mark, axis, {-kFar, kFar});
    for (int i = 1; i < count; ++i) {
      const double seam = i * pitch + kGridOverlap_mm / 2;
      n_cuts += reach.low < seam && seam < reach.high ? 1 : 0;
    }
  }
  return n_cuts;
}

inline FixedGrid on_a_fixed_grid(const PieceShape& piece, const PageFrame& frame) {
  const glm::dvec2 room = frame.net.size();
  const glm::dvec2 pitch = room - kGridOverlap_mm;
  FixedGrid best;
  double least_fill = 0;
  for (int k = 0; k < 60; ++k) {
    const double angle = k * std::numbers::pi / 60;
    const Box2 box = turned_box(piece.hull, angle);
    const auto [columns, rows] = tiles_for(box.size(), room, kGridOverlap_mm);
    const glm::dvec2 canvas = tiled_size(room, kGridOverlap_mm, columns, rows);
    Rigid2 turn = Rigid2::rotation(angle);
    turn.x = (canvas.x - box.size().x) / 2 - box.min.x;
    turn.y = -(canvas.y - box.size().y) / 2 - box.max.y;
    TiledArea area;
    add_to_area(area, piece, turn);
    const std::size_t n_sheets = sheets_on_grid(area, pitch, columns, rows);
    const double fill = std::max(box.size().x / canvas.x, box.size().y / canvas.y);
    if (std::pair(n_sheets, fill) >= std::pair(best.n_sheets, least_fill)) continue;
    best = {n_sheets, cuts_on_grid(area, 0, pitch.x, columns) + cuts_on_grid(area, 1, pitch.y, rows)};
    least_fill = fill;
  }
  return best;
}

/// Of all the paper's orientations the one that takes the fewest sheets.
inline FixedGrid on_a_fixed_grid(const PieceShape& piece, const std::vector<PageFrame>& frames) {
  FixedGrid best;
  for (const PageFrame& frame : frames) {
    const FixedGrid grid = on_a_fixed_grid(piece, frame);
    if (grid.n_sheets < best.n_sheets) best = grid;
  }
  return best;
}

/// How often a layout's seams run through the marks of its first piece.
inline int marks_cut(const PieceShapes& shapes, const PageLayout& layout) {
  TiledArea area;
  add_to_area(area, shapes.pieces.front(), layout.pieces.front().turn);
  int n_cuts = 0;
  for (const auto& [from, to] : layout.canvases.front().seams) {
    const int axis = from.x == to.x ? 0 : 1;
    for (const NetMark& mark : area.marks) {
      const Span reach = reach_of(mark, axis, {from[1 - axis], to[1 - axis]});
      n_cuts += reach.low < from[axis] && from[axis] < reach.high ? 1 : 0;
    }
  }
  return n_cuts;
}

}  // namespace netwright::testing
