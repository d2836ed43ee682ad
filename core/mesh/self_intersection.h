// Finds faces that cut through each other in space. Such a model still unfolds, but nobody can glue it
// without slits; the user is warned.
#pragma once

#include <utility>
#include <vector>

#include "core/mesh/mesh.h"

namespace netwright {

/// Pairs of faces (first < second, sorted) whose surfaces cross properly: faces that only touch, at a common
/// corner or edge or anywhere else, do not count.
std::vector<std::pair<FaceId, FaceId>> self_intersections(const Mesh& mesh);

}  // namespace netwright
