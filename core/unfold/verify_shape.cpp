// Proof, part one: the prepared copy of the net, and whether every face has the shape it has on the model,
// printed side up.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/geometry.h"
#include "core/base/predicates.h"
#include "core/unfold/verify_checks.h"

namespace netwright::proof {
namespace {

/// A face is congruent to its place on the model when no corner distance is off by more than this share of
/// its longest side: far above what 17 digits lose, far below what a pair of scissors can tell.
constexpr double kCongruence = 1e-6;

/// A hair more than kFlatness, so that a face at that limit is not refused for the last digit of another
/// way to find its plane.
constexpr double kUneven = 1.1 * kFlatness;

template <class Vec>
double largest_coordinate(const std::vector<Vec>& points) {
  double largest = 0;
  for (const Vec& p : points) {
    for (int i = 0; i < Vec::length(); ++i) largest = std::max(largest, std::abs(p[i]));
  }
  return largest;
}

/// Multiplies by the power of two that brings the largest coordinate into [1/2, 1).
template <class Vec>
std::vector<Vec> normalised(const std::vector<Vec>& points) {
  int exponent = 0;
  static_cast<void>(std::frexp(largest_coordinate(points), &exponent));
  std::vector<Vec> result = points;
  for (Vec& p : result) {
    for (int i = 0; i < Vec::length(); ++i) p[i] = std::ldexp(p[i], -exponent);
  }
  return result;
}

/// Points of no face must not decide the scale: they go to the first corner of all.
template <class Vec>
std::vector<Vec> used_only(const FlatNet& net, std::vector<Vec> points) {
  std::vector<char> is_used(points.size(), 0);
  for (const std::vector<int>& face : net.faces) {
    for (const int corner : face) is_used[static_cast<std::size_t>(corner)] = 1;
  }
  const Vec spare = points[static_cast<std::size_t>(net.faces.front().front())];
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (is_used[i] == 0) points[i] = spare;
  }
  return points;
}

std::vector<int> number_places(const std::vector<glm::dvec3>& folded) {
  std::vector<int> order(folded.size());
  std::iota(order.begin(), order.end(), 0);
  const auto at = [&](int i) -> const glm::dvec3& { return folded[static_cast<std::size_t>(i)]; };
  const auto compare = [&](int a, int b) {
    if (at(a).x != at(b).x) return at(a).x < at(b).x;
    if (at(a).y != at(b).y) return at(a).y < at(b).y;
    return at(a).z < at(b).z;
  };
  std::sort(order.begin(), order.end(), compare);
  std::vector<int> place(folded.size());
  int number = -1;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i == 0 || compare(order[i - 1], order[i])) ++number;
    place[static_cast<std::size_t>(order[i])] = number;
  }
  return place;
}

std::vector<glm::dvec2> corners_of(const Subject& s, std::size_t face) {
  std::vector<glm::dvec2> corners;
  for (const int c : s.net.faces[face]) corners.push_back(s.points[static_cast<std::size_t>(c)]);
  return corners;
}

double longest_side(const std::vector<glm::dvec2>& corners) {
  double longest = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec2 side = corners[(i + 1) % corners.size()] - corners[i];
    longest = std::max(longest, std::hypot(side.x, side.y));
  }
  return longest;
}

/// Twice the area in units of the longest side squared: sign = direction, size = how far from degenerate.
double relative_area(const std::vector<glm::dvec2>& corners) {
  const double longest = longest_side(corners);
  if (!(longest > 0)) return 0;
  double sum = 0;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    sum += cross((corners[i] - corners[0]) / longest, (corners[i + 1] - corners[0]) / longest);
  }
  return sum;
}

/// The mean of all sides, rounded down by more than the sum can have been rounded up.
double mean_edge_lower(const Subject& s) {
  double sum = 0;
  double count = 0;
  for (std::size_t f = 0; f < s.net.faces.size(); ++f) {
    const std::vector<glm::dvec2> corners = corners_of(s, f);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const glm::dvec2 side = corners[(i + 1) % corners.size()] - corners[i];
      sum += std::hypot(side.x, side.y);
    }
    count += static_cast<double>(corners.size());
  }
  return sum / count * (1 - (count + 16) * 0x1p-52);
}

struct FaceInSpace {
  std::vector<glm::dvec3> corners;
  std::vector<double> height;  ///< of each corner over the best plane
  double size = 0;             ///< longest side
};

