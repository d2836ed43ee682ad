// The canvas is cut into rows first, by what lies in each of them then into sheets: a straight seam through
// the whole net would cut more, and rows that are short or have gaps would waste paper.
#include "core/sheet/tiles.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/sheet/outline.h"

namespace netwright {

namespace {

constexpr int kMostPerSide = 10000;
constexpr double kFar = std::numeric_limits<double>::infinity();

int count_for(double size, double window, double overlap) {
  // A billionth of a page more is no reason for another page.
  const double count = std::ceil((size - overlap) / (window - overlap) - 1e-9);
  return static_cast<int>(std::clamp(count, 1.0, static_cast<double>(kMostPerSide)));
}

/// How far a segment reaches along an axis between two levels along the other one.
Span reach_of(glm::dvec2 a, glm::dvec2 b, int axis, Span between) {
  const int other = 1 - axis;
  if (a[other] > b[other]) std::swap(a, b);
  if (b[other] < between.low || a[other] > between.high) return {kFar, -kFar};
  const auto at = [&](double level) {
    const double t = (level - a[other]) / (b[other] - a[other]);
    return a[axis] + (b[axis] - a[axis]) * t;
  };
  const double one = a[other] < between.low ? at(between.low) : a[axis];
  const double two = b[other] > between.high ? at(between.high) : b[axis];
  return {std::min(one, two), std::max(one, two)};
}

/// The paper along an axis, between two levels: where its outline runs, and what lies inside of it between.
std::vector<Span> paper_along(const TiledArea& area, int axis, Span between, double overlap) {
  std::vector<Span> spans;
  for (const auto& [a, b] : area.outline) {
    const Span reach = reach_of(a, b, axis, between);
    if (reach.low <= reach.high) spans.push_back(reach);
  }
  spans = merge_spans(std::move(spans), overlap);
  const double level = (between.low + between.high) / 2;
  for (std::size_t i = 1; i < spans.size(); ++i) {
    glm::dvec2 gap(level);
    gap[axis] = (spans[i - 1].high + spans[i].low) / 2;
    if (winding_number(area.outline, gap) != 0) spans[i].low = spans[i - 1].high;
  }
  return merge_spans(std::move(spans), overlap);
}

CutStrip cut_along(const TiledArea& area, int axis, Span between, double window, double overlap) {
  StripToCut strip{paper_along(area, axis, between, overlap), {}};
  for (const NetMark& mark : area.marks) {
    const Span reach = reach_of(mark, axis, between);
    if (reach.low < reach.high) strip.marks.push_back(reach);
  }
  return cut_strip(strip, window, overlap);
}

/// Which sides of a share are seams.
struct Joined {
  bool low = false;
  bool high = false;
};

Joined joined_at(const std::vector<Span>& shares, std::size_t i) {
  return {i > 0 && shares[i - 1].high == shares[i].low,
          i + 1 < shares.size() && shares[i].high == shares[i + 1].low};
}

/// Where a window begins that reaches over the seams of a share by half an overlap: what is left over lies on
/// both sides.
double window_start(const Span& share, Joined joined, double window, double overlap) {
  const double low = share.low - (joined.low ? overlap / 2 : 0);
  const double high = share.high + (joined.high ? overlap / 2 : 0);
  return (low + high - window) / 2;
}

Tiling::Tile tile_of(const Box2& share, glm::dvec2 origin, glm::dvec2 window, double overlap) {
  Tiling::Tile tile;
  tile.share = share;
  tile.origin = origin;
  tile.shown = {glm::max(share.min - overlap / 2, origin),
                glm::min(share.max + overlap / 2, origin + window)};
  return tile;
}

void add_row(Tiling& tiling, const CutStrip& row, const Box2& place, double top, glm::dvec2 window,
             double overlap) {
  for (std::size_t i = 0; i < row.shares.size(); ++i) {
    const Box2 share{{row.shares[i].low, place.min.y}, {row.shares[i].high, place.max.y}};
    const Joined joined = joined_at(row.shares, i);
    const glm::dvec2 origin(window_start(row.shares[i], joined, window.x, overlap), top);
    Tiling::Tile& tile = tiling.tiles.emplace_back(tile_of(share, origin, window, overlap));
    tile.row = tiling.n_rows;
    tile.column = static_cast<int>(i);
    if (joined.low) tiling.seams.emplace_back(share.min, glm::dvec2(share.min.x, share.max.y));
  }
  ++tiling.n_rows;
  tiling.n_cut_marks += row.n_cut_marks;
}

}  // namespace

std::pair<int, int> tiles_for(glm::dvec2 size, glm::dvec2 window, double overlap) {
  return {count_for(size.x, window.x, overlap), count_for(size.y, window.y, overlap)};
}

glm::dvec2 tiled_size(glm::dvec2 window, double overlap, int columns, int rows) {
  return glm::dvec2(columns, rows) * (window - overlap) + overlap;
}

void add_to_area(TiledArea& area, const PieceShape& piece, const Rigid2& turn) {
  const auto on_canvas = [&](glm::dvec2 p) {
    const glm::dvec2 turned = turn(p);
    return glm::dvec2(turned.x, -turned.y);
  };
  for (const std::vector<glm::dvec2>& outline : piece.outlines) {
    glm::dvec2 before = on_canvas(outline.back());
    for (const glm::dvec2 p : outline) {
      const glm::dvec2 here = on_canvas(p);
      area.outline.emplace_back(before, here);
      area.box.add(here);
      before = here;
    }
  }
  for (NetMark mark : piece.marks) {
    for (glm::dvec2& p : mark.points) p = on_canvas(p);
    area.marks.push_back(mark);
  }
}

Span reach_of(const NetMark& mark, int axis, Span between) {
  Span reach{kFar, -kFar};
  const Span grown{between.low - mark.radius_mm, between.high + mark.radius_mm};
  for (int i = 0; i < mark.n_points; ++i) {
    const auto next = static_cast<std::size_t>((i + 1) % mark.n_points);
    const Span side = reach_of(mark.points[static_cast<std::size_t>(i)], mark.points[next], axis, grown);
    reach = {std::min(reach.low, side.low), std::max(reach.high, side.high)};
  }
  return {reach.low - mark.radius_mm, reach.high + mark.radius_mm};
}

Tiling tile_area(const TiledArea& area, glm::dvec2 window, double overlap) {
  Tiling tiling;
  const CutStrip rows = cut_along(area, 1, {area.box.min.x, area.box.max.x}, window.y, overlap);
  tiling.n_cut_marks = rows.n_cut_marks;
  for (std::size_t i = 0; i < rows.shares.size(); ++i) {
    const Span height = rows.shares[i];
    const Joined joined = joined_at(rows.shares, i);
    const Box2 place{{area.box.min.x, height.low}, {area.box.max.x, height.high}};
    if (joined.low) tiling.seams.emplace_back(place.min, glm::dvec2(place.max.x, place.min.y));
    add_row(tiling, cut_along(area, 0, height, window.x, overlap), place,
            window_start(height, joined, window.y, overlap), window, overlap);
  }
  return tiling;
}

bool is_better(const Tiling& a, const Tiling& b) {
  const auto cost = [](const Tiling& tiling) {
    return kMarksPerSheet * static_cast<double>(tiling.tiles.size()) + tiling.n_cut_marks;
  };
  return cost(a) < cost(b);
}

std::string tile_tag(int row, int column) {
  std::string letters;
  for (int rest = row; rest >= 0; rest = rest / 26 - 1)
    letters.insert(letters.begin(), static_cast<char>('A' + rest % 26));
  return letters + std::to_string(column + 1);
}

}  // namespace netwright
