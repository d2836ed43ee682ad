// Strips are rectangles. They lie together in rows; where there is no room for all, half of them try, and so
// on down to single ones, which may stand upright.
#include "core/sheet/loose_strips.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>

#include "core/sheet/labels.h"

namespace netwright {

namespace {

constexpr double kShortestCut = 3;
constexpr double kOffEnds = 0.5;  // a strip ends this much before its cut does
constexpr double kHalfWidth = 5;
constexpr double kNumberShare = 0.6;  // of the half's width
constexpr double kGap = 2;            // between strips
constexpr double kBlockShape = 1.2;   // a block of strips is a little wider than high
constexpr double kRoomiest = 1.4;     // a number wider than the strip is long is left out

void draw_number(Sheet& sheet, const Box2& half, bool is_upright, const LooseStrip& strip, const Font& font) {
  if (strip.number == 0) return;
  const double size = std::min(kNumberShare * strip.width_mm, 2.47);
  const std::string words = number_words(strip.number);
  const double width = font.width(words, size);
  if (width > strip.length_mm / kRoomiest) return;
  Text text{Layer::Labels, half.centre() + glm::dvec2(-width / 2, 0.36 * size), words, size};
  if (is_upright) {
    text.angle_rad = 1.5707963267948966;
    text.at = half.centre() + glm::dvec2(-0.36 * size, -width / 2);
  }
  sheet.texts.push_back(std::move(text));
}

void draw_strip(Sheet& sheet, const Box2& box, bool is_upright, const LooseStrip& strip,
                const LineStyles& styles, const Font& font) {
  const glm::dvec2 a = box.min;
  const glm::dvec2 b = box.max;
  Stroke outline = net_stroke(styles, Layer::Cut, a, b);
  outline.points = {a, {b.x, a.y}, b, {a.x, b.y}};
  outline.is_closed = true;
  sheet.strokes.push_back(std::move(outline));
  const glm::dvec2 middle = box.centre();
  if (is_upright) {
    sheet.strokes.push_back(net_stroke(styles, Layer::TabFold, {middle.x, a.y}, {middle.x, b.y}));
    draw_number(sheet, {a, {middle.x, b.y}}, true, strip, font);
    draw_number(sheet, {{middle.x, a.y}, b}, true, strip, font);
  } else {
    sheet.strokes.push_back(net_stroke(styles, Layer::TabFold, {a.x, middle.y}, {b.x, middle.y}));
    draw_number(sheet, {a, {b.x, middle.y}}, false, strip, font);
    draw_number(sheet, {{a.x, middle.y}, b}, false, strip, font);
  }
}

/// Strips in rows, one beside the other.
struct Block {
  std::vector<glm::dvec2> corners;  ///< of each strip, from the block's upper left one
  glm::dvec2 size{0, 0};
};

Block block_of(std::span<const LooseStrip> strips) {
  double area = 0;
  for (const LooseStrip& strip : strips) area += (strip.length_mm + kGap) * (2 * strip.width_mm + kGap);
  const double width = std::max(strips.front().length_mm, kBlockShape * std::sqrt(area));
  Block block;
  glm::dvec2 at(0, 0);
  double row_height = 0;
  for (const LooseStrip& strip : strips) {
    if (at.x > 0 && at.x + strip.length_mm > width) {
      at = {0, at.y + row_height + kGap};
      row_height = 0;
    }
    block.corners.push_back(at);
    row_height = std::max(row_height, 2 * strip.width_mm);
    block.size = glm::max(block.size, at + glm::dvec2(strip.length_mm, 2 * strip.width_mm));
    at.x += strip.length_mm + kGap;
  }
  return block;
}

}  // namespace

std::vector<LooseStrip> loose_strips(const Net& net, const PageLayout& layout, const SheetSettings& settings,
                                     const PlacedLabels& labels) {
  std::vector<LooseStrip> strips;
  if (!settings.loose_strips || layout.tabs.missing.empty()) return strips;
  const IdVector<EdgeId, int> numbers = cut_numbers(net, settings.labels.skips_obvious, layout.tabs.missing);
  const auto has_number = [&](EdgeId e) {
    return settings.labels.edge_numbers && !std::ranges::binary_search(labels.left_out, e);
  };
  for (const EdgeId e : layout.tabs.missing) {
    const double length = net.mesh().length(e) * layout.scale;
    if (length < kShortestCut) continue;
    strips.push_back({length - 2 * kOffEnds, std::clamp(length / 2, kLeastTabWidth, kHalfWidth),
                      has_number(e) ? numbers[e] : 0});
  }
  std::ranges::stable_sort(strips, std::greater<>(), &LooseStrip::length_mm);
  return strips;
}

void draw_loose_strips(Sheet& sheet, FreeSpots& spots, const LineStyles& styles, const Font& font,
                       std::vector<LooseStrip>& strips) {
  std::vector<LooseStrip> left;
  std::size_t begin = 0;
  std::size_t count = strips.size();
  while (begin < strips.size()) {
    const std::span<const LooseStrip> together = std::span(strips).subspan(begin, count);
    const Block block = block_of(together);
    if (const std::optional<Box2> box = spots.take(block.size)) {
      for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec2 low = box->min + block.corners[i];
        const glm::dvec2 size(together[i].length_mm, 2 * together[i].width_mm);
        draw_strip(sheet, {low, low + size}, false, together[i], styles, font);
      }
      begin += count;
      count = strips.size() - begin;
    } else if (count > 1) {
      count /= 2;
    } else {
      const LooseStrip& strip = together.front();
      const std::optional<Box2> upright = spots.take({2 * strip.width_mm, strip.length_mm});
      if (upright) {
        draw_strip(sheet, *upright, true, strip, styles, font);
      } else {
        left.push_back(strip);
      }
      begin += 1;
      count = std::min<std::size_t>(1, strips.size() - begin);
    }
  }
  strips = std::move(left);
}

}  // namespace netwright
