// Files opened before, as menu and empty state offer them.
#pragma once

#include <filesystem>
#include <string>

#include "ui/ui_state.h"

namespace netwright {

/// Opens one of the recent files. One that is gone is told and forgotten.
void open_recent(UiContext& context, const std::filesystem::path& file);

/// The folder a file lies in, short enough for a menu: the home folder is "~", the middle of long ones "…".
std::string folder_text(const std::filesystem::path& file);

/// Where opening a file starts: the folder of the latest file whose folder is still there, else home.
std::filesystem::path latest_folder(const Settings& settings);

}  // namespace netwright
