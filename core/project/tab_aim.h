// Glue tabs as an aim of the search: what settings of tabs, paper and size ask of it.
#pragma once

#include <optional>

#include "core/base/paper.h"
#include "core/sheet/pages.h"
#include "core/solve/solve.h"

namespace netwright {

/// Nothing unless tabs are on and wanted in the search. The scale is the one at which each net would be
/// printed.
std::optional<TabAim> tab_aim(const PaperSetup& paper, const PrintSize& size, const TabSettings& tabs);

}  // namespace netwright
