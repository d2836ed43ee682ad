// Bottom-left packing on bitmaps. A page remembers which cells are taken or too near to a piece; for a piece
// at some angle, all places of a row are tried at once, 64 to a word.
#include "core/sheet/pack_outlines.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <numeric>

#include "core/base/best_angle.h"

namespace netwright {

namespace {

constexpr int kAngles = 8;
constexpr int kFewAngles = 4;  ///< where there are many pieces, which fill each other's bays anyway
constexpr std::size_t kManyPieces = 50;
constexpr double kLongestSide = 280;  ///< cells along the page
constexpr double kLeastCell_mm = 0.5;
constexpr double kTolerance_mm = 1e-6;

/// A row of cells as bits.
using Bits = std::vector<std::uint64_t>;

std::size_t words_for(int n_bits) { return static_cast<std::size_t>((n_bits + 63) / 64); }

void set_bits(Bits& bits, int first, int last) {
  for (int i = std::max(first, 0); i <= last && i < static_cast<int>(bits.size()) * 64; ++i)
    bits[static_cast<std::size_t>(i / 64)] |= std::uint64_t{1} << static_cast<unsigned>(i % 64);
}

/// Every bit comes to stand `by` places lower; zeros follow.
void shift_down(const Bits& from, int by, Bits& to) {
  const auto words = static_cast<std::size_t>(by / 64);
  const auto rest = static_cast<unsigned>(by % 64);
  to.assign(from.size(), 0);
  for (std::size_t i = 0; i + words < from.size(); ++i) {
    to[i] = from[i + words] >> rest;
    if (rest != 0 && i + words + 1 < from.size()) to[i] |= from[i + words + 1] << (64 - rest);
  }
}

/// The piece's cells at one angle, from its lowest and leftmost point on.
struct Raster {
  struct Run {
    int row = 0;
    int first = 0;
    int length = 0;
  };
  double angle_rad = 0;
  glm::dvec2 corner{0, 0};  ///< of the turned outlines' box
  glm::dvec2 size_mm{0, 0};
  std::vector<Run> runs;  ///< the longest first: where they do not fit, nothing does
};

/// Marks the cells that a side runs through.
void mark_side(glm::dvec2 a, glm::dvec2 b, double cell, std::vector<Bits>& rows) {
  if (a.y > b.y) std::swap(a, b);
  const auto last_row = static_cast<int>(rows.size()) - 1;
  const int from = std::clamp(static_cast<int>(std::floor(a.y / cell)), 0, last_row);
  const int to = std::clamp(static_cast<int>(std::floor(b.y / cell)), 0, last_row);
  for (int row = from; row <= to; ++row) {
    const double rise = b.y - a.y;
    const auto x_at = [&](double y) {
      return rise > 0 ? a.x + (b.x - a.x) * std::clamp((y - a.y) / rise, 0.0, 1.0) : a.x;
    };
    double x0 = x_at(row * cell);
    double x1 = rise > 0 ? x_at((row + 1) * cell) : b.x;
    if (x0 > x1) std::swap(x0, x1);
    // A line on the border of two cells belongs to both.
    set_bits(rows[static_cast<std::size_t>(row)], static_cast<int>(std::floor((x0 - kTolerance_mm) / cell)),
             static_cast<int>(std::floor((x1 + kTolerance_mm) / cell)));
  }
}

/// Marks the cells whose middle the outlines wind around.
void mark_inside(const Outlines& outlines, double cell, std::vector<Bits>& rows) {
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const double y = (static_cast<double>(row) + 0.5) * cell;
    std::vector<std::pair<double, int>> crossings;
    for (const std::vector<glm::dvec2>& outline : outlines)
      for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::dvec2 a = outline[i];
        const glm::dvec2 b = outline[(i + 1) % outline.size()];
        if ((a.y <= y) == (b.y <= y)) continue;
        crossings.emplace_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y), a.y <= y ? 1 : -1);
      }
    std::sort(crossings.begin(), crossings.end());
    int winding = 0;
    for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
      winding += crossings[i].second;
      if (winding == 0) continue;
      set_bits(rows[row], static_cast<int>(std::ceil(crossings[i].first / cell - 0.5)),
               static_cast<int>(std::floor(crossings[i + 1].first / cell - 0.5)));
    }
  }
}

