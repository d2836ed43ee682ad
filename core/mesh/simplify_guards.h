// What a collapse must leave of the shape of the faces around it. Only simplify*.cpp include it.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/mesh/simplify_surface.h"

namespace netwright::simplify {

/// A face that a collapse moves: one of its corners goes elsewhere.
struct RingFace {
  FaceId face;
  std::array<glm::dvec3, 3> before;
  std::array<glm::dvec3, 3> after;
};

struct Limits {
  double turn_cosine;  ///< of each face's normal, before to after
  double shape;        ///< 1 for an equilateral triangle, 0 for none; no worse than the worst before
  double fold_cosine;  ///< between the normals of neighbours, unless they were folded more before
};

/// Unit normal; zero for a triangle without area.
glm::dvec3 unit_normal(const std::array<glm::dvec3, 3>& triangle);

/// The faces that stay when h's ends become one point at `place`, with their shapes before and after.
void gather_ring(const TriangleSurface& surface, HalfedgeId h, const glm::dvec3& place,
                 std::vector<RingFace>& ring);

/// No face turns over or becomes a sliver.
bool keeps_shape(std::span<const RingFace> ring, const Limits& limits);

/// No two neighbours come to lie nearly back to back, inside the ring or across its rim.
bool stays_unfolded(const TriangleSurface& surface, HalfedgeId h, const glm::dvec3& place,
                    std::span<const RingFace> ring, const Limits& limits);

}  // namespace netwright::simplify
