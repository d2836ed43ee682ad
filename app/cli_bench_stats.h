// The figures of many measured times, as plain arithmetic on a list of numbers.
#pragma once

#include <optional>
#include <vector>

namespace netwright {

struct BenchStats {
  int n = 0;  ///< how many values there were; with none, all figures are 0
  double min = 0;
  double mean = 0;
  double filtered_mean = 0;  ///< without outliers, see below
  double median = 0;         ///< of an even number of values, half way between the middle two
  double p95 = 0;            ///< nearest rank, see below
  double p99 = 0;
  double max = 0;
};

/// The figures of these values, in any order. An outlier is a value above mean + 3 standard deviations
/// (section 5.1.1 of the paper), with the standard deviation of the values themselves: sum of squares over n.
BenchStats bench_stats(std::vector<double> values);

/// y = factor · x^exponent.
struct PowerLaw {
  double factor = 0;
  double exponent = 0;
  [[nodiscard]] double at(double x) const;
};

/// The law that comes nearest to the points, by least squares on the logarithms of both. Points with a number
/// that is not positive are left out; nothing when fewer than two different x are left.
std::optional<PowerLaw> power_fit(const std::vector<double>& x, const std::vector<double>& y);

/// c of the line y = c · x that comes nearest to the points, by least squares; some x must not be 0.
double proportional_fit(const std::vector<double>& x, const std::vector<double>& y);

/// The percentile by nearest rank: the smallest of the values such that at least `percent` percent (above 0,
/// up to 100) of them are no larger. Always one of the values; they must be sorted and not empty.
double nearest_rank(const std::vector<double>& sorted, double percent);

}  // namespace netwright
