// What the interface knows beside the Session: selection, hover, which dialog is open, what is shown, what
// the user is being told. Panels and views take (Session&, UiState&); nothing of it is part of a Project.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/ids.h"
#include "core/project/session.h"
#include "ui/overlap_list.h"
#include "ui/settings.h"
#include "ui/swing.h"
#include "ui/theme.h"
#include "ui/widget_log.h"

namespace netwright {

class KeyFocus;
class RunPictures;

enum class Dialog {
  None,
  Open,
  Export,
  Keys,
  About,
  Repair,
  Save,
  Unsaved,
  Recover,
  Preferences,
  Replace,
  Print
};

/// How far the net is folded up in the model's view.
struct Folding {
  double amount = 1;  ///< 0 flat … 1 the model
  bool is_playing = false;
  bool goes_up = false;  ///< where it plays, and played last
};

/// A point of the paper: on a face, in the face's own flat frame.
struct PaperPoint {
  FaceId face;
  glm::dvec2 flat{0};
  HalfedgeId side;  ///< the edge it was snapped to; invalid for corners and free points
  [[nodiscard]] bool is_valid() const { return face.is_valid(); }
};

/// The measuring tool.
struct Measuring {
  bool is_on = false;
  PaperPoint hovered;
  std::vector<PaperPoint> points;  ///< clicked: none, one or two
};

/// The tool that joins and cuts by hand, and what it would do where the pointer is.
struct Editing {
  bool is_on = false;
  HalfedgeId side = {};  ///< the edge the edit is about
  bool is_strip = false;
  FaceId branch = {};                   ///< being dragged; invalid while none is
  std::vector<HalfedgeId> places = {};  ///< where it could hang
  std::uint64_t version = 0;            ///< of the net it was worked out for
  std::optional<HandEdit> edit = {};
  std::shared_ptr<const ShownNet> preview = {};  ///< the net after it
};

/// The tool that arranges pieces on the page, and what it has in its hand.
struct Arranging {
  enum class Grip { None, Move, Turn };
  bool is_on = false;
  Grip grip = Grip::None;
  int hovered = -1;                               ///< piece
  std::vector<int> pieces = {};                   ///< held, or moved and waiting for their new pages
  std::shared_ptr<const ShownNet> shown = {};     ///< of this net,
  std::shared_ptr<const PageLayout> layout = {};  ///< on these pages;
  std::vector<Box2> boxes = {};                   ///< of all pieces there, in the net's view,
  Box2 box = {};                                  ///< and of those held
  std::vector<double> levels = {};                ///< turns that lay an edge of theirs level
  glm::dvec2 from{0};                             ///< where the hand took hold
  bool has_motion = false;
  Rigid2 motion = {};                                ///< what they do in the net's view,
  HandLayout goal = {};                              ///< how they would lie then,
  std::vector<FaceId> misplaced = {};                ///< and which faces badly
  std::array<std::optional<double>, 2> guides = {};  ///< x and y at which something snapped
  std::uint64_t version = 0;                         ///< changes with the motion
};

/// The tool for glue tabs.
struct Tabbing {
  bool is_on = false;
  HalfedgeId side = {};  ///< of the cut under the pointer
  HalfedgeId tab = {};   ///< the side whose tab is under the pointer
  HalfedgeId held = {};  ///< the side whose tab was pressed
  bool is_dragging = false;
  double width_mm = 0;  ///< while it is dragged
};

/// The gluing order of the net that it was worked out for, and its numbers with the settings they were made
/// by.
struct Assembly {
  std::uint64_t version = 0;
  bool is_known = false;
  std::vector<EdgeId> order = {};
  std::uint64_t numbers_version = 0;
  bool skips_obvious = false;
  std::vector<EdgeId> tabless = {};
  IdVector<EdgeId, int> numbers = {};  ///< as printed; 0 for cuts without; empty before they are asked for
};

struct Toast {
  std::string text;
  bool is_good = true;
  double until = 0;  ///< on the clock of UiState::now
};

struct UiContext;

/// The line of the model's report that is lit in the views, and what it is about.
struct Lit {
  std::optional<std::size_t> line;  ///< the file's lines count on from the report's
  std::vector<FaceId> faces;
  std::vector<EdgeId> edges;                        ///< those that the mesh has
  std::vector<std::array<glm::dvec3, 2>> segments;  ///< edges that the mesh has no more
  std::vector<glm::dvec3> points;
};

struct UiState {
  Look look;
  Settings settings;
  WidgetLog* widgets = nullptr;
  bool is_desktop_dark = false;
  bool is_motion_reduced = false;  ///< the desktop asks for it: nothing flies

