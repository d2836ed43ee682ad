// The layout of pages: for each orientation the paper allows, every piece is turned, packed or tiled; the
// orientation that prints larger (fit to page) or needs fewer pages (a given height) is kept.
#include "core/sheet/pages.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/error.h"
#include "core/sheet/best_angle.h"
#include "core/sheet/number_text.h"
#include "core/sheet/outline.h"
#include "core/sheet/pack.h"
#include "core/sheet/print_style.h"
#include "core/sheet/tiles.h"

namespace netwright {

namespace {

using print_style::kPieceGap;
using print_style::kTileOverlap;

constexpr std::size_t kMostPages = 1000;
constexpr std::size_t kMostTilesSearched = 400;

using Hull = std::vector<glm::dvec2>;

/// What the layout needs to know of a net: hull and outline of every piece, in model units, y up.
struct Shapes {
  std::vector<Hull> hulls;
  std::vector<std::vector<Segment>> outlines;
  double model_height = 0;
  double area = 0;
};

Shapes shapes_of(const Net& net) {
  const auto n = static_cast<std::size_t>(net.n_pieces);
  Shapes shapes{std::vector<Hull>(n), std::vector<std::vector<Segment>>(n), net.mesh().height(), 0};
  for (const OutlineLoop& loop : outline_loops(net))
    for (std::size_t i = 0; i < loop.sides.size(); ++i) {
      const glm::dvec2 a = net.corner(loop.sides[i]);
      const glm::dvec2 b = net.corner(loop.sides[(i + 1) % loop.sides.size()]);
      shapes.outlines[static_cast<std::size_t>(loop.piece)].emplace_back(a, b);
      shapes.hulls[static_cast<std::size_t>(loop.piece)].push_back(a);
      shapes.area += cross(a, b) / 2;
    }
  for (Hull& hull : shapes.hulls) hull = convex_hull(std::move(hull));
  return shapes;
}

/// How much of the room a box takes: over 1 it does not fit.
double fill_factor(glm::dvec2 size, glm::dvec2 room) { return std::max(size.x / room.x, size.y / room.y); }

Hull scaled(const Hull& hull, double scale) {
  Hull result;
  result.reserve(hull.size());
  for (const glm::dvec2 p : hull) result.push_back(p * scale);
  return result;
}

/// Puts a piece on a canvas so that its box's upper left corner (y down) is at `corner`.
PageLayout::Placement placed_at(const Hull& hull_mm, double angle_rad, int canvas, glm::dvec2 corner) {
  const Box2 box = turned_box(hull_mm, angle_rad);
  Rigid2 turn = Rigid2::rotation(angle_rad);
  turn.x = corner.x - box.min.x;
  turn.y = -corner.y - box.max.y;
  return {canvas, turn};
}

/// A layout under construction for one orientation of the paper.
class Arranger {
 public:
  Arranger(const Shapes& shapes, const PageFrame& frame, double scale) : shapes_(shapes) {
    layout_.frame = frame;
    layout_.scale = scale;
    layout_.model_height_mm = scale * shapes.model_height;
    layout_.overlap_mm = kTileOverlap;
    layout_.pieces.resize(shapes.hulls.size());
  }

  /// Nothing when more pages than allowed would be needed.
  std::optional<PageLayout> run() {
    std::vector<std::size_t> to_pack;
    for (std::size_t piece = 0; piece < shapes_.hulls.size(); ++piece) {
      const Hull hull = scaled(shapes_.hulls[piece], layout_.scale);
      const double angle = best_angle(hull, [&](glm::dvec2 size) { return fill_factor(size, room()); });
      if (fill_factor(turned_box(hull, angle).size(), room()) <= 1 + 1e-9) {
        angles_.push_back(angle);
        to_pack.push_back(piece);
      } else if (!tile(piece, hull)) {
        return std::nullopt;
      }
    }
    pack_pieces(to_pack);
    if (layout_.pages.size() > kMostPages) return std::nullopt;
    return std::move(layout_);
  }

