// The separate parts of a model, as a list to choose from, and a model without some of them.
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <vector>

#include "core/mesh/mesh.h"

namespace netwright {

/// Parts whose diagonal is below this share of the model's are small: on a model as tall as a hand they are
/// crumbs that scissors lose.
inline constexpr double kSmallPartShare = 0.05;

/// Faces that hang together along edges.
struct ModelPart {
  int first_face = -1;  ///< the least of its faces in the file, its name; -1 when a repair made all of them
  std::vector<int> faces{};  ///< its faces in the mesh
  glm::dvec3 size{0};        ///< of the box around it, model units
  bool is_inner = false;     ///< lies wholly inside a closed part
  bool is_small = false;     ///< kSmallPartShare; never the largest part
};

/// All parts, the largest first (by diagonal, then by first_face): that is how they are numbered, from 1.
/// Inner parts are looked for with bounded work.
std::vector<ModelPart> parts_of(const Mesh& mesh);

/// The mesh without the parts that hold any of these faces of the file; null when none would stay. Faces and
/// corners keep their order, and what they know of the file.
std::shared_ptr<const Mesh> without_parts(const Mesh& mesh, std::span<const int> left_out);

}  // namespace netwright
