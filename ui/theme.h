// Colours, fonts and sizes of the interface, for the light and the dark theme at any scale. The pictures' own
// colours (tree, root, overlap …) are render/palette.h.
#pragma once

#include <imgui.h>

#include <cmath>

namespace netwright {

enum class ThemeChoice { System, Light, Dark };

/// What the frame around the two views is painted with.
struct Colours {
  bool is_dark = false;
  ImU32 bar = 0;    ///< menu bar, toolbar, side panel, status bar
  ImU32 field = 0;  ///< inputs, popups
  ImU32 border = 0;
  ImU32 text = 0;
  ImU32 muted = 0;  ///< secondary text, still 4.5:1
  ImU32 faint = 0;  ///< disabled
  ImU32 hover = 0;  ///< behind a hovered button
  ImU32 accent = 0;
  ImU32 accent_hover = 0;
  ImU32 on_accent = 0;  ///< text on the accent colour
  ImU32 tint = 0;       ///< behind a toggle that is on
  ImU32 on_tint = 0;
  ImU32 good = 0;
  ImU32 bad = 0;
  ImU32 bad_back = 0;  ///< behind an error message
};

struct Fonts {
  ImFont* text = nullptr;   ///< Inter 15 px
  ImFont* bold = nullptr;   ///< Inter SemiBold 15 px
  ImFont* small = nullptr;  ///< Inter 13 px
  ImFont* title = nullptr;  ///< Inter SemiBold 22 px
};

/// Everything a widget needs to know about how it looks.
struct Look {
  Colours colours;
  Fonts fonts;
  float scale = 1;
  /// A length of the design (at 100 %) in whole pixels.
  [[nodiscard]] float px(float length) const { return std::round(length * scale); }
};

Colours colours_of(bool is_dark);

/// Does the desktop ask for dark windows? Read from GTK's settings; false when nothing is said.
bool desktop_prefers_dark();

/// Does the desktop ask for no animations? From the same settings; false when nothing is said.
bool desktop_reduces_motion();

/// Fills the font atlas of the present ImGui context for a scale; all figures of a font become equally wide.
/// The window uploads the texture afterwards.
Fonts load_fonts(float scale);

/// Sets ImGui's own style to the look.
void apply_style(const Look& look);

}  // namespace netwright
