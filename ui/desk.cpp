// Sheets lie in one row, a finger's breadth apart.
#include "ui/desk.h"

#include <algorithm>

namespace netwright {
namespace {

constexpr double kGapMm = 15;  ///< between canvases on the desk

/// A canvas beyond the last is a single sheet.
glm::dvec2 canvas_size(const PageLayout& layout, int index) {
  if (index >= static_cast<int>(layout.canvases.size())) return layout.frame.net.size();
  const auto& canvas = layout.canvases[static_cast<std::size_t>(index)];
  return {canvas.width_mm, canvas.height_mm};
}

Box2 on_desk(const PageLayout& layout, glm::dvec2 corner, glm::dvec2 size) {
  Box2 box;
  box.add(glm::dvec2(corner.x, -corner.y) / layout.scale);
  box.add(glm::dvec2(corner.x + size.x, -corner.y - size.y) / layout.scale);
  return box;
}

}  // namespace

double canvas_left(const PageLayout& layout, int index) {
  double left = 0;
  for (int i = 0; i < index; ++i) left += std::max(canvas_size(layout, i).x, layout.frame.width_mm) + kGapMm;
  return left;
}

int canvas_at(const PageLayout& layout, double x_mm) {
  const auto n = static_cast<int>(layout.canvases.size());
  int index = 0;
  while (index < n && x_mm > canvas_left(layout, index + 1) - layout.frame.net.min.x - kGapMm / 2) ++index;
  return index;
}

Box2 sheet_on_desk(const PageLayout& layout, int index) {
  const bool is_new = index >= static_cast<int>(layout.canvases.size());
  if (!is_new && layout.canvases[static_cast<std::size_t>(index)].is_tiled())
    return room_on_desk(layout, index);
  const glm::dvec2 corner = glm::dvec2(canvas_left(layout, index), 0) - layout.frame.net.min;
  return on_desk(layout, corner, {layout.frame.width_mm, layout.frame.height_mm});
}

Box2 room_on_desk(const PageLayout& layout, int index) {
  return on_desk(layout, {canvas_left(layout, index), 0}, canvas_size(layout, index));
}

}  // namespace netwright
