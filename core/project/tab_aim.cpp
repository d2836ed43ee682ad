// The scale of a net is found as the pages find it.
#include "core/project/tab_aim.h"

namespace netwright {

std::optional<TabAim> tab_aim(const PaperSetup& paper, const PrintSize& size, const TabSettings& tabs) {
  if (!tabs.is_on || !tabs.in_search) return std::nullopt;
  return TabAim{tabs, [=](const Net& net) { return arrange(net, paper, size, tabs).scale; }};
}

}  // namespace netwright
