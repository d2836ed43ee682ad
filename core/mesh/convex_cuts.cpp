// One inward corner after the other, the sharpest first, gets the shortest diagonal that straightens it, or
// the shortest of all where none does alone.
#include "core/mesh/convex_cuts.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "core/base/geometry.h"
#include "core/base/polygon2.h"

namespace netwright {

namespace {

/// A diagonal nearer to a side than this (radians, half a degree) would cut a sliver off.
constexpr double kLeastAngle = 0.0087266462599716;
/// A diagonal that straightens its corner alone may be this much longer than one that does not.
constexpr double kWorthOfStraight = 3;

using Ring = std::vector<int>;

class Cutter {
 public:
  explicit Cutter(std::span<const glm::dvec2> polygon) : polygon_(polygon) {}

  std::vector<Ring> cut() {
    Ring all;
    for (std::size_t i = 0; i < polygon_.size(); ++i) all.push_back(static_cast<int>(i));
    std::vector<Ring> waiting{std::move(all)};
    std::vector<Ring> parts;
    while (!waiting.empty()) {
      const Ring ring = std::move(waiting.back());
      waiting.pop_back();
      const auto cut = best_cut(ring);
      if (!cut) {
        parts.push_back(ring);
        continue;
      }
      const auto [i, j] = *cut;
      const auto at = [&](std::size_t k) { return ring.begin() + static_cast<std::ptrdiff_t>(k); };
      waiting.emplace_back(at(i), at(j + 1));
      Ring& rest = waiting.emplace_back(at(j), ring.end());
      rest.insert(rest.end(), ring.begin(), at(i + 1));
    }
    return parts;
  }

 private:
  [[nodiscard]] glm::dvec2 point(const Ring& ring, std::size_t k) const {
    return polygon_[static_cast<std::size_t>(ring[k % ring.size()])];
  }
  /// How far the corner turns from the way in to the way out, counter-clockwise positive.
  static double turn(glm::dvec2 before, glm::dvec2 here, glm::dvec2 after) {
    return std::atan2(cross(here - before, after - here), glm::dot(here - before, after - here));
  }
  [[nodiscard]] double turn_at(const Ring& ring, std::size_t k) const {
    return turn(point(ring, k + ring.size() - 1), point(ring, k), point(ring, k + 1));
  }

  [[nodiscard]] std::optional<std::pair<std::size_t, std::size_t>> best_cut(const Ring& ring) const {
    std::vector<std::pair<double, std::size_t>> inward;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const double angle = turn_at(ring, k);
      if (angle < -kStraightTurn) inward.emplace_back(angle, k);
    }
    std::sort(inward.begin(), inward.end());
    for (const auto& [angle, from] : inward) {
      const std::size_t to = best_end(ring, from);
      if (to < ring.size()) return std::minmax(from, to);
    }
    return std::nullopt;
  }

  /// The other end of the best diagonal from a corner; the ring's size when there is none.
  [[nodiscard]] std::size_t best_end(const Ring& ring, std::size_t from) const {
    const std::size_t n = ring.size();
    std::size_t best = n;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 2; k + 1 < n; ++k) {
      const std::size_t to = (from + k) % n;
      const glm::dvec2 here = point(ring, from);
      const glm::dvec2 there = point(ring, to);
      const bool is_straight = turn(point(ring, from + n - 1), here, there) > -kStraightTurn &&
                               turn(there, here, point(ring, from + 1)) > -kStraightTurn;
      const double cost = glm::distance(here, there) * (is_straight ? 1 : kWorthOfStraight);
      if (cost < least && leads_inside(ring, from, there) && leads_inside(ring, to, here) &&
          is_free(ring, from, to)) {
        least = cost;
        best = to;
      }
    }
    return best;
  }

  /// Does the way from a corner to a point lead inside, and not along a side?
  [[nodiscard]] bool leads_inside(const Ring& ring, std::size_t corner, glm::dvec2 target) const {
    const glm::dvec2 here = point(ring, corner);
    const glm::dvec2 out = point(ring, corner + 1) - here;
    const glm::dvec2 back = point(ring, corner + ring.size() - 1) - here;
    const auto angle_to = [&](glm::dvec2 way) {
      const double angle = std::atan2(cross(out, way), glm::dot(out, way));
      return angle < 0 ? angle + kFullTurn : angle;
    };
    const double angle = angle_to(target - here);
    return angle > kLeastAngle && angle < angle_to(back) - kLeastAngle;
  }

  [[nodiscard]] bool is_free(const Ring& ring, std::size_t from, std::size_t to) const {
    const std::size_t n = ring.size();
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t next = (k + 1) % n;
      if (k == from || k == to || next == from || next == to) continue;
      if (segments_meet(point(ring, from), point(ring, to), point(ring, k), point(ring, next))) return false;
    }
    return true;
  }

  static constexpr double kFullTurn = 6.283185307179586;
  std::span<const glm::dvec2> polygon_;
};

}  // namespace

bool is_open(std::span<const glm::dvec2> polygon) {
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec2 in = polygon[(i + 1) % n] - polygon[i];
    const glm::dvec2 out = polygon[(i + 2) % n] - polygon[(i + 1) % n];
    if (std::atan2(cross(in, out), glm::dot(in, out)) < -kStraightTurn) return false;
  }
  return true;
}

std::vector<std::vector<int>> convex_cuts(std::span<const glm::dvec2> polygon) {
  return Cutter(polygon).cut();
}

}  // namespace netwright
