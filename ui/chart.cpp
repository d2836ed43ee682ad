// Frame, lines and labels of a chart. Lines lie on whole pixels, so that they stay thin.
#include "ui/chart.h"

#include <algorithm>
#include <cmath>

namespace netwright {
namespace {

void draw_label(const UiState& ui, const std::string& text, ImVec2 at, float align_x) {
  ImFont* font = ui.look.fonts.small;
  const ImVec2 extent = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.c_str());
  ImGui::GetWindowDrawList()->AddText(
      font, font->FontSize, ImVec2(std::floor(at.x - extent.x * align_x), std::floor(at.y - extent.y / 2)),
      ui.look.colours.muted, text.c_str());
}

}  // namespace

int nice_ceiling(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(std::max(value, 1.0))));
  for (const double step : {1.0, 2.0, 4.0, 5.0, 8.0, 10.0}) {
    if (step * power >= value) return static_cast<int>(step * power);
  }
  return static_cast<int>(10 * power);
}

void begin_chart(const UiState& ui, float height, const std::string& widest_label, ChartFrame& frame) {
  const Look& look = ui.look;
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x - look.px(16), look.px(height));
  const ImVec2 max(min.x + size.x, min.y + size.y);
  ImGui::Dummy(size);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(min, max, look.colours.field, look.px(4));
  draw.AddRect(min, max, look.colours.border, look.px(4));
  ImFont* font = look.fonts.small;
  const float label = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, widest_label.c_str()).x;
  frame.min = ImVec2(min.x + look.px(14) + label, min.y + look.px(14));
  frame.max = ImVec2(max.x - look.px(12), max.y - look.px(26));
}

void chart_line(const UiState& ui, const ChartFrame& frame, double y, const std::string& label) {
  const float at = std::floor(frame.y(y)) + 0.5F;
  ImGui::GetWindowDrawList()->AddLine(ImVec2(frame.min.x, at), ImVec2(frame.max.x, at),
                                      ui.look.colours.border);
  if (!label.empty()) draw_label(ui, label, ImVec2(frame.min.x - ui.look.px(6), at), 1);
}

void chart_ends(const UiState& ui, const ChartFrame& frame, const std::string& left,
                const std::string& right) {
  const float below = frame.max.y + ui.look.px(12);
  draw_label(ui, left, ImVec2(frame.min.x, below), 0);
  draw_label(ui, right, ImVec2(frame.max.x, below), 1);
}

void chart_moment(const UiState& ui, const ChartFrame& frame, double x, const std::vector<double>& heights) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImU32 colour = ui.look.colours.text;
  const float at = std::floor(frame.x(x)) + 0.5F;
  draw.AddLine(ImVec2(at, frame.min.y), ImVec2(at, frame.max.y), colour, ui.look.px(1));
  for (const double y : heights) draw.AddCircleFilled(ImVec2(at, frame.y(y)), ui.look.px(4), colour, 16);
}

}  // namespace netwright
