// The size that makes the most of the paper: as large as fits on one page, or on so many.
#pragma once

#include <vector>

#include "core/sheet/pages.h"

namespace netwright {

/// As large as a search finds on at most so many pages, on the frame that prints larger; on one page nothing
/// is tiled. Throws Error(Usage) when there are too many parts for one page.
PageLayout fit_pages(const Net& net, const std::vector<PageFrame>& frames, int n_pages,
                     const TabSettings& tabs);

}  // namespace netwright
