// What is pointed out over both views in this frame: pins and those that contradict each other, hovered and
// selected edges, and for cuts the way from one side to the other.
#pragma once

#include "render/model_pose.h"
#include "render/overlay_renderer.h"
#include "ui/ui_state.h"

namespace netwright {

/// `net`: as it is drawn, with the kinds of its edges; both null when there is none.
OverlayLines overlay_of(const UiState& ui, const ModelPose& pose, const Net* net,
                        const IdVector<EdgeId, EdgeKind>* kinds, const Constraints& pins,
                        const Contradiction* contradiction);

}  // namespace netwright
