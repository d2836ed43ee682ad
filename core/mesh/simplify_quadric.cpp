// Finds the point of least quadric error along the axes of the quadric, leaving out those along which it
// hardly changes (P. Lindstrom, Out-of-Core Simplification of Large Polygonal Models, 2000, does so by SVD).
#include "core/mesh/simplify_quadric.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace netwright::simplify {
namespace {

// Along an axis whose share of the largest eigenvalue is less than this the planes say nothing: a slope of
// one percent.
constexpr double kFlatAxis = 1e-4;

using Matrix = std::array<std::array<double, 3>, 3>;

// One Jacobi rotation that makes m[p][q] zero; v gathers the axes as its columns.
void rotate(Matrix& m, Matrix& v, std::size_t p, std::size_t q) {
  if (m[p][q] == 0) return;
  const double theta = (m[q][q] - m[p][p]) / (2 * m[p][q]);
  const double t = (theta >= 0 ? 1 : -1) / (std::abs(theta) + std::sqrt(theta * theta + 1));
  const double c = 1 / std::sqrt(t * t + 1);
  const double s = t * c;
  for (std::size_t k = 0; k < 3; ++k) {
    const double kp = m[k][p];
    const double kq = m[k][q];
    m[k][p] = c * kp - s * kq;
    m[k][q] = s * kp + c * kq;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const double pk = m[p][k];
    const double qk = m[q][k];
    m[p][k] = c * pk - s * qk;
    m[q][k] = s * pk + c * qk;
    const double vp = v[k][p];
    const double vq = v[k][q];
    v[k][p] = c * vp - s * vq;
    v[k][q] = s * vp + c * vq;
  }
}

}  // namespace

glm::dvec3 Quadric::minimise(const glm::dvec3& start) const {
  Matrix m{{{xx, xy, xz}, {xy, yy, yz}, {xz, yz, zz}}};
  Matrix v{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (int sweep = 0; sweep < 8; ++sweep) {
    const double off = std::abs(m[0][1]) + std::abs(m[0][2]) + std::abs(m[1][2]);
    if (off <= 1e-17 * (xx + yy + zz)) break;
    rotate(m, v, 0, 1);
    rotate(m, v, 0, 2);
    rotate(m, v, 1, 2);
  }
  const double largest = std::max({m[0][0], m[1][1], m[2][2]});
  const glm::dvec3 slope = times(start) + b;
  glm::dvec3 best = start;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(m[i][i] > kFlatAxis * largest)) continue;
    const glm::dvec3 axis(v[0][i], v[1][i], v[2][i]);
    best -= axis * (glm::dot(axis, slope) / m[i][i]);
  }
  return best;
}

}  // namespace netwright::simplify
