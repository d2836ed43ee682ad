// Glue tabs: how they are made, how many there are, which cuts have none, and what is said of single edges.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "assets/icons.h"
#include "ui/panels.h"
#include "ui/selection.h"
#include "ui/status.h"
#include "ui/tab_tool.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

constexpr int kRowsSeen = 6;
constexpr float kRowHeight = 26;
constexpr double kDegree = std::numbers::pi / 180;

/// What people choose among; the width goes with it as long as it is one of the usual ones.
struct Preset {
  const char* name;
  TabSettings::Pattern pattern;
  double width_mm;
};
constexpr std::array<Preset, 4> kPresets{
    Preset{"Normal", TabSettings::Pattern::BestSide, 5},
    Preset{"For children", TabSettings::Pattern::BestSide, kChildTabWidth},
    Preset{"On both sides", TabSettings::Pattern::BothSides, 5},
    Preset{"Alternating", TabSettings::Pattern::Alternating, 5}};

std::string preset_name(const TabSettings& tabs) {
  for (const Preset& preset : kPresets)
    if (preset.pattern == tabs.pattern && preset.width_mm == tabs.width_mm) return preset.name;
  for (const Preset& preset : kPresets)
    if (preset.pattern == tabs.pattern && preset.pattern != TabSettings::Pattern::BestSide)
      return preset.name;
  return "Own width";
}

void on_row(UiContext& c) {
  TabSettings tabs = c.session.project().tabs;
  if (checkbox(c.ui, "tabs/on", "Glue tabs", tabs.is_on, "A flap on one side of every cut, to glue it by"))
    c.session.set_tabs(tabs, tabs.is_on ? "glue tabs" : "no glue tabs");
}

void preset_row(UiContext& c) {
  TabSettings tabs = c.session.project().tabs;
  ImGui::SetNextItemWidth(row(c.ui, "Kind") - c.ui.look.px(16));
  if (!begin_combo(c.ui, "tabs/kind", preset_name(tabs))) return;
  for (const Preset& preset : kPresets) {
    const bool is_it = preset_name(tabs) == preset.name;
    if (ImGui::Selectable(preset.name, is_it) && !is_it) {
      tabs.pattern = preset.pattern;
      tabs.width_mm = preset.width_mm;
      c.session.set_tabs(tabs, "kind of tabs");
    }
    note_widget(c.ui, std::string("tabs/kind/") + preset.name);
  }
  ImGui::EndCombo();
}

void width_row(UiContext& c) {
  TabSettings tabs = c.session.project().tabs;
  ImGui::SetNextItemWidth(row(c.ui, "Width") - c.ui.look.px(16));
  const bool is_entered = length_field(c.ui, "tabs/width", tabs.width_mm);
  tooltip(c.ui, "How wide tabs are where there is room; never more than half of their edge");
  if (!is_entered) return;
  tabs.width_mm = std::clamp(tabs.width_mm, kLeastTabWidth, kMostTabWidth);
  c.session.set_tabs(tabs, "tab width");
}

bool angle_field(UiContext& c, const std::string& name, double& angle_rad) {
  double degrees = angle_rad / kDegree;
  if (!number_field(c.ui, name, degrees, "%.0f°")) return false;
  angle_rad = std::clamp(degrees * kDegree, kLeastTabAngle, kMostTabAngle);
  return true;
}

void more_rows(UiContext& c) {
  if (!more_header(c.ui, "tabs/more", c.ui.is_more_tabs_open)) return;
  TabSettings tabs = c.session.project().tabs;
  ImGui::SetNextItemWidth(row(c.ui, "Angle") - c.ui.look.px(16));
  const bool is_entered = angle_field(c, "tabs/angle", tabs.angle_rad);
  tooltip(c.ui, "Between the slanted ends of a tab and its edge, 10° to 90°");
  if (is_entered) c.session.set_tabs(tabs, "tab angle");
  if (checkbox(c.ui, "tabs/borders", "On open borders, too", tabs.on_borders,
               "Also where the model is open and nothing is glued"))
    c.session.set_tabs(tabs, "tabs on borders");
  SheetSettings sheet = c.session.project().sheet;
  if (checkbox(c.ui, "tabs/strips", "Loose strips", sheet.loose_strips,
               "For cuts without a tab: strips to glue behind them, where a sheet has room"))
    c.session.set_sheet(sheet, "loose strips");
  const auto n = static_cast<std::int64_t>(tabs.edits.size());
  if (n == 0) return;
  ButtonSpec reset{"tabs/reset-all", "Reset " + counted(n, "edge", "edges"), "",
                   "Makes the tabs of all edges as the others again", ButtonKind::Outlined};
  if (!button(c.ui, reset)) return;
  tabs.edits.clear();
  c.session.set_tabs(tabs, "reset tabs");
}

