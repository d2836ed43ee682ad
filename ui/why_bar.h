// What is said above the views when a search ended without a net: that it did, and the ways on, each one
// click.
#pragma once

#include "ui/ui_state.h"

namespace netwright {

/// The bar's height for a width; 0 when there is nothing to tell or it was closed.
float why_bar_height(const UiContext& context, float width);
/// Draws it into the present window.
void draw_why_bar(UiContext& context);

}  // namespace netwright
