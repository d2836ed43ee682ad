// Numbers of faces and edges over the picture of the net, where there is room for them.
#pragma once

#include <imgui.h>

#include "core/project/shown_net.h"
#include "render/camera.h"
#include "ui/ui_state.h"

namespace netwright {

/// `net` as it is drawn; `corner`: of the picture in the window. How many numbers were drawn: none when
/// everything is too small to read.
int draw_numbers(const UiState& ui, const Net& net, const IdVector<EdgeId, EdgeKind>& kinds,
                 const PanZoomCamera& camera, ImVec2 corner);

}  // namespace netwright
