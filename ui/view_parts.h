// What both views have in common: the header with its toggles, and telling clicks from drags.
#pragma once

#include <imgui.h>

#include <initializer_list>
#include <optional>
#include <string>

#include "core/mesh/mesh.h"
#include "render/camera.h"
#include "render/palette.h"
#include "ui/actions.h"

namespace netwright {

/// Where a view lies in the window, in pixels.
struct ViewRect {
  ImVec2 min;
  ImVec2 size;
};

ImU32 to_u32(const Colour& colour);
const Palette& palette_of(const UiState& ui);

/// What a view's header says beside its title.
struct HeaderState {
  std::string whole;
  std::string brief;                  ///< where that does not fit; empty = as much of it as does
  std::optional<ActionId> idle = {};  ///< a switch that would change nothing in this view now,
  std::string why_idle = {};          ///< and why
};

/// Title, state and toggle buttons over the view's own background; height as view_header_height.
void view_header(UiContext& context, const std::string& name, const std::string& title,
                 const HeaderState& state, ImU32 back, std::initializer_list<ActionId> toggles);
float view_header_height(const UiState& ui);

/// What the mouse does on the picture of a view.
struct Gesture {
  bool is_hovered = false;
  ImVec2 pointer;           ///< relative to the picture's corner
  bool is_clicked = false;  ///< left, released without having moved
  bool is_double_clicked = false;
  bool is_pressed = false;  ///< left, in this frame
  int drag_button = -1;     ///< the button that drags, -1 for none
  ImVec2 drag;              ///< since the last frame
  float wheel = 0;
  bool is_adding = false;  ///< Shift is held: adds to the selection
  bool is_free = false;    ///< Ctrl is held: nothing snaps
};

/// An invisible button over the picture, named for tests; the cursor must stand at its corner.
Gesture picture_gesture(const UiState& ui, const std::string& name, ImVec2 size);

/// Turns the camera's distance and centre so that the model fills this share of the view as it is seen now.
void frame_model(OrbitCamera& camera, const Mesh& mesh, double share);

/// How much of a flight of the camera is done after so many seconds: 0…1, slow at both ends.
double flight_share(double seconds);

/// "Face 123", as people count: from 1.
std::string face_text(FaceId face);

}  // namespace netwright
