// The separating-axis test again, this time for the axis along which the way out is shortest.
#include "core/unfold/overlap_depth.h"

#include <algorithm>
#include <limits>

namespace netwright {
namespace {

std::vector<glm::dvec2> part_corners(const Net& net, FaceId f, int k) {
  std::vector<glm::dvec2> corners;
  for (const int c : net.dual->part(f, k))
    corners.push_back(net.corner(HalfedgeId(net.mesh().first(f).value + c)));
  return corners;
}

/// How far b reaches over the edge lines of a to the inner side, at the line where it is least.
double least_reach(const std::vector<glm::dvec2>& a, const std::vector<glm::dvec2>& b) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < a.size(); ++i) {
    const glm::dvec2 along = a[(i + 1) % a.size()] - a[i];
    const double length = glm::length(along);
    if (length == 0) continue;
    double reach = -std::numeric_limits<double>::infinity();
    for (const glm::dvec2& p : b) reach = std::max(reach, cross(along, p - a[i]) / length);
    least = std::min(least, reach);
  }
  return least;
}

}  // namespace

double overlap_depth(const Net& net, const Overlap& overlap) {
  double deepest = 0;
  for (int i = 0; i < net.dual->n_parts(overlap.first); ++i) {
    const auto a = part_corners(net, overlap.first, i);
    for (int j = 0; j < net.dual->n_parts(overlap.second); ++j) {
      const auto b = part_corners(net, overlap.second, j);
      deepest = std::max(deepest, std::min(least_reach(a, b), least_reach(b, a)));
    }
  }
  return deepest;
}

}  // namespace netwright