void missing_row(UiContext& c, EdgeId edge, std::size_t index) {
  UiState& ui = c.ui;
  const Look& look = ui.look;
  const std::string name = "tabs/missing/" + std::to_string(index);
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x, look.px(kRowHeight));
  const bool is_clicked = ImGui::InvisibleButton(name.c_str(), size);
  const bool is_pressed = pressed_by_key(ui, name) || is_clicked;
  note_widget(ui, name);
  const bool is_lit = std::ranges::binary_search(ui.selected_edges, edge);
  const ImVec2 max(min.x + size.x, min.y + size.y);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  if (is_lit || ImGui::IsItemHovered())
    draw.AddRectFilled(min, max, is_lit ? look.colours.tint : look.colours.hover, look.px(4));
  const Mesh& mesh = c.session.project().dual->mesh();
  const std::string length = exact_length_text(mesh.length(edge) * print_scale(c.session), ui.settings.unit);
  const float y = std::floor(min.y + (size.y - ImGui::GetTextLineHeight()) / 2);
  const float right = max.x - look.px(8) - ImGui::CalcTextSize(length.c_str()).x;
  const std::string text = "Edge " + grouped(edge.value + 1);
  draw.AddText(ImVec2(min.x + look.px(8), y), is_lit ? look.colours.on_tint : look.colours.text,
               text.c_str());
  draw.AddText(ImVec2(right, y), is_lit ? look.colours.on_tint : look.colours.muted, length.c_str());
  if (ImGui::IsItemHovered()) ui.hint = "Click shows this cut in both views";
  if (is_pressed) show_edge(c, edge);
}

void missing_list(UiContext& c, const GlueTabs& tabs) {
  if (tabs.missing.empty()) return;
  const int n_seen = std::min(static_cast<int>(tabs.missing.size()), kRowsSeen);
  const float width = ImGui::GetContentRegionAvail().x - c.ui.look.px(16);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  ImGui::BeginChild("##missing", ImVec2(width, static_cast<float>(n_seen) * c.ui.look.px(kRowHeight)));
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(tabs.missing.size()), c.ui.look.px(kRowHeight));
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
      missing_row(c, tabs.missing[static_cast<std::size_t>(i)], static_cast<std::size_t>(i));
  }
  ImGui::EndChild();
  ImGui::PopStyleVar();
  ImGui::Dummy(ImVec2(0, 0));
}

/// The cure for cuts without a tab.
void room_rows(UiContext& c, const GlueTabs& missing) {
  TabSettings tabs = c.session.project().tabs;
  if (!missing.missing.empty() &&
      button(c.ui, {"tabs/make-room", "Make room for tabs", "",
                    "Searches on from this net until every cut has room for a tab", ButtonKind::Outlined}))
    make_room_for_tabs(c);
  if (tabs.in_search &&
      checkbox(c.ui, "tabs/in-search", "In every search", tabs.in_search,
               "Every search goes on until all cuts have room for a tab; that takes a little longer"))
    c.session.set_tabs(tabs, "room for tabs");
}

void selected_rows(UiContext& c) {
  const std::vector<EdgeId> edges = tab_edges(c);
  if (edges.empty()) return;
  ImGui::Spacing();
  TabEdit common = tab_wish(c.session.project().tabs, edges.front());
  text_muted(c.ui, edges.size() == 1 ? "Edge " + grouped(edges.front().value + 1)
                                     : counted(static_cast<std::int64_t>(edges.size()), "edge", "edges"));
  int side = static_cast<int>(common.side);
  const float width = ImGui::GetContentRegionAvail().x - c.ui.look.px(16);
  if (segments(c.ui, "tabs/side", width, {"Auto", "One", "Other", "Both", "None"}, side))
    edit_tabs(c, edges, "tab side", [&](TabEdit& edit) { edit.side = static_cast<TabSide>(side); });
  double width_mm = common.width_mm.value_or(c.session.project().tabs.width_mm);
  ImGui::SetNextItemWidth(row(c.ui, "Its width") - c.ui.look.px(16));
  if (length_field(c.ui, "tabs/edge-width", width_mm)) {
    width_mm = std::clamp(width_mm, kLeastTabWidth, kMostTabWidth);
    edit_tabs(c, edges, "tab width", [&](TabEdit& edit) { edit.width_mm = width_mm; });
  }
  const float each = (row(c.ui, "Its angles") - c.ui.look.px(24)) / 2;
  double first = common.first_angle_rad.value_or(c.session.project().tabs.angle_rad);
  double second = common.second_angle_rad.value_or(c.session.project().tabs.angle_rad);
  ImGui::SetNextItemWidth(each);
  if (angle_field(c, "tabs/first-angle", first))
    edit_tabs(c, edges, "tab angle", [&](TabEdit& edit) { edit.first_angle_rad = first; });
  ImGui::SameLine();
  ImGui::SetNextItemWidth(each);
  if (angle_field(c, "tabs/second-angle", second))
    edit_tabs(c, edges, "tab angle", [&](TabEdit& edit) { edit.second_angle_rad = second; });
  if (button(c.ui, {"tabs/as-others", "As the others", "", "Forgets what was said of these edges",
                    ButtonKind::Outlined}))
    reset_tabs(c, edges);
}

}  // namespace

void panel_tabs(UiContext& context) {
  if (!context.session.has_model()) {
    text_muted(context.ui, "Open a model to set its tabs.");
    return;
  }
  on_row(context);
  if (!context.session.project().tabs.is_on) return;
  preset_row(context);
  width_row(context);
  more_rows(context);
  if (const auto pages = context.session.pages()) {
    text_muted(context.ui, tabs_text(pages->tabs) + ".");
    missing_list(context, pages->tabs);
    room_rows(context, pages->tabs);
  }
  selected_rows(context);
}

}  // namespace netwright
