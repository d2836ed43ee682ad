// The old project's recipe for the new file: what it says of single faces and parts is found again there.
#pragma once

#include <memory>
#include <vector>

#include "core/project/match_meshes.h"
#include "core/project/project.h"

namespace netwright {

struct CarriedRecipe {
  Recipe recipe;
  std::vector<MeshReport::Line> lines;  ///< what could not be found again
};

/// `wanted` is the old recipe without left_out and apart; `made` the new model by it, for its stages.
CarriedRecipe carry_recipe(const Project& old, const Recipe& wanted, const MadeModel& made,
                           const ModelFrame& frame);

}  // namespace netwright
