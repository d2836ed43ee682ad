// The quadric error of a point: a sum of squared distances from planes, kept as ten numbers. Only
// simplify*.cpp include it.
#pragma once

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

  /// The point of least error; of all that the planes leave open, or nearly, the one nearest to `start`.
  [[nodiscard]] glm::dvec3 minimise(const glm::dvec3& start) const;
};

/// A sum of squared distances from points.
struct Spread {
  double weight = 0;
  glm::dvec3 moment{0};
  double square = 0;

  static Spread point(const glm::dvec3& p, double w) { return {w, w * p, w * glm::dot(p, p)}; }
  Spread& operator+=(const Spread& o) {
    weight += o.weight;
    moment += o.moment;
    square += o.square;
    return *this;
  }
  [[nodiscard]] double operator()(const glm::dvec3& p) const {
    return weight * glm::dot(p, p) - 2 * glm::dot(p, moment) + square;
  }
};

}  // namespace netwright::simplify
