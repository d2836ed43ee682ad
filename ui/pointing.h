// What the pointer does with faces and edges, the same in both views: hover, click, double-click, and the
// line in the status bar that says so.
#pragma once

#include <string>

#include "render/edge_picker.h"
#include "ui/view_parts.h"

namespace netwright {

/// How near the pointer must be to an edge to mean it, in pixels.
[[nodiscard]] double edge_reach(const UiState& ui);

/// `ground_hint`: what can be done where nothing is.
void take_pointer(UiContext& context, const Pointed& pointed, const Gesture& gesture,
                  const std::string& ground_hint);

/// While a rubber band is drawn.
std::string band_hint(const UiState& ui);

}  // namespace netwright
