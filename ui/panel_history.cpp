// Every step that can be undone or redone, by name, the first one on top; a click goes there.
#include <algorithm>
#include <cmath>

#include "ui/panels.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

constexpr float kRowHeight = 26;
constexpr std::size_t kMostRows = 9;  ///< more are scrolled

std::string with_capital(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

std::string step_text(const UiContext& c, const std::string& label) {
  return label.empty() ? "Opened " + c.session.first_name() : with_capital(label);
}

void step_row(UiContext& c, std::size_t step, const std::string& text, float width) {
  const UiState& ui = c.ui;
  const Look& look = ui.look;
  const std::size_t present = c.session.history_position();
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const ImVec2 max(min.x + width, min.y + look.px(kRowHeight));
  const std::string name = "history/" + std::to_string(step);
  bool is_clicked = ImGui::InvisibleButton(name.c_str(), ImVec2(width, max.y - min.y));
  note_widget(ui, name);
  is_clicked = pressed_by_key(ui, name) || is_clicked;
  if (step != present)
    tooltip(ui, step < present ? "Undoes all steps after this one" : "Redoes all steps up to this one");
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const bool is_present = step == present;
  if (is_present || ImGui::IsItemHovered())
    draw.AddRectFilled(min, max, is_present ? look.colours.tint : look.colours.hover, look.px(4));
  const float y = std::floor((min.y + max.y - ImGui::GetTextLineHeight()) / 2);
  const ImU32 colour =
      is_present ? look.colours.on_tint : (step < present ? look.colours.text : look.colours.muted);
  draw.AddText(ImVec2(min.x + look.px(8), y), colour, shortened(text, width - look.px(16)).c_str());
  if (is_clicked) c.session.go_to_step(step);
}

}  // namespace

void panel_history(UiContext& context) {
  UiState& ui = context.ui;
  if (!context.session.has_model() && !context.session.unrepaired()) {
    text_muted(ui, "Open a model to begin.");
    return;
  }
  const std::vector<std::string> steps = context.session.history();
  const float row = ui.look.px(kRowHeight);
  const float width = ImGui::GetContentRegionAvail().x - ui.look.px(16);
  const auto n_rows = static_cast<float>(std::min(steps.size(), kMostRows));
  const bool is_scrolled = steps.size() > kMostRows;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  ImGui::PushStyleVar(ImGuiStyleVar_ScrollbarSize, ui.look.px(8));
  ImGui::BeginChild("history", ImVec2(width + (is_scrolled ? ui.look.px(12) : 0),
                                      row * n_rows + (is_scrolled ? row / 2 : 0)));
  const std::size_t present = context.session.history_position();
  for (std::size_t step = 0; step < steps.size(); ++step) {
    step_row(context, step, step_text(context, steps[step]), width);
    const bool has_moved = step == present && ui.history_seen != present;
    if (has_moved) ImGui::SetScrollHereY();
  }
  ui.history_seen = present;
  ImGui::EndChild();
  ImGui::PopStyleVar(2);
}

}  // namespace netwright
