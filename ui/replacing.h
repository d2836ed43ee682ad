// Another version of the model in the place of the present one.
#pragma once

#include <string>

#include "ui/ui_state.h"

namespace netwright {

/// Why the model cannot be replaced now, one sentence; empty when it can.
std::string needs_old_version(const UiContext& context);

/// To be called each frame: shows the list of what was kept when a new version has come.
void watch_replacement(UiContext& context);

}  // namespace netwright
