// The quadric error of a point: a sum of squared distances from planes, kept as ten numbers. Only
// simplify*.cpp include it.
#pragma once

#include <array>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace netwright::simplify {

/// x -> x·A x + 2 b·x + c with A symmetric.
struct Quadric {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
  glm::dvec3 b{0};
  double c = 0;

  /// weight · (squared distance from the plane through p with this unit normal).
  static Quadric plane(const glm::dvec3& normal, const glm::dvec3& p, double weight) {
    const double d = -glm::dot(normal, p);
    const glm::dvec3 n = normal * weight;
    return {n.x * normal.x, n.x * normal.y, n.x * normal.z, n.y * normal.y,
            n.y * normal.z, n.z * normal.z, n * d,          weight * d * d};
  }
  /// weight · (squared distance from the point p).
  static Quadric point(const glm::dvec3& p, double weight) {
    return {weight, 0, 0, weight, 0, weight, -weight * p, weight * glm::dot(p, p)};
  }

  Quadric& operator+=(const Quadric& q) {
    xx += q.xx;
    xy += q.xy;
    xz += q.xz;
    yy += q.yy;
    yz += q.yz;
    zz += q.zz;
    b += q.b;
    c += q.c;
    return *this;
  }

  [[nodiscard]] glm::dvec3 times(const glm::dvec3& p) const {
    return {xx * p.x + xy * p.y + xz * p.z, xy * p.x + yy * p.y + yz * p.z, xz * p.x + yz * p.y + zz * p.z};
  }
  [[nodiscard]] double operator()(const glm::dvec3& p) const { return glm::dot(p, times(p) + 2.0 * b) + c; }

  /// The point of least error; false when the planes leave it undecided (A is singular, or nearly).
  [[nodiscard]] bool minimise(glm::dvec3& best) const {
    const glm::dvec3 r0(xx, xy, xz);
    const glm::dvec3 r1(xy, yy, yz);
    const glm::dvec3 r2(xz, yz, zz);
    const glm::dvec3 c12 = glm::cross(r1, r2);
    const double determinant = glm::dot(r0, c12);
    const double trace = xx + yy + zz;
    if (!(determinant > 1e-14 * trace * trace * trace)) return false;
    best = -(c12 * b.x + glm::cross(r2, r0) * b.y + glm::cross(r0, r1) * b.z) / determinant;
    return true;
  }
};

}  // namespace netwright::simplify
