// The frame around the views: menu bar, toolbar, the slim bar of long work, status bar. All of it is made
// from the table of actions and the session's figures.
#pragma once

#include "ui/ui_state.h"

namespace netwright {

/// Draws ImGui's main menu bar; its height.
float draw_menu_bar(UiContext& context);

/// Into the present window, one line high; labels are dropped where they do not fit.
void draw_toolbar(UiContext& context);

/// Is something running that a person should see the progress of?
bool has_progress(const UiContext& context);
void draw_progress(UiContext& context);

void draw_status_bar(UiContext& context);

}  // namespace netwright
