// The table of actions, their conditions and effects. Reasons are whole sentences, because tooltips show
// them.
#include "ui/actions.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "assets/icons.h"
#include "ui/arranging.h"
#include "ui/assembly.h"
#include "ui/editing.h"
#include "ui/leave.h"
#include "ui/measure.h"
#include "ui/pinning.h"
#include "ui/replacing.h"
#include "ui/run_actions.h"
#include "ui/selection.h"
#include "ui/tab_tool.h"

namespace netwright {
namespace {

constexpr int kShiftBit = 1;
constexpr int kControlBit = 2;
constexpr int kSpaceKey = 32;
constexpr int kEscapeKey = 256;
constexpr int kEnterKey = 257;
constexpr int kDeleteKey = 261;
constexpr int kRightKey = 262;
constexpr int kLeftKey = 263;
constexpr int kPageUpKey = 266;
constexpr int kPageDownKey = 267;
constexpr int kHomeKey = 268;
constexpr int kF1Key = 290;
constexpr double kToastSeconds = 5;

bool is_busy(const UiContext& c) {
  const RunState state = c.session.state();
  return state == RunState::Running || state == RunState::Paused || state == RunState::Replaying;
}

std::string always(const UiContext& /*c*/) { return {}; }

std::string needs_model(const UiContext& c) { return c.session.has_model() ? "" : "Open a model first."; }

std::string needs_unsaved(const UiContext& c) {
  if (!c.session.has_model()) return "Open a model first.";
  return c.session.is_modified() || c.session.file().empty() ? "" : "Everything is saved.";
}

std::string needs_leftovers(const UiContext& c) {
  return c.session.leftovers().empty() ? "There is no unsaved work to recover." : "";
}

std::string needs_sheets(const UiContext& c) {
  if (!c.session.has_model()) return "Open a model first.";
  if (is_busy(c)) return "The search is still running; the best run so far can be exported from the runs.";
  if (c.session.viewed_run() != 0 && c.session.viewed_run() != c.session.accepted_run())
    return c.session.shown()->overlaps.empty() ? "" : "This run has overlaps left.";
  if (c.session.sheets() != nullptr) return "";
  const auto shown = c.session.shown();
  if (shown == nullptr || !shown->is_proved) return "Unfold the model into one piece first (Space).";
  if (const Misplaced* const wrong = c.session.misplaced()) return misplaced_sentence(*wrong);
  return c.session.is_laying_out() ? "The pages are still being laid out."
                                   : "The net has no pages: see to paper and margins.";
}

std::string needs_project_sheets(const UiContext& c) {
  const int viewed = c.session.viewed_run();
  const bool is_own = viewed == 0 || viewed == c.session.accepted_run();
  return is_own ? needs_sheets(c) : "Use this run's net first: the cutter gets the project's.";
}

/// Runs that are only looked at are not printed.
std::string needs_own_sheets(const UiContext& c) {
  const std::string reason = needs_sheets(c);
  return reason.empty() && c.session.sheets() == nullptr ? "Only the project's own net is printed." : reason;
}

std::string needs_width(const UiContext& c) {
  return c.ui.has_room_for_side ? "" : "The window is too narrow for the side panel.";
}

std::string needs_undo(const UiContext& c) { return c.session.can_undo() ? "" : "There is nothing to undo."; }
std::string needs_redo(const UiContext& c) { return c.session.can_redo() ? "" : "There is nothing to redo."; }

std::string needs_no_replay(const UiContext& c) {
  if (!c.session.has_model()) return "Open a model first.";
  return c.session.state() == RunState::Replaying ? "Wait for the end of the replay, or skip it (Esc)." : "";
}

std::string needs_run(const UiContext& c) { return is_busy(c) ? "" : "Nothing is running."; }

std::string needs_replay(const UiContext& c) {
  return c.session.state() == RunState::Replaying ? "" : "No replay is running.";
}

FaceId chosen_face(const UiContext& c) { return c.ui.hovered.is_valid() ? c.ui.hovered : c.ui.selected; }

std::string needs_face(const UiContext& c) {
  if (!c.session.has_model()) return "Open a model first.";
  return chosen_face(c).is_valid() ? "" : "Click a face first, or point at one and press the key.";
}

std::string needs_face_or_pin(const UiContext& c) {
  return c.session.project().pins.root.is_valid() ? "" : needs_face(c);
}

std::string needs_selection(const UiContext& c) { return has_selection(c.ui) ? "" : "Nothing is selected."; }

std::string needs_looks(const UiContext& c) {
  const auto& dual = c.session.project().dual;
  return dual != nullptr && dual->mesh().materials().empty() ? "The model has neither colours nor pictures."
                                                             : "";
}

void ask_export(UiContext& c, const char* extension) {
  c.ui.export_extension = extension;
  const int viewed = c.session.viewed_run();
  c.ui.export_run = viewed == c.session.accepted_run() ? 0 : viewed;
  c.ui.dialog = Dialog::Export;
}

void unfold_or_pause(UiContext& c) {
  switch (c.session.state()) {
    case RunState::Running:
      c.session.pause();
      break;
    case RunState::Replaying:
      c.session.skip_replay();
      break;
    default:
      c.session.unfold();
      break;
  }
}

std::string unfold_label(const UiContext& c) {
  switch (c.session.state()) {
    case RunState::Running:
      return "Pause";
    case RunState::Paused:
      return "Resume";
    case RunState::Replaying:
      return "Skip";
    default:
      return "Unfold";
  }
}

void stop_or_skip(UiContext& c) {
  if (c.session.state() == RunState::Replaying) {
    c.session.skip_replay();
  } else {
    c.session.stop();
  }
}

void pin_root(UiContext& c) {
  const FaceId face = chosen_face(c);
  c.session.pin_root(face == c.session.project().pins.root ? FaceId() : face);
}

std::string root_label(const UiContext& c) {
  const FaceId face = chosen_face(c);
  const FaceId pinned = c.session.project().pins.root;
  return pinned.is_valid() && (!face.is_valid() || face == pinned) ? "Unpin root" : "Pin root";
}

std::string undo_label(const UiContext& c) { return c.session.undo_label(); }
std::string redo_label(const UiContext& c) { return c.session.redo_label(); }

void frame_all(UiContext& c) { c.ui.wants_frame_model = c.ui.wants_frame_net = true; }

void show_all(UiContext& c) {
  c.ui.wants_home = c.ui.wants_frame_desk = true;
  frame_all(c);
}

std::string needs_net(const UiContext& c) {
  if (!c.session.has_model()) return "Open a model first.";
  return c.session.shown() == nullptr ? "Unfold the model first (Space)." : "";
}

std::string needs_still_net(const UiContext& c) {
  const std::string reason = needs_net(c);
  return reason.empty() && is_busy(c) ? "A search is running: wait for it or stop it (Esc)." : reason;
}

constexpr double kFoldStep = 0.05;

void play_fold(UiContext& c) {
  Folding& folding = c.ui.folding;
  folding.is_playing = !folding.is_playing;
  if (folding.amount >= 1) folding.goes_up = false;
  if (folding.amount <= 0) folding.goes_up = true;
}

std::string play_label(const UiContext& c) {
  const Folding& folding = c.ui.folding;
  if (folding.is_playing) return "Stop folding";
  const bool goes_up = folding.amount <= 0 || (folding.amount < 1 && folding.goes_up);
  return goes_up ? "Fold up" : "Fold flat";
}

void toggle_editing(UiContext& c) {
  const bool was_on = c.ui.editing.is_on;
  end_tab_tool(c.ui);
  end_measure(c.ui);
  end_editing(c.ui);
  end_arranging(c.ui);
  c.ui.editing.is_on = !was_on;
}

std::string rest_label(const UiContext& c) {
  return c.session.has_hand_edits() ? "Solve the rest" : "Unfold from here";
}

void toggle_measure(UiContext& c) {
  end_tab_tool(c.ui);
  end_editing(c.ui);
  end_arranging(c.ui);
  const bool was_on = c.ui.measuring.is_on;
  c.ui.measuring = Measuring();
  c.ui.measuring.is_on = !was_on;
}

void fold_by(UiContext& c, double step) {
  c.ui.folding.is_playing = false;
  c.ui.folding.amount = std::clamp(c.ui.folding.amount + step, 0.0, 1.0);
}

void show_report(UiContext& c) {
  c.ui.settings.is_side_open = true;
  c.ui.settings.is_open(Section::Model) = true;
}

constexpr int kUsualFaces = 400;  ///< what scissors and an evening can cope with

std::string needs_more_faces(const UiContext& c) {
  if (!c.session.has_model()) return "Open a model first.";
  if (c.session.n_faces_before_simplifying() <= kUsualFaces)
    return "The model has no more than 400 faces as it is.";
  return c.session.wanted_recipe().faces == kUsualFaces ? "The model is simplified to 400 faces already."
                                                        : "";
}

std::string needs_simplified(const UiContext& c) {
  if (!c.session.has_model()) return "Open a model first.";
  return c.session.wanted_recipe().faces == 0 ? "The model has all its faces." : "";
}

void toggle_merging(UiContext& c) {
  Recipe recipe = c.session.wanted_recipe();
  recipe.merges = !recipe.merges;
  c.session.set_recipe(recipe, recipe.merges ? "merge faces" : "keep faces apart");
}

bool is_merging(const UiContext& c) { return c.session.has_model() && c.session.wanted_recipe().merges; }

/// The group that the face was merged into, or that it was split off: faces of the file.
std::vector<int> group_of(const UiContext& c, FaceId face) {
  const Project& project = c.session.project();
  const std::size_t group = group_apart(project.recipe, project.dual->mesh().face_source(face));
  if (group < project.recipe.apart.size()) return project.recipe.apart[group];
  return project.made->groups.empty() ? std::vector<int>() : project.made->groups[face];
}

bool is_split(const UiContext& c, FaceId face) {
  const std::vector<int> group = group_of(c, face);
  return !group.empty() && group_apart(c.session.recipe(), group.front()) < c.session.recipe().apart.size();
}

std::string needs_merged_face(const UiContext& c) {
  if (std::string reason = needs_face(c); !reason.empty()) return reason;
  if (!c.session.recipe().merges) return "Merge the faces of one plane first (M).";
  if (c.session.is_making()) return "The model is still being made.";
  return !group_of(c, chosen_face(c)).empty() ? "" : "This face was not merged of several ones.";
}

void split_or_merge_face(UiContext& c) {
  Recipe recipe = c.session.wanted_recipe();
  std::vector<int> group = group_of(c, chosen_face(c));
  const bool was_split = is_split(c, chosen_face(c));
  if (was_split) {
    std::erase(recipe.apart, group);
  } else {
    recipe.apart.push_back(std::move(group));
  }
  c.session.set_recipe(recipe, was_split ? "merge face" : "split face");
}

std::string split_label(const UiContext& c) {
  const FaceId face = chosen_face(c);
  const bool was_split = c.session.has_model() && face.is_valid() && is_split(c, face);
  return was_split ? "Merge this face again" : "Split this face again";
}

template <Align Where>
void align(UiContext& c) {
  align_chosen(c, Where);
}

std::string needs_failure(const UiContext& c) {
  return c.session.trouble() == nullptr ? "No search has ended without a net." : "";
}

std::string needs_pins_to_try(const UiContext& c) {
  if (c.session.trouble() == nullptr) return "No search has ended without a net.";
  if (c.session.project().pins.are_free()) return "Nothing is pinned.";
  if (c.session.trouble()->is_impossible) return "It is proved that no pin is to blame.";
  return c.session.trial() != nullptr ? "Something is being tried already." : "";
}

std::string needs_trial(const UiContext& c) {
  if (c.session.trouble() == nullptr) return "No search has ended without a net.";
  return c.session.trial() != nullptr ? "Something is being tried already." : "";
}

void open_why(UiContext& c) {
  c.ui.settings.is_side_open = true;
  c.ui.settings.is_open(Section::Why) = true;
}

void ask_why(UiContext& c) {
  open_why(c);
  c.ui.settings.show_heat = true;
}

void find_releases_of_pins(UiContext& c) {
  open_why(c);
  c.session.look_for_releases();
}

template <bool Settings::*Flag>
void toggle(UiContext& c) {
  c.ui.settings.*Flag = !(c.ui.settings.*Flag);
}
template <bool Settings::*Flag>
bool is_set(const UiContext& c) {
  return c.ui.settings.*Flag;
}

// clang-format off
const auto kActions = std::to_array<Action>({
    {ActionId::Open, "Open…", icon::kOpen, {'O', kControlBit}, "Opens a model or a project", always,
     [](UiContext& c) { c.ui.dialog = Dialog::Open; }, nullptr, nullptr},
    {ActionId::ReplaceModel, "Replace model…", icon::kImport, {'R', kControlBit},
     "Loads a changed version of the model and keeps pins, net and settings", needs_old_version,
     [](UiContext& c) { c.ui.dialog = Dialog::Replace; }, nullptr, nullptr},
    {ActionId::Save, "Save", icon::kSave, {'S', kControlBit}, "Saves model, net and settings as a project",
     needs_unsaved, save_project_of, nullptr, nullptr},
    {ActionId::SaveAs, "Save as…", "", {'S', kControlBit | kShiftBit}, "Saves the project under another name",
     needs_model, [](UiContext& c) { c.ui.dialog = Dialog::Save; }, nullptr, nullptr},
    {ActionId::Recover, "Recover unsaved work…", "", {}, "Opens what was not saved before Netwright ended",
     needs_leftovers, [](UiContext& c) { c.ui.dialog = Dialog::Recover; }, nullptr, nullptr},
    {ActionId::PrintPages, "Print…", icon::kPrint, {'I', kControlBit}, "Sends sheets to a printer at true size",
     needs_own_sheets, [](UiContext& c) { c.ui.dialog = Dialog::Print; }, nullptr, nullptr},
    {ActionId::ExportPdf, "Export PDF…", icon::kPrint, {'P', kControlBit}, "Writes the pages for the printer",
     needs_sheets, [](UiContext& c) { ask_export(c, "pdf"); }, nullptr, nullptr},
    {ActionId::ExportSvg, "SVG drawing…", icon::kExportDrawing, {}, "Writes a drawing with named layers",
     needs_sheets, [](UiContext& c) { ask_export(c, "svg"); }, nullptr, nullptr},
    {ActionId::ExportDxf, "DXF drawing…", "", {}, "Writes closed outlines and folds for cutting machines",
     needs_sheets, [](UiContext& c) { ask_export(c, "dxf"); }, nullptr, nullptr},
    {ActionId::ExportPng, "PNG picture…", icon::kExportImage, {}, "Writes the pages as pictures",
     needs_sheets, [](UiContext& c) { ask_export(c, "png"); }, nullptr, nullptr},
    {ActionId::ExportObj, "OBJ to paint on…", "", {}, "Writes the model with its net as texture coordinates",
     needs_sheets, [](UiContext& c) { ask_export(c, "obj"); }, nullptr, nullptr},
    {ActionId::ExportFold, "FOLD file…", icon::kExport, {}, "Writes the net for origami programs",
     needs_sheets, [](UiContext& c) { ask_export(c, "fold"); }, nullptr, nullptr},
    {ActionId::ExportSilhouette, "Silhouette folder…", "", {},
     "Writes a PDF to print and SVG and DXF to cut, with the marks that Silhouette machines look for",
     needs_project_sheets, [](UiContext& c) { ask_export(c, "silhouette"); }, nullptr, nullptr},
    {ActionId::ExportCricut, "Cricut folder…", "", {},
     "Writes a PDF to print and SVG and DXF to cut, without pictures in the files to cut",
     needs_project_sheets, [](UiContext& c) { ask_export(c, "cricut"); }, nullptr, nullptr},
    {ActionId::ExportLaser, "Laser cutter folder…", "", {},
     "Writes PDF, SVG and DXF with hairlines in pure colours",
     needs_project_sheets, [](UiContext& c) { ask_export(c, "laser"); }, nullptr, nullptr},
    {ActionId::Quit, "Quit", "", {'Q', kControlBit}, "Closes Netwright", always,
     ask_to_quit, nullptr, nullptr},
    {ActionId::Undo, "Undo", icon::kUndo, {'Z', kControlBit}, "Takes the last change back", needs_undo,
     [](UiContext& c) { c.session.undo(); }, nullptr, undo_label},
    {ActionId::Redo, "Redo", icon::kRedo, {'Y', kControlBit}, "Makes the change again", needs_redo,
     [](UiContext& c) { c.session.redo(); }, nullptr, redo_label},
    {ActionId::ShowHistory, "History", "", {'H', kControlBit}, "Lists all steps that can be undone or redone",
     needs_history, show_history, nullptr, nullptr},
    {ActionId::Preferences, "Preferences…", icon::kSettings, {',', kControlBit},
     "Looks, lengths, paper, file dialogs and more", always, [](UiContext& c) { c.ui.dialog = Dialog::Preferences; },
     nullptr, nullptr},
    {ActionId::ShowReport, "Show report", icon::kInfo, {}, "Says what is known about the model", needs_model,
     show_report, nullptr, nullptr},
    {ActionId::MergeFaces, "Merge faces of one plane", icon::kFaces, {'M', 0},
     "Neighbours that lie in one plane become one face: fewer folds, same shape", needs_model, toggle_merging,
     is_merging, nullptr},
    {ActionId::SplitFace, "Split this face again", "", {'M', kShiftBit},
     "Takes a merged face apart, or merges one again that was split", needs_merged_face, split_or_merge_face, nullptr,
     split_label},
    {ActionId::Simplify400, "Simplify to 400 faces", "", {}, "Brings the model to a size that can be glued",
     needs_more_faces, [](UiContext& c) { c.session.simplify_to(kUsualFaces, false); }, nullptr, nullptr},
    {ActionId::AllFaces, "All faces", "", {}, "Takes the simplification back", needs_simplified,
     [](UiContext& c) { c.session.simplify_to(0, false); }, nullptr, nullptr},
    {ActionId::CentreFace, "Centre the face", icon::kFrame, {'J', 0}, "Brings the face to the middle of both views",
     needs_face, [](UiContext& c) { c.ui.wants_centre = chosen_face(c); }, nullptr, nullptr},
    {ActionId::ClearSelection, "Clear selection", "", {}, "Lets go of the selected faces and edges", needs_selection,
     [](UiContext& c) { clear_selection(c.ui); }, nullptr, nullptr},
    {ActionId::Unfold, "Unfold", icon::kPlay, {kSpaceKey, 0}, "Searches for a net in one piece", needs_model,
     unfold_or_pause, nullptr, unfold_label},
    {ActionId::Step, "Step", icon::kStep, {'S', 0}, "Makes one move and shows it", needs_no_replay,
     [](UiContext& c) { c.session.step(); }, nullptr, nullptr},
    {ActionId::Stop, "Stop", icon::kStop, {kEscapeKey, 0}, "Ends the search and keeps the best net", needs_run,
     stop_or_skip, nullptr, nullptr},
    {ActionId::NewSeed, "New seed", icon::kSeed, {'N', 0}, "Searches again with the next seed", needs_model,
     [](UiContext& c) { c.session.new_seed(); }, nullptr, nullptr},
    {ActionId::UnfoldFromHere, "Unfold from here", icon::kReplay, {kSpaceKey, kShiftBit},
     "Starts from the net as it is and changes only what overlaps and pins ask for", needs_still_net,
     [](UiContext& c) { c.session.unfold_from_here(); }, nullptr, rest_label},
    {ActionId::AskWhy, "Why?", icon::kHelp, {}, "Shows where the search was stuck, and what can be done",
     needs_failure, ask_why, nullptr, nullptr},
    {ActionId::FindSoftening, "Soften the shape", icon::kTune, {},
     "Looks for the least change of shape that gives a net; nothing is changed before you agree", needs_trial,
     [](UiContext& c) { open_why(c); c.session.look_for_softening(); }, nullptr, nullptr},
    {ActionId::FindPieces, "Several pieces", icon::kCut, {},
     "Looks for nets of the fewest pieces; you choose one", needs_trial,
     [](UiContext& c) { open_why(c); c.session.look_for_pieces(); }, nullptr, nullptr},
    {ActionId::FindReleases, "Find pins to release", icon::kUnpin, {},
     "Tries which pins stand in the way of a net", needs_pins_to_try, find_releases_of_pins, nullptr, nullptr},
    {ActionId::MakeRoomForTabs, "Make room for tabs", "", {},
     "Searches on from this net until every cut has room for a glue tab", why_no_room_for_tabs, make_room_for_tabs,
     nullptr, nullptr},
    {ActionId::PinRoot, "Pin root", icon::kRoot, {'R', 0}, "Layout and tree start at this face",
     needs_face_or_pin, pin_root, nullptr, root_label},
    {ActionId::MustFold, "Must fold", icon::kPin, {'G', 0}, "The edge is a fold in every net from now on", why_no_edge_pin,
     [](UiContext& c) { pin_edges(c, EdgePin::MustFold); }, nullptr, must_fold_label},
    {ActionId::MustCut, "Must cut", icon::kCut, {'C', 0}, "The edge is a cut in every net from now on", why_no_edge_pin,
     [](UiContext& c) { pin_edges(c, EdgePin::MustCut); }, nullptr, must_cut_label},
    {ActionId::KeepTogether, "Keep together", icon::kLocked, {'K', 0},
     "The selected faces stay one patch, joined by folds among themselves", why_no_patch, keep_faces_together,
     nullptr, patch_label},
    {ActionId::ClearPins, "Clear pins", icon::kUnpin, {kDeleteKey, 0}, "Frees the edges and faces of their pins",
     why_no_clearing, clear_pins, nullptr, nullptr},
    {ActionId::ClearAllPins, "Clear all pins", "", {}, "Frees the whole model of its pins", why_nothing_pinned,
     clear_all_pins, nullptr, nullptr},
    {ActionId::SkipReplay, "Skip the replay", icon::kSkip, {}, "Shows the finished net at once", needs_replay,
     [](UiContext& c) { c.session.skip_replay(); }, nullptr, nullptr},
    {ActionId::NewerRun, "Look at the newer run", icon::kChevronUp, {kPageUpKey, 0},
     "Shows the run above in the list; the project stays as it is", needs_runs, view_newer_run, nullptr, nullptr},
    {ActionId::OlderRun, "Look at the older run", icon::kChevronDown, {kPageDownKey, 0},
     "Shows the run below in the list; the project stays as it is", needs_runs, view_older_run, nullptr, nullptr},
    {ActionId::AcceptRun, "Accept the run", icon::kDone, {kEnterKey, 0}, "Makes this run's net the project's",
     needs_acceptable_run, accept_viewed_run, nullptr, nullptr},
    {ActionId::LeaveRun, "Back to the net", icon::kClose, {}, "Shows the project's own net again", needs_viewed_run,
     leave_run, nullptr, nullptr},
    {ActionId::DeleteRun, "Delete the run", icon::kDelete, {kDeleteKey, kShiftBit}, "Takes the run off the list",
     needs_viewed_run, delete_viewed_run, nullptr, nullptr},
    {ActionId::ExportBestRun, "Export the best run…", icon::kPrint, {'P', kControlBit | kShiftBit},
     "Writes the net of the best finished run, also while a search goes on", needs_proved_run, export_best_run,
     nullptr, nullptr},
    {ActionId::PlayMoves, "Play the moves", icon::kPlay, {'V', 0}, "Plays the run's recorded moves, or holds them",
     needs_timeline, play_or_hold, is_playing, play_label},
    {ActionId::MoveBack, "Move back", icon::kStepBack, {kLeftKey, 0}, "Takes one recorded move back", needs_timeline,
     move_back, nullptr, nullptr},
    {ActionId::MoveOn, "Move on", icon::kStep, {kRightKey, 0}, "Makes the next recorded move", needs_timeline,
     move_on, nullptr, nullptr},
    {ActionId::Frame, "Frame all", icon::kFullscreen, {'F', 0}, "Fits model and net into their views", needs_model,
     frame_all, nullptr, nullptr},
    {ActionId::Home, "Home view", icon::kHome, {kHomeKey, 0}, "Looks at the model as at first, and at all sheets", needs_model,
     show_all, nullptr, nullptr},
    {ActionId::JoinAndCut, "Join and cut", icon::kCut, {'E', 0},
     "Joins and cuts edges of the net by hand, and hangs branches elsewhere", needs_still_net, toggle_editing,
     [](const UiContext& c) { return c.ui.editing.is_on; }, nullptr},
    {ActionId::ArrangePieces, "Arrange pieces", icon::kPan, {'A', 0},
     "Moves, turns and aligns the pieces on their pages by hand", why_not_arrange, toggle_arranging,
     [](const UiContext& c) { return c.ui.arranging.is_on; }, nullptr},
    {ActionId::EditTabs, "Edit tabs", icon::kGlue, {'B', kShiftBit},
     "Puts glue tabs on the other side of a cut, on both or on none, and changes their width", why_no_tab_tool,
     toggle_tab_tool, [](const UiContext& c) { return c.ui.tabbing.is_on; }, nullptr},
    {ActionId::HideFolds, "Hide fold line", "", {'H', 0}, "The line of this fold is not printed, or is again",
     why_no_fold_lines, toggle_fold_lines, nullptr, fold_lines_label},
    {ActionId::SeamOn, "Next seam", icon::kChevronRight, {'W', 0}, "Shows what is glued next in both views",
     why_no_assembly, [](UiContext& c) { go_in_assembly(c, 1); }, nullptr, nullptr},
    {ActionId::SeamBack, "Seam before", icon::kChevronLeft, {'W', kShiftBit}, "Shows what was glued before",
     why_no_assembly, [](UiContext& c) { go_in_assembly(c, -1); }, nullptr, nullptr},
    {ActionId::TickSeam, "Glued", icon::kDone, {'I', 0}, "Ticks this seam off and shows the next one, or takes the tick back",
     why_no_assembly, tick_seam, nullptr, nullptr},
    {ActionId::TurnPieces, "Turn by a quarter", "", {'Q', 0}, "Turns the selected pieces clockwise on their pages",
     why_not_align, turn_chosen_by_a_quarter, nullptr, nullptr},
    {ActionId::AlignLeft, "Align left", "", {}, "Brings the left sides of the selected pieces in line", why_not_align,
     align<Align::Left>, nullptr, nullptr},
    {ActionId::AlignRight, "Align right", "", {}, "Brings the right sides of the selected pieces in line",
     why_not_align, align<Align::Right>, nullptr, nullptr},
    {ActionId::AlignTop, "Align top", "", {}, "Brings the tops of the selected pieces in line", why_not_align,
     align<Align::Top>, nullptr, nullptr},
    {ActionId::AlignBottom, "Align bottom", "", {}, "Brings the bottoms of the selected pieces in line",
     why_not_align, align<Align::Bottom>, nullptr, nullptr},
    {ActionId::AlignCentreAcross, "Centre across", "", {}, "Puts the middles of the selected pieces above each other",
     why_not_align, align<Align::CentreAcross>, nullptr, nullptr},
    {ActionId::AlignCentreUpright, "Centre up and down", "", {},
     "Puts the middles of the selected pieces beside each other", why_not_align, align<Align::CentreUpright>, nullptr,
     nullptr},
    {ActionId::RearrangeAll, "Re-arrange all", "", {'A', kShiftBit},
     "Lays the pieces out anew, as it was before they were moved by hand", why_not_rearrange, rearrange, nullptr,
     nullptr},
    {ActionId::SplitToFit, "Split to fit the paper", "", {},
     "Cuts a net larger than the paper into the fewest pieces that fit it; the cuts can be moved by hand (E)",
     why_not_split, split_to_fit, nullptr, nullptr},
    {ActionId::Measure, "Measure", icon::kRuler, {'D', 0}, "Measures distances and angles in both views, in printed size",
     needs_model, toggle_measure, [](const UiContext& c) { return c.ui.measuring.is_on; }, nullptr},
    {ActionId::ToggleTextures, "Textures", icon::kTexture, {}, "Shows the model's own colours and pictures",
     needs_looks, toggle<&Settings::show_textures>, is_set<&Settings::show_textures>, nullptr},
    {ActionId::PlayFold, "Fold up and down", icon::kPlay, {'U', 0}, "Folds the net up to the model, or back to the flat net",
     needs_net, play_fold, nullptr, play_label},
    {ActionId::FoldLess, "Fold less", "", {',', 0}, "Unfolds the net a little in the model's view", needs_net,
     [](UiContext& c) { fold_by(c, -kFoldStep); }, nullptr, nullptr},
    {ActionId::FoldMore, "Fold more", "", {'.', 0}, "Folds the net a little in the model's view", needs_net,
     [](UiContext& c) { fold_by(c, kFoldStep); }, nullptr, nullptr},
    {ActionId::ToggleTree, "Unfold tree", icon::kTree, {'T', 0}, "Shows the tree of folds", always,
     toggle<&Settings::show_tree>, is_set<&Settings::show_tree>, nullptr},
    {ActionId::ToggleOverlaps, "Overlaps", icon::kWarning, {'O', 0}, "Marks the faces that overlap", always,
     toggle<&Settings::show_overlaps>, is_set<&Settings::show_overlaps>, nullptr},
    {ActionId::ToggleHeat, "Heat map", icon::kFire, {'O', kShiftBit},
     "Colours the faces by how often they collided in a search that found no net", needs_failure,
     toggle<&Settings::show_heat>, is_set<&Settings::show_heat>, nullptr},
    {ActionId::ToggleRoot, "Root", icon::kRoot, {}, "Marks the face where the tree starts", always,
     toggle<&Settings::show_root>, is_set<&Settings::show_root>, nullptr},
    {ActionId::TogglePages, "Pages", icon::kLayers, {'P', 0}, "Lays the finished net on its paper", always,
     toggle<&Settings::show_pages>, is_set<&Settings::show_pages>, nullptr},
    {ActionId::ToggleTabs, "Glue tabs", icon::kGlue, {'B', 0}, "Shows the net with its glue tabs; on pages, as it will be printed",
     always, toggle<&Settings::show_tabs>, is_set<&Settings::show_tabs>, nullptr},
    {ActionId::ToggleXray, "X-ray", icon::kModel, {'X', 0}, "Looks through the model: what is hidden shows faintly",
     needs_model, toggle<&Settings::is_xray>, is_set<&Settings::is_xray>, nullptr},
    {ActionId::ToggleNumbers, "Numbers", icon::kNumbers, {'L', 0}, "Numbers faces and edges of the net, as far as there is room",
     needs_net, toggle<&Settings::show_numbers>, is_set<&Settings::show_numbers>, nullptr},
    {ActionId::ToggleSide, "Side panel", icon::kMenu, {kF1Key + 8, 0}, "Shows or hides the panels at the left",
     needs_width, toggle<&Settings::is_side_open>, is_set<&Settings::is_side_open>, nullptr},
    {ActionId::OpenMenus, "Menus", "", {kF1Key + 9, 0}, "Opens the menus for the arrow keys", always,
     [](UiContext& c) { c.ui.wants_menus = true; }, nullptr, nullptr},
    {ActionId::Keys, "Keys", icon::kKeyboard, {kF1Key, 0}, "Lists keys and mouse gestures", always,
     [](UiContext& c) { c.ui.dialog = Dialog::Keys; }, nullptr, nullptr},
    {ActionId::About, "About Netwright", icon::kInfo, {}, "Says what this program is", always,
     [](UiContext& c) { c.ui.dialog = Dialog::About; }, nullptr, nullptr},
});
// clang-format on

/// Other keys for the same thing.
constexpr Shortcut canonical(Shortcut pressed) {
  if (pressed == Shortcut{'Z', kControlBit | kShiftBit}) return {'Y', kControlBit};
  return pressed;
}

}  // namespace

std::string shortcut_text(const Shortcut& shortcut) {
  if (shortcut.key == 0) return {};
  std::string text;
  if ((shortcut.modifiers & kControlBit) != 0) text += "Ctrl+";
  if ((shortcut.modifiers & kShiftBit) != 0) text += "Shift+";
  if (shortcut.key == kSpaceKey) return text + "Space";
  if (shortcut.key == kEscapeKey) return text + "Esc";
  if (shortcut.key == kEnterKey) return text + "Enter";
  if (shortcut.key == kDeleteKey) return text + "Del";
  if (shortcut.key == kRightKey) return text + "→";
  if (shortcut.key == kLeftKey) return text + "←";
  if (shortcut.key == kPageUpKey) return text + "Page Up";
  if (shortcut.key == kPageDownKey) return text + "Page Down";
  if (shortcut.key == kHomeKey) return text + "Home";
  if (shortcut.key == kF1Key) return text + "?";
  if (shortcut.key > kF1Key && shortcut.key <= kF1Key + 11)
    return text + "F" + std::to_string(shortcut.key - kF1Key + 1);
  return text + static_cast<char>(shortcut.key);
}

std::span<const Action> actions() { return kActions; }

const Action& action(ActionId id) {
  const auto it = std::find_if(kActions.begin(), kActions.end(), [&](const Action& a) { return a.id == id; });
  if (it == kActions.end()) throw std::logic_error("an action without a line in the table");
  return *it;
}

bool is_possible(const UiContext& context, ActionId id) { return action(id).why_not(context).empty(); }

std::string label_of(const UiContext& context, const Action& action) {
  return action.label != nullptr ? action.label(context) : std::string(action.name);
}

std::string tip_of(const UiContext& context, const Action& action) {
  const std::string reason = action.why_not(context);
  std::string tip(action.what);
  const std::string keys = shortcut_text(action.shortcut);
  if (!keys.empty()) tip += "  (" + keys + ")";
  return reason.empty() ? tip : tip + "\n" + reason;
}

void run_action(UiContext& context, ActionId id) {
  const Action& wanted = action(id);
  const std::string reason = wanted.why_not(context);
  if (reason.empty()) {
    wanted.run(context);
  } else {
    add_toast(context.ui, reason, false);
  }
}

bool run_shortcut(UiContext& context, const Shortcut& pressed) {
  const Shortcut wanted = canonical(pressed);
  for (const Action& candidate : kActions) {
    if (candidate.shortcut.key == 0 || candidate.shortcut != wanted) continue;
    // The tool in hand is what Esc gets rid of first.
    if (candidate.id == ActionId::Stop && context.ui.editing.is_on) {
      end_editing(context.ui);
    } else if (candidate.id == ActionId::Stop && context.ui.measuring.is_on) {
      end_measure(context.ui);
      return true;
    }
    if (candidate.id == ActionId::Stop && context.ui.tabbing.is_on) {
      end_tab_tool(context.ui);
      return true;
    }
    if (candidate.id == ActionId::Stop && context.ui.arranging.is_on) {
      escape_arranging(context);
      return true;
    }
    // Esc is also how people get out of things; pressing it once too often is no mistake to be told about.
    const bool is_idle_escape = candidate.id == ActionId::Stop && !is_possible(context, ActionId::Stop);
    const bool is_about_a_run = candidate.id == ActionId::AcceptRun || candidate.id == ActionId::MoveBack ||
                                candidate.id == ActionId::MoveOn;
    if (is_about_a_run && context.session.viewed_run() == 0) return false;
    if (is_idle_escape && context.session.viewed_run() != 0) {
      context.session.view_run(0);
    } else if (is_idle_escape) {
      clear_selection(context.ui);
    } else {
      run_action(context, candidate.id);
    }
    return true;
  }
  return false;
}

void add_toast(UiState& ui, const std::string& text, bool is_good) {
  std::erase_if(ui.toasts, [&](const Toast& toast) { return toast.text == text; });
  ui.toasts.push_back({text, is_good, ui.now + kToastSeconds});
  if (ui.toasts.size() > 3) ui.toasts.pop_front();
}

}  // namespace netwright
