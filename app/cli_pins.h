// The pins of the command line: numbers of faces become faces and edges of the mesh.
#pragma once

#include <string>
#include <utility>

#include "app/cli_options.h"
#include "core/mesh/mesh.h"
#include "core/solve/constraints.h"

namespace netwright {

/// The edge that two faces share, told by their numbers; `purpose` as in "there is nothing to fold". Throws
/// Error(Usage) like pins_of().
EdgeId edge_between(const Mesh& mesh, std::pair<int, int> faces, const std::string& purpose);

/// Faces are told by their number in the file, counted from 1, edges by the two faces that share them. Throws
/// Error(Usage) when there is no such face or the two are no neighbours.
Constraints pins_of(const UnfoldCommand& command, const Mesh& mesh);

}  // namespace netwright
