// One empty page of paper: its size, its margins, and how it is shared out between title block, legend, ruler
// and net. In mm from the page's top left corner, y down.
#pragma once

#include <vector>

#include "core/base/geometry.h"
#include "core/base/paper.h"

namespace netwright {

/// What is reserved on a page; the strips never overlap.
struct PageFrame {
  double width_mm = 0;
  double height_mm = 0;
  Box2 printable;  ///< the paper without its margins; nothing is drawn outside
  Box2 header;     ///< title block
  Box2 footer;     ///< legend, and the ruler where the page is wide enough
  Box2 side;       ///< upright ruler on narrow pages, empty otherwise
  Box2 net;        ///< what is left for the net
  [[nodiscard]] bool is_landscape() const { return width_mm > height_mm; }
};

/// The page of a setup, Auto taken as upright where that has room. Throws Error(Usage): unknown paper,
/// margins that leave no room.
PageFrame page_frame(const PaperSetup& paper);

/// The pages a setup allows: one, or for Auto the upright and then the lying one (where there is room).
/// Throws as above.
std::vector<PageFrame> possible_frames(const PaperSetup& paper);

}  // namespace netwright
