// The figures of many measured times, as plain arithmetic on a list of numbers.
#pragma once

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

/// The percentile by nearest rank: the smallest of the values such that at least `percent` percent (above 0,
/// up to 100) of them are no larger. Always one of the values; they must be sorted and not empty.
double nearest_rank(const std::vector<double>& sorted, double percent);

}  // namespace netwright
