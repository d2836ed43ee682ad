// The outline of a net: its cut and border edges joined in order, and clipping of strokes to a box.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/unfold/glue_tabs.h"
#include "core/unfold/net.h"

namespace netwright {

/// A closed run of uncovered sides of one piece, counter-clockwise around the paper. A piece that is a tree
/// of faces has exactly one loop.
struct OutlineLoop {
  int piece = 0;
  std::vector<HalfedgeId> sides;
};

using Segment = std::pair<glm::dvec2, glm::dvec2>;

/// All loops, ordered by piece.
std::vector<OutlineLoop> outline_loops(const Net& net);

/// For each side the tab that grows from it; null where there is none.
IdVector<HalfedgeId, const GlueTab*> tabs_by_side(const Mesh& mesh, const GlueTabs& tabs);

/// The part of a segment inside a box, as parameters 0…1 from a to b; nothing when it misses the box or only
/// touches it in a point.
std::optional<std::pair<double, double>> clip_segment(const Box2& box, glm::dvec2 a, glm::dvec2 b);

/// How often a closed outline winds around a point: 0 outside.
int winding_number(const std::vector<Segment>& outline, glm::dvec2 point);

/// The runs of a polyline inside a box; `is_closed` in, open runs out (a closed line wholly inside comes back
/// whole, with `is_whole` set).
struct ClippedLine {
  std::vector<std::vector<glm::dvec2>> runs;
  bool is_whole = false;
};
ClippedLine clip_polyline(const Box2& box, const std::vector<glm::dvec2>& points, bool is_closed);

}  // namespace netwright
