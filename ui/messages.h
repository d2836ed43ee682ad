// What the user is told: good news in a corner for a few seconds, errors on a bar above the views until
// closed.
#pragma once

#include "ui/ui_state.h"

namespace netwright {

/// Takes the session's messages over into the state.
void take_messages(UiContext& context);

/// The error bar's height for a width; 0 when there is no error.
float error_bar_height(const UiState& ui, float width);
/// Draws it into the present window.
void draw_error_bar(UiState& ui);

/// Toasts at the bottom right of a rectangle; none while a dialog is open.
void draw_toasts(UiState& ui, ImVec2 bottom_right);

}  // namespace netwright
