// The pieces of a net as the layout sees them: what paper each one takes, faces and glue tabs together, and
// the marks on it that a seam between two sheets should not run through. In mm at print scale, y up.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <vector>

#include "core/sheet/outline.h"
#include "core/unfold/glue_tabs.h"
#include "core/unfold/net.h"

namespace netwright {

using Hull = std::vector<glm::dvec2>;

/// A fold, a tab or a label: the hull of some points, grown by a radius.
struct NetMark {
  std::array<glm::dvec2, 4> points{};
  int n_points = 0;
  double radius_mm = 0;
};

struct PieceShape {
  double area_mm2 = 0;
  Hull hull;                                      ///< convex, counter-clockwise
  std::vector<std::vector<glm::dvec2>> outlines;  ///< closed, led round the tabs
  std::vector<NetMark> marks;
};

struct PieceShapes {
  double scale = 1;            ///< mm per model unit
  double model_height_mm = 0;  ///< along the up axis
  double area_mm2 = 0;         ///< of all outlines
  std::vector<PieceShape> pieces;
  GlueTabs tabs;
};

/// Tabs are placed anew for this scale; none with no_tabs().
PieceShapes piece_shapes(const Net& net, double scale, const TabSettings& tabs);
/// With tabs that were placed for this scale.
PieceShapes piece_shapes(const Net& net, double scale, GlueTabs tabs);

/// All sides of closed lines.
std::vector<Segment> sides_of(const std::vector<std::vector<glm::dvec2>>& outlines);

}  // namespace netwright
