// Loose strips of paper for the cuts that have no room for a glue tab: folded along the middle and glued
// under both sides. They lie in free spots of the sheets, with the number of their cut. Used by draw_sheets
// only.
#pragma once

#include <vector>

#include "core/sheet/free_spots.h"

namespace netwright {

struct LooseStrip {
  double length_mm = 0;
  double width_mm = 0;  ///< of each half
  int number = 0;       ///< of the cut, 0 where it has none
};

/// One for each cut without a tab, the longest first. Cuts under 3 mm get none: nobody can glue them.
std::vector<LooseStrip> loose_strips(const Net& net, const PageLayout& layout, const SheetSettings& settings,
                                     const PlacedLabels& labels);

/// Draws those that find room and takes them off the list.
void draw_loose_strips(Sheet& sheet, FreeSpots& spots, const LineStyles& styles, const Font& font,
                       std::vector<LooseStrip>& strips);

}  // namespace netwright
