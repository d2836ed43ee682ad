// Overlaps beyond doubt: faces rolled over hinges with a bound of all rounding carried along. Only the
// checker of impossibility proofs uses it, so that it depends on nothing that finds them.
#pragma once

#include <vector>

#include "core/mesh/mesh.h"

namespace netwright::proof {

/// Where the frame of a face (origin at its first corner) lies in the plane, and how far off that may be.
struct Laid {
  Rigid2 at;
  double turn_error_rad = 0;
  double shift_error = 0;
};

class RolledFaces {
 public:
  explicit RolledFaces(const Mesh& mesh);

  [[nodiscard]] const Mesh& mesh() const { return mesh_; }
  /// Where the face beyond h lies when the face of h lies `here`. Not for borders.
  [[nodiscard]] Laid across(const Laid& here, HalfedgeId h) const;
  /// Do the two overlap deeper than kImpossibleDepth mean edges, however the rounding fell?
  [[nodiscard]] bool overlap(FaceId f, const Laid& f_at, FaceId g, const Laid& g_at) const;

 private:
  using Polygon = std::vector<glm::dvec2>;
  void flatten(FaceId f);
  [[nodiscard]] double error(FaceId f, const Laid& at) const;

  const Mesh& mesh_;
  double limit_ = 0;
  IdVector<HalfedgeId, glm::dvec2> flat_;
  IdVector<FaceId, double> size_;                 ///< no corner is farther from the first one
  IdVector<FaceId, std::vector<Polygon>> parts_;  ///< convex, inside the face, counter-clockwise
};

}  // namespace netwright::proof
