// What is pinned, whether the shown net keeps it, and what contradicts what.
#include <imgui.h>

#include "assets/icons.h"
#include "ui/actions.h"
#include "ui/lit.h"
#include "ui/panels.h"
#include "ui/pinning.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

void show_culprits(UiState& ui, const Contradiction& contradiction) {
  clear_lit(ui);
  ui.lit.faces = contradiction.faces;
  ui.wants_lit_in_view = true;
}

void contradiction_note(UiContext& c, const Contradiction& contradiction) {
  ImGui::PushTextWrapPos(ImGui::GetWindowContentRegionMax().x - c.ui.look.px(16));
  ImGui::PushStyleColor(ImGuiCol_Text, c.ui.look.colours.bad);
  ImGui::TextUnformatted(contradiction.sentence.c_str());
  ImGui::PopStyleColor();
  ImGui::PopTextWrapPos();
  ButtonSpec show{"pins/show", "Show", icon::kSearch, "Turns the model so that the pins to blame are seen"};
  show.kind = ButtonKind::Outlined;
  if (button(c.ui, show)) show_culprits(c.ui, contradiction);
}

void clear_button(UiContext& c) {
  const Action& clear = action(ActionId::ClearAllPins);
  ButtonSpec spec{"pins/clear", "Clear all", icon::kUnpin, tip_of(c, clear)};
  spec.kind = ButtonKind::Outlined;
  if (button(c.ui, spec)) run_action(c, ActionId::ClearAllPins);
}

}  // namespace

void panel_pins(UiContext& context) {
  const Constraints& pins = context.session.project().pins;
  if (pins == Constraints()) return;
  row(context.ui, "Pins");
  ImGui::AlignTextToFramePadding();
  ImGui::PushTextWrapPos(ImGui::GetWindowContentRegionMax().x - context.ui.look.px(16));
  ImGui::TextUnformatted(pins_text(pins).c_str());
  ImGui::PopTextWrapPos();
  note_widget(context.ui, "pins/summary");
  if (const Contradiction* contradiction = context.session.contradiction()) {
    contradiction_note(context, *contradiction);
    ImGui::SameLine();
  } else if (!context.session.keeps_pins() && context.session.state() == RunState::Idle) {
    text_muted(context.ui, "The net does not keep all pins yet: press Space to unfold again.");
  }
  clear_button(context);
}

}  // namespace netwright