 private:
  [[nodiscard]] glm::dvec2 room() const { return layout_.frame.net.size(); }

  [[nodiscard]] std::vector<Segment> outline_on_canvas(std::size_t piece) const {
    std::vector<Segment> outline;
    for (const auto& [a, b] : shapes_.outlines[piece])
      outline.emplace_back(layout_.on_canvas(static_cast<int>(piece), a),
                           layout_.on_canvas(static_cast<int>(piece), b));
    return outline;
  }

  /// Centres the piece on a grid of tiles of its own and says which of them it needs.
  std::pair<TileGrid, std::vector<char>> try_tiles(std::size_t piece, const Hull& hull, double angle) {
    const glm::dvec2 size = turned_box(hull, angle).size();
    const TileGrid grid = TileGrid::covering(size, room(), kTileOverlap);
    layout_.pieces[piece] =
        placed_at(hull, angle, static_cast<int>(layout_.canvases.size()), (grid.size() - size) * 0.5);
    const std::size_t count = grid.index(0, grid.rows);
    if (count > kMostTilesSearched * 10) return {grid, {}};
    return {grid, needed_tiles(grid, outline_on_canvas(piece))};
  }

  /// The angle with the fewest tiles; among equals the one that fills its grid least.
  double best_tiling_angle(std::size_t piece, const Hull& hull) {
    constexpr int kAngles = 60;
    double best = 0;
    std::pair<double, double> best_cost{std::numeric_limits<double>::infinity(), 0};
    for (int k = 0; k < kAngles; ++k) {
      const double angle = k * 3.14159265358979323846 / kAngles;
      const glm::dvec2 size = turned_box(hull, angle).size();
      const TileGrid grid = TileGrid::covering(size, room(), kTileOverlap);
      double count = static_cast<double>(grid.columns) * grid.rows;
      if (count <= static_cast<double>(kMostTilesSearched)) {
        const std::vector<char> is_needed = try_tiles(piece, hull, angle).second;
        count = static_cast<double>(std::count(is_needed.begin(), is_needed.end(), 1));
      }
      const std::pair cost(count, fill_factor(size, grid.size()));
      if (cost < best_cost) {
        best = angle;
        best_cost = cost;
      }
    }
    return best;
  }

  bool tile(std::size_t piece, const Hull& hull) {
    const auto [grid, is_needed] = try_tiles(piece, hull, best_tiling_angle(piece, hull));
    if (is_needed.empty()) return false;
    PageLayout::Canvas canvas{grid.size().x, grid.size().y, grid.columns, grid.rows, n_lettered_rows_};
    for (int row = 0; row < grid.rows; ++row)
      for (int column = 0; column < grid.columns; ++column)
        if (is_needed[grid.index(column, row)] != 0)
          layout_.pages.push_back({static_cast<int>(layout_.canvases.size()), column, row,
                                   grid.origin(column, row), tile_tag(n_lettered_rows_ + row, column)});
    n_lettered_rows_ += grid.rows;
    layout_.canvases.push_back(canvas);
    return true;
  }

