// Along each axis the marks are counted that a seam at every half millimetre would cut; the best row of
// seams, none further from the next than a window reaches, is found by dynamic programming.
#include "core/sheet/tile_seams.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace netwright {

namespace {

constexpr double kStep_mm = 0.5;
constexpr double kNear_mm = 2;
/// A mark that a seam passes within kNear_mm counts so much of one that it cuts.
constexpr double kNearCost = 0.05;
/// Keeps seams where they would be evenly spaced when nothing else says where; per mm.
constexpr double kStrayCost = 1e-6;

struct Span {
  double low = 0;
  double high = 0;
};

int cut_by(const std::vector<Span>& marks, const std::vector<double>& seams) {
  int count = 0;
  for (const Span& mark : marks)
    for (const double seam : seams) count += mark.low < seam && seam < mark.high ? 1 : 0;
  return count;
}

/// The cost of a seam at every step from 0 on.
std::vector<double> seam_costs(const std::vector<Span>& marks, std::size_t n_steps) {
  std::vector<double> change(n_steps + 1, 0);
  const auto add = [&](double low, double high, double cost) {
    const double first = std::floor(low / kStep_mm) + 1;
    const double last = std::ceil(high / kStep_mm) - 1;
    const auto n = static_cast<double>(n_steps);
    if (!(first <= last) || last < 0 || first >= n) return;
    change[static_cast<std::size_t>(std::max(first, 0.0))] += cost;
    change[static_cast<std::size_t>(std::min(last + 1, n))] -= cost;
  };
  for (const Span& mark : marks) {
    add(mark.low, mark.high, 1);
    add(mark.low - kNear_mm, mark.high + kNear_mm, kNearCost);
  }
  double sum = 0;
  for (double& value : change) value = sum += value;
  change.resize(n_steps);
  return change;
}

/// One axis of the search for seams.
class SeamRow {
 public:
  SeamRow(const std::vector<Span>& marks, Span content, double window, double overlap, int count)
      : window_(window),
        overlap_(overlap),
        content_(content),
        n_seams_(static_cast<std::size_t>(count) - 1),
        n_steps_(static_cast<std::size_t>(std::ceil((count * (window - overlap) + overlap) / kStep_mm)) + 1),
        costs_(seam_costs(marks, n_steps_)) {}

  /// Empty when no row of seams on the steps does.
  [[nodiscard]] std::vector<double> find() {
    constexpr double kNever = std::numeric_limits<double>::infinity();
    std::vector<double> best = first_seam();
    for (std::size_t k = 1; k < n_seams_; ++k) best = next_seam(best, k);
    const double least_last = content_.high - (window_ - overlap_ / 2);
    std::size_t last = 0;
    double least = kNever;
    for (std::size_t i = 0; i < n_steps_; ++i) {
      if (at(i) < least_last || at(i) > content_.high - overlap_ || !(best[i] < least)) continue;
      least = best[i];
      last = i;
    }
    if (least == kNever) return {};
    std::vector<double> seams(n_seams_);
    for (std::size_t k = n_seams_; k-- > 0;) {
      seams[k] = at(last);
      if (k > 0) last = from_[k - 1][last];
    }
    return seams;
  }

 private:
  [[nodiscard]] static double at(std::size_t step) { return static_cast<double>(step) * kStep_mm; }

  [[nodiscard]] double cost(std::size_t step, std::size_t k) const {
    const double even = static_cast<double>(k + 1) * (window_ - overlap_) + overlap_ / 2;
    return costs_[step] + kStrayCost * std::abs(at(step) - even);
  }

  [[nodiscard]] std::vector<double> first_seam() const {
    std::vector<double> best(n_steps_, std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < n_steps_; ++i)
      if (at(i) >= content_.low + overlap_ && at(i) <= content_.low + window_ - overlap_ / 2)
        best[i] = cost(i, 0);
    return best;
  }

  /// The least cost of seam k at every step, from that of the seam before; a queue holds the steps that may
  /// still be the best within reach.
  [[nodiscard]] std::vector<double> next_seam(const std::vector<double>& before, std::size_t k) {
    std::vector<double> best(n_steps_, std::numeric_limits<double>::infinity());
    std::vector<std::size_t>& from = from_.emplace_back(n_steps_, 0);
    const auto least = static_cast<std::size_t>(std::ceil(overlap_ / kStep_mm));
    const auto most = static_cast<std::size_t>(std::floor((window_ - overlap_) / kStep_mm));
    std::vector<std::size_t> queue;
    std::size_t head = 0;
    for (std::size_t i = least; i < n_steps_; ++i) {
      const std::size_t fresh = i - least;
      while (queue.size() > head && before[queue.back()] >= before[fresh]) queue.pop_back();
      queue.push_back(fresh);
      while (queue[head] + most < i) ++head;
      best[i] = before[queue[head]] + cost(i, k);
      from[i] = queue[head];
    }
    return best;
  }

