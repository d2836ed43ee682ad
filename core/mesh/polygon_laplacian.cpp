// Everything here is at most rank two away from the identity or from zero, so no basis of the kernel is ever
// made: projections come from two orthonormal vectors, which stay exact for long thin faces too.
#include "core/mesh/polygon_laplacian.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace netwright {
namespace {

using Values = std::vector<double>;

double dot(const Values& a, const Values& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// Takes the part along the (unit) direction out; twice, since once leaves rounding of the size of what went.
void take_out(Values& values, const Values& direction) {
  for (int pass = 0; pass < 2; ++pass) {
    const double along = dot(values, direction);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] -= along * direction[i];
  }
}

/// Makes the vectors orthonormal in their order; those without a direction of their own become 0.
void orthonormalize(std::span<Values> vectors) {
  for (std::size_t k = 0; k < vectors.size(); ++k) {
    for (std::size_t j = 0; j < k; ++j) take_out(vectors[k], vectors[j]);
    const double length = std::sqrt(dot(vectors[k], vectors[k]));
    for (double& value : vectors[k]) value = length > 0 ? value / length : 0;
  }
}

/// The identity without what lies along these orthonormal vectors.
CornerMatrix identity_without(std::size_t n, std::span<const Values> vectors) {
  CornerMatrix matrix(n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      matrix(i, j) = i == j ? 1 : 0;
      for (const Values& v : vectors) matrix(i, j) -= v[i] * v[j];
    }
  }
  return matrix;
}

/// dᵀ M d: from functions of the sides to functions of the corners.
CornerMatrix on_corners(const CornerMatrix& sides) {
  const std::size_t n = sides.size();
  CornerMatrix matrix(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t before_i = (i + n - 1) % n;
    for (std::size_t j = 0; j < n; ++j) {
      const std::size_t before_j = (j + n - 1) % n;
      matrix(i, j) = sides(before_i, before_j) - sides(before_i, j) - sides(i, before_j) + sides(i, j);
    }
  }
  return matrix;
}

/// The frame's longest direction first, so that a thin face's short one keeps its digits.
std::array<glm::dvec3, 2> plane_axes(std::span<const glm::dvec3> corners, const PolygonFrame& frame) {
  glm::dvec3 longest(0);
  for (const glm::dvec3& corner : corners) {
    const glm::dvec3 arm =
        corner - frame.centre - frame.normal * glm::dot(corner - frame.centre, frame.normal);
    if (glm::dot(arm, arm) > glm::dot(longest, longest)) longest = arm;
  }
  const double length = glm::length(longest);
  const glm::dvec3 x = length > 0 ? longest / length : glm::dvec3(0);
  return {x, glm::cross(frame.normal, x)};
}

}  // namespace

double PolygonFrame::unevenness() const {
  if (height.size() == 3 || size <= 0) return 0;
  double off = 0;
  for (const double h : height) off = std::max(off, std::abs(h));
  return off / size;
}

glm::dvec3 vector_area(std::span<const glm::dvec3> corners) {
  glm::dvec3 area(0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    area += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]) * 0.5;
  }
  return area;
}

PolygonFrame frame_of(std::span<const glm::dvec3> corners) {
  PolygonFrame frame;
  const glm::dvec3 area = vector_area(corners);
  frame.area = glm::length(area);
  if (frame.area > 0) frame.normal = area / frame.area;
  for (const glm::dvec3& corner : corners) frame.centre += corner / static_cast<double>(corners.size());
  const auto [x, y] = plane_axes(corners, frame);
  for (const glm::dvec3& corner : corners) {
    const glm::dvec3 arm = corner - frame.centre;
    frame.flat.emplace_back(glm::dot(arm, x), glm::dot(arm, y));
    frame.height.push_back(glm::dot(arm, frame.normal));
    for (const glm::dvec3& other : corners) frame.size = std::max(frame.size, glm::length(corner - other));
  }
  return frame;
}

CornerMatrix completion(const PolygonFrame& frame) {
  const std::size_t n = frame.flat.size();
  std::array<Values, 2> sides{Values(n), Values(n)};
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec2 side = frame.flat[(i + 1) % n] - frame.flat[i];
    sides[0][i] = side.x;
    sides[1][i] = side.y;
  }
  orthonormalize(sides);
  return identity_without(n, sides);
}

CornerMatrix off_plane_energy(const PolygonFrame& frame) { return on_corners(completion(frame)); }

CornerMatrix height_residue(const PolygonFrame& frame) {
  const std::size_t n = frame.flat.size();
  std::array<Values, 3> affine{Values(n, 1.0), Values(n), Values(n)};
  for (std::size_t i = 0; i < n; ++i) {
    affine[1][i] = frame.flat[i].x;
    affine[2][i] = frame.flat[i].y;
  }
  orthonormalize(affine);
  return identity_without(n, affine);
}

CornerMatrix polygon_laplacian(std::span<const glm::dvec3> corners, double lambda) {
  const PolygonFrame frame = frame_of(corners);
  const std::size_t n = corners.size();
  CornerMatrix sides = completion(frame);
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec3 middle = (corners[i] + corners[(i + 1) % n]) * 0.5 - frame.centre;
    for (std::size_t j = 0; j < n; ++j) {
      const glm::dvec3 other = (corners[j] + corners[(j + 1) % n]) * 0.5 - frame.centre;
      sides(i, j) = lambda * sides(i, j) + glm::dot(middle, other) / frame.area;
    }
  }
  return on_corners(sides);
}

}  // namespace netwright
