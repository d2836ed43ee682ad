// Glue tabs: for every cut a flap on one of its two sides, which lands under the face on the other one. Which
// side gets it is decided over the whole net, so that as many cuts as possible get a good tab.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "core/unfold/net.h"

namespace netwright {

/// Which sides of a cut get a tab. First is the side of Mesh::halfedge(edge), Second that of its twin.
enum class TabSide { Auto, First, Second, Both, None };

/// What the user wants for one edge; where nothing is said the settings of the whole net apply. A tab is
/// never made larger than there is room for, whatever was asked.
struct TabEdit {
  EdgeId edge;
  TabSide side = TabSide::Auto;
  std::optional<double> width_mm;
  std::optional<double> first_angle_rad;   ///< at the vertex where Mesh::halfedge(edge) begins
  std::optional<double> second_angle_rad;  ///< at its other vertex
  bool operator==(const TabEdit&) const = default;
};

/// How tabs are made. Defaults are those of the field: 5 mm, 45 degrees, at most half the edge.
struct TabSettings {
  enum class Pattern {
    BestSide,     ///< one tab per cut, on the side where it is best
    Alternating,  ///< one tab per cut; along an outline with tab and without take turns where both have room
    BothSides,    ///< two tabs per cut, each as good as it gets
  };
  bool is_on = true;
  Pattern pattern = Pattern::BestSide;
  double width_mm = 5;
  double angle_rad = 0.78539816339744831;  ///< between the tab's slanted ends and the edge
  bool in_search = false;                  ///< the search exchanges folds until every cut has room for a tab
  bool on_borders = false;                 ///< also where the model is open and nothing is glued
  std::vector<TabEdit> edits = {};         ///< sorted by edge, one for each at most
  bool operator==(const TabSettings&) const = default;
};

inline TabSettings no_tabs() {
  TabSettings settings;
  settings.is_on = false;
  return settings;
}

inline constexpr double kLeastTabWidth = 2;                    ///< mm; a narrower tab holds no glue
inline constexpr double kMostTabWidth = 50;                    ///< mm
inline constexpr double kChildTabWidth = 10;                   ///< mm, the preset for children
inline constexpr double kLeastTabAngle = 0.17453292519943295;  ///< 10 degrees
inline constexpr double kMostTabAngle = 1.5707963267948966;    ///< upright

/// A tab in the plane of its net, in mm at print scale (net coordinates times scale, y up).
struct GlueTab {
  HalfedgeId side;  ///< the uncovered side it grows from; it is glued under the face of the twin
  /// Counter-clockwise, convex: where the side ends, where it begins, then the free rim (two points; one
  /// where the tab is a triangle).
  std::vector<glm::dvec2> points;
  double width_mm = 0;       ///< height of the trapezoid
  bool lands_inside = true;  ///< false when it reaches out of the face it is glued to
};

struct GlueTabs {
  std::vector<GlueTab> tabs;    ///< sorted by side
  std::vector<EdgeId> missing;  ///< cuts that should have a tab and have room for none of kLeastTabWidth
  /// Cuts among the missing that could not have one even if no other tab were there.
  std::size_t n_hopeless = 0;
};

/// Tabs for this net printed at `scale` mm per model unit. No tab covers a face or another tab of its piece,
/// nor comes nearer to them than kTabGap. The same input gives the same tabs.
GlueTabs place_tabs(const Net& net, double scale, const TabSettings& settings);

inline constexpr double kTabGap =
    0.05;  ///< mm of paper that is left between a tab and what it must not cover

}  // namespace netwright
