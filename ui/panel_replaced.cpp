// What came of the old version's pins, net and settings when a new version of the model took its place: on
// top of the model's section until it is closed.
#include "assets/icons.h"
#include "ui/lit.h"
#include "ui/panels.h"
#include "ui/replacing.h"
#include "ui/report_line.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

/// Far above the numbers of the lines of the model's own reports.
constexpr std::size_t kFirstIndex = std::size_t{1} << 20U;

/// True when it was closed.
bool heading(const UiContext& context) {
  const UiState& ui = context.ui;
  const float right = ImGui::GetWindowContentRegionMax().x - ui.look.px(16);
  ImGui::AlignTextToFramePadding();
  ImGui::PushFont(ui.look.fonts.bold);
  ImGui::TextUnformatted("Replaced");
  ImGui::PopFont();
  ButtonSpec close{"replaced/close", "", icon::kClose, "Closes this list"};
  close.height = ui.look.px(26);
  ImGui::SameLine(right - button_width(ui, close));
  return button(ui, close);
}

}  // namespace

void panel_replaced(UiContext& context) {
  UiState& ui = context.ui;
  const std::shared_ptr<const ReplaceReport> report = context.session.replacement();
  if (report == nullptr || report == ui.closed_replacement) return;
  const bool is_closed = heading(context);
  for (std::size_t i = 0; i < report->lines.size(); ++i)
    report_line(context, kFirstIndex + i, report->lines[i], "replaced/" + std::to_string(i));
  ImGui::Dummy(ImVec2(0, ui.look.px(2)));
  const float y = ImGui::GetCursorScreenPos().y;
  const float x = ImGui::GetWindowPos().x;
  ImGui::GetWindowDrawList()->AddLine(ImVec2(x + ImGui::GetCursorPosX(), y),
                                      ImVec2(x + ImGui::GetWindowContentRegionMax().x - ui.look.px(16), y),
                                      ui.look.colours.border);
  ImGui::Dummy(ImVec2(0, ui.look.px(4)));
  if (!is_closed) return;
  ui.closed_replacement = report;
  if (ui.lit.line && *ui.lit.line >= kFirstIndex) clear_lit(ui);
}

void watch_replacement(UiContext& context) {
  UiState& ui = context.ui;
  const std::shared_ptr<const ReplaceReport> report = context.session.replacement();
  if (report == nullptr || report == ui.seen_replacement) return;
  ui.seen_replacement = report;
  ui.settings.is_side_open = true;
  ui.settings.is_open(Section::Model) = true;
}

std::string needs_old_version(const UiContext& context) {
  if (!context.session.has_model()) return "Open a model first.";
  return context.session.is_replacing() ? "The new version is being read already." : "";
}

}  // namespace netwright