FaceInSpace in_space(const Subject& s, std::size_t face) {
  FaceInSpace result;
  for (const int c : s.net.faces[face]) result.corners.push_back(s.folded[static_cast<std::size_t>(c)]);
  const std::size_t n = result.corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec3 side = result.corners[(i + 1) % n] - result.corners[i];
    result.size = std::max(result.size, std::hypot(side.x, side.y, side.z));
  }
  result.height.assign(n, 0);
  if (n == 3 || !(result.size > 0)) return result;
  glm::dvec3 normal(0);
  glm::dvec3 centre(0);
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec3 a = (result.corners[i] - result.corners[0]) / result.size;
    const glm::dvec3 b = (result.corners[(i + 1) % n] - result.corners[0]) / result.size;
    normal += glm::cross(a, b);
    centre += a / static_cast<double>(n);
  }
  normal = glm::normalize(normal);
  for (std::size_t i = 0; i < n; ++i) {
    result.height[i] =
        result.size * glm::dot(normal, (result.corners[i] - result.corners[0]) / result.size - centre);
  }
  return result;
}

/// Net units per model unit: the middle one of all faces' own scales, so that a few distorted faces are
/// blamed themselves instead of shifting it for all.
double common_scale(const Subject& s) {
  std::vector<double> scales;
  for (std::size_t f = 0; f < s.net.faces.size(); ++f) {
    double flat = 0;
    double space = 0;
    const std::vector<int>& face = s.net.faces[f];
    for (std::size_t i = 0; i < face.size(); ++i) {
      const auto a = static_cast<std::size_t>(face[i]);
      const auto b = static_cast<std::size_t>(face[(i + 1) % face.size()]);
      const glm::dvec2 p = s.points[b] - s.points[a];
      const glm::dvec3 q = s.folded[b] - s.folded[a];
      flat += std::hypot(p.x, p.y);
      space += std::hypot(q.x, q.y, q.z);
    }
    if (space > 0) scales.push_back(flat / space);
  }
  if (scales.empty()) return 0;
  const auto middle = scales.begin() + static_cast<std::ptrdiff_t>(scales.size() / 2);
  std::nth_element(scales.begin(), middle, scales.end());
  return *middle;
}

/// Largest deviation of a corner distance, as a share of the longest side. A face that is not perfectly flat
/// is laid out by projection to its plane, so every length between the true one and the projected one is
/// right.
double deviation(const std::vector<glm::dvec2>& flat, const FaceInSpace& space, double scale) {
  const double size = longest_side(flat);
  double worst = 0;
  for (std::size_t i = 0; i < flat.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const glm::dvec2 p = flat[i] - flat[j];
      const glm::dvec3 q = space.corners[i] - space.corners[j];
      const double length = std::hypot(q.x, q.y, q.z);
      const double rise = std::min(std::abs(space.height[i] - space.height[j]), length);
      const double projected = std::sqrt((length - rise) * (length + rise));
      const double found = std::hypot(p.x, p.y);
      worst = std::max({worst, (found - scale * length) / size, (scale * projected - found) / size});
    }
  }
  return worst;
}

bool is_flat(const FaceInSpace& face) {
  return std::all_of(face.height.begin(), face.height.end(),
                     [&](double h) { return std::abs(h) <= kUneven * face.size; });
}

}  // namespace

bool measure(Subject& s, Faults& faults) {
  s.points = normalised(used_only(s.net, s.net.points));
  s.folded = normalised(used_only(s.net, s.net.folded));
  s.place = number_places(s.folded);
  s.mean_edge = mean_edge_lower(s);
  std::vector<int> degenerate;
  for (std::size_t f = 0; f < s.net.faces.size(); ++f) {
    const double area = relative_area(corners_of(s, f));
    s.turn.push_back(area < 0 ? -1 : 1);
    if (!(std::abs(area) >= kDegenerateHeight)) degenerate.push_back(static_cast<int>(f));
  }
  if (degenerate.empty()) return true;
  faults.push_back(about_faces(s.net, degenerate, "has no area", "have no area") + ".");
  return false;
}

double check_congruence(const Subject& s, Faults& faults) {
  const double scale = common_scale(s);
  double worst = 0;
  std::vector<int> distorted;
  std::vector<int> uneven;
  for (std::size_t f = 0; f < s.net.faces.size(); ++f) {
    const FaceInSpace space = in_space(s, f);
    const double off = deviation(corners_of(s, f), space, scale);
    worst = std::max(worst, off);
    if (!(off <= kCongruence)) distorted.push_back(static_cast<int>(f));
    if (!is_flat(space)) uneven.push_back(static_cast<int>(f));
  }
  if (!distorted.empty()) {
    faults.push_back(about_faces(s.net, distorted, "does", "do") +
                     " not have the shape and size of the model's face.");
  }
  if (!uneven.empty()) faults.push_back(about_faces(s.net, uneven, "is", "are") + " not flat on the model.");
  return worst;
}

}  // namespace netwright::proof
