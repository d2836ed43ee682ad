// What is known about the model, line by line as the report has it; notices and problems carry a sign. A line
// that is about certain faces is a button: it lights them in both views and turns the model to them.
#include "assets/icons.h"
#include "ui/lit.h"
#include "ui/panels.h"
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

void report_line(UiContext& context, std::size_t index, const MeshReport::Line& line,
                 const std::string& group) {
  const UiState& ui = context.ui;
  const Look& look = ui.look;
  const bool can_light = line.has_culprits();
  const bool is_lit = ui.lit.line == index;
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x - look.px(16) - (can_light ? look.px(24) : 0);
  const float indent = line.kind == MeshReport::Line::Kind::Fact ? 0 : look.px(24);
  const ImVec2 text = ImGui::CalcTextSize(line.text.c_str(), nullptr, false, room - indent);
  const ImVec2 size(ImGui::GetContentRegionAvail().x - look.px(16), text.y);
  const std::string name = group + std::string(topic_name(line.topic));
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  if (can_light) {
    ImGui::PushID(static_cast<int>(index));
    if (ImGui::InvisibleButton(name.c_str(), size)) light(context, index, line);
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

/// What the file had that the mesh has no more: still worth a look, to see whether it was meant so.
void lines_about_file(UiContext& context) {
  const std::size_t before = context.session.report()->lines.size();
  const std::vector<MeshReport::Line>& lines = context.session.project().made->stages->file_lines;
  if (lines.empty()) return;
  ImGui::PushFont(context.ui.look.fonts.bold);
  ImGui::TextUnformatted("In the file");
  ImGui::PopFont();
  for (std::size_t i = 0; i < lines.size(); ++i) report_line(context, before + i, lines[i], "report/file/");
}

/// What was done to the file's faces before anything was simplified or merged.
void done_lines(const UiContext& context) {
  const UiState& ui = context.ui;
  for (const std::string& sentence : context.session.project().made->stages->done) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddText(at, ui.look.colours.good, icon::kDone);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ui.look.px(24));
    ImGui::PushTextWrapPos(ImGui::GetWindowContentRegionMax().x - ui.look.px(16));
    text_muted(ui, sentence);
    ImGui::PopTextWrapPos();
  }
}

/// Formats have their customs, programs don't always keep to them.
void up_row(UiContext& context) {
  Recipe recipe = context.session.recipe();
  int chosen = context.session.project().dual->mesh().up_axis() == UpAxis::Y ? 0 : 1;
  const float width = row(context.ui, "Up") - context.ui.look.px(16);
  if (segments(context.ui, "model/up", width, {"Y", "Z"}, chosen)) {
    recipe.up = chosen == 0 ? UpAxis::Y : UpAxis::Z;
    context.session.set_recipe(recipe, "up axis");
  }
  tooltip(context.ui, "Which axis is up: the height is measured along it");
}

}  // namespace

void panel_model(UiContext& context) {
  const UiState& ui = context.ui;
  const MeshReport* report = context.session.report();
  if (report == nullptr) {
    text_muted(ui, "Open a model to see its report.");
    return;
  }
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.look.px(8), ui.look.px(6)));
  ImGui::Dummy(ImVec2(0, 0));
  for (std::size_t i = 0; i < report->lines.size(); ++i) report_line(context, i, report->lines[i], "report/");
  lines_about_file(context);
  done_lines(context);
  up_row(context);
  panel_repairs(context);
  panel_parts(context);
  ImGui::PopStyleVar();
  panel_faces(context);
}

}  // namespace netwright
