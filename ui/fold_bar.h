// The strip under the model's view: folds the net up from the flat paper to the model and back.
#pragma once

#include "ui/ui_state.h"

namespace netwright {

/// As high as the legend under the net.
float fold_bar_height(const UiState& ui);
/// At the cursor, over the whole width.
void draw_fold_bar(UiContext& context);

}  // namespace netwright
