// A band belongs to the press that began it: Shift may be let go while the rectangle is pulled.
#include "ui/rubber_band.h"

namespace netwright {

bool RubberBand::follow(const UiState& ui, const Gesture& gesture) {
  const glm::dvec2 pointer(gesture.pointer.x, gesture.pointer.y);
  if (gesture.is_pressed && gesture.is_adding) {
    is_armed_ = true;
    from_ = pointer;
    before_ = ui.selected_faces;
  } else if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
    is_armed_ = false;
  }
  is_drawn_ = is_armed_ && gesture.drag_button == 0;
  if (!is_drawn_) return false;
  box_ = Box2();
  box_.add(from_);
  box_.add(pointer);
  return true;
}

bool RubberBand::holds(glm::dvec2 pixel) const {
  return pixel.x >= box_.min.x && pixel.x <= box_.max.x && pixel.y >= box_.min.y && pixel.y <= box_.max.y;
}

void RubberBand::draw(const UiState& ui, ImVec2 corner) const {
  if (!is_drawn_) return;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec2 min(corner.x + static_cast<float>(box_.min.x), corner.y + static_cast<float>(box_.min.y));
  const ImVec2 max(corner.x + static_cast<float>(box_.max.x), corner.y + static_cast<float>(box_.max.y));
  const Colour line = palette_of(ui).selection;
  draw.AddRectFilled(min, max, to_u32(Colour(glm::vec3(line), 0.14F)));
  draw.AddRect(min, max, to_u32(line), 0, 0, ui.look.px(1));
}

}  // namespace netwright
