// The tool that joins and cuts by hand: click a cut and its sides join, click a fold and it is cut, drag a
// face and the branch that begins there hangs elsewhere. What would happen is shown before it does.
#pragma once

#include "render/edge_picker.h"
#include "ui/view_parts.h"

namespace netwright {

/// What the pointer does while the tool is on; the same in both views. `net` (may be null) is the net as it
/// is drawn and `at` the pointer in its plane, where the view is the net's own.
void take_edit(UiContext& context, const Pointed& pointed, const Gesture& gesture, const Net* net,
               const glm::dvec2* at);

/// Lets go of the tool.
void end_editing(UiState& ui);

}  // namespace netwright
