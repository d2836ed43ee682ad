// The predicted difficulty against what the search really needs, over shapes of many kinds and sizes.
#include "core/mesh/difficulty.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/mesh/simplify.h"
#include "core/solve/solve.h"
#include "tests/support.h"

namespace netwright {
namespace {

/// Ranks from 0; equal values share the mean of theirs.
std::vector<double> ranks(const std::vector<double>& values) {
  std::vector<double> result;
  for (const double v : values) {
    const auto below = std::ranges::count_if(values, [&](double w) { return w < v; });
    const auto equal = std::ranges::count(values, v);
    result.push_back(static_cast<double>(below) + static_cast<double>(equal - 1) / 2);
  }
  return result;
}

double rank_correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const std::vector<double> ra = ranks(a);
  const std::vector<double> rb = ranks(b);
  const double mean = static_cast<double>(a.size() - 1) / 2;
  double ab = 0;
  double aa = 0;
  double bb = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ab += (ra[i] - mean) * (rb[i] - mean);
    aa += (ra[i] - mean) * (ra[i] - mean);
    bb += (rb[i] - mean) * (rb[i] - mean);
  }
  return ab / std::sqrt(aa * bb);
}

double moves_needed(const std::shared_ptr<const DualGraph>& dual) {
  double sum = 0;
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    Progress progress;
    const SolveOptions options{.seed = seed, .streams = 1, .threads = 1, .max_iterations = 2000};
    sum += static_cast<double>(solve(dual, options, progress).iterations);
  }
  return sum;
}

TEST(Difficulty, RanksShapesLikeTheSearchDoes) {
  std::vector<double> predicted;
  std::vector<double> needed;
  for (const PolygonSoup& soup :
       {shapes::icosphere(8), shapes::torus(36, 24), shapes::torus(40, 20, 2, 0.4), shapes::sand_clock(60),
        shapes::bumpy_patch(24, 24), shapes::globe(30, 40), testing::with_hats(shapes::icosphere(2)),
        shapes::combined(shapes::torus(16, 12), shapes::icosphere(6), {9, 0, 0})}) {
    Progress progress;
    const Simplifier simplifier(testing::make_mesh(soup), {}, progress);
    for (const int n : {50, 100, 200, 400, 700}) {
      if (n > simplifier.n_faces_max()) continue;
      const auto dual = testing::make_dual(simplifier.soup_at(n));
      predicted.push_back(predicted_difficulty(dual->mesh()));
      needed.push_back(moves_needed(dual));
    }
  }
  EXPECT_GE(predicted.size(), 30u);
  EXPECT_GE(rank_correlation(predicted, needed), 0.6);
}

TEST(Difficulty, DoesNotDependOnTheSize) {
  PolygonSoup torus = shapes::torus(20, 12);
  const double before = predicted_difficulty(Mesh(torus));
  for (glm::dvec3& p : torus.points) p *= 1000.0;
  EXPECT_NEAR(predicted_difficulty(Mesh(torus)), before, 1e-6 * before);
}

TEST(Difficulty, IsANumberForEveryShape) {
  for (const testing::ZooShape& shape : testing::zoo()) {
    const double difficulty = predicted_difficulty(Mesh(shape.soup));
    EXPECT_TRUE(std::isfinite(difficulty)) << shape.soup.name;
    EXPECT_GE(difficulty, 0) << shape.soup.name;
  }
}

TEST(Difficulty, SeesThatDentsAreHarderThanBumps) {
  const Mesh ball(shapes::icosphere(4));
  PolygonSoup dented = shapes::icosphere(4);
  for (std::size_t i = 0; i < dented.points.size(); i += 3) dented.points[i] *= 0.7;
  EXPECT_GT(predicted_difficulty(Mesh(dented)), 1.5 * predicted_difficulty(ball));
}

}  // namespace
}  // namespace netwright
