// The polygon Laplacian of M. Alexa and M. Wardetzky, "Discrete Laplacians on General Polygonal Meshes" (ACM
// TOG 30(4), 2011), one face at a time: its vector area, the pre-Laplacian, the completion that sees what is
// not flat, and their sum.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace netwright {

/// A symmetric matrix with a row and column per corner of a face.
class CornerMatrix {
 public:
  explicit CornerMatrix(std::size_t n) : n_(n), values_(n * n, 0.0) {}
  [[nodiscard]] std::size_t size() const { return n_; }
  double& operator()(std::size_t row, std::size_t column) { return values_[row * n_ + column]; }
  double operator()(std::size_t row, std::size_t column) const { return values_[row * n_ + column]; }

 private:
  std::size_t n_;
  std::vector<double> values_;
};

/// A face seen from its best plane, the one of its largest projection.
struct PolygonFrame {
  glm::dvec3 centre{0};          ///< mean of the corners
  glm::dvec3 normal{0};          ///< unit, or 0 where the polygon has no vector area
  double area = 0;               ///< length of the vector area: that of the largest projection
  double size = 0;               ///< longest side or diagonal
  std::vector<glm::dvec2> flat;  ///< the corners in the plane, about the centre: the maximal projection
  std::vector<double> height;    ///< the corners' distances from the plane, signed
  /// Largest distance of a corner from the plane as a share of the size, as Mesh::unevenness has it.
  [[nodiscard]] double unevenness() const;
};

/// Half the sum of the cross products of neighbouring corners.
glm::dvec3 vector_area(std::span<const glm::dvec3> corners);

PolygonFrame frame_of(std::span<const glm::dvec3> corners);

/// C Cᵀ, where C is an orthonormal basis of all edge functions at right angles to the sides of the maximal
/// projection. Times the face's sides it is 0 exactly when the face is flat.
CornerMatrix completion(const PolygonFrame& frame);

/// dᵀ C Cᵀ d: half of it as a quadratic form of the corners is the face's planarizing energy.
CornerMatrix off_plane_energy(const PolygonFrame& frame);

/// What remains of corner heights after the best affine function of the place in the plane is taken out:
/// the part of the energy's second derivative that does not vanish on flat faces.
CornerMatrix height_residue(const PolygonFrame& frame);

/// The stiffness matrix dᵀ (B Bᵀ / |a| + lambda C Cᵀ) d. For a triangle it is the cotangent Laplacian,
/// whatever lambda is.
CornerMatrix polygon_laplacian(std::span<const glm::dvec3> corners, double lambda);

}  // namespace netwright
