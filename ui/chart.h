// What the charts of the side panel have in common: a field with room for labels, lines across it, small
// text.
#pragma once

#include <imgui.h>

#include <string>

#include "ui/ui_state.h"

namespace netwright {

/// A plot on the screen: x goes from 0 to `most_x`, y from `least_y` at the bottom to `most_y`.
struct ChartFrame {
  ImVec2 min;
  ImVec2 max;
  double most_x = 1;
  double least_y = 0;
  double most_y = 1;
  [[nodiscard]] float x(double value) const {
    return min.x + (max.x - min.x) * static_cast<float>(value / most_x);
  }
  [[nodiscard]] float y(double value) const {
    return max.y - (max.y - min.y) * static_cast<float>((value - least_y) / (most_y - least_y));
  }
};

/// Draws the empty field, as wide as the panel and `height` high at 100 %, with room at the left for `label`;
/// sets where the plot lies in it.
void begin_chart(const UiState& ui, float height, const std::string& widest_label, ChartFrame& frame);

/// A line across the plot with a label at its left, which may be empty.
void chart_line(const UiState& ui, const ChartFrame& frame, double y, const std::string& label);

/// What stands at both ends of the lower edge.
void chart_ends(const UiState& ui, const ChartFrame& frame, const std::string& left,
                const std::string& right);

/// A moment of the chart that is looked at, with dots where the curves are.
void chart_moment(const UiState& ui, const ChartFrame& frame, double x, const std::vector<double>& heights);

/// The next 1, 2, 4, 5 or 8 times a power of ten, at least `value` and at least 1.
int nice_ceiling(double value);

}  // namespace netwright
