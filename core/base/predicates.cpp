// The exact orientation test: a fast determinant with an error bound, and an exact sum of products behind it.
#include "core/base/predicates.h"

#include <array>
#include <cmath>
#include <limits>

namespace netwright {

namespace {

// Adds b exactly to the expansion e (components of increasing size, not overlapping): Shewchuk's
// GROW-EXPANSION.
template <std::size_t N>
void grow(std::array<double, N>& e, std::size_t& n, double b) {
  double q = b;
  for (std::size_t i = 0; i < n; ++i) {
    const double sum = q + e[i];
    const double virt = sum - q;
    const double error = (q - (sum - virt)) + (e[i] - virt);
    e[i] = error;
    q = sum;
  }
  e[n++] = q;
}

int exact_orientation(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
  // ax by − ay bx + bx cy − by cx + cx ay − cy ax; every product as high + low part without error.
  const std::array<std::array<double, 2>, 6> factors = {
      {{a.x, b.y}, {-a.y, b.x}, {b.x, c.y}, {-b.y, c.x}, {c.x, a.y}, {-c.y, a.x}}};
  std::array<double, 12> sum{};
  std::size_t n = 0;
  for (const auto& f : factors) {
    const double high = f[0] * f[1];
    grow(sum, n, std::fma(f[0], f[1], -high));
    grow(sum, n, high);
  }
  for (std::size_t i = n; i-- > 0;)
    if (sum[i] != 0) return sum[i] > 0 ? 1 : -1;
  return 0;
}

}  // namespace

int orientation(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double det = left - right;
  constexpr double kUnit = std::numeric_limits<double>::epsilon() / 2;
  const double bound = (3 + 16 * kUnit) * kUnit * (std::abs(left) + std::abs(right));
  if (det > bound) return 1;
  if (det < -bound) return -1;
  return exact_orientation(a, b, c);
}

}  // namespace netwright
