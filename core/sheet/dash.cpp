// Fitting dash patterns to lengths.
#include "core/sheet/dash.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/sheet/print_style.h"

namespace netwright {

std::vector<double> fit_dash(std::span<const double> pattern_mm, double length_mm) {
  if (pattern_mm.empty()) return {};
  const double period = std::accumulate(pattern_mm.begin(), pattern_mm.end(), 0.0);
  const double last_dash = pattern_mm.front();
  const double periods = std::max(1.0, std::round((length_mm - last_dash) / period));
  const double scale = length_mm / (periods * period + last_dash);
  if (!(scale >= print_style::kLeastDashScale)) return {};
  std::vector<double> fitted(pattern_mm.begin(), pattern_mm.end());
  for (double& part : fitted) part *= scale;
  return fitted;
}

}  // namespace netwright
