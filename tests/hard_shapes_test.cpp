// The search on shapes that are hard to unfold: those it solves in a moment stay solved, and on the one it
// does not solve it ends with the truth.
#include <gtest/gtest.h>

#include "core/solve/solve.h"
#include "tests/support.h"

namespace netwright {
namespace {

SolveResult solve_within(const PolygonSoup& soup, std::int64_t iterations) {
  SolveOptions options;
  options.streams = 1;
  options.max_iterations = iterations;
  Progress progress;
  return solve(testing::make_dual(soup), options, progress);
}

TEST(HardShapes, OfEveryFamilyAreUnfoldedInAMoment) {
  for (const PolygonSoup& soup : testing::hard_zoo()) {
    const SolveResult result = solve_within(soup, 20'000);
    EXPECT_TRUE(result.is_proved) << soup.name << ", " << soup.n_faces() << " faces";
    EXPECT_EQ(result.net.n_pieces, 1) << soup.name;
  }
}

TEST(HardShapes, ThatAreNotUnfoldedInTimeEndWithATreeAndItsOverlaps) {
  const SolveResult result = solve_within(testing::hardest_shape(), 3'000);
  EXPECT_TRUE(result.net.tree.is_forest(result.net.mesh()));
  EXPECT_EQ(result.net.n_pieces, 1);
  EXPECT_EQ(result.is_proved, result.overlaps.empty());
  EXPECT_EQ(result.is_proved, verify(to_flat_net(result.net, 1)).is_net);
}

}  // namespace
}  // namespace netwright
