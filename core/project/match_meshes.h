// Which edges and faces of a model are there again in a changed version of it: first those that lie exactly
// where they lay, then, for what is left on both sides, the nearest that look alike.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "core/base/ids.h"
#include "core/mesh/mesh.h"

namespace netwright {

/// How places of the old model are brought to those of the new one: turned, scaled, shifted.
struct ModelFrame {
  enum class Turn { None, UpToZ, UpToY };  ///< up was y and is z now, or the other way round
  Turn turn = Turn::None;
  double scale = 1;
  glm::dvec3 shift{0};

  [[nodiscard]] glm::dvec3 direction(const glm::dvec3& d) const;
  [[nodiscard]] glm::dvec3 operator()(const glm::dvec3& p) const { return scale * direction(p) + shift; }
  bool operator==(const ModelFrame&) const = default;
};

/// Changed versions usually stand where the old one stood. Where hardly an edge is found there, the file may
/// have been written in another unit, place or with another axis up: then the frame that makes the boxes
/// coincide is taken, if it finds more.
ModelFrame find_frame(const Mesh& from, const Mesh& to);

/// What became of the edges and faces of the old mesh. No two of them have the same partner.
struct MeshMatch {
  IdVector<EdgeId, EdgeId> edges;       ///< invalid: gone
  IdVector<EdgeId, char> is_edge_same;  ///< both ends lie where they lay
  IdVector<FaceId, FaceId> faces;
  IdVector<FaceId, char> is_face_same;  ///< centre, size and normal are those that were
};

/// Edges are near when they run the same way (30 degrees), their faces look the same way (60 degrees), one is
/// at most 2.5 times as long as the other, and their middles are within half of the longer one; faces when
/// they look the same way (30 degrees) and their centres are within half of their sizes. The nearest pairs go
/// first, those of the edges in `first` before all others.
MeshMatch match_meshes(const Mesh& from, const Mesh& to, const ModelFrame& frame,
                       const std::vector<EdgeId>& first);

}  // namespace netwright
