// The strip under the net with which one goes back and forth through the moves of a finished run.
#pragma once

#include "ui/ui_state.h"

namespace netwright {

/// 0 while no run with moves is looked at.
float timeline_height(const UiContext& context);

/// Fills the rest of the present window's width; nothing while its height is 0.
void draw_timeline(UiContext& context);

/// The speed slider of a run of so many pictures: 0 is one move a second, 1 all of it in two seconds.
double play_speed_of_slider(double t, int n_steps);
double slider_of_play_speed(double moves_per_second, int n_steps);

}  // namespace netwright
