// Makes the faces of a mesh flat while its shape stays nearly as it was: the planarization flow of M. Alexa
// and M. Wardetzky, "Discrete Laplacians on General Polygonal Meshes" (ACM TOG 30(4), 2011), which section
// 4.1 of the paper asks for before unfolding, and a finish that brings it to its target.
#pragma once

#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

namespace netwright {

struct PlanarizeOptions {
  /// Faces are done when no corner is off its best plane by more than this share of the face's size.
  double target = 1e-6;
  int max_iterations = 300;  ///< of flow and finish together
  /// No corner may move by more than this share of the model's size (its box's diagonal); past it the work
  /// ends and says so.
  double max_move = 0.1;
};

struct PlanarizeResult {
  /// The mesh with moved corners: faces in its order, point v is its vertex v, with name, up axis, uv and
  /// materials. When not converged, the flattest shape reached within the limits.
  PolygonSoup soup;
  bool has_converged = false;
  bool was_cancelled = false;
  int iterations = 0;                 ///< sparse systems solved
  std::vector<double> flow_energies;  ///< of the start and after each step of the flow, in mean edges squared
  double unevenness_before = 0;  ///< the worst face's, as Mesh::unevenness has it: share of the face's size
  double unevenness_after = 0;
  double largest_move = 0;     ///< of any corner, in model units
  double hausdorff = 0;        ///< between the surfaces before and after, both ways, in model units
  double moved_share = 0;      ///< largest_move as a share of the model's size
  double hausdorff_share = 0;  ///< hausdorff as a share of the model's size
  /// What happened, for people: how flat, how far moved; and when not converged, why and what to do instead.
  std::string sentence;
};

/// Flattens all faces together. A mesh whose faces are below the target already comes back as it is. Ends
/// early, with what was reached, when `progress` is cancelled. The same mesh gives the same result.
PlanarizeResult planarize(const Mesh& mesh, const PlanarizeOptions& options, Progress& progress);

}  // namespace netwright
