// How bars above the views that ask something are laid out: a sentence, and controls beside it where there is
// room for both, else below it.
#pragma once

#include <string>

#include "ui/ui_state.h"

namespace netwright {

inline constexpr float kBarGap = 8;             ///< between controls
inline constexpr float kBarControlHeight = 32;  ///< of all of them

struct BarContent {
  const char* icon;
  std::string text;
  float controls_width;  ///< pixels, gaps included
};

/// How high the bar is in a window of that width.
float bar_height(const UiState& ui, const BarContent& content, float width);

/// Fills what is left of the window with sign and text; the first control comes where the cursor is then.
void begin_bar(const UiState& ui, const BarContent& content);

}  // namespace netwright
