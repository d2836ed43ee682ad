// Rigid motions and boxes of the plane and space. Everything is in double precision; angles are radians.
#pragma once

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>

namespace netwright {

inline double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

/// A rotation followed by a shift of the plane: p -> R p + offset, with R given by (cos, sin).
struct Rigid2 {
  double cos = 1;
  double sin = 0;
  double x = 0;
  double y = 0;

  [[nodiscard]] glm::dvec2 rotate(glm::dvec2 p) const {
    return {cos * p.x - sin * p.y, sin * p.x + cos * p.y};
  }
  [[nodiscard]] glm::dvec2 operator()(glm::dvec2 p) const {
    return {cos * p.x - sin * p.y + x, sin * p.x + cos * p.y + y};
  }
  [[nodiscard]] Rigid2 inverse() const { return {cos, -sin, -(cos * x + sin * y), sin * x - cos * y}; }
  static Rigid2 rotation(double angle_rad) { return {std::cos(angle_rad), std::sin(angle_rad), 0, 0}; }
  bool operator==(const Rigid2&) const = default;
};

/// First b, then a. One Newton step keeps (cos, sin) on the unit circle, so long chains do not drift.
inline Rigid2 operator*(const Rigid2& a, const Rigid2& b) {
  double c = a.cos * b.cos - a.sin * b.sin;
  double s = a.sin * b.cos + a.cos * b.sin;
  const double k = 1.5 - 0.5 * (c * c + s * s);
  c *= k;
  s *= k;
  return {c, s, a.cos * b.x - a.sin * b.y + a.x, a.sin * b.x + a.cos * b.y + a.y};
}

template <class Vec>
struct Box {
  Vec min = Vec(std::numeric_limits<double>::infinity());
  Vec max = Vec(-std::numeric_limits<double>::infinity());

  void add(const Vec& p) {
    min = glm::min(min, p);
    max = glm::max(max, p);
  }
  void add(const Box& b) {
    min = glm::min(min, b.min);
    max = glm::max(max, b.max);
  }
  [[nodiscard]] bool is_empty() const { return !(min.x <= max.x); }
  [[nodiscard]] Vec size() const { return is_empty() ? Vec(0) : max - min; }
  [[nodiscard]] Vec centre() const { return is_empty() ? Vec(0) : (min + max) * 0.5; }
  [[nodiscard]] double diagonal() const { return glm::length(size()); }
};
using Box2 = Box<glm::dvec2>;
using Box3 = Box<glm::dvec3>;

}  // namespace netwright
