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

/// Quiet words on white paper, strong ones on a picture, and light ones where it is dark.
glm::dvec3 ink_for(const Sheet& sheet, const PageView& view, const Label& label) {
  constexpr double kWhite = 0.95;
  double sum = brightness(sheet, view.at(label.centre));
  for (const glm::dvec2 corner : label.corners())
    sum += brightness(sheet, view.at((corner + label.centre) * 0.5));
  if (sum / 5 < kDarkGround) return kPaperInk;
  return label.kind == Label::Kind::EdgeNumber || sum / 5 < kWhite ? kInk : kQuietInk;
}

}  // namespace

double brightness(const Sheet& sheet, glm::dvec2 at) {
  for (const Picture& picture : sheet.pictures) {
    const Image& image = *picture.image;
    const glm::dvec2 pixel =
        glm::floor((at - picture.at) / picture.size_mm * glm::dvec2(image.width, image.height));
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= image.width || pixel.y >= image.height) continue;
    const std::uint8_t* const p =
        &image.rgba[4 * (static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(image.width) +
                         static_cast<std::size_t>(pixel.x))];
    if (p[3] != 0) return (0.3 * p[0] + 0.59 * p[1] + 0.11 * p[2]) / 255;
  }
  return 1;
}

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
    text.colour = ink_for(sheet, view, label);
    text.angle_rad = angle;
    sheet.texts.push_back(std::move(text));
  }
}

}  // namespace netwright
