// Where a search without a net was stuck, in the colours of both views: faces by how often they collided, and
// the corners there that have more than a full turn of faces around them.
#pragma once

#include "render/face_states.h"
#include "render/model_pose.h"
#include "render/overlay_renderer.h"
#include "ui/ui_state.h"

namespace netwright {

/// So many of the points are listed and marked, those with the largest share of the collisions.
inline constexpr std::size_t kMostExcessPoints = 24;

/// The heat map is wanted, and there is a search to tell about.
bool shows_heat(const UiContext& context);
/// 0 = hardly ever in collision, 1 = seldom, 2 = often, 3 = most often.
int heat_level(float heat);
/// Does nothing where the heat map is not shown.
void mark_heat(const UiContext& context, FaceStates& states);
/// Likewise. `net`: as it is drawn, null for none.
void add_excess_points(const UiContext& context, const ModelPose& pose, const Net* net, OverlayLines& lines);
/// Lights a point's faces in both views and lets the cameras fly there.
void show_excess_point(UiContext& context, VertexId vertex);

}  // namespace netwright
