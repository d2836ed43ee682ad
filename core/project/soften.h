// The least change of shape that lets a model unfold into one piece, where no search finds a net of it as it
// is: corners near the trouble moved a little, or two of them made one.
#pragma once

#include <memory>

#include "core/base/progress.h"
#include "core/project/make_model.h"
#include "core/solve/trouble.h"

namespace netwright {

struct Softening {
  Recipe recipe;                          ///< the model's, with these corners moved
  std::shared_ptr<const MadeModel> made;  ///< what comes of it; null when nothing helped
  double deviation = 0;        ///< how far the surface moved at most, in model units, from the mesh before
  int n_moved = 0;             ///< corners moved now
  bool was_cancelled = false;  ///< what was found until then may not be the least
  [[nodiscard]] bool is_found() const { return made != nullptr; }
};

/// Tries, near the faces of `trouble`, to lower peaks, to fill the points of negative curvature, both, to
/// smooth all corners, and to join those of the shortest edges; each as little as gives a proved net with
/// these options, and none farther than `most` (model units). Takes what moves the surface least. `made` must
/// have a mesh and `options` speak of it; its pins are carried over to each of the meshes tried.
Softening soften(const std::shared_ptr<const PolygonSoup>& source, const Recipe& recipe,
                 const MadeModel& made, const SolveOptions& options, const Trouble& trouble, double most,
                 Progress& progress);

}  // namespace netwright