void add_runs(const Bits& bits, int row, std::vector<Raster::Run>& runs) {
  bool was_set = false;
  for (int i = 0; i < static_cast<int>(bits.size()) * 64; ++i) {
    const bool is_set = (bits[static_cast<std::size_t>(i / 64)] >> static_cast<unsigned>(i % 64) & 1U) != 0;
    if (is_set && !was_set) runs.push_back({row, i, 0});
    if (is_set) ++runs.back().length;
    was_set = is_set;
  }
}

Raster rasterized(const Outlines& outlines, double angle_rad, double cell) {
  Raster raster;
  raster.angle_rad = angle_rad;
  const Rigid2 turn = Rigid2::rotation(angle_rad);
  Outlines turned = outlines;
  Box2 box;
  for (std::vector<glm::dvec2>& outline : turned)
    for (glm::dvec2& p : outline) box.add(p = turn(p));
  for (std::vector<glm::dvec2>& outline : turned)
    for (glm::dvec2& p : outline) p -= box.min;
  raster.corner = box.min;
  raster.size_mm = box.size();
  const int columns = static_cast<int>(std::floor(raster.size_mm.x / cell)) + 2;
  const int rows = static_cast<int>(std::floor(raster.size_mm.y / cell)) + 1;
  std::vector<Bits> bits(static_cast<std::size_t>(rows), Bits(words_for(columns), 0));
  for (const std::vector<glm::dvec2>& outline : turned)
    for (std::size_t i = 0; i < outline.size(); ++i)
      mark_side(outline[i], outline[(i + 1) % outline.size()], cell, bits);
  mark_inside(turned, cell, bits);
  for (int row = 0; row < rows; ++row) add_runs(bits[static_cast<std::size_t>(row)], row, raster.runs);
  std::stable_sort(raster.runs.begin(), raster.runs.end(),
                   [](const Raster::Run& a, const Raster::Run& b) { return a.length > b.length; });
  return raster;
}

struct Spot {
  int x = 0;
  int y = 0;
  double top_mm = std::numeric_limits<double>::infinity();
};

class PageMap {
 public:
  PageMap(glm::dvec2 page, double cell, double gap)
      : page_(page),
        cell_(cell),
        n_columns_(static_cast<int>(std::ceil(page.x / cell)) + 2),
        rows_(static_cast<std::size_t>(std::ceil(page.y / cell)) + 2, Bits(words_for(n_columns_), 0)) {
    // How far a cell keeps others off, row by row: as long as two points in them could be too near.
    for (int dy = 0;; ++dy) {
      const double up = std::max(dy - 1, 0) * cell;
      if (up >= gap) break;
      const double across = std::sqrt(gap * gap - up * up);
      reach_.push_back(static_cast<int>(std::ceil(across / cell)));
    }
  }

  /// The lowest place, of those the leftmost; only if its upper edge ends below `top_mm`.
  [[nodiscard]] Spot find(const Raster& piece, double top_mm) const {
    Spot spot;
    const int last_x = static_cast<int>(std::floor((page_.x - piece.size_mm.x) / cell_ + kTolerance_mm));
    if (last_x < 0) return spot;
    Bits all(rows_.front().size(), 0);
    set_bits(all, 0, last_x);
    Bits free;
    Bits taken;
    Bits shifted;
    for (int y = 0;; ++y) {
      const double top = y * cell_ + piece.size_mm.y;
      if (top > page_.y + kTolerance_mm || top >= top_mm) return spot;
      free = all;
      if (narrow(free, taken, shifted, piece, y)) return {first_bit(free), y, top};
    }
  }

