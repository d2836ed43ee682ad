// What is known about the model, line by line as the report has it; notices and problems carry a sign.
#include "assets/icons.h"
#include "ui/panels.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

void report_line(const UiState& ui, const MeshReport::Line& line) {
  const bool is_fact = line.kind == MeshReport::Line::Kind::Fact;
  const float left = ImGui::GetCursorPosX();
  if (!is_fact) {
    const bool is_problem = line.kind == MeshReport::Line::Kind::Problem;
    ImGui::PushStyleColor(ImGuiCol_Text, is_problem ? ui.look.colours.bad : ui.look.colours.muted);
    ImGui::TextUnformatted(is_problem ? icon::kError : icon::kInfo);
    ImGui::PopStyleColor();
    ImGui::SameLine(left + ui.look.px(24));
  }
  ImGui::PushTextWrapPos(ImGui::GetWindowContentRegionMax().x - ui.look.px(16));
  ImGui::TextUnformatted(line.text.c_str());
  ImGui::PopTextWrapPos();
}

}  // namespace

void panel_model(UiContext& context) {
  const UiState& ui = context.ui;
  const MeshReport* report = context.session.report();
  if (report == nullptr) {
    text_muted(ui, "Open a model to see its report.");
    return;
  }
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.look.px(8), ui.look.px(4)));
  ImGui::Dummy(ImVec2(0, 0));
  for (const MeshReport::Line& line : report->lines) report_line(ui, line);
  ImGui::PopStyleVar();
}

}  // namespace netwright
