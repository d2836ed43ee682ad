// The strip under the net that says what its lines and colours mean.
#pragma once

#include "ui/ui_state.h"

namespace netwright {

float legend_height(const UiState& ui);

/// Fills the rest of the present window's width; only what can be seen now is explained. `shown` may be null.
/// `is_printed`: the net is seen in the lines that it is printed in.
void draw_legend(const UiContext& context, const ShownNet* shown, bool is_printed);

}  // namespace netwright
