// Before printing: what will be hard to cut, fold and glue at this size. Each line leads to its place.
#include <algorithm>
#include <cmath>

#include "assets/icons.h"
#include "core/sheet/buildability.h"
#include "ui/panels.h"
#include "ui/selection.h"
#include "ui/tab_tool.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

constexpr float kRowHeight = 28;

bool leads_somewhere(const BuildLine& line) { return !line.edges.empty() || !line.faces.empty(); }

void show(UiContext& c, const BuildLine& line) {
  if (!line.faces.empty()) {
    clear_selection(c.ui);
    for (const FaceId f : line.faces) select_face(c.ui, f, true);
    c.ui.wants_flight = line.faces;
    return;
  }
  show_edge(c, line.edges.front());
  const Mesh& mesh = c.session.project().dual->mesh();
  for (std::size_t i = 1; i < line.edges.size(); ++i)
    select_side(c.ui, mesh, mesh.halfedge(line.edges[i]), true);
}

void draw_line(UiContext& c, const BuildLine& line, std::size_t index) {
  UiState& ui = c.ui;
  const Look& look = ui.look;
  const std::string name = "check/" + std::to_string(index);
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x - look.px(16), look.px(kRowHeight));
  const bool is_clicked = ImGui::InvisibleButton(name.c_str(), size);
  const bool leads = leads_somewhere(line);
  const bool is_pressed = (leads && pressed_by_key(ui, name)) || is_clicked;
  note_widget(ui, name);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec2 max(min.x + size.x, min.y + size.y);
  if (leads && ImGui::IsItemHovered()) {
    draw.AddRectFilled(min, max, look.colours.hover, look.px(4));
    ui.hint = "Click shows the place in both views";
  }
  const bool is_trouble = line.grade == BuildLine::Grade::Trouble;
  const bool is_fine = line.grade == BuildLine::Grade::Fact;
  const ImU32 colour = is_trouble ? look.colours.bad : look.colours.text;
  const float y = std::floor(min.y + (size.y - ImGui::GetTextLineHeight()) / 2);
  const char* sign = is_trouble ? icon::kError : is_fine ? icon::kDone : icon::kWarning;
  draw.AddText(ImVec2(min.x, y), is_fine ? look.colours.muted : colour, sign);
  const float left = look.px(26);
  draw.AddText(ImVec2(min.x + left, y), colour, shortened(line.text, size.x - left).c_str());
  if (is_pressed && leads) show(c, line);
}

}  // namespace

void panel_check(UiContext& context) {
  const auto judged = context.session.buildability();
  const auto shown = context.session.shown();
  if (judged == nullptr || shown == nullptr) {
    text_muted(context.ui, "Unfold the model first (Space).");
    return;
  }
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  const std::vector<BuildLine> lines = lines_of(*judged, shown->net);
  for (std::size_t i = 0; i < lines.size(); ++i) draw_line(context, lines[i], i);
  ImGui::PopStyleVar();
}

}  // namespace netwright
