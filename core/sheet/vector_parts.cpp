// Dash patterns walked along their lines, curves of letters cut into short lines, and rows of sheets.
#include "core/sheet/vector_parts.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace netwright {

namespace {

constexpr double kSheetGap = 10;

/// Follows a dash pattern: which part of it one is in, and how much of that is left.
class DashWalk {
 public:
  DashWalk(const std::vector<double>& pattern_mm, double phase_mm) : pattern_(pattern_mm) {
    const double period = std::accumulate(pattern_.begin(), pattern_.end(), 0.0);
    // A pattern of an odd number of parts changes ink and gap each time round.
    const double whole = pattern_.size() % 2 == 0 ? period : 2 * period;
    left_ = pattern_.front();
    double rest = phase_mm - std::floor(phase_mm / whole) * whole;
    while (rest >= left_) {
      rest -= left_;
      next();
    }
    left_ -= rest;
  }
  [[nodiscard]] bool is_ink() const { return part_ % 2 == 0; }
  [[nodiscard]] double left() const { return left_; }
  void go(double length) { left_ -= length; }
  void next() {
    ++part_;
    left_ = pattern_[part_ % pattern_.size()];
  }

 private:
  const std::vector<double>& pattern_;
  std::size_t part_ = 0;
  double left_ = 0;
};

class DashCutter {
 public:
  explicit DashCutter(const Stroke& stroke) : walk_(stroke.dash_mm, stroke.dash_phase_mm) {}

  void add_side(glm::dvec2 from, glm::dvec2 to) {
    const double length = glm::length(to - from);
    if (!(length > 0)) return;
    if (walk_.is_ink() && current_.empty()) current_.push_back(from);
    double done = 0;
    while (length - done > walk_.left()) {
      done += walk_.left();
      const glm::dvec2 at = from + (to - from) * (done / length);
      if (walk_.is_ink()) {
        current_.push_back(at);
        close();
      }
      walk_.next();
      if (walk_.is_ink()) current_.push_back(at);
    }
    walk_.go(length - done);
    if (walk_.is_ink()) current_.push_back(to);
  }
  std::vector<Line> take() {
    close();
    return std::move(lines_);
  }

 private:
  void close() {
    if (current_.size() > 1) lines_.push_back(std::move(current_));
    current_.clear();
  }
  DashWalk walk_;
  Line current_;
  std::vector<Line> lines_;
};

bool has_pattern(const Stroke& stroke) {
  const bool is_sound =
      std::ranges::all_of(stroke.dash_mm, [](double part) { return part >= 0 && std::isfinite(part); });
  return is_sound && std::accumulate(stroke.dash_mm.begin(), stroke.dash_mm.end(), 0.0) > 1e-3;
}

/// How many lines a curve needs: its second differences bound how far it bends away from its chords.
int pieces_of(glm::dvec2 a, const std::array<glm::dvec2, 3>& c) {
  constexpr double kTolerance = 0.01;
  const double bend = std::max(glm::length(a - 2.0 * c[0] + c[1]), glm::length(c[0] - 2.0 * c[1] + c[2]));
  return std::clamp(static_cast<int>(std::ceil(std::sqrt(0.75 * bend / kTolerance))), 1, 64);
}

}  // namespace

std::vector<Line> inked_lines(const Stroke& stroke) {
  if (stroke.points.size() < 2) return {};
  Line line = stroke.points;
  if (stroke.is_closed) line.push_back(line.front());
  if (!has_pattern(stroke)) return {std::move(line)};
  DashCutter cutter(stroke);
  for (std::size_t i = 1; i < line.size(); ++i) cutter.add_side(line[i - 1], line[i]);
  return cutter.take();
}

std::vector<Font::Step> text_outline(const Text& text, const Font& font) {
  std::vector<Font::Step> steps = font.outline(clean_utf8(text.words), text.size_mm, text.at);
  if (text.angle_rad == 0) return steps;
  const double c = std::cos(text.angle_rad);
  const double s = std::sin(text.angle_rad);
  for (Font::Step& step : steps) {
    for (glm::dvec2& p : step.points) {
      const glm::dvec2 arm = p - text.at;
      p = text.at + glm::dvec2(c * arm.x - s * arm.y, s * arm.x + c * arm.y);
    }
  }
  return steps;
}

std::vector<Line> text_polygons(const Text& text, const Font& font) {
  std::vector<Line> polygons;
  for (const Font::Step& step : text_outline(text, font)) {
    if (step.kind == 'M') polygons.emplace_back();
    if (step.kind == 'M' || step.kind == 'L') polygons.back().push_back(step.points[0]);
    if (step.kind != 'C') continue;
    const glm::dvec2 a = polygons.back().back();
    const int n = pieces_of(a, step.points);
    for (int i = 1; i <= n; ++i) {
      const double t = static_cast<double>(i) / n;
      const double u = 1 - t;
      polygons.back().push_back(u * u * u * a + 3 * u * u * t * step.points[0] +
                                3 * u * t * t * step.points[1] + t * t * t * step.points[2]);
    }
  }
  for (Line& polygon : polygons)
    if (polygon.size() > 1 && polygon.front() == polygon.back()) polygon.pop_back();
  std::erase_if(polygons, [](const Line& polygon) { return polygon.size() < 3; });
  return polygons;
}

Sheet moved(Sheet sheet, glm::dvec2 by_mm) {
  for (Fill& fill : sheet.fills)
    for (glm::dvec2& p : fill.points) p += by_mm;
  for (Picture& picture : sheet.pictures) picture.at += by_mm;
  for (Stroke& stroke : sheet.strokes)
    for (glm::dvec2& p : stroke.points) p += by_mm;
  for (Text& text : sheet.texts) text.at += by_mm;
  return sheet;
}

SheetRow side_by_side(std::span<const Sheet> sheets) {
  SheetRow row;
  for (const Sheet& sheet : sheets) {
    const double left = row.sheets.empty() ? 0 : row.width_mm + kSheetGap;
    row.left_mm.push_back(left);
    row.sheets.push_back(moved(sheet, {left, 0}));
    row.width_mm = left + sheet.width_mm;
    row.height_mm = std::max(row.height_mm, sheet.height_mm);
  }
  return row;
}

}  // namespace netwright
