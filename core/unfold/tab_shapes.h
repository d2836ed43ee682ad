// The shapes a glue tab may take on one side of a cut, given what else lies around it: trapezoids from the
// width and angles that are wished for down to what just holds glue. Used by place_tabs only.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/unfold/glue_tabs.h"

namespace netwright {

/// What a tab on some side should be like, in mm and radians.
struct TabWish {
  double width_mm = 5;
  double from_angle_rad = 0.78539816339744831;  ///< at the corner where the side begins
  double to_angle_rad = 0.78539816339744831;    ///< where it ends
};

/// One possible tab.
struct TabShape {
  std::array<glm::dvec2, 4> points{};  ///< counter-clockwise: side's end, its begin, the free rim
  int n_points = 4;                    ///< 3 for a triangle
  double width_mm = 0;
  double rim_share = 0;  ///< length of the free rim as a share of the side's
  bool lands_inside = true;

  [[nodiscard]] std::span<const glm::dvec2> polygon() const {
    return std::span(points).first(static_cast<std::size_t>(n_points));
  }
};

/// Sides of faces of one piece, in mm, found by place.
class SideGrid {
 public:
  struct Side {
    HalfedgeId h;
    glm::dvec2 from;
    glm::dvec2 to;
  };
  SideGrid(std::vector<Side> sides, double cell_mm);
  /// Indices of sides that may come into the box, sorted.
  [[nodiscard]] std::vector<int> near(const Box2& box) const;
  [[nodiscard]] const Side& side(int index) const { return sides_[static_cast<std::size_t>(index)]; }

 private:
  [[nodiscard]] glm::ivec2 cell_of(glm::dvec2 p) const;
  [[nodiscard]] std::size_t bucket(int x, int y) const;

  std::vector<Side> sides_;
  Box2 box_;
  glm::ivec2 n_cells_{1, 1};
  double cell_mm_;
  std::vector<std::vector<int>> buckets_;
};

/// All shapes worth trying on a side, none where not even kLeastTabWidth fits; widest first. `sides`:
/// uncovered sides of the piece. `partner`: the face the tab is glued to, laid down beyond the side (its
/// corners in mm, beginning with the side's end; empty for a border).
std::vector<TabShape> tab_shapes(const SideGrid& sides, const SideGrid::Side& side, const TabWish& wish,
                                 std::span<const glm::dvec2> partner);

/// Would tab_shapes() find any shape, wherever it lands?
bool has_room_for_tab(const SideGrid& sides, const SideGrid::Side& side, const TabWish& wish);

/// Do two tabs cover each other, or come nearer than kTabGap without growing from one corner?
bool tabs_collide(const TabShape& a, const TabShape& b);

}  // namespace netwright
