// For one orientation of the paper: every piece that fits a page is turned and packed, every larger one
// tiled.
#include "core/sheet/arranger.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include "core/sheet/best_angle.h"
#include "core/sheet/pack.h"
#include "core/sheet/print_style.h"
#include "core/sheet/tile_seams.h"

namespace netwright {

namespace {

using print_style::kPieceGap;
using print_style::kTileOverlap;

constexpr std::size_t kMostTilesSearched = 400;
constexpr std::size_t kMostTilesDrawn = 4000;

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

  /// A way to lay a piece out on a grid of tiles of its own, in the middle of it.
  struct Tiled {
    double angle_rad = 0;
    PageLayout::Placement place;
    Tiling tiling;
    double fill = 0;  ///< of the canvas, by the piece's box

    [[nodiscard]] bool is_better_than(const Tiled& other) const {
      if (is_better(tiling, other.tiling)) return true;
      return !is_better(other.tiling, tiling) && fill < other.fill;
    }
  };

  /// `best_seams` takes a while; else the seams are evenly spaced.
  [[nodiscard]] Tiled tiled_at(std::size_t piece, double angle_rad, bool best_seams) const {
    const PieceShape& shape = shapes_.pieces[piece];
    const glm::dvec2 size = turned_box(shape.hull, angle_rad).size();
    const auto [columns, rows] = tiles_for(size, room(), kTileOverlap);
    const glm::dvec2 canvas = TileGrid::even(room(), kTileOverlap, columns, rows, {}).size();
    Tiled tiled{angle_rad, {}, {}, fill_factor(size, canvas)};
    tiled.place =
        placed_at(shape.hull, angle_rad, static_cast<int>(layout_.canvases.size()), (canvas - size) * 0.5);
    TiledArea area;
    add_to_area(area, shape, tiled.place.turn);
    const auto make_tiling = best_seams ? best_tiling : even_tiling;
    tiled.tiling = make_tiling(area, room(), kTileOverlap, columns, rows);
    return tiled;
  }

  [[nodiscard]] std::size_t n_tiles_at(const Hull& hull, double angle_rad) const {
    const auto [columns, rows] = tiles_for(turned_box(hull, angle_rad).size(), room(), kTileOverlap);
    return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  }

  /// The angle and the seams with the fewest sheets and, among equals, the fewest marks cut. Where that would
  /// take too long, the angle whose grid has the fewest tiles.
  [[nodiscard]] std::optional<Tiled> best_tiled(std::size_t piece, const Hull& hull) const {
    constexpr int kAngles = 60;
    std::optional<Tiled> best;
    std::pair<std::size_t, double> fewest{std::numeric_limits<std::size_t>::max(), 0};
    for (int k = 0; k < kAngles; ++k) {
      const double angle_rad = k * std::numbers::pi / kAngles;
      const std::size_t n_tiles = n_tiles_at(hull, angle_rad);
      fewest = std::min(fewest, std::pair(n_tiles, angle_rad));
      if (n_tiles > kMostTilesSearched) continue;
      Tiled tiled = tiled_at(piece, angle_rad, true);
      if (!best || tiled.is_better_than(*best)) best = std::move(tiled);
    }
    if (best || fewest.first > kMostTilesDrawn) return best;
    return tiled_at(piece, fewest.second, false);
  }

  bool tile(std::size_t piece, const Hull& hull) {
    std::optional<Tiled> tiled = best_tiled(piece, hull);
    if (!tiled) return false;
    layout_.pieces[piece] = tiled->place;
    add_tiled_canvas(layout_, tiled->tiling, n_lettered_rows_);
    n_lettered_rows_ += tiled->tiling.grid.rows();
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

void add_tiled_canvas(PageLayout& layout, const Tiling& tiling, int first_row_letter) {
  const TileGrid& grid = tiling.grid;
  const auto canvas = static_cast<int>(layout.canvases.size());
  for (int row = 0; row < grid.rows(); ++row)
    for (int column = 0; column < grid.columns(); ++column)
      if (tiling.is_needed[grid.index(column, row)] != 0)
        layout.pages.push_back({canvas, column, row, grid.origin(column, row),
                                tile_tag(first_row_letter + row, column), grid.shown(column, row)});
  layout.canvases.push_back({grid.size().x, grid.size().y, grid.columns(), grid.rows(), first_row_letter,
                             grid.column_seams, grid.row_seams});
}

std::optional<PageLayout> arrange_on(const PieceShapes& shapes, const PageFrame& frame) {
  return Arranger(shapes, frame).run();
}

}  // namespace netwright
