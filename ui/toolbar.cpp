// The toolbar: the few things people do most. Where the window is too narrow for the labels, icons stay.
#include <array>
#include <cmath>
#include <string>

#include "assets/icons.h"
#include "ui/actions.h"
#include "ui/frame_parts.h"
#include "ui/status.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

/// What stands in the bar, in order.
enum class Item { Action, IconOnly, Separator, Speed };
struct BarItem {
  Item kind = Item::Action;
  ActionId id = ActionId::Open;
  const char* label = "";  ///< shorter than the action's own
};

constexpr std::array<BarItem, 17> kBar{BarItem{Item::Action, ActionId::Open, "Open"},
                                       BarItem{Item::IconOnly, ActionId::Save},
                                       BarItem{Item::Separator},
                                       BarItem{Item::IconOnly, ActionId::Undo},
                                       BarItem{Item::IconOnly, ActionId::Redo},
                                       BarItem{Item::Separator},
                                       BarItem{Item::Action, ActionId::Unfold, ""},
                                       BarItem{Item::Action, ActionId::Step, "Step"},
                                       BarItem{Item::Action, ActionId::Stop, "Stop"},
                                       BarItem{Item::Action, ActionId::NewSeed, "New seed"},
                                       BarItem{Item::Speed},
                                       BarItem{Item::Separator},
                                       BarItem{Item::Action, ActionId::PinRoot, "Root"},
                                       BarItem{Item::IconOnly, ActionId::JoinAndCut},
                                       BarItem{Item::IconOnly, ActionId::ArrangePieces},
                                       BarItem{Item::IconOnly, ActionId::Measure},
                                       BarItem{Item::Action, ActionId::ExportPdf, "Print"}};

const char* unfold_icon(const UiContext& context) {
  switch (context.session.state()) {
    case RunState::Running:
      return icon::kPause;
    case RunState::Replaying:
      return icon::kSkip;
    default:
      return icon::kPlay;
  }
}

ButtonSpec spec_of(const UiContext& context, const BarItem& item, bool has_labels) {
  const Action& wanted = action(item.id);
  const bool is_main = item.id == ActionId::Unfold;
  const bool is_pin = item.id == ActionId::PinRoot;
  ButtonSpec spec{"toolbar/" + std::string(wanted.name), "", wanted.icon, ""};
  if (is_main) spec.icon = unfold_icon(context);
  const std::string label = is_main ? label_of(context, wanted) : item.label;
  if (has_labels && item.kind == Item::Action) spec.label = label;
  // Without its label a button has to say its name in the tooltip, and the root's whether it pins or lets go.
  spec.tip = (spec.label.empty() || is_pin ? label_of(context, wanted) + ": " : "") + tip_of(context, wanted);
  spec.is_enabled = is_possible(context, item.id);
  if (is_main) spec.kind = ButtonKind::Accent;
  if (is_pin && context.session.project().pins.root.is_valid()) spec.kind = ButtonKind::On;
  if (wanted.is_on != nullptr && wanted.is_on(context)) spec.kind = ButtonKind::On;
  // The main button changes its word while it is watched; its neighbours must not jump.
  if (is_main && has_labels) spec.width = context.ui.look.px(104);
  return spec;
}

float speed_width(const UiState& ui, bool has_labels) {
  const float slider = ui.look.px(has_labels ? 96 : 80);
  return slider + (has_labels ? ImGui::CalcTextSize("speed").x + ui.look.px(16) : 0);
}

/// Where room is shortest the tools stay in the menus and on their keys.
bool is_tool(const BarItem& item) {
  return item.kind == Item::IconOnly && (item.id == ActionId::JoinAndCut ||
                                         item.id == ActionId::ArrangePieces || item.id == ActionId::Measure);
}

float bar_width(const UiContext& context, bool has_labels) {
  const UiState& ui = context.ui;
  float width = ui.look.px(16);
  for (const BarItem& item : kBar) {
    if (item.kind == Item::Separator) {
      width += ui.look.px(17);
    } else if (item.kind == Item::Speed) {
      width += speed_width(ui, has_labels) + ui.look.px(4);
    } else {
      width += button_width(ui, spec_of(context, item, has_labels)) + ui.look.px(4);
    }
  }
  return width;
}

void separator(const UiState& ui) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float x = at.x + ui.look.px(6);
  ImGui::GetWindowDrawList()->AddLine(ImVec2(x, at.y + ui.look.px(2)), ImVec2(x, at.y + ui.look.px(30)),
                                      ui.look.colours.border);
  ImGui::Dummy(ImVec2(ui.look.px(13), ui.look.px(32)));
}

void speed_slider(UiContext& context, bool has_labels) {
  const UiState& ui = context.ui;
  if (has_labels) {
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ui.look.px(8));
    const float y = ImGui::GetCursorPosY();
    ImGui::SetCursorPosY(y + std::floor((ui.look.px(32) - ImGui::GetTextLineHeight()) / 2));
    text_muted(ui, "speed");
    ImGui::SameLine(0, ui.look.px(8));
    ImGui::SetCursorPosY(y);
  }
  auto t = static_cast<float>(slider_of_speed(context.session.speed()));
  const std::string tip =
      "How fast the search moves before your eyes: " + speed_text(context.session.speed());
  if (slim_slider(ui, "toolbar/speed", ui.look.px(has_labels ? 96 : 80), t, tip)) {
    context.session.set_speed(speed_of_slider(t));
  }
}

}  // namespace

void draw_toolbar(UiContext& context) {
  const UiState& ui = context.ui;
  const bool has_labels = bar_width(context, true) <= ImGui::GetContentRegionAvail().x;
  const bool has_tools = has_labels || bar_width(context, false) <= ImGui::GetContentRegionAvail().x;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.look.px(4), 0));
  for (const BarItem& item : kBar) {
    if (is_tool(item) && !has_tools) continue;
    const float y = ImGui::GetCursorPosY();
    if (item.kind == Item::Separator) {
      separator(ui);
    } else if (item.kind == Item::Speed) {
      speed_slider(context, has_labels);
    } else if (button(ui, spec_of(context, item, has_labels))) {
      run_action(context, item.id);
    }
    ImGui::SameLine();
    ImGui::SetCursorPosY(y);
  }
  ImGui::PopStyleVar();
}

}  // namespace netwright
