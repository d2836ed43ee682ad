// The arrays of a soup or mesh as bytes, the way a project file holds them: exact, compact, and checked on
// the way back, so that what is read may be trusted like any soup.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/mesh/mesh.h"

namespace netwright {

struct StoredShape {
  PolygonSoup soup;              ///< points, faces, texture coordinates, materials per face; no words
  std::vector<int> face_source;  ///< of a mesh; empty for what a file held
  std::vector<bool> is_flipped;  ///< of a mesh; empty for what a file held
  [[nodiscard]] bool is_mesh() const { return !face_source.empty(); }
};

/// Everything that Mesh's constructor needs to make this mesh again, with the same numbers everywhere.
StoredShape shape_of(const Mesh& mesh);

/// Little-endian: a mark, seven counts, the arrays.
std::string shape_bytes(const StoredShape& shape);

/// Believes nothing: counts are held against the number of bytes before anything is allocated, and every
/// index and number is checked. Throws Error(Read), "FILE is damaged: …".
StoredShape parse_shape(std::string_view bytes, const std::string& file);

/// Throws Error(Read): "FILE is damaged: WHAT; open an earlier copy of it."
[[noreturn]] void refuse_damaged(const std::string& file, const std::string& what);

}  // namespace netwright
