// The chart of overlaps over moves. At most one corner per pixel is drawn: of the values that share a column
// the largest and the last, so that peaks stay visible however long the search was.
#include <algorithm>
#include <cmath>
#include <string>

#include "ui/chart.h"
#include "ui/panels.h"
#include "ui/status.h"

namespace netwright {
namespace {

void draw_axes(const UiState& ui, const ChartFrame& frame) {
  for (const double share : {0.0, 0.5, 1.0}) {
    const double value = frame.most_y * share;
    const bool is_whole = value == std::floor(value);
    chart_line(ui, frame, value, is_whole ? grouped(std::llround(value)) : "");
  }
  chart_ends(ui, frame, "0", grouped(std::llround(frame.most_x)));
}

void draw_curve(const UiState& ui, const ChartFrame& frame, const std::vector<int>& history,
                std::int64_t stride) {
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

}  // namespace

void overlap_chart(const UiState& ui, const RunFigures& figures, bool is_running) {
  const std::vector<int>& history = figures.history;
  const std::int64_t stride = figures.history_stride;
  ChartFrame frame;
  frame.most_y = nice_ceiling(*std::max_element(history.begin(), history.end()));
  const double moves = static_cast<double>(history.size() - 1) * static_cast<double>(stride);
  // While it runs the right end moves in jumps, so that the curve can be followed; at the end it fits.
  frame.most_x = is_running ? nice_ceiling(std::max(moves, 20.0)) : std::max(moves, 1.0);
  begin_chart(ui, 128, grouped(std::llround(frame.most_y)), frame);
  draw_axes(ui, frame);
  draw_curve(ui, frame, history, stride);
  if (figures.at_move >= 0)
    chart_moment(ui, frame, static_cast<double>(figures.at_move), {static_cast<double>(figures.overlaps)});
}

}  // namespace netwright
