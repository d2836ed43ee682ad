// Another version of the model in the place of the one a project was made for: recipe, pins, edits by hand
// and as much of the net as is still there go over to it.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/mesh_report.h"
#include "core/project/match_meshes.h"
#include "core/project/project.h"

namespace netwright {

/// What came of the old project's work.
struct ReplaceReport {
  int n_pins = 0;        ///< the root, pinned edges and patches that there were:
  int n_kept = 0;        ///< where they were,
  int n_moved = 0;       ///< on the nearest face or edge,
  int n_lost = 0;        ///< gone
  int n_folds = 0;       ///< of the old net,
  int n_folds_kept = 0;  ///< and those of them that the search starts with
  std::string summary;   ///< one sentence
  /// All of it in whole sentences. What moved is a notice with the new places, what was lost a problem with
  /// the places where it was, in the coordinates of the new model.
  std::vector<MeshReport::Line> lines;
};

struct Replacement {
  /// With paper, size and seed of the old one, and without a tree. When `refusal` says that the new model
  /// is not fit, source and made are all there is.
  Project project;
  /// The folds that are left of the old net, as a forest to search on from; null when there was no net.
  std::shared_ptr<const UnfoldTree> start;
  ReplaceReport report;
  std::string refusal;
};

/// `source` is what the new file held. Steps of the recipe that speak of faces of the old file (parts left
/// out, groups split again) are found again or left away, and the report says so; `repairs`, where given,
/// takes the place of the recipe's own for repairs and uneven faces. Pins that contradict each other on the
/// new faces, and did not before, are let go of. Reads nothing and searches nothing; as long as making the
/// model takes, and some. The old project must have a model; when cancelled, the result means nothing.
Replacement replace_model(const Project& old, std::filesystem::path path,
                          std::shared_ptr<const PolygonSoup> source, const std::optional<Recipe>& repairs,
                          Progress& progress);

}  // namespace netwright
