// The status bar: a hint at the left, the truth in words at the right.
#include <cmath>

#include "assets/icons.h"
#include "ui/arranging.h"
#include "ui/frame_parts.h"
#include "ui/selection.h"
#include "ui/status.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

std::string standing_hint(const UiContext& context) {
  if (!context.ui.hint.empty()) return context.ui.hint;
  switch (context.session.state()) {
    case RunState::Empty:
      return "Drop a model on the window, or press Ctrl+O";
    case RunState::Opening:
      return "";
    case RunState::Running:
      return "Space pauses · Esc stops and keeps the best net";
    case RunState::Paused:
      return "S makes one move · Space goes on · Esc stops";
    case RunState::Replaying:
      return "This is how the net was found · Esc skips to the end";
    case RunState::Idle:
      break;
  }
  if (context.ui.arranging.is_on) return arranging_hint(context);
  if (const std::string selected = selection_text(context.ui); !selected.empty())
    return selected + " · Shift+click adds or lets go · Esc lets go of all";
  if (context.session.timeline())
    return "Enter uses this net · ← → go move by move · V plays · Esc goes back";
  if (context.session.viewed_run() != 0)
    return "Enter uses this net · Page Up and Page Down look at others · Esc goes back";
  const auto shown = context.session.shown();
  if (shown == nullptr) return "Space unfolds · S goes move by move · ? lists all keys";
  return shown->is_proved ? "Ctrl+P exports the pages · N searches another net · ? lists all keys"
                          : "Space searches again · N tries the next seed · ? lists all keys";
}

struct Sign {
  const char* icon;
  ImU32 colour;
};

Sign sign_of(Tone tone, const Colours& colours) {
  switch (tone) {
    case Tone::Good:
      return {icon::kProved, colours.good};
    case Tone::Bad:
      return {icon::kWarning, colours.bad};
    case Tone::Working:
      return {icon::kTime, colours.accent};
    case Tone::Quiet:
      break;
  }
  return {"", colours.muted};
}

}  // namespace

void draw_status_bar(UiContext& context) {
  const UiState& ui = context.ui;
  const Look& look = ui.look;
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const ImVec2 size = ImGui::GetContentRegionAvail();
  const float y = std::floor(min.y + (size.y - ImGui::GetTextLineHeight()) / 2);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const Status status = status_of(context.session);
  const Sign sign = sign_of(status.tone, look.colours);
  const float sign_width = *sign.icon == 0 ? 0 : ImGui::CalcTextSize(sign.icon).x + look.px(8);
  // The truth comes first: the hint takes what is left.
  const float room = size.x - look.px(32) - sign_width;
  const std::string text = shortened(status.text, room);
  const float right = min.x + size.x - look.px(16) - ImGui::CalcTextSize(text.c_str()).x;
  draw.AddText(ImVec2(std::floor(right), y), look.colours.text, text.c_str());
  if (sign_width > 0) draw.AddText(ImVec2(std::floor(right - sign_width), y), sign.colour, sign.icon);
  const float hint_room = right - sign_width - look.px(24) - (min.x + look.px(16));
  const std::string hint = hint_room < look.px(80) ? "" : shortened(standing_hint(context), hint_room);
  draw.AddText(ImVec2(min.x + look.px(16), y), look.colours.muted, hint.c_str());
}

}  // namespace netwright
