// Toasts and the error bar.
#include "ui/messages.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "assets/icons.h"
#include "ui/actions.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

constexpr float kButtonsWidth = 116;

float text_height(const UiState& ui, float width) {
  const float wrap = width - ui.look.px(kBarTextLeft) - ui.look.px(kButtonsWidth);
  return ImGui::CalcTextSize(ui.error.c_str(), nullptr, false, wrap).y;
}

void draw_toast(const UiState& ui, const Toast& toast, std::size_t index, ImVec2 bottom_right, float& above) {
  const Look& look = ui.look;
  const float wrap = look.px(320);
  const ImVec2 text = ImGui::CalcTextSize(toast.text.c_str(), nullptr, false, wrap);
  const ImVec2 size(text.x + look.px(56), text.y + look.px(24));
  above += size.y + look.px(8);
  const ImVec2 min(bottom_right.x - look.px(16) - size.x, bottom_right.y - look.px(8) - above);
  ImGui::SetNextWindowPos(min);
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, look.px(4));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, look.colours.field);
  constexpr auto kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                          ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoSavedSettings;
  if (ImGui::Begin(("toast" + std::to_string(index)).c_str(), nullptr, kFlags)) {
    ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddText(ImVec2(min.x + look.px(12), min.y + look.px(12)),
                 toast.is_good ? look.colours.good : look.colours.muted,
                 toast.is_good ? icon::kProved : icon::kInfo);
    ImGui::SetCursorPos(ImVec2(look.px(40), look.px(12)));
    ImGui::PushTextWrapPos(look.px(40) + wrap);
    ImGui::TextUnformatted(toast.text.c_str());
    ImGui::PopTextWrapPos();
  }
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
}

/// Under a dialog nobody reads them: they wait, and their time does not run. True while they do.
bool hold_back(UiState& ui) {
  if (ui.toasts_held_at >= 0) {
    for (Toast& toast : ui.toasts) toast.until += ui.now - ui.toasts_held_at;
  }
  const bool is_held = ui.dialog != Dialog::None;
  ui.toasts_held_at = is_held ? ui.now : -1;
  return is_held;
}

}  // namespace

void take_messages(UiContext& context) {
  for (const Message& message : context.session.take_messages()) {
    if (message.kind == Message::Kind::Error) {
      context.ui.error = message.text;
    } else if (message.kind != Message::Kind::Good || !context.ui.is_dragging_faces) {
      // While the slider is held a net is found at every stop; only the last one is news.
      add_toast(context.ui, message.text, message.kind == Message::Kind::Good);
    }
  }
}

float error_bar_height(const UiState& ui, float width) {
  return ui.error.empty() ? 0 : std::ceil(text_height(ui, width) + 2 * ui.look.px(kBarPadding));
}

void draw_error_bar(UiState& ui) {
  const Look& look = ui.look;
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const ImVec2 size = ImGui::GetContentRegionAvail();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec2 max(min.x + size.x, min.y + size.y);
  draw.AddRectFilled(min, max, look.colours.bad_back);
  draw.AddRectFilled(min, ImVec2(min.x + look.px(4), max.y), look.colours.bad);
  draw.AddText(ImVec2(min.x + look.px(16), min.y + look.px(kBarPadding)), look.colours.bad, icon::kError);
  ImGui::SetCursorScreenPos(ImVec2(min.x + look.px(kBarTextLeft), min.y + look.px(kBarPadding)));
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + size.x - look.px(kBarTextLeft) - look.px(kButtonsWidth));
  ImGui::TextUnformatted(ui.error.c_str());
  ImGui::PopTextWrapPos();
  note_widget(ui, "error/text");
  ImGui::SetCursorScreenPos(ImVec2(max.x - look.px(112), min.y + look.px(6)));
  ButtonSpec copy{"error/copy", "Copy", "", "Puts the message on the clipboard"};
  copy.height = look.px(32);
  if (button(ui, copy)) ImGui::SetClipboardText(ui.error.c_str());
  ImGui::SameLine(0, look.px(4));
  if (button(ui, {"error/close", "", icon::kClose, "Closes this message"})) ui.error.clear();
}

void draw_toasts(UiState& ui, ImVec2 bottom_right) {
  if (hold_back(ui)) return;
  std::erase_if(ui.toasts, [&](const Toast& toast) { return toast.until <= ui.now; });
  float above = 0;
  for (std::size_t i = ui.toasts.size(); i-- > 0;) draw_toast(ui, ui.toasts[i], i, bottom_right, above);
}

}  // namespace netwright
