// Convex hulls (Andrew's monotone chain) and a search over the angles at which a hull may lie.
#include "core/base/best_angle.h"

#include <algorithm>
#include <numbers>

namespace netwright {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kStep = kPi / 90;

/// Golden-section search on an interval small enough to hold one minimum.
double refine(const std::function<double(double)>& cost_at, double low, double high) {
  const double ratio = (std::sqrt(5.0) - 1) / 2;
  double a = high - ratio * (high - low);
  double b = low + ratio * (high - low);
  double cost_a = cost_at(a);
  double cost_b = cost_at(b);
  for (int i = 0; i < 40; ++i) {
    if (cost_a <= cost_b) {
      high = b;
      b = a;
      cost_b = cost_a;
      a = high - ratio * (high - low);
      cost_a = cost_at(a);
    } else {
      low = a;
      a = b;
      cost_a = cost_b;
      b = low + ratio * (high - low);
      cost_b = cost_at(b);
    }
  }
  return cost_a <= cost_b ? a : b;
}

std::vector<double> candidate_angles(const std::vector<glm::dvec2>& hull) {
  std::vector<double> angles;
  for (double angle = 0; angle < kPi - kStep / 2; angle += kStep) angles.push_back(angle);
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const glm::dvec2 side = hull[(i + 1) % hull.size()] - hull[i];
    // Turning by minus its direction lays the side flat; a quarter turn more stands it up.
    const double angle = std::fmod(2 * kPi - std::atan2(side.y, side.x), kPi);
    angles.push_back(angle);
    angles.push_back(std::fmod(angle + kPi / 2, kPi));
  }
  std::sort(angles.begin(), angles.end());
  return angles;
}

}  // namespace

std::vector<glm::dvec2> convex_hull(std::vector<glm::dvec2> points) {
  std::sort(points.begin(), points.end(),
            [](glm::dvec2 a, glm::dvec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<glm::dvec2> hull;
  const auto add = [&](glm::dvec2 p, std::size_t keep) {
    while (hull.size() > keep && cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0)
      hull.pop_back();
    hull.push_back(p);
  };
  for (const glm::dvec2 p : points) add(p, 1);
  const std::size_t lower = hull.size();
  for (auto p = points.rbegin() + 1; p != points.rend(); ++p) add(*p, lower);
  hull.pop_back();
  return hull;
}

Box2 turned_box(const std::vector<glm::dvec2>& hull, double angle_rad) {
  const Rigid2 turn = Rigid2::rotation(angle_rad);
  Box2 box;
  for (const glm::dvec2 p : hull) box.add(turn(p));
  return box;
}

double best_angle(const std::vector<glm::dvec2>& hull, const std::function<double(glm::dvec2 size)>& cost) {
  const auto cost_at = [&](double angle) { return cost(turned_box(hull, angle).size()); };
  const std::vector<double> angles = candidate_angles(hull);
  std::vector<double> costs;
  costs.reserve(angles.size());
  for (const double angle : angles) costs.push_back(cost_at(angle));
  const double least = *std::min_element(costs.begin(), costs.end());

  double best = angles.front();
  double best_cost = std::numeric_limits<double>::infinity();
  const auto offer = [&](double angle, double angle_cost) {
    // A rounding error's gain is no reason to leave a plain angle.
    if (angle_cost < best_cost - 1e-9 * std::abs(angle_cost)) {
      best = angle;
      best_cost = angle_cost;
    }
  };
  for (std::size_t i = 0; i < angles.size(); ++i) offer(angles[i], costs[i]);
  for (std::size_t i = 0; i < angles.size(); ++i) {
    if (costs[i] > least + 0.05 * std::abs(least)) continue;
    const double before = i == 0 ? angles[i] - kStep : angles[i - 1];
    const double after = i + 1 == angles.size() ? angles[i] + kStep : angles[i + 1];
    const double angle = refine(cost_at, before, after);
    offer(angle, cost_at(angle));
  }
  return best;
}

}  // namespace netwright
