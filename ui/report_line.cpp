// A line that is about certain places is a button; the others are text. Notices and problems carry a sign.
#include "ui/report_line.h"

#include "assets/icons.h"
#include "ui/lit.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

/// The sign at the left, if the line has one.
void draw_sign(const UiState& ui, const MeshReport::Line& line, ImVec2 at) {
  if (line.kind == MeshReport::Line::Kind::Fact) return;
  const bool is_problem = line.kind == MeshReport::Line::Kind::Problem;
  ImGui::GetWindowDrawList()->AddText(at, is_problem ? ui.look.colours.bad : ui.look.colours.muted,
                                      is_problem ? icon::kError : icon::kInfo);
}

}  // namespace

void report_line(UiContext& context, std::size_t index, const MeshReport::Line& line,
                 const std::string& name) {
  const UiState& ui = context.ui;
  const Look& look = ui.look;
  const bool can_light = line.has_culprits();
  const bool is_lit = ui.lit.line == index;
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x - look.px(16) - (can_light ? look.px(24) : 0);
  const float indent = line.kind == MeshReport::Line::Kind::Fact ? 0 : look.px(24);
  const ImVec2 text = ImGui::CalcTextSize(line.text.c_str(), nullptr, false, room - indent);
  const ImVec2 size(ImGui::GetContentRegionAvail().x - look.px(16), text.y);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  if (can_light) {
    ImGui::PushID(static_cast<int>(index));
    const bool is_clicked = ImGui::InvisibleButton(name.c_str(), size);
    // Lines of one kind share a name.
    if (pressed_by_key(ui, name + "/" + std::to_string(index)) || is_clicked) light(context, index, line);
    ImGui::PopID();
    const ImVec2 edge(look.px(8), look.px(3));
    const ImU32 back = is_lit ? look.colours.tint : (ImGui::IsItemHovered() ? look.colours.hover : 0);
    if (back != 0) {
      draw.AddRectFilled(ImVec2(min.x - edge.x, min.y - edge.y),
                         ImVec2(min.x + size.x + edge.x, min.y + size.y + edge.y), back, look.px(4));
    }
    draw.AddText(ImVec2(min.x + size.x - look.px(15), min.y),
                 is_lit ? look.colours.on_tint : look.colours.muted, icon::kVisible);
  } else {
    ImGui::Dummy(size);
  }
  note_widget(ui, name);
  if (can_light) tooltip(ui, is_lit ? "Stop showing" : "Show on the model");
  draw_sign(ui, line, min);
  draw.AddText(nullptr, 0, ImVec2(min.x + indent, min.y), look.colours.text, line.text.c_str(), nullptr,
               room - indent);
}

}  // namespace netwright
