// Strips are rectangles; each lies or stands, whichever finds a spot.
#include "core/sheet/loose_strips.h"

#include <algorithm>
#include <optional>
#include <string>

#include "core/sheet/labels.h"

namespace netwright {

namespace {

constexpr double kShortestCut = 3;
constexpr double kOffEnds = 0.5;  // a strip ends this much before its cut does
constexpr double kHalfWidth = 5;
constexpr double kNumberShare = 0.6;  // of the half's width
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
  for (const LooseStrip& strip : strips) {
    const glm::dvec2 lying(strip.length_mm, 2 * strip.width_mm);
    bool is_upright = false;
    std::optional<Box2> box = spots.take(lying);
    if (!box) {
      is_upright = true;
      box = spots.take({lying.y, lying.x});
    }
    if (box) {
      draw_strip(sheet, *box, is_upright, strip, styles, font);
    } else {
      left.push_back(strip);
    }
  }
  strips = std::move(left);
}

}  // namespace netwright
