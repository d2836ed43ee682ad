// Controls end at the right where they stand beside the sentence, and begin under it where they do not.
#include "ui/bar_layout.h"

#include <imgui.h>

#include <cmath>

#include "ui/widgets.h"

namespace netwright {
namespace {

constexpr float kEdge = 6;  ///< above and below the controls

bool is_one_line(const UiState& ui, const BarContent& content, float width) {
  const float text = ImGui::CalcTextSize(content.text.c_str()).x;
  return ui.look.px(kBarTextLeft + kBarGap + kBarPadding) + text + content.controls_width <= width;
}

float wrap_width(const UiState& ui, float width) { return width - ui.look.px(kBarTextLeft + kBarPadding); }

}  // namespace

float bar_height(const UiState& ui, const BarContent& content, float width) {
  const float line = ui.look.px(kBarControlHeight + 2 * kEdge);
  if (is_one_line(ui, content, width)) return line;
  const ImVec2 text = ImGui::CalcTextSize(content.text.c_str(), nullptr, false, wrap_width(ui, width));
  return std::ceil(text.y + ui.look.px(kBarPadding) + line);
}

void begin_bar(const UiState& ui, const BarContent& content) {
  const Look& look = ui.look;
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const ImVec2 size = ImGui::GetContentRegionAvail();
  bar_background(ui, content.icon, content.text, wrap_width(ui, size.x));
  const bool is_beside = is_one_line(ui, content, size.x);
  const float x = is_beside ? min.x + size.x - look.px(kBarPadding) - content.controls_width
                            : min.x + look.px(kBarTextLeft);
  ImGui::SetCursorScreenPos(ImVec2(x, min.y + size.y - look.px(kBarControlHeight + kEdge)));
}

}  // namespace netwright
