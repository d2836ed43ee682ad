// Means, outliers, percentiles and fitted laws.
#include "app/cli_bench_stats.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace netwright {
namespace {

constexpr double kOutlierDeviations = 3;

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double standard_deviation(const std::vector<double>& values, double mean) {
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return std::sqrt(squares / static_cast<double>(values.size()));
}

}  // namespace

double PowerLaw::at(double x) const { return factor * std::pow(x, exponent); }

std::optional<PowerLaw> power_fit(const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<double> u;
  std::vector<double> v;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i] <= 0 || y[i] <= 0) continue;
    u.push_back(std::log(x[i]));
    v.push_back(std::log(y[i]));
  }
  if (u.empty() || std::all_of(u.begin(), u.end(), [&](double value) { return value == u.front(); }))
    return {};
  const double mean_u = mean_of(u);
  const double mean_v = mean_of(v);
  double products = 0;
  double squares = 0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    products += (u[i] - mean_u) * (v[i] - mean_v);
    squares += (u[i] - mean_u) * (u[i] - mean_u);
  }
  const double exponent = products / squares;
  return PowerLaw{std::exp(mean_v - exponent * mean_u), exponent};
}

double proportional_fit(const std::vector<double>& x, const std::vector<double>& y) {
  return std::inner_product(x.begin(), x.end(), y.begin(), 0.0) /
         std::inner_product(x.begin(), x.end(), x.begin(), 0.0);
}

double nearest_rank(const std::vector<double>& sorted, double percent) {
  // Multiplied before divided, so that 95 percent of 20 values are 19 and not a hair more.
  const double rank = std::ceil(percent * static_cast<double>(sorted.size()) / 100);
  const auto i = static_cast<std::size_t>(std::max(rank, 1.0)) - 1;
  return sorted[std::min(i, sorted.size() - 1)];
}

BenchStats bench_stats(std::vector<double> values) {
  BenchStats stats;
  if (values.empty()) return stats;
  std::sort(values.begin(), values.end());
  stats.n = static_cast<int>(values.size());
  stats.min = values.front();
  stats.max = values.back();
  stats.mean = mean_of(values);
  stats.median = (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
  stats.p95 = nearest_rank(values, 95);
  stats.p99 = nearest_rank(values, 99);
  const double limit = stats.mean + kOutlierDeviations * standard_deviation(values, stats.mean);
  const auto is_outlier = [limit](double value) { return value > limit; };
  // Of equal values, rounding may put the mean below them all.
  if (!is_outlier(values.front()))
    values.erase(std::find_if(values.begin(), values.end(), is_outlier), values.end());
  stats.filtered_mean = mean_of(values);
  return stats;
}

}  // namespace netwright
