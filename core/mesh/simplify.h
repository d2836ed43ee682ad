// Fewer faces, same look: edges collapse in the order of the quadric error they cause (M. Garland and
// P. Heckbert, Surface Simplification Using Quadric Error Metrics, 1997). The collapses are made once and
// recorded, so that the model with any number of faces is there as fast as a slider moves.
#pragma once

#include <memory>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/mesh.h"
#include "core/mesh/soup.h"

namespace netwright {

class SurfaceTree;
struct CollapseHistory;

struct SimplifyOptions {
  int least_faces = 20;              ///< where to stop; under 4 counts as 4
  bool keep_uv_seams = false;        ///< points of a seam stay on it; else seams only pull a little
  bool keep_sharp_edges = false;     ///< points of a sharp edge stay on it
  double sharp_angle_rad = 0.69813;  ///< from this bend on an edge is sharp (40 degrees)
};

/// A model with its whole history of collapses. Immutable, cheap to copy, shared between threads.
///
/// What every step keeps: an oriented manifold, the genus, the number of components and of border loops.
/// Points of a border only move along it. No face turns over or degenerates, none is pushed through another
/// one that it did not cut already. The same mesh and options give the same history on every machine.
class Simplifier {
 public:
  /// Makes all collapses; polygons are cut into triangles for it. About linear in the number of faces.
  /// When `progress` is cancelled the history is as long as it got, which is no error.
  Simplifier(std::shared_ptr<const Mesh> mesh, const SimplifyOptions& options, Progress& progress);

  /// As many faces as the mesh itself has.
  [[nodiscard]] int n_faces_max() const;
  /// The fewest that could be reached.
  [[nodiscard]] int n_faces_min() const;

  /// The model with the most faces that are not more than `n_faces` (most steps take two away at once);
  /// outside of n_faces_min … n_faces_max the nearest of the two. Polygons that nothing has happened to yet
  /// stay polygons, all other faces are triangles. Keeps name, up axis, materials and texture coordinates.
  /// A Mesh can be made of it.
  [[nodiscard]] PolygonSoup soup_at(int n_faces) const;

  /// For every face of soup_at(n_faces) the face of the mesh that it was (FaceId's value).
  [[nodiscard]] std::vector<int> sources_at(int n_faces) const;

  /// For every face of the mesh the face of soup_at(n_faces) that has taken its place: itself while it
  /// lives, else a neighbour. Carries pins along.
  [[nodiscard]] std::vector<int> heirs_at(int n_faces) const;

  /// The Hausdorff distance between the mesh and soup_at(n_faces), in model units: how far the point of
  /// either surface that is furthest from the other one lies from it. Triangles are bisected with certain
  /// bounds until no point can be further away than this by more than 2 % or kDeviationTolerance of the
  /// model's diagonal, whichever is more; so it is no guess from samples.
  [[nodiscard]] double deviation_at(int n_faces) const;
  /// The same for any mesh that was made of this one; when `progress` is cancelled, the result means nothing.
  [[nodiscard]] double deviation_of(const Mesh& mesh, const Progress& progress) const;

  [[nodiscard]] const std::shared_ptr<const Mesh>& mesh() const { return mesh_; }

 private:
  [[nodiscard]] int step_at(int n_faces) const;

  std::shared_ptr<const Mesh> mesh_;
  std::shared_ptr<const CollapseHistory> history_;
  std::shared_ptr<const SurfaceTree> surface_;  ///< of the mesh, for measuring
};

}  // namespace netwright
