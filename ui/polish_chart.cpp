// The chart of polish: how long the cuts are and how much paper the net takes, both in percent of the first
// net's, over the work done.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "ui/chart.h"
#include "ui/panels.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

constexpr double kStep = 25;  ///< percent between lines, at the least

double percent_of(double value, double first) { return first > 0 ? 100 * value / first : 100; }

std::string percent_text(double percent) { return std::to_string(std::lround(percent)) + " %"; }

struct Curve {
  const char* name;
  double PolishStation::*value;
  ImU32 colour;
  bool is_square;
};

struct Plot {
  const UiState& ui;
  ChartFrame frame;
  const std::vector<PolishStation>& stations;
  double end;  ///< fraction up to which the nets stand

  [[nodiscard]] double height(const Curve& curve, const PolishStation& station) const {
    return percent_of(station.*curve.value, stations.front().*curve.value);
  }
};

void draw_marker(const UiState& ui, const Curve& curve, ImVec2 at) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float r = ui.look.px(4);
  if (curve.is_square) {
    draw.AddRectFilled(ImVec2(at.x - r, at.y - r), ImVec2(at.x + r, at.y + r), curve.colour);
  } else {
    draw.AddCircleFilled(at, r, curve.colour, 16);
  }
}

// A net stands until the next one: a line of steps. Those of one pixel are one.
void draw_curve(const Plot& plot, const Curve& curve) {
  const ChartFrame& frame = plot.frame;
  ImVec2 at(frame.x(0), frame.y(plot.height(curve, plot.stations.front())));
  std::vector<ImVec2> corners{at};
  const auto go_to = [&](ImVec2 next) {
    if (next.x != at.x) corners.emplace_back(next.x, at.y);
    if (next.y != at.y) corners.push_back(next);
    at = next;
  };
  for (const PolishStation& station : plot.stations) {
    const float x = frame.x(station.fraction);
    if (x - at.x >= 1) go_to({x, frame.y(plot.height(curve, station))});
  }
  go_to({at.x, frame.y(plot.height(curve, plot.stations.back()))});
  go_to({frame.x(plot.end), at.y});
  ImGui::GetWindowDrawList()->AddPolyline(corners.data(), static_cast<int>(corners.size()), curve.colour, 0,
                                          plot.ui.look.px(1.5F));
  draw_marker(plot.ui, curve, at);
}

void draw_percents(const Plot& plot) {
  const ChartFrame& frame = plot.frame;
  const double step = frame.most_y - frame.least_y > 4 * kStep ? 2 * kStep : kStep;
  for (double y = 100; y >= frame.least_y; y -= step) chart_line(plot.ui, frame, y, percent_text(y));
  for (double y = 100 + step; y <= frame.most_y; y += step) chart_line(plot.ui, frame, y, percent_text(y));
}

void set_range(Plot& plot, const std::array<Curve, 2>& curves) {
  double least = 100;
  double most = 100;
  for (const Curve& curve : curves)
    for (const PolishStation& station : plot.stations) {
      least = std::min(least, plot.height(curve, station));
      most = std::max(most, plot.height(curve, station));
    }
  plot.frame.least_y = std::min(100 - kStep, std::floor(least / kStep) * kStep);
  plot.frame.most_y = most;
}

// Signs and figures of both curves in one row.
void draw_legend(const Plot& plot, const std::array<Curve, 2>& curves) {
  const Look& look = plot.ui.look;
  ImGui::PushFont(look.fonts.small);
  for (const Curve& curve : curves) {
    if (&curve != &curves.front()) ImGui::SameLine(0, look.px(16));
    const ImVec2 min = ImGui::GetCursorScreenPos();
    draw_marker(plot.ui, curve, ImVec2(min.x + look.px(4), min.y + ImGui::GetTextLineHeight() / 2));
    ImGui::SetCursorScreenPos(ImVec2(min.x + look.px(12), min.y));
    ImGui::TextUnformatted(
        (curve.name + (" " + percent_text(plot.height(curve, plot.stations.back())))).c_str());
  }
  ImGui::PopFont();
}

}  // namespace

std::string polish_shares(const RunFigures& figures) {
  const std::vector<PolishStation>& stations = figures.polish_stations;
  if (stations.empty()) return {};
  const PolishStation& first = stations.front();
  const PolishStation& last = stations.back();
  return "Cuts " + percent_text(percent_of(last.cut_length, first.cut_length)) + ", paper " +
         percent_text(percent_of(last.paper, first.paper)) + " of the first net";
}

void polish_chart(const UiState& ui, const RunFigures& figures, bool is_running) {
  const Look& look = ui.look;
  const std::array<Curve, 2> curves{Curve{"Cuts", &PolishStation::cut_length, look.colours.accent, false},
                                    Curve{"Paper", &PolishStation::paper, look.colours.good, true}};
  Plot plot{ui, {}, figures.polish_stations, figures.polish_fraction};
  set_range(plot, curves);
  // While it runs the right end moves in jumps, as that of the overlaps does.
  plot.frame.most_x = is_running ? std::min(1.0, nice_ceiling(100 * plot.end) / 100.0) : plot.end;
  if (plot.frame.most_x <= 0) plot.frame.most_x = 1;
  begin_chart(ui, 112, percent_text(100), plot.frame);
  tooltip(ui, polish_shares(figures) +
                  ". Paper is the smallest sheet that the net can be cut from; every step is a net without "
                  "overlaps");
  note_widget(ui, "polish/chart");
  draw_percents(plot);
  chart_ends(ui, plot.frame, "first net", percent_text(100 * plot.frame.most_x) + " done");
  for (const Curve& curve : curves) draw_curve(plot, curve);
  if (figures.at_polish >= 0) chart_moment(ui, plot.frame, figures.at_polish, {});
  draw_legend(plot, curves);
}

}  // namespace netwright
