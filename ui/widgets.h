// The few kinds of controls the interface is made of. Every one takes a name that tests use to find it (see
// WidgetLog), shows a tooltip, and says why when it is disabled.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ui/ui_state.h"

namespace netwright {

/// Notes the last item under a name; does nothing when nobody asked.
void note_widget(const UiState& ui, const std::string& name);

/// The last item may be pressed by keyboard, too: shows the ring and tells whether it was.
bool pressed_by_key(const UiState& ui, const std::string& name);

/// A tooltip for the last item, also when it is disabled.
void tooltip(const UiState& ui, const std::string& text);

enum class ButtonKind { Plain, Accent, Outlined, On };

struct ButtonSpec {
  std::string name;       ///< for tests and as ImGui's id
  std::string label;      ///< may be empty: icon only
  const char* icon = "";  ///< may be empty: label only
  std::string tip = {};
  ButtonKind kind = ButtonKind::Plain;
  bool is_enabled = true;
  float width = 0;   ///< 0: as wide as the content
  float height = 0;  ///< 0: the usual 32
};

/// True when pressed.
bool button(const UiState& ui, const ButtonSpec& spec);
/// How wide the button would be.
float button_width(const UiState& ui, const ButtonSpec& spec);

/// A header of the side panel's accordion: chevron, title, summary at the right. True when clicked.
bool section_header(const UiState& ui, const std::string& title, const std::string& summary, bool is_open);

/// "Seed      [ field" : the label at the left, the cursor placed for a control; returns the control's width.
float row(const UiState& ui, const char* label);

/// A slider with a thin track; t is 0…1. True while it is changed.
bool slim_slider(const UiState& ui, const std::string& name, float width, float& t, const std::string& tip,
                 bool is_enabled = true);

/// A box with a tick and its label. True when it was clicked; `is_on` is the new state then.
bool checkbox(const UiState& ui, const std::string& name, const std::string& label, bool& is_on,
              const std::string& tip);

/// Fills what is left of the window as a bar above the views that asks something: a sign and a text, which
/// wraps at this width. How far the text stands from the left and from the top:
inline constexpr float kBarTextLeft = 44;
inline constexpr float kBarPadding = 12;
void bar_background(const UiState& ui, const char* icon, const std::string& text, float wrap_width);

/// A thin bar, filled up to the fraction; as tall as a slider's track.
void progress_line(const UiState& ui, float width, double fraction);

/// Choices side by side, one of them on. True when another one was picked.
bool segments(const UiState& ui, const std::string& name, float width, const std::vector<std::string>& labels,
              int& chosen);

/// A field for a number, as wide as SetNextItemWidth said. True when a new one was entered: on Enter, Tab or
/// a click elsewhere, not at every key.
bool number_field(UiState& ui, const std::string& name, double& value, const char* format);
bool number_field(UiState& ui, const std::string& name, std::uint64_t& value);
/// The same for a length: shown and typed in the user's unit, kept in millimetres.
bool length_field(UiState& ui, const std::string& name, double& millimetres);

/// A field for words; `hint` stands in it while it is empty. True when new ones were entered.
bool text_field(UiState& ui, const std::string& name, std::string& words, const char* hint);

/// The line that opens and closes what most people leave alone; returns whether it is open.
bool more_header(const UiState& ui, const std::string& name, bool& is_open);

/// ImGui's BeginCombo in the looks of the rest, named for tests and reachable by keyboard; when true, fill it
/// and call ImGui::EndCombo.
bool begin_combo(const UiState& ui, const std::string& name, const std::string& shown);

void text_muted(const UiState& ui, const std::string& text);
void text_small(const UiState& ui, const std::string& text);
/// Text that cannot grow past `width`; the end is cut with an ellipsis.
std::string shortened(const std::string& text, float width);

}  // namespace netwright
