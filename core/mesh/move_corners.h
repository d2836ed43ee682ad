// Corners of a mesh moved elsewhere, named by where they lie: how a model is softened where it cannot be
// unfolded.
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "core/mesh/mesh.h"

namespace netwright {

struct MovedCorner {
  glm::dvec3 from{0};  ///< where the corner lies
  glm::dvec3 to{0};    ///< and where it goes; corners that go to the very same place become one
  bool operator==(const MovedCorner&) const = default;
};

struct MovedMesh {
  std::shared_ptr<const Mesh> mesh;  ///< null where it cannot be done
  std::vector<int> heirs;            ///< per face before: the face that took its place, -1 for none
};

/// Moves them; faces that lose their area by corners becoming one go, and those that are not flat afterwards
/// are split into triangles. Keeps name, looks and the faces' sources. The mesh is null where a corner is not
/// found, or where what comes out is no mesh.
MovedMesh move_corners(const Mesh& mesh, const std::vector<MovedCorner>& moved);

}  // namespace netwright
