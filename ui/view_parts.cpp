// Headers of the views and the reading of mouse gestures from ImGui's state.
#include "ui/view_parts.h"

#include <algorithm>
#include <cmath>

#include "assets/icons.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

constexpr double kFlightSeconds = 0.18;
constexpr float kClickSlack = 4;  ///< how far a hand trembles while it clicks, in design pixels

}  // namespace

ImU32 to_u32(const Colour& colour) {
  return ImGui::ColorConvertFloat4ToU32(ImVec4(colour.r, colour.g, colour.b, colour.a));
}

const Palette& palette_of(const UiState& ui) {
  return palette(ui.look.colours.is_dark ? Theme::Dark : Theme::Light);
}

float view_header_height(const UiState& ui) { return ui.look.px(40); }

namespace {

/// The name of the view and, where there is room, its state.
void header_text(const UiState& ui, const std::string& title, const HeaderState& state, ImVec2 min,
                 float width) {
  const Look& look = ui.look;
  ImFont* bold = look.fonts.bold;
  const float y = std::floor(min.y + (view_header_height(ui) - ImGui::GetTextLineHeight()) / 2);
  const float title_width = bold->CalcTextSizeA(bold->FontSize, FLT_MAX, 0, title.c_str()).x;
  if (title_width > width) return;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddText(bold, bold->FontSize, ImVec2(min.x, y), look.colours.text, title.c_str());
  const float left = title_width + look.px(10);
  if (width - left < look.px(48)) return;
  const bool fits = ImGui::CalcTextSize(state.whole.c_str()).x <= width - left;
  const std::string& text = fits || state.brief.empty() ? state.whole : state.brief;
  draw.AddText(ImVec2(min.x + left, y), look.colours.muted, shortened(text, width - left).c_str());
}

}  // namespace

void view_header(UiContext& context, const std::string& name, const std::string& title,
                 const HeaderState& state, ImU32 back, std::initializer_list<ActionId> toggles) {
  UiState& ui = context.ui;
  const Look& look = ui.look;
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x, view_header_height(ui));
  ImGui::GetWindowDrawList()->AddRectFilled(min, ImVec2(min.x + size.x, min.y + size.y), back);
  const float buttons = static_cast<float>(toggles.size()) * look.px(32);
  header_text(ui, title, state, ImVec2(min.x + look.px(16), min.y), size.x - buttons - look.px(32));
  ImGui::SetCursorScreenPos(
      ImVec2(std::max(min.x + size.x - look.px(8) - buttons, min.x), min.y + look.px(6)));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(look.px(4), 0));
  for (const ActionId id : toggles) {
    const Action& entry = action(id);
    ButtonSpec spec{name + "/" + std::string(entry.name), "", entry.icon, tip_of(context, entry)};
    spec.width = spec.height = look.px(28);
    spec.kind = entry.is_on != nullptr && entry.is_on(context) ? ButtonKind::On : ButtonKind::Plain;
    spec.is_enabled = is_possible(context, id) && id != state.idle;
    if (id == state.idle) spec.tip = state.why_idle;
    if (button(ui, spec)) run_action(context, id);
    ImGui::SameLine();
  }
  ImGui::PopStyleVar();
  ImGui::SetCursorScreenPos(ImVec2(min.x, min.y + size.y));
}

Gesture picture_gesture(const UiState& ui, const std::string& name, ImVec2 size) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton(name.c_str(), size,
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                             ImGuiButtonFlags_MouseButtonMiddle);
  note_widget(ui, name);
  const ImGuiIO& io = ImGui::GetIO();
  Gesture gesture;
  gesture.is_hovered = ImGui::IsItemHovered();
  gesture.pointer = ImVec2(io.MousePos.x - corner.x, io.MousePos.y - corner.y);
  gesture.is_pressed = ImGui::IsItemActivated() && ImGui::IsMouseDown(ImGuiMouseButton_Left);
  gesture.is_double_clicked = gesture.is_hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
  const float slack = ui.look.px(kClickSlack);
  for (const int which : {0, 1, 2}) {
    if (!ImGui::IsItemActive() || !ImGui::IsMouseDragging(which, slack)) continue;
    gesture.drag_button = which;
    gesture.drag = io.MouseDelta;
  }
  gesture.is_clicked = ImGui::IsItemDeactivated() && gesture.is_hovered && ImGui::IsMouseReleased(0) &&
                       io.MouseDragMaxDistanceSqr[0] < slack * slack;
  gesture.is_adding = io.KeyShift;
  gesture.is_free = io.KeyCtrl;
  if (gesture.is_hovered) gesture.wheel = io.MouseWheel;
  return gesture;
}

void frame_model(OrbitCamera& camera, const Mesh& mesh, double share) {
  camera.frame(mesh.box());
  // Perspective makes each step an approximation of the next; three are enough for the eye.
  for (int round = 0; round < 3; ++round) {
    Box2 seen;
    for (const VertexId v : mesh.vertices()) {
      const glm::dvec3 pixel = camera.project(mesh.position(v));
      seen.add(glm::dvec2(pixel.x, pixel.y));
    }
    if (seen.is_empty() || seen.diagonal() < 1) return;
    const glm::dvec2 middle = camera.size_px() * 0.5;
    camera.pan(middle - seen.centre());
    const glm::dvec2 room = camera.size_px() * share / glm::max(seen.size(), glm::dvec2(1));
    camera.zoom(std::min(room.x, room.y), middle);
  }
}

double flight_share(double seconds) {
  const double t = std::clamp(seconds / kFlightSeconds, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

std::string face_text(FaceId face) { return "Face " + std::to_string(face.value + 1); }

}  // namespace netwright
