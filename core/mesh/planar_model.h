// A mesh on its way to flat faces: where its corners are, how far from flat that is, and the way back to a
// soup. Only planarize.cpp includes it.
#pragma once

#include <cstddef>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/mesh/polygon_laplacian.h"

namespace netwright::planarize_parts {

using Points = std::vector<glm::dvec3>;

struct PlanarModel {
  /// Refers to the mesh, which must outlive it.
  explicit PlanarModel(const Mesh& mesh);

  const Mesh& mesh;
  std::vector<std::vector<std::size_t>> faces;  ///< vertices of each face
  Points start;                                 ///< the corners in mean edges, about the box's centre
  double unit = 1;                              ///< one mean edge in model units
  double size = 1;                              ///< diagonal of the box in mean edges
  std::vector<char> was_simple;                 ///< per face: its projection does not cross itself

  [[nodiscard]] Points corners(std::size_t f, const Points& points) const;
  [[nodiscard]] PolygonFrame frame(std::size_t f, const Points& points) const;

  /// Half the sum of |C Cᵀ E|² over the faces: 0 when all are flat.
  [[nodiscard]] double energy(const Points& points) const;

  struct Measure {
    double unevenness = 0;            ///< of the worst face, as a share of its size
    double off_plane = 0;             ///< largest distance of a corner from its face's plane, in mean edges
    std::vector<std::size_t> folded;  ///< faces that turned over or cross themselves, as they did not before
  };
  [[nodiscard]] Measure measure(const Points& points) const;

  /// The mesh with its corners there, as PlanarizeResult::soup promises it.
  [[nodiscard]] PolygonSoup soup(const Points& points) const;
};

double largest_move(const Points& from, const Points& to);

/// Of a soup in its own units: the worst face's.
double worst_unevenness(const PolygonSoup& soup);

}  // namespace netwright::planarize_parts
