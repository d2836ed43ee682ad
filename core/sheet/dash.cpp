// Fitting dash patterns to lengths.
#include "core/sheet/dash.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/sheet/print_style.h"

namespace netwright {

std::vector<double> fit_dash(std::span<const double> pattern_mm, double length_mm) {
  std::vector<double> fitted(pattern_mm.begin(), pattern_mm.end());
  // Every second part is a gap also where the pattern has an odd number of them.
  if (fitted.size() % 2 == 1) fitted.insert(fitted.end(), pattern_mm.begin(), pattern_mm.end());
  const double period = std::accumulate(fitted.begin(), fitted.end(), 0.0);
  const bool has_sense = std::ranges::all_of(fitted, [](double part) { return part >= 0; });
  if (!has_sense || !(period > 0)) return {};
  const double last_dash = fitted.front();
  const double periods = std::max(1.0, std::round((length_mm - last_dash) / period));
  const double scale = length_mm / (periods * period + last_dash);
  if (!(scale >= print_style::kLeastDashScale)) return {};
  for (double& part : fitted) part *= scale;
  return fitted;
}

}  // namespace netwright
