// Means, outliers and percentiles, against figures worked out by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "app/cli_bench_stats.h"

namespace netwright {
namespace {

std::vector<double> counted_to(int n) {
  std::vector<double> values(static_cast<std::size_t>(n));
  std::iota(values.begin(), values.end(), 1.0);
  return values;
}

TEST(BenchStats, AreZeroWithoutValues) {
  const BenchStats stats = bench_stats({});
  EXPECT_EQ(stats.n, 0);
  EXPECT_EQ(stats.mean, 0);
  EXPECT_EQ(stats.max, 0);
}

TEST(BenchStats, OfOneValueAreThatValue) {
  const BenchStats stats = bench_stats({0.1});
  EXPECT_EQ(stats.n, 1);
  for (const double figure :
       {stats.min, stats.mean, stats.filtered_mean, stats.median, stats.p95, stats.p99, stats.max}) {
    EXPECT_EQ(figure, 0.1);
  }
}

TEST(BenchStats, DoNotDependOnTheOrder) {
  const BenchStats stats = bench_stats({3, 1, 2, 10});
  EXPECT_EQ(stats.n, 4);
  EXPECT_EQ(stats.min, 1);
  EXPECT_EQ(stats.mean, 4);
  EXPECT_EQ(stats.median, 2.5);
  EXPECT_EQ(stats.max, 10);
  EXPECT_EQ(bench_stats({7, 1, 3}).median, 3);
}

TEST(BenchStats, TakePercentilesByNearestRank) {
  const std::vector<double> twenty = counted_to(20);
  EXPECT_EQ(nearest_rank(twenty, 95), 19);
  EXPECT_EQ(nearest_rank(twenty, 95.1), 20);
  EXPECT_EQ(nearest_rank(twenty, 99), 20);
  EXPECT_EQ(nearest_rank(twenty, 5), 1);
  EXPECT_EQ(nearest_rank(twenty, 0.1), 1);
  EXPECT_EQ(nearest_rank(twenty, 100), 20);
  const BenchStats stats = bench_stats(counted_to(200));
  EXPECT_EQ(stats.p95, 190);
  EXPECT_EQ(stats.p99, 198);
}

TEST(BenchStats, LeaveOutliersOutOfTheFilteredMeanAlone) {
  // 20 values 1 and one 100: mean 5.71, deviation 21.08, so the limit is 68.96.
  std::vector<double> values(20, 1.0);
  values.push_back(100);
  const BenchStats stats = bench_stats(values);
  EXPECT_DOUBLE_EQ(stats.mean, 120.0 / 21);
  EXPECT_EQ(stats.filtered_mean, 1);
  EXPECT_EQ(stats.max, 100);
  EXPECT_EQ(stats.n, 21);
}

TEST(BenchStats, KeepValuesBelowTheLimit) {
  // Eight values 1 and one 100: mean 12, deviation 31.1, so the limit is 105.3.
  std::vector<double> values(8, 1.0);
  values.push_back(100);
  EXPECT_EQ(bench_stats(values).filtered_mean, 12);
  EXPECT_EQ(bench_stats(counted_to(9)).filtered_mean, 5);
}

TEST(BenchStats, CopeWithManyEqualValues) {
  const BenchStats stats = bench_stats(std::vector<double>(1000, 0.1));
  EXPECT_NEAR(stats.mean, 0.1, 1e-12);
  EXPECT_NEAR(stats.filtered_mean, 0.1, 1e-12);
}

TEST(PowerFit, FindsTheLawThatMadeThePoints) {
  const auto law =
      power_fit({100, 200, 400, 800}, {3e-4 * 1e3, 3e-4 * 2828.4271247, 3e-4 * 8e3, 3e-4 * 22627.416998});
  ASSERT_TRUE(law.has_value());
  EXPECT_NEAR(law->exponent, 1.5, 1e-9);
  EXPECT_NEAR(law->factor, 3e-4, 1e-12);
  EXPECT_NEAR(law->at(400), 2.4, 1e-8);
}

TEST(PowerFit, TakesTheLineNearestInLogarithms) {
  // Logarithms to the base 2: (0, 0), (1, 2), (2, 1); the nearest line is 0.5 + 0.5 x.
  const auto law = power_fit({1, 2, 4}, {1, 4, 2});
  ASSERT_TRUE(law.has_value());
  EXPECT_NEAR(law->exponent, 0.5, 1e-12);
  EXPECT_NEAR(law->factor, std::sqrt(2.0), 1e-12);
}

TEST(PowerFit, LeavesOutWhatHasNoLogarithm) {
  const auto law = power_fit({100, 200, 400}, {0, 7, 7});
  ASSERT_TRUE(law.has_value());
  EXPECT_NEAR(law->exponent, 0, 1e-12);
  EXPECT_FALSE(power_fit({}, {}).has_value());
  EXPECT_FALSE(power_fit({100, 200}, {0, 7}).has_value());
  EXPECT_FALSE(power_fit({100, 100}, {3, 7}).has_value());
}

TEST(ProportionalFit, GoesThroughTheOrigin) {
  EXPECT_DOUBLE_EQ(proportional_fit({1, 2, 3}, {2, 4, 6}), 2);
  EXPECT_DOUBLE_EQ(proportional_fit({1, 2}, {0, 5}), 2);
}

}  // namespace
}  // namespace netwright
