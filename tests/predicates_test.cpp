// The exact orientation test, where rounding would mislead a plain determinant.
#include "core/base/predicates.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"

namespace netwright {
namespace {

TEST(Orientation, TellsLeftFromRight) {
  EXPECT_EQ(orientation({0, 0}, {1, 0}, {0, 1}), 1);
  EXPECT_EQ(orientation({0, 0}, {0, 1}, {1, 0}), -1);
  EXPECT_EQ(orientation({0, 0}, {1, 1}, {3, 3}), 0);
}

TEST(Orientation, SeesTheLastBitOfACoordinate) {
  // Points on the line y = x, one moved by a single unit in the last place: a plain determinant rounds to
  // zero.
  const double x = 12.000000000000002;
  const double up = std::nextafter(x, 13);
  EXPECT_EQ(orientation({0.5, 0.5}, {24, 24}, {x, up}), 1);
  EXPECT_EQ(orientation({0.5, 0.5}, {24, 24}, {up, x}), -1);
  EXPECT_EQ(orientation({0.5, 0.5}, {24, 24}, {x, x}), 0);
}

TEST(Orientation, IsAntisymmetricAndCyclicOnNearlyCollinearPoints) {
  Random random(3);
  for (int k = 0; k < 2000; ++k) {
    const glm::dvec2 a(random.unit(), random.unit());
    const glm::dvec2 d(random.unit(), random.unit());
    const glm::dvec2 b = a + d * 0.37;
    const glm::dvec2 c = a + d * 1.91;
    const int o = orientation(a, b, c);
    EXPECT_EQ(orientation(b, c, a), o);
    EXPECT_EQ(orientation(c, a, b), o);
    EXPECT_EQ(orientation(b, a, c), -o);
  }
}

}  // namespace
}  // namespace netwright
