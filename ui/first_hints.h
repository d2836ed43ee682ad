// What people who are new here are told once, on a strip above the views; gone for good when they close it or
// do what it says.
#pragma once

#include "ui/ui_state.h"

namespace netwright {

/// 0 when there is nothing to be told.
float first_hint_height(UiContext& context, float width);
/// Into the present window.
void draw_first_hint(UiContext& context);

}  // namespace netwright
