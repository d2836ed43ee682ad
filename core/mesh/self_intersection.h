// Finds faces that cut through each other in space. Such a model still unfolds, but nobody can glue it
// without slits; the user is warned.
#pragma once

#include <utility>
#include <vector>

#include "core/mesh/mesh.h"

namespace netwright {

struct SelfIntersections {
  std::vector<std::pair<int, int>> pairs;  ///< face numbers (first < second), sorted
  bool is_complete = true;  ///< false: the search ended at its fixed amount of work, there may be more
};

/// Pairs of faces whose surfaces cross properly: faces that only touch, at a common corner or edge or
/// anywhere else, do not count, nor do faces without area. Takes n log n time for models that do not cross
/// much, and is cut off after 40 million comparisons of boxes or 100 000 pairs.
SelfIntersections find_self_intersections(const PolygonSoup& soup);
SelfIntersections find_self_intersections(const Mesh& mesh);

/// The pairs alone.
std::vector<std::pair<FaceId, FaceId>> self_intersections(const Mesh& mesh);

}  // namespace netwright
