// What repair did and could still do to the model, step by step; each switch is one undo step.
#include "core/mesh/mesh_report.h"
#include "ui/panels.h"
#include "ui/repair_rows.h"
#include "ui/widgets.h"

namespace netwright {

void panel_repairs(UiContext& context) {
  UiState& ui = context.ui;
  Session& session = context.session;
  const auto survey = session.project().made->stages->survey;
  if (survey == nullptr || !has_repair_rows(survey->repairs)) return;
  const Recipe wanted = session.wanted_recipe();
  ImGui::Dummy(ImVec2(0, ui.look.px(2)));
  ImGui::PushFont(ui.look.fonts.bold);
  ImGui::TextUnformatted("Repairs");
  ImGui::PopFont();
  const float width = ImGui::GetContentRegionAvail().x - ui.look.px(16);
  const double unit_mm = guess_unit(*session.project().source).in_mm;
  const auto change = repair_rows(ui, wanted, survey->repairs, unit_mm, width);
  if (change) session.set_recipe(change->recipe, change->label);
  ImGui::PushTextWrapPos(ImGui::GetWindowContentRegionMax().x - ui.look.px(16));
  for (const std::string& done : beyond_rows(*session.project().made->stages)) text_small(ui, done);
  ImGui::PopTextWrapPos();
  if (!can_repair_more(wanted, survey->repairs)) return;
  ButtonSpec all{"repair/all", "Repair all"};
  all.kind = ButtonKind::Outlined;
  all.tip = "Everything that changes nothing but faults";
  all.height = ui.look.px(30);
  if (button(ui, all)) session.set_recipe(with_all_repairs(wanted), "repair all");
}

}  // namespace netwright
