// Lighting what a line of the report is about, in both views.
#pragma once

#include <cstddef>

#include "render/model_pose.h"
#include "ui/ui_state.h"

namespace netwright {

/// Lights the culprits of a line and lets the camera fly there; a line that is lit already goes out.
void light(UiContext& context, std::size_t index, const MeshReport::Line& line);
void clear_lit(UiState& ui);

/// A box around all that is lit.
Box3 lit_box(const Lit& lit, const ModelPose& pose);

/// Where it is seen from best; zero when it has no side of its own.
glm::dvec3 lit_side(const Lit& lit, const ModelPose& pose);

}  // namespace netwright
