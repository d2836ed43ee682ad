// Ear clipping and the merging of its triangles. All turns are decided by the exact orientation test.
#include "core/base/polygon2.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/base/geometry.h"
#include "core/base/predicates.h"

namespace netwright {

namespace {

using Corners = std::span<const glm::dvec2>;

const glm::dvec2& at(Corners p, int i) { return p[static_cast<std::size_t>(i)]; }

bool is_between(glm::dvec2 a, glm::dvec2 b, glm::dvec2 p) {
  return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

bool in_triangle(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 p) {
  return orientation(a, b, p) >= 0 && orientation(b, c, p) >= 0 && orientation(c, a, p) >= 0;
}

bool is_ear(Corners p, const std::vector<int>& ring, std::size_t k) {
  const std::size_t n = ring.size();
  const glm::dvec2 a = at(p, ring[(k + n - 1) % n]);
  const glm::dvec2 b = at(p, ring[k]);
  const glm::dvec2 c = at(p, ring[(k + 1) % n]);
  if (orientation(a, b, c) <= 0) return false;
  return std::none_of(ring.begin(), ring.end(), [&](int i) {
    const glm::dvec2 q = at(p, i);
    return q != a && q != b && q != c && in_triangle(a, b, c, q);
  });
}

// The ear with the largest smallest side of its turn keeps slivers away; without any ear (collinear corners
// only) the flattest corner goes.
std::size_t best_ear(Corners p, const std::vector<int>& ring) {
  const std::size_t n = ring.size();
  std::size_t best = n;
  double best_quality = -1;
  std::size_t flattest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < n; ++k) {
    const glm::dvec2 a = at(p, ring[(k + n - 1) % n]);
    const glm::dvec2 b = at(p, ring[k]);
    const glm::dvec2 c = at(p, ring[(k + 1) % n]);
    const double turn = cross(b - a, c - b);
    if (std::abs(turn) < least) {
      least = std::abs(turn);
      flattest = k;
    }
    const double quality = turn / (glm::dot(b - a, b - a) + glm::dot(c - b, c - b) + glm::dot(a - c, a - c));
    if (quality > best_quality && is_ear(p, ring, k)) {
      best = k;
      best_quality = quality;
    }
  }
  return best < n ? best : flattest;
}

// Joins part b into part a when they share a side and the union is convex.
bool merge_parts(Corners p, std::vector<int>& a, const std::vector<int>& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) {
      if (a[i] != b[(j + 1) % b.size()] || a[(i + 1) % a.size()] != b[j]) continue;
      std::vector<int> merged;
      for (std::size_t k = 1; k <= a.size(); ++k) merged.push_back(a[(i + k) % a.size()]);
      for (std::size_t k = 2; k < b.size(); ++k) merged.push_back(b[(j + k) % b.size()]);
      std::vector<glm::dvec2> corners;
      for (const int c : merged) corners.push_back(at(p, c));
      if (!is_convex(corners)) return false;
      a = std::move(merged);
      return true;
    }
  return false;
}

}  // namespace

bool segments_meet(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 d) {
  const int o1 = orientation(a, b, c);
  const int o2 = orientation(a, b, d);
  const int o3 = orientation(c, d, a);
  const int o4 = orientation(c, d, b);
  if (o1 * o2 < 0 && o3 * o4 < 0) return true;
  return (o1 == 0 && is_between(a, b, c)) || (o2 == 0 && is_between(a, b, d)) ||
         (o3 == 0 && is_between(c, d, a)) || (o4 == 0 && is_between(c, d, b));
}

double signed_area(std::span<const glm::dvec2> polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    twice += cross(polygon[i] - polygon[0], polygon[(i + 1) % polygon.size()] - polygon[0]);
  return twice / 2;
}

bool is_convex(std::span<const glm::dvec2> polygon) {
  const std::size_t n = polygon.size();
  double turned = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec2 a = polygon[i];
    const glm::dvec2 b = polygon[(i + 1) % n];
    const glm::dvec2 c = polygon[(i + 2) % n];
    if (orientation(a, b, c) < 0) return false;
    turned += std::atan2(cross(b - a, c - b), glm::dot(b - a, c - b));
  }
  return turned < 7;  // one full turn is 6.28, two are 12.57
}

bool is_simple(std::span<const glm::dvec2> polygon) {
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec2 a = polygon[i];
    const glm::dvec2 b = polygon[(i + 1) % n];
    const glm::dvec2 c = polygon[(i + 2) % n];
    if (orientation(a, b, c) == 0 && glm::dot(b - a, c - b) <= 0) return false;
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      if (segments_meet(a, b, polygon[j], polygon[(j + 1) % n])) return false;
    }
  }
  return n >= 3;
}

bool contains(std::span<const glm::dvec2> polygon, glm::dvec2 point) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const glm::dvec2 a = polygon[i];
    const glm::dvec2 b = polygon[j];
    if ((a.y > point.y) != (b.y > point.y) && point.x < (b.x - a.x) * (point.y - a.y) / (b.y - a.y) + a.x)
      inside = !inside;
  }
  return inside;
}

std::vector<std::array<int, 3>> triangulate(std::span<const glm::dvec2> polygon) {
  std::vector<int> ring(polygon.size());
  for (std::size_t i = 0; i < ring.size(); ++i) ring[i] = static_cast<int>(i);
  std::vector<std::array<int, 3>> triangles;
  while (ring.size() > 3) {
    const std::size_t k = best_ear(polygon, ring);
    const std::size_t n = ring.size();
    triangles.push_back({ring[(k + n - 1) % n], ring[k], ring[(k + 1) % n]});
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(k));
  }
  if (ring.size() == 3) triangles.push_back({ring[0], ring[1], ring[2]});
  return triangles;
}

std::vector<std::vector<int>> convex_parts(std::span<const glm::dvec2> polygon) {
  std::vector<std::vector<int>> parts;
  if (is_convex(polygon)) {
    parts.emplace_back();
    for (std::size_t i = 0; i < polygon.size(); ++i) parts.back().push_back(static_cast<int>(i));
    return parts;
  }
  for (const auto& t : triangulate(polygon))
    if (orientation(at(polygon, t[0]), at(polygon, t[1]), at(polygon, t[2])) > 0)
      parts.push_back({t[0], t[1], t[2]});
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (std::size_t j = i + 1; j < parts.size();) {
      if (merge_parts(polygon, parts[i], parts[j])) {
        parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(j));
        j = i + 1;
      } else {
        ++j;
      }
    }
  }
  return parts;
}

}  // namespace netwright
