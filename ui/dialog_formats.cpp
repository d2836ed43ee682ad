// The table of model formats, behind a button of the dialog that opens models.
#include "assets/icons.h"
#include "core/mesh/formats.h"
#include "ui/dialogs.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

constexpr const char* kPopup = "formats";

void table(const UiState& ui) {
  const auto rows = model_format_table();
  if (!ImGui::BeginTable("formats", static_cast<int>(rows.front().size()), ImGuiTableFlags_SizingFixedFit))
    return;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    ImGui::TableNextRow();
    for (std::size_t c = 0; c < rows[r].size(); ++c) {
      ImGui::TableNextColumn();
      const bool is_strong = r == 0 || c == 0;
      if (r == 0) ImGui::PushFont(ui.look.fonts.bold);
      if (is_strong) {
        ImGui::TextUnformatted(rows[r][c].c_str());
      } else {
        text_muted(ui, rows[r][c]);
      }
      if (r == 0) ImGui::PopFont();
      if (c == 0) note_widget(ui, "formats/" + rows[r][c]);
    }
  }
  ImGui::EndTable();
}

}  // namespace

void Dialogs::draw_formats(const UiState& ui) const {
  ButtonSpec spec{"dialog/formats", "Formats", icon::kInfo, "What can be opened, and what is kept of it"};
  if (button(ui, spec)) ImGui::OpenPopup(kPopup);
  const ImVec2 corner = ImGui::GetItemRectMin();
  ImGui::SetNextWindowPos(ImVec2(corner.x, corner.y - ui.look.px(6)), ImGuiCond_Always, ImVec2(0, 1));
  ImGui::SetNextWindowSize(ImVec2(ImGui::GetWindowWidth() - ui.look.px(40), 0));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.look.px(16), ui.look.px(12)));
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(ui.look.px(8), ui.look.px(3)));
  if (ImGui::BeginPopup(kPopup)) {
    table(ui);
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar(2);
}

}  // namespace netwright
