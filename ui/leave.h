// Whatever takes the present project away asks first when something in it is unsaved: quitting, opening
// another file, a dropped one, a sample, recovered work.
#pragma once

#include <filesystem>
#include <functional>

#include "ui/ui_state.h"

namespace netwright {

/// Does `next` at once, or after the question about unsaved changes was answered; not at all when the user
/// stays.
void leave(UiContext& context, std::function<void(UiContext&)> next);

/// A model or project in the place of the present one.
void open_file(UiContext& context, const std::filesystem::path& file);
void ask_to_quit(UiContext& context);

/// To the project's file, or asks for one.
void save_project_of(UiContext& context);

/// To be called each frame: goes on with what waits for a save to be done.
void watch_leaving(UiContext& context);

/// What the project is called: its file, else its model.
std::string project_name(const Session& session);

}  // namespace netwright