  void put(const Raster& piece, const Spot& spot) {
    const int most = static_cast<int>(reach_.size()) - 1;
    for (const Raster::Run& run : piece.runs)
      for (int dy = -most; dy <= most; ++dy) {
        const int row = spot.y + run.row + dy;
        if (row < 0 || row >= static_cast<int>(rows_.size())) continue;
        const int reach = reach_[static_cast<std::size_t>(std::abs(dy))];
        const int first = spot.x + run.first;
        set_bits(rows_[static_cast<std::size_t>(row)], first - reach, first + run.length - 1 + reach);
      }
  }

 private:
  /// Strikes out the places at which the piece would meet what is taken; false when none is left.
  [[nodiscard]] bool narrow(Bits& free, Bits& taken, Bits& shifted, const Raster& piece, int y) const {
    for (const Raster::Run& run : piece.runs) {
      const auto row = static_cast<std::size_t>(y + run.row);
      if (row >= rows_.size()) continue;
      shift_down(rows_[row], run.first, taken);
      // Taken anywhere in the run: doubling the length that is looked at.
      for (int length = 1; length < run.length;) {
        const int step = std::min(length, run.length - length);
        shift_down(taken, step, shifted);
        for (std::size_t i = 0; i < taken.size(); ++i) taken[i] |= shifted[i];
        length += step;
      }
      std::uint64_t left = 0;
      for (std::size_t i = 0; i < free.size(); ++i) left |= free[i] &= ~taken[i];
      if (left == 0) return false;
    }
    return true;
  }

  static int first_bit(const Bits& bits) {
    for (std::size_t i = 0; i < bits.size(); ++i)
      if (bits[i] != 0) return static_cast<int>(i) * 64 + std::countr_zero(bits[i]);
    return 0;
  }

  glm::dvec2 page_;
  double cell_;
  int n_columns_;
  std::vector<Bits> rows_;
  std::vector<int> reach_;
};

std::vector<Raster> rasters_of(const PieceToPack& piece, int n_angles, glm::dvec2 page, double cell) {
  std::vector<glm::dvec2> points;
  for (const std::vector<glm::dvec2>& outline : piece.outlines)
    points.insert(points.end(), outline.begin(), outline.end());
  const double flat =
      best_angle(convex_hull(std::move(points)), [](glm::dvec2 size) { return size.x * size.y; });
  std::vector<double> angles;
  // The angle at which it is known to fit comes in only where no other one will do.
  for (int k = 0; k < n_angles; ++k) angles.push_back(flat + k * 2 * std::numbers::pi / n_angles);
  std::vector<Raster> rasters;
  for (const double angle : angles) {
    Raster raster = rasterized(piece.outlines, angle, cell);
    if (raster.size_mm.x <= page.x + kTolerance_mm && raster.size_mm.y <= page.y + kTolerance_mm)
      rasters.push_back(std::move(raster));
  }
  if (rasters.empty()) rasters.push_back(rasterized(piece.outlines, piece.angle_rad, cell));
  const glm::dvec2 size = rasters.front().size_mm;
  if (size.x > page.x + kTolerance_mm || size.y > page.y + kTolerance_mm) rasters.clear();
  return rasters;
}

Rigid2 turn_to(const Raster& raster, const Spot& spot, double cell, glm::dvec2 page) {
  Rigid2 turn = Rigid2::rotation(raster.angle_rad);
  // A place on the last cell may stand over the edge by a rounding error.
  const glm::dvec2 at = glm::min(glm::dvec2(spot.x, spot.y) * cell, page - raster.size_mm);
  turn.x = at.x - raster.corner.x;
  turn.y = at.y - raster.corner.y;
  return turn;
}

Outlines moved(Outlines outlines, const Rigid2& turn) {
  for (std::vector<glm::dvec2>& outline : outlines)
    for (glm::dvec2& p : outline) p = turn(p);
  return outlines;
}

