// What polish did not reach, in words that the window and the command line share.
#include "core/solve/aims.h"

#include <cmath>

#include "core/base/counted.h"

namespace netwright {

std::vector<std::string> unmet_wishes(const PolishReport& report, const PolishSettings& settings) {
  constexpr double kRootIsOff = 0.1;  // nearer is in the middle for whoever looks at it
  std::vector<std::string> unmet;
  if (settings.fits_paper > 0 && report.size_after > 1)
    unmet.push_back(std::to_string(std::lround(std::ceil(100 * (report.size_after - 1)))) +
                    " % too large for the page");
  if (settings.few_necks > 0 && report.necks_after > 0)
    unmet.push_back(counted(report.necks_after, "neck", "necks") + " under 3 mm");
  if (settings.root_in_middle > 0 && report.root_off > kRootIsOff)
    unmet.emplace_back("the root is off the middle");
  return unmet;
}

}  // namespace netwright
