// Rounding leaves touching corners 1e-14 apart, on either side. On a grid coarse enough that differences of
// coordinates are exact, and with equal corners really equal, such contacts have no area in any arithmetic.
#include "core/unfold/settle.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numeric>

#include "core/base/geometry.h"
#include "core/base/predicates.h"

namespace netwright {

namespace {

// Points by x, to look up those near an edge.
class SortedPoints {
 public:
  explicit SortedPoints(const std::vector<glm::dvec2>& points) : points_(points), order_(points.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
      return points[a].x != points[b].x ? points[a].x < points[b].x : a < b;
    });
  }

  template <class Visit>
  void between(double min_x, double max_x, Visit&& visit) const {
    auto it = std::lower_bound(order_.begin(), order_.end(), min_x,
                               [&](std::size_t i, double x) { return points_[i].x < x; });
    for (; it != order_.end() && points_[*it].x <= max_x; ++it) visit(*it);
  }
  [[nodiscard]] const std::vector<std::size_t>& order() const { return order_; }

 private:
  const std::vector<glm::dvec2>& points_;
  std::vector<std::size_t> order_;
};

double grid_width(const std::vector<glm::dvec2>& points) {
  double extent = 0;
  for (const glm::dvec2 p : points) extent = std::max({extent, std::abs(p.x), std::abs(p.y)});
  return extent > 0 ? std::ldexp(1.0, std::ilogb(extent) - 50) : 1;
}

void unite_corners(std::vector<glm::dvec2>& points, double reach) {
  const std::vector<glm::dvec2> before = points;
  const SortedPoints sorted(before);
  std::vector<char> is_settled(points.size(), 0);
  for (const std::size_t i : sorted.order()) {
    if (is_settled[i]) continue;
    sorted.between(before[i].x, before[i].x + reach, [&](std::size_t j) {
      if (is_settled[j] || std::abs(before[j].y - before[i].y) > reach) return;
      points[j] = before[i];
      is_settled[j] = 1;
    });
  }
}

// Moves every point that touches the inside of this cut edge (face on its left) to its right.
bool push_out(FlatNet& net, const SortedPoints& sorted, const FlatNet::Edge& edge, double reach,
              double grid) {
  const glm::dvec2 a = net.points[static_cast<std::size_t>(edge.from)];
  const glm::dvec2 b = net.points[static_cast<std::size_t>(edge.to)];
  const double length = glm::length(b - a);
  const glm::dvec2 along = (b - a) / length;
  const double gap = 0.4 * reach;
  bool moved = false;
  sorted.between(std::min(a.x, b.x) - reach, std::max(a.x, b.x) + reach, [&](std::size_t i) {
    glm::dvec2& q = net.points[i];
    if (q == a || q == b) return;
    const double t = glm::dot(q - a, along);
    const double inside = cross(along, q - a);
    if (t <= 0 || t >= length || std::abs(inside) > reach || inside <= -0.9 * gap) return;
    q += glm::dvec2(along.y, -along.x) * (inside + gap);
    q = glm::round(q / grid) * grid;
    moved = true;
  });
  return moved;
}

}  // namespace

void settle(FlatNet& net, double mean_edge) {
  const double grid = grid_width(net.points);
  for (glm::dvec2& p : net.points) p = glm::round(p / grid) * grid;
  const double reach = kSameCorner * mean_edge;
  if (reach < 8 * grid) return;  // the net is so wide for its edges that the grid would be felt
  unite_corners(net.points, reach);
  const std::vector<glm::dvec2> before = net.points;
  const SortedPoints sorted(before);
  bool moved = true;
  for (int pass = 0; pass < 3 && moved; ++pass) {
    moved = false;
    for (const FlatNet::Edge& edge : net.edges)
      if (edge.assignment == Assignment::Boundary) moved = push_out(net, sorted, edge, reach, grid) || moved;
  }
}

}  // namespace netwright
