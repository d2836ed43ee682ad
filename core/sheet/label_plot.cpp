// A label is tested in its own frame, where it is an upright box: lines are clipped against it.
#include "core/sheet/label_plot.h"

#include <algorithm>
#include <cmath>

#include "core/base/polygon2.h"
#include "core/sheet/outline.h"

namespace netwright {

namespace {

constexpr double kAir = 0.28;  ///< between ink and ink, mm

/// Two boxes are apart when one of their four sides' directions tells them apart.
bool are_apart(const std::array<glm::dvec2, 4>& a, const std::array<glm::dvec2, 4>& b) {
  const auto splits = [](const auto& box, const auto& other, std::size_t i) {
    const glm::dvec2 axis = box[(i + 1) % 4] - box[i];
    const double low = glm::dot(axis, box[i]);
    const double high = glm::dot(axis, box[(i + 1) % 4]);
    double least = glm::dot(axis, other[0]);
    double most = least;
    for (const glm::dvec2 p : other) {
      least = std::min(least, glm::dot(axis, p));
      most = std::max(most, glm::dot(axis, p));
    }
    return most < low || least > high;
  };
  return splits(a, b, 0) || splits(a, b, 1) || splits(b, a, 0) || splits(b, a, 1);
}

}  // namespace

double WordMeasure::width_em(const std::string& words) {
  double width = 0;
  for (const char32_t code : code_points(words)) {
    const auto [place, is_new] = known_.try_emplace(code, 0);
    if (is_new) {
      const std::string one = code == U'°' ? "°" : std::string(1, static_cast<char>(code));
      place->second = font_.width(one, 1);
    }
    width += place->second;
  }
  return width;
}

bool LabelPlot::has_room_for(const Label& label) const {
  Label airy = label;
  airy.box_mm += 2 * kAir;
  const Rigid2 turn = Rigid2::rotation(-label.angle_rad);
  const glm::dvec2 half = airy.box_mm * 0.5;
  const Box2 box{-half, half};
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 a = turn.rotate(polygon[i] - label.centre);
    const glm::dvec2 b = turn.rotate(polygon[(i + 1) % polygon.size()] - label.centre);
    if (clip_segment(box, a, b)) return false;
  }
  if (!contains(polygon, label.centre)) return false;
  const std::array<glm::dvec2, 4> corners = airy.corners();
  return std::ranges::all_of(taken, [&](const Label& other) { return are_apart(corners, other.corners()); });
}

std::vector<glm::dvec2> LabelPlot::places() const {
  constexpr int kSteps = 9;
  Box2 box;
  glm::dvec2 middle(0);
  for (const glm::dvec2 p : polygon) {
    box.add(p);
    middle += p / static_cast<double>(polygon.size());
  }
  std::vector<glm::dvec2> places = {middle};
  for (int i = 1; i < kSteps; ++i)
    for (int j = 1; j < kSteps; ++j)
      places.push_back(box.min + box.size() * glm::dvec2(i, j) / static_cast<double>(kSteps));
  std::ranges::stable_sort(places, {}, [&](glm::dvec2 p) { return glm::length(p - middle); });
  return places;
}

double upright(double angle_rad) {
  constexpr double kHalfTurn = 3.14159265358979323846;
  double angle = std::remainder(angle_rad, kHalfTurn);
  if (angle <= -kHalfTurn / 2 + 1e-9) angle += kHalfTurn;
  return angle;
}

}  // namespace netwright
