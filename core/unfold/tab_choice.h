// Which tab every cut gets, so that as many as possible get a good one: a weighted choice of one option per
// cut of which no two may collide. Used by place_tabs only.
#pragma once

#include <vector>

#include "core/unfold/tab_shapes.h"

namespace netwright {

/// One way to give a cut its tab.
struct TabOption {
  HalfedgeId side;
  TabShape shape;
  double value = 0;  ///< above 0; having a tab at all outweighs how good it is
};

/// One entry per cut (per side, where a cut gets two): the index of its option, -1 for none. Begins with the
/// best options and then trades: a cut takes an option, the cuts it collides with look for others, and so on
/// over a few steps; kept where the sum of values grows, until nothing does. The same input gives the same
/// choice.
std::vector<int> choose_tabs(const std::vector<std::vector<TabOption>>& cuts);

}  // namespace netwright
