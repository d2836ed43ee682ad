// Rigid motions, boxes and the random numbers everything else leans on.
#include "core/base/geometry.h"

#include <gtest/gtest.h>

#include "core/base/random.h"

namespace netwright {
namespace {

Rigid2 random_motion(Random& random) {
  Rigid2 m = Rigid2::rotation(6.28 * random.unit());
  m.x = random.unit() * 10 - 5;
  m.y = random.unit() * 10 - 5;
  return m;
}

TEST(Rigid2, ComposesAsApplyingOneAfterTheOther) {
  Random random(1);
  for (int k = 0; k < 100; ++k) {
    const Rigid2 a = random_motion(random);
    const Rigid2 b = random_motion(random);
    const glm::dvec2 p(random.unit(), random.unit());
    EXPECT_LT(glm::distance((a * b)(p), a(b(p))), 1e-13);
    EXPECT_LT(glm::distance(a.inverse()(a(p)), p), 1e-13);
  }
}

TEST(Rigid2, StaysRigidOverLongChains) {
  Random random(2);
  Rigid2 chain;
  for (int k = 0; k < 100000; ++k) chain = chain * Rigid2::rotation(random.unit());
  EXPECT_NEAR(chain.cos * chain.cos + chain.sin * chain.sin, 1, 1e-15);
}

TEST(Box, GrowsAroundWhatIsAdded) {
  Box2 box;
  EXPECT_TRUE(box.is_empty());
  EXPECT_EQ(box.size(), glm::dvec2(0));
  box.add({1, 5});
  box.add({-1, 2});
  EXPECT_EQ(box.size(), glm::dvec2(2, 3));
  EXPECT_EQ(box.centre(), glm::dvec2(0, 3.5));
}

TEST(Random, RepeatsForOneSeedAndDiffersBetweenStreams) {
  Random a(7, 1);
  Random b(7, 1);
  Random c(7, 2);
  bool differs = false;
  for (int k = 0; k < 50; ++k) {
    const auto bits = a.bits();
    EXPECT_EQ(bits, b.bits());
    differs = differs || bits != c.bits();
  }
  EXPECT_TRUE(differs);
}

TEST(Random, FillsItsRangesEvenly) {
  Random random(5);
  std::vector<int> hits(10, 0);
  for (int k = 0; k < 100000; ++k) {
    const int i = random.below(10);
    ASSERT_GE(i, 0);
    ASSERT_LT(i, 10);
    ++hits[static_cast<std::size_t>(i)];
    const double u = random.unit();
    ASSERT_GE(u, 0);
    ASSERT_LT(u, 1);
  }
  for (const int n : hits) EXPECT_NEAR(n, 10000, 500);
}

}  // namespace
}  // namespace netwright
