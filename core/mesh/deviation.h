// How far two surfaces lie apart: a tree of boxes over triangles that finds the nearest point of a surface,
// and the Hausdorff distance made with it.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/progress.h"
#include "core/mesh/mesh.h"
#include "core/mesh/soup.h"

namespace netwright {

/// The point of triangle a b c nearest to p.
glm::dvec3 nearest_in_triangle(const std::array<glm::dvec3, 3>& triangle, const glm::dvec3& p);

/// Triangles in a tree of boxes. Polygons are cut into triangles (flat ones lose nothing by it).
class SurfaceTree {
 public:
  using Triangle = std::array<glm::dvec3, 3>;

  explicit SurfaceTree(std::vector<Triangle> triangles);
  explicit SurfaceTree(const Mesh& mesh);
  explicit SurfaceTree(const PolygonSoup& soup);

  struct Hit {
    int triangle = -1;
    double distance = 0;
  };
  /// The nearest triangle; or the first one met that is not further than `enough`. `guess`, when it names a
  /// triangle, is looked at first, which makes the search shorter.
  [[nodiscard]] Hit nearest(const glm::dvec3& p, int guess = -1, double enough = 0) const;

  [[nodiscard]] std::span<const Triangle> triangles() const { return triangles_; }
  [[nodiscard]] const Box3& box() const { return nodes_.front().box; }

 private:
  struct Node {
    Box3 box;
    int begin = 0;  ///< triangles of a leaf; of an inner node `end` is 0 and `begin` its first child
    int end = 0;
  };
  void build(std::size_t node, int begin, int end, std::vector<int>& order);

  std::vector<Triangle> triangles_;
  std::vector<Node> nodes_;
};

/// How closely distances between surfaces are found: the true one is larger by at most 2 % or by this share
/// of the diagonal, whichever is more. On paper 20 cm tall that is a tenth of a millimetre.
inline constexpr double kDeviationTolerance = 5e-4;

/// The largest distance found that a point of `a` has from the surface `b`. Triangles are bisected until none
/// can hold a point that is further away by more than the tolerance (a share of a's diagonal).
double distance_from(const SurfaceTree& a, const SurfaceTree& b, double tolerance = kDeviationTolerance);

/// The larger one of both directions.
double hausdorff_distance(const SurfaceTree& a, const SurfaceTree& b, double tolerance = kDeviationTolerance);

/// The same, given up when `progress` is cancelled: then what was found so far, which is too little.
double hausdorff_distance(const SurfaceTree& a, const SurfaceTree& b, const Progress& progress);

}  // namespace netwright
