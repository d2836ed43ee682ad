// A bar above the views, like that for errors.
#include "ui/unrepaired_bar.h"

#include <imgui.h>

#include <cmath>
#include <string>

#include "assets/icons.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

constexpr float kButtonGap = 24;

ButtonSpec repair_button(const UiState& ui) {
  ButtonSpec spec{"unrepaired/repair", "Repair…"};
  spec.kind = ButtonKind::Accent;
  spec.tip = "Says what is wrong with the file and what can be done about it";
  spec.height = ui.look.px(32);
  return spec;
}

/// Why it cannot be unfolded, without the advice behind the semicolon: the button beside it is better.
std::string text_of(const UiContext& context) {
  const auto file = context.session.unrepaired();
  std::string reason = file->refusal.substr(0, file->refusal.rfind("; "));
  if (reason.starts_with(file->name + ": ")) reason.erase(0, file->name.size() + 2);
  return file->name + " is not repaired: " + reason + (reason.ends_with('.') ? "" : ".");
}

float wrap_width(const UiContext& context, float width) {
  const UiState& ui = context.ui;
  return width - ui.look.px(kBarTextLeft + kButtonGap + kBarPadding) - button_width(ui, repair_button(ui));
}

}  // namespace

float unrepaired_bar_height(const UiContext& context, float width) {
  if (!context.session.unrepaired()) return 0;
  const Look& look = context.ui.look;
  const ImVec2 text =
      ImGui::CalcTextSize(text_of(context).c_str(), nullptr, false, wrap_width(context, width));
  return std::ceil(std::max(text.y + look.px(2 * kBarPadding), look.px(32 + 2 * 6)));
}

void draw_unrepaired_bar(UiContext& context) {
  const UiState& ui = context.ui;
  const Look& look = ui.look;
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const ImVec2 size = ImGui::GetContentRegionAvail();
  const ImVec2 max(min.x + size.x, min.y + size.y);
  bar_background(ui, icon::kWarning, text_of(context), wrap_width(context, size.x));
  const ButtonSpec repair = repair_button(ui);
  ImGui::SetCursorScreenPos(
      ImVec2(max.x - look.px(kBarPadding) - button_width(ui, repair), min.y + look.px(6)));
  if (button(ui, repair)) context.session.ask_again();
}

}  // namespace netwright
