// A bar above the views like those that ask, but nobody has to answer: it can be closed, and goes with the
// next search.
#include "ui/why_bar.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "assets/icons.h"
#include "core/base/counted.h"
#include "ui/actions.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

constexpr float kGap = 8;
constexpr float kButtonHeight = 32;
constexpr float kCloseWidth = 32;

struct Choice {
  const char* name;
  ActionId id;
  ButtonKind kind;
};

/// Only what can be done: releasing pins where there are some.
std::vector<Choice> choices(const UiContext& context) {
  std::vector<Choice> all{{"why/explain", ActionId::AskWhy, ButtonKind::Accent}};
  if (!context.session.project().pins.are_free() && !context.session.trouble()->is_impossible)
    all.push_back({"why/pins", ActionId::FindReleases, ButtonKind::Outlined});
  all.push_back({"why/soften", ActionId::FindSoftening, ButtonKind::Outlined});
  all.push_back({"why/pieces", ActionId::FindPieces, ButtonKind::Outlined});
  return all;
}

ButtonSpec button_of(const UiContext& context, const Choice& choice) {
  const Action& wanted = action(choice.id);
  ButtonSpec spec{choice.name, label_of(context, wanted), "", tip_of(context, wanted)};
  spec.kind = choice.kind;
  spec.height = context.ui.look.px(kButtonHeight);
  spec.is_enabled = is_possible(context, choice.id);
  return spec;
}

float controls_width(const UiContext& context) {
  float width = context.ui.look.px(kCloseWidth);
  for (const Choice& choice : choices(context))
    width += button_width(context.ui, button_of(context, choice)) + context.ui.look.px(kGap);
  return width;
}

std::string text_of(const UiContext& context) {
  if (context.session.trouble()->is_impossible) return "This model has no net in one piece: that is proved.";
  const auto shown = context.session.shown();
  const auto n = static_cast<std::int64_t>(shown == nullptr ? 0 : shown->overlaps.size());
  return "The search found no net in one piece: " + counted(n, "overlap is", "overlaps are") + " left.";
}

/// The buttons stand beside the sentence where there is room for both, else below it.
bool is_one_line(const UiContext& context, float width) {
  const Look& look = context.ui.look;
  const float text = ImGui::CalcTextSize(text_of(context).c_str()).x;
  return look.px(kBarTextLeft + kGap + kBarPadding) + text + controls_width(context) <= width;
}

}  // namespace

float why_bar_height(const UiContext& context, float width) {
  const auto trouble = context.session.trouble();
  if (trouble == nullptr || trouble == context.ui.closed_trouble) return 0;
  const Look& look = context.ui.look;
  const float line = look.px(kButtonHeight + 2 * 6);
  if (is_one_line(context, width)) return line;
  const float wrap = width - look.px(kBarTextLeft + kBarPadding);
  const ImVec2 text = ImGui::CalcTextSize(text_of(context).c_str(), nullptr, false, wrap);
  return std::ceil(text.y + look.px(kBarPadding) + line);
}

void draw_why_bar(UiContext& context) {
  UiState& ui = context.ui;
  const Look& look = ui.look;
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const ImVec2 size = ImGui::GetContentRegionAvail();
  const ImVec2 max(min.x + size.x, min.y + size.y);
  bar_background(ui, icon::kInfo, text_of(context), size.x - look.px(kBarTextLeft + kBarPadding));
  note_widget(ui, "why/bar");
  const float x = is_one_line(context, size.x) ? max.x - look.px(kBarPadding) - controls_width(context)
                                               : min.x + look.px(kBarTextLeft);
  ImGui::SetCursorScreenPos(ImVec2(x, max.y - look.px(kButtonHeight + 6)));
  for (const Choice& choice : choices(context)) {
    if (button(ui, button_of(context, choice))) run_action(context, choice.id);
    ImGui::SameLine(0, look.px(kGap));
  }
  ButtonSpec close{"why/close", "", icon::kClose, "Closes this; the panel at the left still tells why"};
  close.width = look.px(kCloseWidth);
  close.height = look.px(kButtonHeight);
  if (button(ui, close)) ui.closed_trouble = context.session.trouble();
}

}  // namespace netwright
