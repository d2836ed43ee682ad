// Where the faces of a mesh came from. Simplifying, splitting and merging make one face of several of the
// file's, or several of one; pins, culprits and groups that are split again find their way by this list.
#pragma once

#include <compare>
#include <span>
#include <vector>

#include "core/base/ids.h"
#include "core/mesh/mesh.h"

namespace netwright {

/// Face `file_face` of the file went into `face` of the mesh, or was swallowed by it.
struct Origin {
  int file_face = 0;
  FaceId face;
  auto operator<=>(const Origin&) const = default;
};
using Origins = std::vector<Origin>;  ///< ascending, each pair once

/// Of a mesh whose faces have one source each (Mesh::face_source); faces that fill holes have none.
Origins origins_of(const Mesh& mesh);

/// The same where `groups` says for merged faces what they were merged of (empty, or one per face).
Origins origins_of(const Mesh& mesh, const IdVector<FaceId, std::vector<int>>& groups);

/// After another step, in which every face of the mesh became part of the face that `heirs` names (-1:
/// nothing is left of it).
Origins passed_on(const Origins& origins, const std::vector<int>& heirs);

/// The faces of the mesh that were made of these faces of the file, ascending; those made of the first one
/// come first.
std::vector<FaceId> faces_made_of(const Origins& origins, std::span<const int> file_faces);

/// The faces of the file that went into a face of the mesh, ascending.
std::vector<int> file_faces_of(const Origins& origins, FaceId face);

}  // namespace netwright
