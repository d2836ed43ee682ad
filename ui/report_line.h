// One line of a report in the side panel.
#pragma once

#include <cstddef>
#include <string>

#include "ui/ui_state.h"

namespace netwright {

/// Pressing a line that names places lights them in both views and turns the model to them. `index` tells the
/// lines of all reports apart (Lit::line), `name` is the widget's.
void report_line(UiContext& context, std::size_t index, const MeshReport::Line& line,
                 const std::string& name);

}  // namespace netwright
