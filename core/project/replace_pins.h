// Pins and edits by hand for another version of the model, with an account of each.
#pragma once

#include <vector>

#include "core/project/match_meshes.h"
#include "core/project/project.h"
#include "core/project/replace_model.h"

namespace netwright {

/// Fills in the pins and edits of `next`, whose model is there, from those of `old`, and says in the report
/// what became of them.
void replace_pins(const Project& old, const MeshMatch& match, const ModelFrame& frame, Project& next,
                  ReplaceReport& report);

}  // namespace netwright
