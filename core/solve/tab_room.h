// Room for glue tabs as an aim of the search: cuts whose two sides have no room for even the narrowest tab.
#pragma once

#include <memory>

#include "core/solve/refine.h"
#include "core/unfold/tab_shapes.h"

namespace netwright {

/// Judges nets of one component printed at `scale` mm per model unit: the cost is the number of cuts that
/// place_tabs would have to call hopeless. Tabs of other cuts are not considered; place_tabs sees to them.
class TabRoom {
 public:
  TabRoom(const DualGraph& dual, const SearchModel& model, double scale, const TabSettings& settings);
  Judgement operator()(const SearchState& state) const;

 private:
  [[nodiscard]] glm::dvec2 corner(const SearchState& state, int h) const;

  const SearchModel* model_;
  double mm_per_length_;  ///< of the search's own unit, the mean edge
  TabWish wish_;
  std::vector<glm::dvec2> corners_;  ///< per halfedge: its corner in its face's frame, search's unit
  std::vector<int> next_;
};

}  // namespace netwright
