// A button that plays, a slider from flat to folded, and what the amount is.
#include "ui/fold_bar.h"

#include <cmath>
#include <string>

#include "assets/icons.h"
#include "ui/actions.h"
#include "ui/legend.h"
#include "ui/view_parts.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

constexpr float kLeastSlider = 80;

void word(const UiState& ui, const char* text, float x, float middle) {
  const ImFont* font = ui.look.fonts.small;
  ImGui::GetWindowDrawList()->AddText(
      font, font->FontSize, ImVec2(x, std::floor(middle - font->FontSize / 2)), ui.look.colours.text, text);
}

float word_width(const UiState& ui, const char* text) {
  const ImFont* font = ui.look.fonts.small;
  return std::ceil(font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text).x);
}

void play_button(UiContext& context) {
  const Action& play = action(ActionId::PlayFold);
  const bool is_playing = context.ui.folding.is_playing;
  ButtonSpec spec{"fold/play", "", is_playing ? icon::kPause : icon::kPlay, tip_of(context, play)};
  spec.width = spec.height = context.ui.look.px(28);
  spec.is_enabled = is_possible(context, ActionId::PlayFold);
  if (button(context.ui, spec)) run_action(context, ActionId::PlayFold);
}

}  // namespace

float fold_bar_height(const UiState& ui) { return legend_height(ui); }

void draw_fold_bar(UiContext& context) {
  UiState& ui = context.ui;
  const Look& look = ui.look;
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const ImVec2 max(min.x + ImGui::GetContentRegionAvail().x, min.y + fold_bar_height(ui));
  ImGui::GetWindowDrawList()->AddRectFilled(min, max, to_u32(palette_of(ui).background_bottom));
  const float middle = (min.y + max.y) / 2;
  float left = min.x + look.px(8);
  ImGui::SetCursorScreenPos(ImVec2(left, min.y + look.px(6)));
  play_button(context);
  left += look.px(28 + 8);
  float right = max.x - look.px(16);
  const float flat = word_width(ui, "flat");
  const float folded = word_width(ui, "folded");
  const bool has_words = right - left - flat - folded - look.px(16) >= look.px(kLeastSlider);
  if (has_words) {
    word(ui, "flat", left, middle);
    word(ui, "folded", right - folded, middle);
    left += flat + look.px(8);
    right -= folded + look.px(8);
  }
  if (right - left < look.px(24)) return;
  auto t = static_cast<float>(ui.folding.amount);
  ImGui::SetCursorScreenPos(ImVec2(left, min.y + look.px(4)));
  const std::string reason = action(ActionId::PlayFold).why_not(context);
  const std::string tip = reason.empty() ? "How far the net is folded up  (, and .)" : reason;
  if (slim_slider(ui, "fold/amount", right - left, t, tip, reason.empty())) {
    ui.folding.amount = static_cast<double>(t);
    ui.folding.is_playing = false;
  }
}

}  // namespace netwright