  void pack_pieces(const std::vector<std::size_t>& to_pack) {
    std::vector<glm::dvec2> sizes;
    std::vector<Hull> hulls;
    for (std::size_t i = 0; i < to_pack.size(); ++i) {
      hulls.push_back(scaled(shapes_.hulls[to_pack[i]], layout_.scale));
      if (to_pack.size() > 1) angles_[i] = packing_angle(hulls[i], angles_[i]);
      sizes.push_back(turned_box(hulls[i], angles_[i]).size());
    }
    const std::vector<Packed> packed = pack(sizes, room(), kPieceGap);
    const auto first_canvas = static_cast<int>(layout_.canvases.size());
    std::vector<Box2> used;
    for (std::size_t i = 0; i < packed.size(); ++i) {
      used.resize(std::max(used.size(), static_cast<std::size_t>(packed[i].page) + 1));
      used[static_cast<std::size_t>(packed[i].page)].add(packed[i].at);
      used[static_cast<std::size_t>(packed[i].page)].add(packed[i].at + turned_size(sizes[i], packed[i]));
    }
    for (std::size_t i = 0; i < packed.size(); ++i) {
      const double angle = angles_[i] + (packed[i].is_turned ? 1.57079632679489661923 : 0);
      const glm::dvec2 shift = (room() - used[static_cast<std::size_t>(packed[i].page)].size()) * 0.5;
      layout_.pieces[to_pack[i]] =
          placed_at(hulls[i], angle, first_canvas + packed[i].page, packed[i].at + shift);
    }
    for (std::size_t page = 0; page < used.size(); ++page) {
      layout_.pages.push_back({first_canvas + static_cast<int>(page), 0, 0, {0, 0}, ""});
      layout_.canvases.push_back({room().x, room().y, 1, 1, 0});
    }
  }

  static glm::dvec2 turned_size(glm::dvec2 size, const Packed& packed) {
    return packed.is_turned ? glm::dvec2(size.y, size.x) : size;
  }

  /// Pieces that share a page lie in their smallest box, unless only a slant makes them fit.
  [[nodiscard]] double packing_angle(const Hull& hull, double fitting_angle) const {
    const double angle = best_angle(hull, [](glm::dvec2 size) { return size.x * size.y; });
    const glm::dvec2 size = turned_box(hull, angle).size();
    const double fill = std::min(fill_factor(size, room()), fill_factor({size.y, size.x}, room()));
    return fill <= 1 ? angle : fitting_angle;
  }

