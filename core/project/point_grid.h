// Points in space, asked for those near a place. A grid of cells that is only a sorted list, so that the
// order of answers never depends on the machine.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <utility>
#include <vector>

namespace netwright {

class PointGrid {
 public:
  /// `cell` above 0, in the points' units: about the distance between neighbours.
  PointGrid(std::vector<glm::dvec3> points, double cell) : points_(std::move(points)), cell_(cell) {
    for (std::size_t i = 0; i < points_.size(); ++i) entries_.push_back({cell_of(points_[i]), i});
    std::ranges::sort(entries_);
  }

  /// Calls visit(index, distance) for all points up to `radius` away.
  template <class Visit>
  void near(const glm::dvec3& at, double radius, const Visit& visit) const {
    const Cell low = cell_of(at - glm::dvec3(radius));
    const Cell high = cell_of(at + glm::dvec3(radius));
    double n_rows = 1;
    for (std::size_t k = 0; k < 2; ++k) n_rows *= static_cast<double>(high[k] - low[k] + 1);
    if (n_rows > static_cast<double>(points_.size())) {
      for (std::size_t i = 0; i < points_.size(); ++i) look(i, at, radius, visit);
      return;
    }
    for (std::int64_t x = low[0]; x <= high[0]; ++x)
      for (std::int64_t y = low[1]; y <= high[1]; ++y) {
        auto entry = std::ranges::lower_bound(entries_, Entry{{x, y, low[2]}, 0});
        for (; entry != entries_.end() && entry->first <= Cell{x, y, high[2]}; ++entry)
          look(entry->second, at, radius, visit);
      }
  }

 private:
  using Cell = std::array<std::int64_t, 3>;
  using Entry = std::pair<Cell, std::size_t>;

  [[nodiscard]] Cell cell_of(const glm::dvec3& p) const {
    constexpr double kMost = 1e15;  // far outside of any grid, and inside of the integers
    const auto along = [&](double v) {
      return static_cast<std::int64_t>(std::clamp(std::floor(v / cell_), -kMost, kMost));
    };
    return {along(p.x), along(p.y), along(p.z)};
  }

  template <class Visit>
  void look(std::size_t i, const glm::dvec3& at, double radius, const Visit& visit) const {
    const double distance = glm::length(points_[i] - at);
    if (distance <= radius) visit(i, distance);
  }

  std::vector<glm::dvec3> points_;
  double cell_;
  std::vector<Entry> entries_;
};

}  // namespace netwright
