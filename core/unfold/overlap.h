// Full overlap detection: all pairs of faces of one piece whose interiors meet in the plane, found with the
// sweep line of the paper's section 4.7. The plain one; the search has its own incremental index.
#pragma once

#include <utility>
#include <vector>

#include "core/unfold/net.h"

namespace netwright {

/// Two faces of one piece, first < second.
struct Overlap {
  FaceId first;
  FaceId second;
  auto operator<=>(const Overlap&) const = default;
};

/// Every overlap deeper than `depth` mean edge lengths (to within a factor sqrt 2), sorted.
std::vector<Overlap> find_overlaps(const Net& net, double depth);

/// Do two convex counter-clockwise polygons meet deeper than `depth` (a length)? Separating-axis test over
/// the edge lines of both: they overlap when from every edge line of either the other one reaches more than
/// `depth` to the inner side. Touching edges, shared corners and coplanar neighbours have depth zero up to
/// rounding, so adjacent faces need no exception; containment is covered.
bool convex_overlap(std::span<const glm::dvec2> a, std::span<const glm::dvec2> b, double depth);

/// The same for two faces laid down here and there, concave ones part by part.
bool faces_overlap(const DualGraph& dual, FaceId f, const Rigid2& f_placement, FaceId g,
                   const Rigid2& g_placement, double depth);

}  // namespace netwright