  double window_;
  double overlap_;
  Span content_;
  std::size_t n_seams_;
  std::size_t n_steps_;
  std::vector<double> costs_;
  std::vector<std::vector<std::size_t>> from_;
};

struct Axis {
  std::vector<Span> marks;
  std::vector<double> even;
  std::vector<double> moved;  ///< the even ones where none are better
  int even_cuts = 0;
  int moved_cuts = 0;
};

Axis axis_of(const TiledArea& area, int axis, const TileGrid& even) {
  Axis result;
  for (const Box2& mark : area.marks) result.marks.push_back({mark.min[axis], mark.max[axis]});
  result.even = axis == 0 ? even.column_seams : even.row_seams;
  result.even_cuts = cut_by(result.marks, result.even);
  const int count = static_cast<int>(result.even.size()) + 1;
  if (count > 1)
    result.moved = SeamRow(result.marks, {area.box.min[axis], area.box.max[axis]}, even.window[axis],
                           even.overlap, count)
                       .find();
  if (result.moved.empty()) result.moved = result.even;
  result.moved_cuts = cut_by(result.marks, result.moved);
  return result;
}

Tiling tiling_by(TileGrid grid, const TiledArea& area, int n_cut_marks) {
  Tiling tiling{std::move(grid), {}, 0, n_cut_marks};
  tiling.is_needed = needed_tiles(tiling.grid, area.outline);
  tiling.n_sheets = static_cast<std::size_t>(std::count(tiling.is_needed.begin(), tiling.is_needed.end(), 1));
  return tiling;
}

Box2 box_of(const NetMark& mark, const Rigid2& turn) {
  Box2 box;
  for (int i = 0; i < mark.n_points; ++i) {
    const glm::dvec2 p = turn(mark.points[static_cast<std::size_t>(i)]);
    box.add(glm::dvec2(p.x, -p.y));
  }
  return {box.min - mark.radius_mm, box.max + mark.radius_mm};
}

}  // namespace

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
  for (const NetMark& mark : piece.marks) area.marks.push_back(box_of(mark, turn));
}

Tiling even_tiling(const TiledArea& area, glm::dvec2 window, double overlap, int columns, int rows) {
  TileGrid grid = TileGrid::even(window, overlap, columns, rows, area.box);
  int n_cut_marks = 0;
  for (const Box2& mark : area.marks)
    n_cut_marks += cut_by({{mark.min.x, mark.max.x}}, grid.column_seams) +
                   cut_by({{mark.min.y, mark.max.y}}, grid.row_seams);
  return tiling_by(std::move(grid), area, n_cut_marks);
}

std::optional<Tiling> best_tiling(const TiledArea& area, glm::dvec2 window, double overlap, int columns,
                                  int rows, std::size_t most_sheets, int cuts_too_many) {
  const TileGrid even = TileGrid::even(window, overlap, columns, rows, area.box);
  const Axis across = axis_of(area, 0, even);
  const Axis down = axis_of(area, 1, even);
  std::optional<Tiling> best;
  // Where all seams are moved, fewer marks are cut, but more sheets may be touched.
  for (const auto& [moves_columns, moves_rows] :
       {std::pair(true, true), std::pair(true, false), std::pair(false, true), std::pair(false, false)}) {
    const int n_cuts = (moves_columns ? across.moved_cuts : across.even_cuts) +
                       (moves_rows ? down.moved_cuts : down.even_cuts);
    if (n_cuts >= (best ? best->n_cut_marks : cuts_too_many)) continue;
    TileGrid grid = even;
    if (moves_columns) grid.column_seams = across.moved;
    if (moves_rows) grid.row_seams = down.moved;
    Tiling tiling = tiling_by(std::move(grid), area, n_cuts);
    if (tiling.n_sheets <= most_sheets) best = std::move(tiling);
  }
  return best;
}

bool is_better(const Tiling& a, const Tiling& b) {
  return std::pair(a.n_sheets, a.n_cut_marks) < std::pair(b.n_sheets, b.n_cut_marks);
}

}  // namespace netwright