  const Shapes& shapes_;
  PageLayout layout_;
  std::vector<double> angles_;  ///< of the pieces to be packed, in their order
  int n_lettered_rows_ = 0;
};

std::optional<PageLayout> arrange_at(const Shapes& shapes, const PageFrame& frame, double scale) {
  return Arranger(shapes, frame, scale).run();
}

/// The scale at which the largest piece just fits a page by itself: no scale beyond it can do.
double scale_of_largest(const Shapes& shapes, const PageFrame& frame) {
  double scale = std::numeric_limits<double>::infinity();
  for (const Hull& hull : shapes.hulls) {
    const auto cost = [&](glm::dvec2 size) { return fill_factor(size, frame.net.size()); };
    scale = std::min(scale, 1 / cost(turned_box(hull, best_angle(hull, cost)).size()));
  }
  return scale;
}

/// The largest scale that packs everything on one page, by bisection.
PageLayout fit_page(const Shapes& shapes, const PageFrame& frame) {
  const double most = scale_of_largest(shapes, frame) * (1 - 1e-9);
  std::optional<PageLayout> best;
  const auto try_scale = [&](double scale) {
    std::optional<PageLayout> layout = arrange_at(shapes, frame, scale);
    const bool is_good = layout && layout->pages.size() == 1;
    if (is_good && (!best || layout->scale > best->scale)) best = std::move(layout);
    return is_good;
  };
  if (try_scale(most)) return *best;
  double low = most;
  while (!try_scale(low)) {
    low *= 0.5;
    if (low < most * 1e-6)
      throw Error(ErrorKind::Usage,
                  "The model has too many parts for one page; give a height in mm instead.");
  }
  double high = low * 2;
  for (int i = 0; i < 12; ++i) {
    const double middle = (low + high) / 2;
    (try_scale(middle) ? low : high) = middle;
  }
  return *best;
}

/// The largest scale found that takes no more than so many pages. More pages can come with a smaller scale,
/// too, so the search goes down from the scale at which the paper itself would be used up.
std::optional<PageLayout> fit_sheets(const Shapes& shapes, const PageFrame& frame, int sheets) {
  const double one_page = fit_page(shapes, frame).scale;
  const glm::dvec2 room = frame.net.size();
  const double most = std::max(one_page, std::sqrt(sheets * room.x * room.y / shapes.area));
  std::optional<PageLayout> best;
  const auto try_scale = [&](double scale) {
    std::optional<PageLayout> layout = arrange_at(shapes, frame, scale);
    const bool is_good = layout && layout->pages.size() <= static_cast<std::size_t>(sheets);
    if (is_good && (!best || layout->scale > best->scale)) best = std::move(layout);
    return is_good;
  };
  constexpr double kStep = 0.95;
  double scale = most;
  while (!try_scale(scale)) {
    if (scale <= one_page) return std::nullopt;
    scale = std::max(scale * kStep, one_page);
  }
  double low = scale;
  double high = std::min(scale / kStep, most);
  for (int i = 0; i < 6; ++i) {
    const double middle = (low + high) / 2;
    (try_scale(middle) ? low : high) = middle;
  }
  return best;
}

/// For a size that depends on the paper: the orientation that prints larger.
PageLayout fit(const Shapes& shapes, const std::vector<PageFrame>& frames, int sheets) {
  std::optional<PageLayout> best;
  for (const PageFrame& frame : frames) {
    std::optional<PageLayout> layout =
        sheets == 1 ? fit_page(shapes, frame) : fit_sheets(shapes, frame, sheets);
    if (layout && (!best || layout->scale > best->scale * 1.001)) best = std::move(layout);
  }
  return best ? *best : fit(shapes, frames, 1);
}

}  // namespace

PageLayout arrange(const Net& net, const PaperSetup& paper, const PrintSize& size,
                   const TabSettings& /*tabs*/) {
  const std::vector<PageFrame> frames = possible_frames(paper);
  const std::optional<double> scale = scale_of(net.mesh(), size);
  const Shapes shapes = shapes_of(net);
  if (!scale) return fit(shapes, frames, size.kind == PrintSize::Kind::FitSheets ? size.sheets : 1);
  std::optional<PageLayout> best;
  for (const PageFrame& frame : frames) {
    std::optional<PageLayout> layout = arrange_at(shapes, frame, *scale);
    if (layout && (!best || layout->pages.size() < best->pages.size())) best = std::move(layout);
  }
  if (!best)
    throw Error(ErrorKind::Usage, "A model with " + size_words(size) + " would take more than " +
                                      std::to_string(kMostPages) + " pages of " + paper.format +
                                      "; print it smaller or on larger paper.");
  return *best;
}

Net spread_pieces(Net net) {
  if (net.n_pieces < 2) return net;
  std::vector<Box2> boxes(static_cast<std::size_t>(net.n_pieces));
  double area = 0;
  double widest = 0;
  for (const FaceId f : net.mesh().faces()) boxes[static_cast<std::size_t>(net.piece[f])].add(net.box(f));
  for (const Box2& box : boxes) {
    area += box.size().x * box.size().y;
    widest = std::max(widest, box.size().x);
  }
  // Rows from left to right, about as wide as all of it is high.
  const double row_width = std::max(widest, 1.2 * std::sqrt(area));
  const double gap = 0.02 * row_width;
  glm::dvec2 at(0, 0);
  double row_height = 0;
  std::vector<glm::dvec2> shifts;
  for (const Box2& box : boxes) {
    if (at.x > 0 && at.x + box.size().x > row_width) {
      at = {0, at.y + row_height + gap};
      row_height = 0;
    }
    shifts.push_back(at - box.min);
    at.x += box.size().x + gap;
    row_height = std::max(row_height, box.size().y);
  }
  for (const FaceId f : net.mesh().faces()) {
    net.placement[f].x += shifts[static_cast<std::size_t>(net.piece[f])].x;
    net.placement[f].y += shifts[static_cast<std::size_t>(net.piece[f])].y;
  }
  return net;
}

}  // namespace netwright
