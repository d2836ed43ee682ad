// For one orientation of the paper: every piece that fits a page is turned and packed, every larger one
// tiled.
#include "core/sheet/arranger.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <tuple>

#include "core/base/best_angle.h"
#include "core/sheet/pack.h"
#include "core/sheet/pack_outlines.h"
#include "core/sheet/print_style.h"
#include "core/sheet/tiles.h"

namespace netwright {

namespace {

using print_style::kPieceGap;
using print_style::kTileOverlap;

// Every so many half degrees an angle is tried. More find hardly more, and those of the quick look are among
// the others.
constexpr int kBestStep = 6;
constexpr int kQuickStep = 24;
constexpr std::size_t kMostTilesSearched = 1400;
constexpr std::size_t kMostTilesDrawn = 4000;
constexpr std::size_t kMostPackedByOutline = 100;

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
  Arranger(const PieceShapes& shapes, const PageFrame& frame, Seams seams) : shapes_(shapes), seams_(seams) {
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

  /// A piece in the middle of a grid of tiles of its own.
  struct Tiled {
    double angle_rad = 0;
    PageLayout::Placement place;
    TiledArea area;
    int columns = 1;
    int rows = 1;
  };

  [[nodiscard]] Tiled tiled_at(std::size_t piece, double angle_rad) const {
    const PieceShape& shape = shapes_.pieces[piece];
    const glm::dvec2 size = turned_box(shape.hull, angle_rad).size();
    Tiled tiled;
    tiled.angle_rad = angle_rad;
    std::tie(tiled.columns, tiled.rows) = tiles_for(size, room(), kTileOverlap);
    const glm::dvec2 canvas = tiled_size(room(), kTileOverlap, tiled.columns, tiled.rows);
    tiled.place =
        placed_at(shape.hull, angle_rad, static_cast<int>(layout_.canvases.size()), (canvas - size) * 0.5);
    add_to_area(tiled.area, shape, tiled.place.turn);
    return tiled;
  }

  /// Angles whose grids are small enough to look into; else the one whose grid is the smallest, if that can
  /// be drawn at all.
  [[nodiscard]] std::vector<double> tiling_angles(const Hull& hull, int step) const {
    constexpr int kAngles = 360;
    std::vector<double> angles;
    std::pair<std::size_t, double> fewest{std::numeric_limits<std::size_t>::max(), 0};
    for (int k = 0; k < kAngles; k += step) {
      const double angle_rad = k * std::numbers::pi / kAngles;
      const auto [columns, rows] = tiles_for(turned_box(hull, angle_rad).size(), room(), kTileOverlap);
      const std::size_t n_tiles = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
      fewest = std::min(fewest, std::pair(n_tiles, angle_rad));
      if (n_tiles <= kMostTilesSearched) angles.push_back(angle_rad);
    }
    if (angles.empty() && fewest.first <= kMostTilesDrawn) angles.push_back(fewest.second);
    return angles;
  }

  /// At the angle that takes the fewest sheets whose seams cut the fewest marks.
  bool tile(std::size_t piece, const Hull& hull) {
    std::optional<Tiling> best;
    Tiled way;
    for (const double angle_rad : tiling_angles(hull, seams_ == Seams::Best ? kBestStep : kQuickStep)) {
      Tiled here = tiled_at(piece, angle_rad);
      Tiling tiling = tile_area(here.area, room(), kTileOverlap);
      if (best && !is_better(tiling, *best)) continue;
      best = std::move(tiling);
      way = std::move(here);
    }
    if (!best) return false;
    layout_.pieces[piece] = way.place;
    add_tiled_canvas(layout_, *best, way.columns, way.rows, n_lettered_rows_);
    n_lettered_rows_ += best->n_rows;
    return true;
  }

  void pack_pieces(const std::vector<std::size_t>& to_pack) {
    std::vector<PackedOutline> packed = packed_in_boxes(to_pack);
    if (std::optional<std::vector<PackedOutline>> closer = packed_by_outlines(to_pack, n_pages_of(packed)))
      packed = std::move(*closer);
    const auto first_canvas = static_cast<int>(layout_.canvases.size());
    std::vector<Box2> used(static_cast<std::size_t>(n_pages_of(packed)));
    for (std::size_t i = 0; i < packed.size(); ++i)
      for (const glm::dvec2 p : shapes_.pieces[to_pack[i]].hull)
        used[static_cast<std::size_t>(packed[i].page)].add(packed[i].turn(p));
    for (std::size_t i = 0; i < packed.size(); ++i) {
      // What lies on a page lies in its middle; on paper y points down.
      const Box2& box = used[static_cast<std::size_t>(packed[i].page)];
      Rigid2 turn = packed[i].turn;
      turn.x += room().x / 2 - box.centre().x;
      turn.y -= room().y / 2 + box.centre().y;
      layout_.pieces[to_pack[i]] = {first_canvas + packed[i].page, turn};
    }
    for (std::size_t page = 0; page < used.size(); ++page) {
      layout_.pages.push_back({first_canvas + static_cast<int>(page), 0, 0, {0, 0}, ""});
      layout_.canvases.push_back({room().x, room().y, 1, 1, 0});
    }
  }

  static int n_pages_of(const std::vector<PackedOutline>& packed) {
    int n_pages = 0;
    for (const PackedOutline& piece : packed) n_pages = std::max(n_pages, piece.page + 1);
    return n_pages;
  }

  [[nodiscard]] std::vector<PackedOutline> packed_in_boxes(const std::vector<std::size_t>& to_pack) const {
    std::vector<double> angles;
    std::vector<glm::dvec2> sizes;
    for (std::size_t i = 0; i < to_pack.size(); ++i) {
      const Hull& hull = shapes_.pieces[to_pack[i]].hull;
      angles.push_back(to_pack.size() > 1 ? packing_angle(hull, angles_[i]) : angles_[i]);
      sizes.push_back(turned_box(hull, angles[i]).size());
    }
    std::vector<PackedOutline> packed;
    for (const Packed& box : pack(sizes, room(), kPieceGap)) {
      const std::size_t i = packed.size();
      const double angle_rad = angles[i] + (box.is_turned ? std::numbers::pi / 2 : 0);
      packed.push_back({box.page, placed_at(shapes_.pieces[to_pack[i]].hull, angle_rad, 0, box.at).turn});
    }
    return packed;
  }

  /// Only where that takes fewer pages than boxes do: boxes look tidier, and are cut out more easily.
  [[nodiscard]] std::optional<std::vector<PackedOutline>> packed_by_outlines(
      const std::vector<std::size_t>& to_pack, int n_pages) const {
    std::vector<PieceToPack> pieces;
    double area_mm2 = 0;
    for (std::size_t i = 0; i < to_pack.size(); ++i) {
      pieces.push_back({shapes_.pieces[to_pack[i]].outlines, angles_[i]});
      area_mm2 += shapes_.pieces[to_pack[i]].area_mm2;
    }
    constexpr double kFullest = 0.95;  // no packing of nets gets there
    const bool is_hopeless = area_mm2 > kFullest * (n_pages - 1) * room().x * room().y;
    if (n_pages < 2 || is_hopeless || pieces.size() > kMostPackedByOutline) return std::nullopt;
    return pack_outlines(pieces, room(), kPieceGap, n_pages - 1);
  }

  /// Pieces that share a page lie in their smallest box, unless only a slant makes them fit.
  [[nodiscard]] double packing_angle(const Hull& hull, double fitting_angle) const {
    const double angle = best_angle(hull, [](glm::dvec2 size) { return size.x * size.y; });
    const glm::dvec2 size = turned_box(hull, angle).size();
    const double fill = std::min(fill_factor(size, room()), fill_factor({size.y, size.x}, room()));
    return fill <= 1 ? angle : fitting_angle;
  }

  const PieceShapes& shapes_;
  Seams seams_;
  PageLayout layout_;
  std::vector<double> angles_;  ///< of the pieces to be packed, in their order
  int n_lettered_rows_ = 0;
};

}  // namespace

double fill_factor(glm::dvec2 size, glm::dvec2 room) { return std::max(size.x / room.x, size.y / room.y); }

void add_tiled_canvas(PageLayout& layout, const Tiling& tiling, int columns, int rows, int first_row_letter) {
  const auto canvas = static_cast<int>(layout.canvases.size());
  for (const Tiling::Tile& tile : tiling.tiles)
    layout.pages.push_back({canvas, tile.column, tile.row, tile.origin,
                            tile_tag(first_row_letter + tile.row, tile.column), tile.share, tile.shown});
  const glm::dvec2 size = tiled_size(layout.frame.net.size(), layout.overlap_mm, columns, rows);
  layout.canvases.push_back(
      {size.x, size.y, columns, rows, first_row_letter, tiling.seams, tiling.n_cut_marks});
}

std::optional<PageLayout> arrange_on(const PieceShapes& shapes, const PageFrame& frame, Seams seams) {
  return Arranger(shapes, frame, seams).run();
}

}  // namespace netwright
