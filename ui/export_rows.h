// What can be set of exported files, each row only where it means something for the format.
#pragma once

#include "ui/ui_state.h"

namespace netwright {

/// The rows for the format of UiState::export_extension; each change is one undo step. `is_wide`: side by
/// side, as the dialog has room for.
void export_rows(UiContext& context, bool is_wide);

/// Whether a page with instructions goes with the sheets: for whatever has pages.
void instructions_row(UiContext& context, bool is_wide);

}  // namespace netwright
