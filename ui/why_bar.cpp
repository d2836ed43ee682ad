// A bar above the views like those that ask, but nobody has to answer: it can be closed, and goes with the
// next search.
#include "ui/why_bar.h"

#include <imgui.h>

#include <string>
#include <vector>

#include "assets/icons.h"
#include "core/base/counted.h"
#include "ui/actions.h"
#include "ui/bar_layout.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

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
  spec.height = context.ui.look.px(kBarControlHeight);
  spec.is_enabled = is_possible(context, choice.id);
  return spec;
}

float controls_width(const UiContext& context) {
  float width = context.ui.look.px(kCloseWidth);
  for (const Choice& choice : choices(context))
    width += button_width(context.ui, button_of(context, choice)) + context.ui.look.px(kBarGap);
  return width;
}

std::string text_of(const UiContext& context) {
  if (context.session.trouble()->is_impossible) return "This model has no net in one piece: that is proved.";
  const auto shown = context.session.shown();
  const auto n = static_cast<std::int64_t>(shown == nullptr ? 0 : shown->overlaps.size());
  return "The search found no net in one piece: " + counted(n, "overlap is", "overlaps are") + " left.";
}

BarContent content_of(const UiContext& context) {
  return {icon::kInfo, text_of(context), controls_width(context)};
}

}  // namespace

float why_bar_height(const UiContext& context, float width) {
  const auto trouble = context.session.trouble();
  if (trouble == nullptr || trouble == context.ui.closed_trouble) return 0;
  return bar_height(context.ui, content_of(context), width);
}

void draw_why_bar(UiContext& context) {
  UiState& ui = context.ui;
  const Look& look = ui.look;
  begin_bar(ui, content_of(context));
  note_widget(ui, "why/bar");
  for (const Choice& choice : choices(context)) {
    if (button(ui, button_of(context, choice))) run_action(context, choice.id);
    ImGui::SameLine(0, look.px(kBarGap));
  }
  ButtonSpec close{"why/close", "", icon::kClose, "Closes this; the panel at the left still tells why"};
  close.width = look.px(kCloseWidth);
  close.height = look.px(kBarControlHeight);
  if (button(ui, close)) ui.closed_trouble = context.session.trouble();
}

}  // namespace netwright
