// Labels on a page: those that lie on it as a whole. Mirrored pages mirror where a label lies, not its words.
#include <algorithm>
#include <cmath>

#include "core/sheet/draw.h"
#include "core/sheet/print_style.h"

namespace netwright {

namespace {

using namespace print_style;

bool is_inside(const Box2& box, const Label& label) {
  return std::ranges::all_of(label.corners(), [&](glm::dvec2 p) {
    return p.x >= box.min.x && p.x <= box.max.x && p.y >= box.min.y && p.y <= box.max.y;
  });
}

}  // namespace

void draw_labels(Sheet& sheet, const PlacedLabels& placed, const PageView& view) {
  const Box2 window = view.window();
  for (const Label& label : placed.labels) {
    if (label.canvas != view.page.canvas || !is_inside(window, label)) continue;
    const double angle = view.is_mirrored ? -label.angle_rad : label.angle_rad;
    const glm::dvec2 along(std::cos(angle), std::sin(angle));
    const glm::dvec2 down(-along.y, along.x);
    Text text;
    text.layer = Layer::Labels;
    text.at = view.at(label.centre) - along * (label.box_mm.x / 2) + down * (label.box_mm.y / 2);
    text.words = label.words;
    text.size_mm = label.size_mm;
    text.weight = weight_of(label.kind);
    text.colour = label.kind == Label::Kind::EdgeNumber ? kInk : kQuietInk;
    text.angle_rad = angle;
    sheet.texts.push_back(std::move(text));
  }
}

}  // namespace netwright
