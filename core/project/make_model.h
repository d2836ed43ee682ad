// From a file's faces and a recipe to the mesh that is unfolded. Editor and command line both call this, so
// the same file and recipe give the same mesh in both.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/dual_graph.h"
#include "core/mesh/mesh_report.h"
#include "core/mesh/model_parts.h"
#include "core/mesh/simplify.h"
#include "core/project/origins.h"
#include "core/project/recipe.h"

namespace netwright {

/// What there is to choose: what each step of repair has to do, and the parts of the repaired model.
struct ModelSurvey {
  RepairSurvey repairs;  ///< uneven faces, too
  std::vector<ModelPart> parts;
};

/// What later recipes for the same file can take over: the mesh before simplifying, and its collapses.
struct ModelStages {
  std::shared_ptr<const PolygonSoup> source;
  Recipe recipe;  ///< only up, repairs, uneven and left_out count here
  /// Repaired, all faces flat, all parts. Null when a project with parts left out was opened, until
  /// add_survey() or another recipe.
  std::shared_ptr<const Mesh> whole;
  std::shared_ptr<const Mesh> mesh;          ///< without the parts that are left out
  std::vector<std::string> repaired;         ///< what was done for `whole`,
  std::vector<std::string> done;             ///< and for `mesh`
  std::vector<MeshReport::Line> file_lines;  ///< what the file had that the mesh has no more, with culprits
  std::shared_ptr<const Simplifier> simplifier;  ///< null until it is asked for
  std::shared_ptr<const ModelSurvey> survey;     ///< null until add_survey()
};

struct MadeModel {
  std::shared_ptr<const DualGraph> dual;  ///< null when the model is not fit to be unfolded
  MeshReport report;                      ///< of the mesh that came out, else of the file
  std::string refusal;                    ///< why it is not fit, one sentence with the cure; else empty
  std::vector<std::string> done;          ///< what the recipe did, whole sentences
  /// How far simplifying moved the surface, model units; none until it is measured (measure_deviation).
  std::optional<double> deviation = 0;
  double difficulty = 0;  ///< predicted_difficulty of the mesh
  Origins origins;        ///< which faces of the file went into which of the mesh
  /// Of each face that was merged of several: the file's faces of those (Recipe::apart takes such a group);
  /// else empty.
  IdVector<FaceId, std::vector<int>> groups;
  int n_moved = 0;        ///< corners moved as the recipe says; 0 when they could not be
  int n_faces_least = 0;  ///< what simplifying can reach; 0 when nothing was simplified
  std::shared_ptr<const ModelStages> stages;
  bool was_cancelled = false;
};

/// The folds of a merged mesh that need not be seen: flat within the tolerance for merging, where merging
/// would have bent a face. Not those of groups that were split again on purpose.
std::vector<EdgeId> hidden_folds(const Mesh& mesh, const Recipe& recipe);

/// The Hausdorff distance between the mesh and what it was before simplifying, model units. Up to 0.1 s at
/// thousands of faces, so that a slider cannot wait for it. When cancelled, the result means nothing.
double measure_deviation(const MadeModel& made, const Progress& progress);

/// Follows the recipe. `before` may be null; its stages are used again where they still fit. Never throws for
/// a bad model. With recipe.faces > 0 the simplifier is made (or taken over); that is the long part.
MadeModel make_model(const std::shared_ptr<const PolygonSoup>& source, const Recipe& recipe,
                     const std::shared_ptr<const ModelStages>& before, Progress& progress);

/// Looks at what there is to choose, unless the stages taken over know it; about as long as repairing takes.
void add_survey(MadeModel& model, Progress& progress);

}  // namespace netwright
