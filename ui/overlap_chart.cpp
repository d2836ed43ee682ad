// The chart of overlaps over moves. At most one corner per pixel is drawn: of the values that share a column
// the largest and the last, so that peaks stay visible however long the search was.
#include <algorithm>
#include <cmath>
#include <string>

#include "ui/panels.h"
#include "ui/status.h"

namespace netwright {
namespace {

/// The next 1, 2 or 5 times a power of ten, at least `value`.
int nice_ceiling(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(std::max(value, 1.0))));
  for (const double step : {1.0, 2.0, 4.0, 5.0, 8.0, 10.0}) {
    if (step * power >= value) return static_cast<int>(step * power);
  }
  return static_cast<int>(10 * power);
}

struct Frame {
  ImVec2 min;  ///< of the plot
  ImVec2 max;
  double most_overlaps = 1;
  double most_moves = 1;
  [[nodiscard]] float x(double moves) const {
    return min.x + (max.x - min.x) * static_cast<float>(moves / most_moves);
  }
  [[nodiscard]] float y(double overlaps) const {
    return max.y - (max.y - min.y) * static_cast<float>(overlaps / most_overlaps);
  }
};

void draw_label(const UiState& ui, const std::string& text, ImVec2 at, float align_x) {
  ImFont* font = ui.look.fonts.small;
  const ImVec2 extent = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.c_str());
  ImGui::GetWindowDrawList()->AddText(
      font, font->FontSize, ImVec2(std::floor(at.x - extent.x * align_x), std::floor(at.y - extent.y / 2)),
      ui.look.colours.muted, text.c_str());
}

void draw_axes(const UiState& ui, const Frame& frame) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  for (const double share : {0.0, 0.5, 1.0}) {
    const float y = std::floor(frame.y(frame.most_overlaps * share)) + 0.5F;
    draw.AddLine(ImVec2(frame.min.x, y), ImVec2(frame.max.x, y), ui.look.colours.border);
    const double value = frame.most_overlaps * share;
    if (value != std::floor(value)) continue;
    draw_label(ui, grouped(std::llround(value)), ImVec2(frame.min.x - ui.look.px(6), y), 1);
  }
  const float below = frame.max.y + ui.look.px(12);
  draw_label(ui, "0", ImVec2(frame.min.x, below), 0);
  draw_label(ui, grouped(std::llround(frame.most_moves)), ImVec2(frame.max.x, below), 1);
}

void draw_curve(const UiState& ui, const Frame& frame, const std::vector<int>& history, std::int64_t stride) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImU32 line = ui.look.colours.accent;
  const ImU32 area = (line & ~IM_COL32_A_MASK) | IM_COL32(0, 0, 0, 28);
  float x = frame.x(0);
  float y = frame.y(history.front());
  std::vector<ImVec2> corners{{x, y}};
  for (std::size_t i = 1; i < history.size();) {
    const float right = frame.x(static_cast<double>(i) * static_cast<double>(stride));
    int peak = history[i];
    int last = history[i];
    for (++i; i < history.size() && frame.x(static_cast<double>(i) * static_cast<double>(stride)) < right + 1;
         ++i) {
      peak = std::max(peak, history[i]);
      last = history[i];
    }
    draw.AddRectFilled(ImVec2(x, y), ImVec2(right, frame.max.y), area);
    const float next = frame.y(last);
    // Corners on one line would make the polyline's joints swell.
    if (peak != last || next != y || i == history.size()) {
      corners.emplace_back(right, y);
      if (peak > last && frame.y(peak) != y) corners.emplace_back(right, frame.y(peak));
      if (next != corners.back().y) corners.emplace_back(right, next);
    }
    x = right;
    y = next;
  }
  draw.AddPolyline(corners.data(), static_cast<int>(corners.size()), line, 0, ui.look.px(1.5F));
  draw.AddCircleFilled(ImVec2(x, y), ui.look.px(4), history.back() == 0 ? ui.look.colours.good : line, 16);
}

void draw_mark(const UiState& ui, const Frame& frame, const RunFigures& figures) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float x = std::floor(frame.x(static_cast<double>(figures.at_move))) + 0.5F;
  draw.AddLine(ImVec2(x, frame.min.y), ImVec2(x, frame.max.y), ui.look.colours.text, ui.look.px(1));
  const ImVec2 dot(x, frame.y(figures.overlaps));
  draw.AddCircleFilled(dot, ui.look.px(4), ui.look.colours.text, 16);
}

}  // namespace

void overlap_chart(const UiState& ui, const RunFigures& figures, bool is_running) {
  const std::vector<int>& history = figures.history;
  const std::int64_t stride = figures.history_stride;
  const Look& look = ui.look;
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x - look.px(16), look.px(128));
  const ImVec2 max(min.x + size.x, min.y + size.y);
  ImGui::Dummy(size);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(min, max, look.colours.field, look.px(4));
  draw.AddRect(min, max, look.colours.border, look.px(4));
  Frame frame;
  frame.most_overlaps = nice_ceiling(*std::max_element(history.begin(), history.end()));
  const double moves = static_cast<double>(history.size() - 1) * static_cast<double>(stride);
  // While it runs the right end moves in jumps, so that the curve can be followed; at the end it fits.
  frame.most_moves = is_running ? nice_ceiling(std::max(moves, 20.0)) : std::max(moves, 1.0);
  const float label = look.fonts.small
                          ->CalcTextSizeA(look.fonts.small->FontSize, FLT_MAX, 0,
                                          grouped(std::llround(frame.most_overlaps)).c_str())
                          .x;
  frame.min = ImVec2(min.x + look.px(14) + label, min.y + look.px(14));
  frame.max = ImVec2(max.x - look.px(12), max.y - look.px(26));
  draw_axes(ui, frame);
  draw_curve(ui, frame, history, stride);
  if (figures.at_move >= 0) draw_mark(ui, frame, figures);
}

}  // namespace netwright
