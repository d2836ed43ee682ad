// What can be done with finished runs and with the history, for the table of actions: conditions and effects.
// Reasons are whole sentences, because tooltips show them.
#pragma once

#include <string>

#include "ui/ui_state.h"

namespace netwright {

std::string needs_runs(const UiContext& c);
std::string needs_viewed_run(const UiContext& c);
/// A run is looked at whose net may become the project's.
std::string needs_acceptable_run(const UiContext& c);
/// A run of the present mesh has a proved net.
std::string needs_proved_run(const UiContext& c);
/// A run is looked at whose moves can be played.
std::string needs_timeline(const UiContext& c);
std::string needs_history(const UiContext& c);

/// The list shows the newest run on top; these go one line up or down, beginning at the project's own.
void view_newer_run(UiContext& c);
void view_older_run(UiContext& c);
void leave_run(UiContext& c);
void accept_viewed_run(UiContext& c);
/// Looks at the neighbour next, if there is one.
void delete_viewed_run(UiContext& c);
void export_best_run(UiContext& c);

void play_or_hold(UiContext& c);
bool is_playing(const UiContext& c);
std::string play_label(const UiContext& c);
void move_back(UiContext& c);
void move_on(UiContext& c);

void show_history(UiContext& c);

/// "run 3", as people call it.
std::string run_name(int number);

}  // namespace netwright
