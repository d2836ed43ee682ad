// For one orientation of the paper: every piece that fits a page is turned and packed, every larger one
// tiled.
#include "core/sheet/arranger.h"

#include <algorithm>
#include <limits>

#include "core/sheet/best_angle.h"
#include "core/sheet/pack.h"
#include "core/sheet/print_style.h"
#include "core/sheet/tiles.h"

namespace netwright {

namespace {

using print_style::kPieceGap;
using print_style::kTileOverlap;

constexpr std::size_t kMostTilesSearched = 400;

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
  Arranger(const PieceShapes& shapes, const PageFrame& frame) : shapes_(shapes) {
    layout_.frame = frame;
    layout_.scale = shapes.scale;
    layout_.model_height_mm = shapes.model_height_mm;
    layout_.overlap_mm = kTileOverlap;
    layout_.pieces.resize(shapes.pieces.size());
  }

  /// Nothing when more pages than allowed would be needed.
  std::optional<PageLayout> run() {
    std::vector<std::size_t> to_pack;
    for (std::size_t piece = 0; piece < shapes_.pieces.size(); ++piece) {
      const Hull& hull = shapes_.pieces[piece].hull;
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
    for (const auto& [a, b] : sides_of(shapes_.pieces[piece].outlines))
      outline.emplace_back(layout_.on_canvas_mm(static_cast<int>(piece), a),
                           layout_.on_canvas_mm(static_cast<int>(piece), b));
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
      hulls.push_back(shapes_.pieces[to_pack[i]].hull);
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

  const PieceShapes& shapes_;
  PageLayout layout_;
  std::vector<double> angles_;  ///< of the pieces to be packed, in their order
  int n_lettered_rows_ = 0;
};

}  // namespace

double fill_factor(glm::dvec2 size, glm::dvec2 room) { return std::max(size.x / room.x, size.y / room.y); }

std::optional<PageLayout> arrange_on(const PieceShapes& shapes, const PageFrame& frame) {
  return Arranger(shapes, frame).run();
}

}  // namespace netwright
