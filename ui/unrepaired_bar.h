// What there is to see when the repair of a broken file was undone: that it is open, why it cannot be
// unfolded, and the way back to the question.
#pragma once

#include "ui/ui_state.h"

namespace netwright {

/// The bar's height for a width; 0 when the open file needs no repair.
float unrepaired_bar_height(const UiContext& context, float width);
/// Draws it into the present window.
void draw_unrepaired_bar(UiContext& context);

}  // namespace netwright
