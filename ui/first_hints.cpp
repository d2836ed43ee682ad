// Two hints, one after the other: how to begin, and that runs are kept.
#include "ui/first_hints.h"

#include <cmath>
#include <optional>

#include "assets/icons.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

constexpr float kPadding = 9;
constexpr float kTextLeft = 44;
constexpr float kButton = 96;

const char* words_of(FirstHint hint) {
  return hint == FirstHint::Views ? "New here? Space unfolds the model. Drag turns it, the wheel zooms, a "
                                    "click shows a face in both "
                                    "views, and ? lists all keys."
                                  : "Every finished run is kept in the list at the left: click one to look "
                                    "at it, and use the net you "
                                    "like best.";
}

/// Notes what has happened by itself, and says what is left to be told.
std::optional<FirstHint> present_hint(UiContext& c) {
  Settings& settings = c.ui.settings;
  const std::size_t n_runs = c.session.runs().size();
  if (n_runs > 0) settings.is_done(FirstHint::Views) = true;
  if (c.session.viewed_run() != 0) settings.is_done(FirstHint::Runs) = true;
  if (!c.session.has_model()) return std::nullopt;
  if (!settings.is_done(FirstHint::Views)) return FirstHint::Views;
  if (!settings.is_done(FirstHint::Runs) && n_runs > 1) return FirstHint::Runs;
  return std::nullopt;
}

}  // namespace

float first_hint_height(UiContext& context, float width) {
  const auto hint = present_hint(context);
  if (!hint) return 0;
  const Look& look = context.ui.look;
  const float room = width - look.px(kTextLeft) - look.px(kButton) - look.px(16);
  const float text = ImGui::CalcTextSize(words_of(*hint), nullptr, false, room).y;
  return std::ceil(std::max(text, look.px(24)) + 2 * look.px(kPadding));
}

void draw_first_hint(UiContext& context) {
  const auto hint = present_hint(context);
  if (!hint) return;
  UiState& ui = context.ui;
  const Look& look = ui.look;
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const ImVec2 size = ImGui::GetContentRegionAvail();
  const ImVec2 max(min.x + size.x, min.y + size.y);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(min, max, look.colours.tint);
  const float room = size.x - look.px(kTextLeft) - look.px(kButton) - look.px(16);
  const float text = ImGui::CalcTextSize(words_of(*hint), nullptr, false, room).y;
  const float top = std::floor(min.y + (size.y - text) / 2);
  draw.AddText(ImVec2(min.x + look.px(16), top), look.colours.on_tint, icon::kHint);
  ImGui::SetCursorScreenPos(ImVec2(min.x + look.px(kTextLeft), top));
  ImGui::PushStyleColor(ImGuiCol_Text, look.colours.on_tint);
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + room);
  ImGui::TextUnformatted(words_of(*hint));
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  ButtonSpec close{"hint/close", "Got it", "", "Closes this hint for good"};
  close.kind = ButtonKind::Outlined;
  close.width = look.px(kButton);
  close.height = look.px(28);
  ImGui::SetCursorScreenPos(
      ImVec2(max.x - look.px(12) - close.width, std::floor(min.y + (size.y - close.height) / 2)));
  if (button(ui, close)) ui.settings.is_done(*hint) = true;
}

}  // namespace netwright