bool keeps_gaps(const std::vector<PieceToPack>& pieces, const std::vector<PackedOutline>& packed,
                double gap) {
  std::vector<Outlines> placed;
  std::vector<Box2> boxes(pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    placed.push_back(moved(pieces[i].outlines, packed[i].turn));
    for (const std::vector<glm::dvec2>& outline : placed[i])
      for (const glm::dvec2 p : outline) boxes[i].add(p);
    for (std::size_t j = 0; j < i; ++j) {
      const glm::dvec2 apart = glm::max(boxes[i].min - boxes[j].max, boxes[j].min - boxes[i].max);
      if (packed[i].page != packed[j].page || std::max(apart.x, apart.y) >= gap) continue;
      if (distance_between(placed[i], placed[j]) < gap - kTolerance_mm) return false;
    }
  }
  return true;
}

double distance_to_side(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
  const glm::dvec2 along = b - a;
  const double square = glm::dot(along, along);
  const double share = square > 0 ? std::clamp(glm::dot(p - a, along) / square, 0.0, 1.0) : 0;
  return glm::length(p - (a + along * share));
}

bool cross_each_other(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 d) {
  const auto side = [](glm::dvec2 p, glm::dvec2 q, glm::dvec2 r) { return cross(q - p, r - p); };
  return side(a, b, c) * side(a, b, d) <= 0 && side(c, d, a) * side(c, d, b) <= 0 &&
         std::max(a.x, b.x) >= std::min(c.x, d.x) && std::max(c.x, d.x) >= std::min(a.x, b.x) &&
         std::max(a.y, b.y) >= std::min(c.y, d.y) && std::max(c.y, d.y) >= std::min(a.y, b.y);
}

}  // namespace

double distance_between(const Outlines& a, const Outlines& b) {
  double least = std::numeric_limits<double>::infinity();
  for (const std::vector<glm::dvec2>& one : a)
    for (std::size_t i = 0; i < one.size(); ++i) {
      const glm::dvec2 p = one[i];
      const glm::dvec2 q = one[(i + 1) % one.size()];
      for (const std::vector<glm::dvec2>& other : b)
        for (std::size_t j = 0; j < other.size(); ++j) {
          const glm::dvec2 r = other[j];
          const glm::dvec2 s = other[(j + 1) % other.size()];
          if (cross_each_other(p, q, r, s)) return 0;
          least = std::min({least, distance_to_side(p, r, s), distance_to_side(q, r, s),
                            distance_to_side(r, p, q), distance_to_side(s, p, q)});
        }
    }
  return least;
}

std::optional<std::vector<PackedOutline>> pack_outlines(const std::vector<PieceToPack>& pieces,
                                                        glm::dvec2 page, double gap, int most_pages) {
  const double cell = std::max(kLeastCell_mm, std::max(page.x, page.y) / kLongestSide);
  std::vector<std::vector<Raster>> rasters;
  for (const PieceToPack& piece : pieces) {
    rasters.push_back(rasters_of(piece, pieces.size() > kManyPieces ? kFewAngles : kAngles, page, cell));
    if (rasters.back().empty()) return std::nullopt;
  }
  std::vector<std::size_t> order(pieces.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto longest = [&](std::size_t i) {
    const glm::dvec2 size = rasters[i].front().size_mm;
    return std::max(size.x, size.y);
  };
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return longest(a) > longest(b); });
  std::vector<PackedOutline> packed(pieces.size());
  std::vector<PageMap> maps;
  for (const std::size_t i : order) {
    bool is_placed = false;
    for (int p = 0; p < most_pages && !is_placed; ++p) {
      if (p == static_cast<int>(maps.size())) maps.emplace_back(page, cell, gap);
      PageMap& map = maps[static_cast<std::size_t>(p)];
      Spot best;
      const Raster* chosen = nullptr;
      for (const Raster& raster : rasters[i]) {
        const Spot spot = map.find(raster, best.top_mm);
        if (!(spot.top_mm < best.top_mm)) continue;
        best = spot;
        chosen = &raster;
      }
      if (chosen == nullptr) continue;
      map.put(*chosen, best);
      packed[i] = {p, turn_to(*chosen, best, cell, page)};
      is_placed = true;
    }
    if (!is_placed) return std::nullopt;
  }
  if (!keeps_gaps(pieces, packed, gap)) return std::nullopt;
  return packed;
}

}  // namespace netwright
