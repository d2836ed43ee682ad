// From a file's faces and a recipe to the mesh that is unfolded. Editor and command line both call this, so
// the same file and recipe give the same mesh in both.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/dual_graph.h"
#include "core/mesh/mesh_report.h"
#include "core/mesh/simplify.h"
#include "core/project/recipe.h"

namespace netwright {

/// What later recipes for the same file can take over: the mesh before simplifying, and its collapses.
struct ModelStages {
  std::shared_ptr<const PolygonSoup> source;
  Recipe recipe;                     ///< only up, repairs and uneven count here
  std::shared_ptr<const Mesh> mesh;  ///< repaired, all faces flat
  std::vector<std::string> done;
  std::shared_ptr<const Simplifier> simplifier;  ///< null until it is asked for
};

struct MadeModel {
  std::shared_ptr<const DualGraph> dual;  ///< null when the model is not fit to be unfolded
  MeshReport report;                      ///< of the mesh that came out, else of the file
  std::string refusal;                    ///< why it is not fit, one sentence with the cure; else empty
  std::vector<std::string> done;          ///< what the recipe did, whole sentences
  double deviation = 0;                   ///< how far simplifying moved the surface, model units
  int n_faces_least = 0;                  ///< what simplifying can reach; 0 when nothing was simplified
  std::shared_ptr<const ModelStages> stages;
  bool was_cancelled = false;
};

/// Follows the recipe. `before` may be null; its stages are used again where they still fit. Never throws for
/// a bad model. With recipe.faces > 0 the simplifier is made (or taken over); that is the long part.
MadeModel make_model(const std::shared_ptr<const PolygonSoup>& source, const Recipe& recipe,
                     const std::shared_ptr<const ModelStages>& before, Progress& progress);

}  // namespace netwright
