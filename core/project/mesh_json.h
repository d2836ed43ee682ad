// How project files name edges of the mesh: by a face and one of its corners, never by numbers of our own.
#pragma once

#include <string_view>
#include <vector>

#include "core/base/json.h"
#include "core/mesh/mesh.h"
#include "core/project/json_fields.h"

namespace netwright {

/// Face and corner where the edge begins, face and corner …
Json edges_json(const std::vector<EdgeId>& edges, const Mesh& mesh);

/// The same read back, one halfedge for each pair, in the order of the file. Throws Error(Read) where a pair
/// names no corner of the mesh.
std::vector<HalfedgeId> read_sides(JsonFields& fields, std::string_view key, const Mesh& mesh);
/// Their edges, sorted, each once.
std::vector<EdgeId> read_edges(JsonFields& fields, std::string_view key, const Mesh& mesh);

}  // namespace netwright
