// The question how tall a model shall be whose file makes it smaller than a thumb or larger than a person.
#pragma once

#include "ui/ui_state.h"

namespace netwright {

/// The bar's height for a width; 0 when there is nothing to ask.
float size_bar_height(const UiContext& context, float width);
/// Draws it into the present window.
void draw_size_bar(UiContext& context);

}  // namespace netwright