  std::function<void()> wake;  ///< ends the loop's sleep; other threads may call it

  double now = 0;                 ///< seconds, set by the application before each frame
  double chore_since = 0;         ///< when the chore in hand began
  std::string chore_phase;        ///< what it is doing,
  double chore_phase_since = 0;   ///< and since when
  bool has_room_for_side = true;  ///< a narrow window belongs to the views
  FaceId hovered;                 ///< under the pointer, in whichever view
  HalfedgeId hovered_side;        ///< the edge near the pointer, from the face whose side it was pointed at
  // Changed by the functions of ui/selection.h alone.
  FaceId selected;                     ///< clicked last
  HalfedgeId selected_side;            ///< the edge clicked last, from the side it was clicked at
  std::vector<FaceId> selected_faces;  ///< all of them, sorted
  std::vector<EdgeId> selected_edges;
  Lit lit;  ///< gone with the mesh
  /// The part of the model under the pointer in the list of parts, and its faces; gone with the mesh.
  std::optional<std::size_t> hovered_part;
  std::vector<FaceId> hovered_part_faces;
  Folding folding;
  Measuring measuring;
  Editing editing;
  Arranging arranging;
  Tabbing tabbing;
  Assembly assembly;
  PrintJob printing;               ///< as the print dialog has it
  std::optional<SwingWish> swing;  ///< a join was made: the net that comes swings over
  OverlapList overlaps;
  std::optional<Overlap> shown_overlap;  ///< lit in both views; gone with the mesh
  std::string hint;                      ///< what the thing under the pointer does; rebuilt every frame

  Dialog dialog = Dialog::None;
  std::string export_extension = "pdf";  ///< preset of the export dialog
  int export_run = 0;                    ///< whose net it writes; 0 = the project's

  /// What waits until the question about unsaved changes is answered; empty when nothing does.
  std::function<void(UiContext&)> leaving;
  bool leaves_when_saved = false;     ///< it goes on when the save in hand is done
  bool has_offered_recovery = false;  ///< once a start; later the menu has it

  std::string error;  ///< on the bar above the views; empty when there is none
  std::deque<Toast> toasts;
  double toasts_held_at = -1;  ///< the last frame a dialog held the toasts back; negative while none does

  std::shared_ptr<const ReplaceReport> seen_replacement;    ///< the list of it was opened,
  std::shared_ptr<const ReplaceReport> closed_replacement;  ///< and that of this one closed
  std::shared_ptr<const Trouble> closed_trouble;            ///< the bar about it was closed
  double asked_height_mm = 0;  ///< what stands in the field of the question about the size; 0 = the usual
  RunPictures* run_pictures = nullptr;  ///< the workspace's
  KeyFocus* focus = nullptr;            ///< the workspace's
  bool wants_run_in_view = false;       ///< scroll the list of runs to the one that is looked at
  std::size_t history_seen = 0;         ///< the step that the history was last scrolled to

  std::uint64_t draft = 0;      ///< bits of the number being typed, until the field is left
  std::string draft_words;      ///< likewise
  std::string draft_colour_of;  ///< the line whose colour is being picked; empty while none is
  std::array<float, 3> draft_colour{};
  bool is_more_tabs_open = false;
  bool is_more_print_open = false;

  // Wishes of actions, fulfilled by the views in the next frame.
  bool wants_frame_model = false;
  bool wants_frame_net = false;
  bool wants_home = false;
  bool wants_frame_desk = false;  ///< the net's view shows all sheets, not the net alone
  FaceId wants_centre;            ///< becomes centre_now at the next frame, for both views alike
  FaceId centre_now;
  std::vector<FaceId> wants_flight;  ///< becomes flight_now at the next frame: both views fly to these faces
  std::vector<FaceId> flight_now;
  float faces_slider_width = 0;    ///< of the simplify slider
  bool is_dragging_faces = false;  ///< the simplify slider is held: nothing around it may jump
  bool wants_lit_in_view = false;  ///< fly to what is lit
  bool wants_menus = false;        ///< open the first one
  bool wants_quit = false;
  bool wants_new_fonts = false;  ///< scale changed
  int frames_wanted = 0;         ///< more frames to draw although nothing happens
};

/// One frame's worth of what every action and panel may touch.
struct UiContext {
  Session& session;
  UiState& ui;
};

}  // namespace netwright
