// What is known about the model, line by line as the report has it, and what else can be said and chosen.
#include "assets/icons.h"
#include "ui/lit.h"
#include "ui/panels.h"
#include "ui/report_line.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

std::string topic_of(const MeshReport::Line& line) { return std::string(topic_name(line.topic)); }

/// What the file had that the mesh has no more: still worth a look, to see whether it was meant so.
void lines_about_file(UiContext& context) {
  const std::size_t before = context.session.report()->lines.size();
  const std::vector<MeshReport::Line>& lines = context.session.project().made->stages->file_lines;
  if (lines.empty()) return;
  ImGui::PushFont(context.ui.look.fonts.bold);
  ImGui::TextUnformatted("In the file");
  ImGui::PopFont();
  for (std::size_t i = 0; i < lines.size(); ++i)
    report_line(context, before + i, lines[i], "report/file/" + topic_of(lines[i]));
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
  panel_replaced(context);
  for (std::size_t i = 0; i < report->lines.size(); ++i)
    report_line(context, i, report->lines[i], "report/" + topic_of(report->lines[i]));
  lines_about_file(context);
  done_lines(context);
  up_row(context);
  panel_repairs(context);
  panel_parts(context);
  ImGui::PopStyleVar();
  panel_faces(context);
}

}  // namespace netwright
