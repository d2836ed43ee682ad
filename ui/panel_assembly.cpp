// Gluing step by step: which seam is next, where its number is, how far one is.
#include <algorithm>

#include "assets/icons.h"
#include "ui/actions.h"
#include "ui/assembly.h"
#include "ui/panels.h"
#include "ui/selection.h"
#include "ui/status.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

void step_button(UiContext& c, const char* name, ActionId id, ButtonKind kind, float width) {
  const Action& wanted = action(id);
  ButtonSpec spec{name, label_of(c, wanted), wanted.icon, tip_of(c, wanted), kind};
  spec.is_enabled = is_possible(c, id);
  spec.width = width;
  if (button(c.ui, spec)) run_action(c, id);
}

void seam_text(UiContext& c, EdgeId seam, const std::vector<EdgeId>& order) {
  const auto at = std::ranges::find(order, seam) - order.begin();
  const int number = assembly_number(c, seam);
  std::string text = "Step " + grouped(at + 1) + " of " + grouped(static_cast<std::int64_t>(order.size()));
  const bool has_numbers = c.session.project().sheet.labels.edge_numbers;
  text += number > 0    ? ": the sides with number " + grouped(number)
          : has_numbers ? ": two sides that meet at a point"
                        : ": the two sides that are lit";
  const auto unnumbered = c.session.unnumbered();
  const bool is_unnumbered = unnumbered != nullptr && std::ranges::binary_search(*unnumbered, seam);
  if (number > 0 && is_unnumbered) text += ", which had no room";
  if (std::ranges::binary_search(c.session.project().glued, seam)) text += ", glued";
  ImGui::PushTextWrapPos(ImGui::GetWindowContentRegionMax().x - c.ui.look.px(16));
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  note_widget(c.ui, "assembly/step");
}

/// Numbers that are missing on the paper, to be written by hand.
void missing_numbers(UiContext& c) {
  const auto unnumbered = c.session.unnumbered();
  if (unnumbered == nullptr) return;
  std::vector<int> numbers;
  for (const EdgeId e : *unnumbered)
    if (const int number = assembly_number(c, e); number > 0) numbers.push_back(number);
  if (numbers.empty()) return;
  std::ranges::sort(numbers);
  std::string text = "No room on the paper for ";
  text += numbers.size() == 1 ? "number " : "the numbers ";
  for (std::size_t i = 0; i < numbers.size(); ++i)
    text += (i == 0 ? "" : i + 1 == numbers.size() ? " and " : ", ") + grouped(numbers[i]);
  text += numbers.size() == 1 ? ": write it by hand." : ": write them by hand.";
  ImGui::PushTextWrapPos(ImGui::GetWindowContentRegionMax().x - c.ui.look.px(16));
  text_muted(c.ui, text);
  ImGui::PopTextWrapPos();
  note_widget(c.ui, "assembly/unnumbered");
}

}  // namespace

void panel_assembly(UiContext& context) {
  UiState& ui = context.ui;
  if (const std::string reason = why_no_assembly(context); !reason.empty()) {
    text_muted(ui, reason);
    return;
  }
  const std::vector<EdgeId>& order = assembly_order(context);
  const float width = ImGui::GetContentRegionAvail().x - ui.look.px(16);
  const auto n_glued = static_cast<double>(context.session.project().glued.size());
  progress_line(ui, width, order.empty() ? 0 : n_glued / static_cast<double>(order.size()));
  const EdgeId seam = assembly_seam(context);
  if (seam.is_valid())
    seam_text(context, seam, order);
  else
    text_muted(ui, "All seams are glued.");
  const float each = (width - ui.look.px(8)) / 2;
  step_button(context, "assembly/back", ActionId::SeamBack, ButtonKind::Outlined, each);
  ImGui::SameLine();
  step_button(context, "assembly/on", ActionId::SeamOn, ButtonKind::Outlined, each);
  step_button(context, "assembly/tick", ActionId::TickSeam, ButtonKind::Accent, width);
  missing_numbers(context);
}

}  // namespace netwright
