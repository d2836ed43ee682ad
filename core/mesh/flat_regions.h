// Finds the groups of neighbouring faces that lie in one plane and look alike; which polygons they make is
// for merge_pieces to say.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/base/ids.h"
#include "core/mesh/mesh.h"

namespace netwright {

struct Plane {
  glm::dvec3 point{0};
  glm::dvec3 normal{0};  ///< of unit length
};

/// How far off a plane rounding may put its points at this tolerance, in model units.
double rounding_of(const Mesh& mesh, double tolerance_rad);

/// Decides whether a face counts as part of a plane: bent against it by no more than the tolerance, or with
/// all corners so near to it that its own direction is nothing but rounding.
class PlaneTest {
 public:
  PlaneTest(const Mesh& mesh, double tolerance_rad);
  [[nodiscard]] bool holds(FaceId f, const Plane& plane) const;

 private:
  const Mesh& mesh_;
  double sine_;
  double rounding_;  ///< model units
};

/// How a texture lies on one face: the affine map from space to picture that fits its corners best.
class UvMap {
 public:
  UvMap(const Mesh& mesh, FaceId f);
  /// True when the map says what the face's corners say, within kSameUv.
  [[nodiscard]] bool fits(const Mesh& mesh, FaceId f) const;

 private:
  glm::dvec3 origin_{0};
  glm::dvec2 uv_origin_{0};
  glm::dvec3 u_slope_{0};
  glm::dvec3 v_slope_{0};
};

class FlatRegions {
 public:
  explicit FlatRegions(const Mesh& mesh) : mesh_(mesh), is_free_(mesh.n_faces(), 0) {}

  /// Parts the faces into connected groups of one plane, material and texture map, each grown from its
  /// largest face and ascending; every face is in exactly one.
  std::vector<std::vector<FaceId>> grow(std::span<const FaceId> faces, double tolerance_rad);

 private:
  std::vector<FaceId> grow_from(FaceId seed, const PlaneTest& test);

  const Mesh& mesh_;
  IdVector<FaceId, char> is_free_;
};

}  // namespace netwright
