// Everything a person can do, in one table: name, icon, shortcut, when it is possible (and why not), what it
// does. Menu bar, toolbar, shortcuts and the list of keys are all made from it.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "ui/ui_state.h"

namespace netwright {

enum class ActionId {
  Open,
  ReplaceModel,
  Save,
  SaveAs,
  Recover,
  PrintPages,
  ExportPdf,
  ExportSvg,
  ExportDxf,
  ExportPng,
  ExportObj,
  ExportFold,
  ExportSilhouette,
  ExportCricut,
  ExportLaser,
  Quit,
  Undo,
  Redo,
  ShowHistory,
  Preferences,
  ShowReport,
  MergeFaces,
  SplitFace,
  Simplify400,
  AllFaces,
  CentreFace,
  ClearSelection,
  Unfold,
  Step,
  Stop,
  NewSeed,
  UnfoldFromHere,
  MakeRoomForTabs,
  AskWhy,
  FindReleases,
  FindSoftening,
  FindPieces,
  PinRoot,
  MustFold,
  MustCut,
  KeepTogether,
  ClearPins,
  ClearAllPins,
  SkipReplay,
  NewerRun,
  OlderRun,
  AcceptRun,
  LeaveRun,
  DeleteRun,
  ExportBestRun,
  PlayMoves,
  MoveBack,
  MoveOn,
  Frame,
  Home,
  PlayFold,
  FoldLess,
  FoldMore,
  Measure,
  JoinAndCut,
  ArrangePieces,
  SeamOn,
  SeamBack,
  TickSeam,
  TurnPieces,
  EditTabs,
  HideFolds,
  AlignLeft,
  AlignRight,
  AlignTop,
  AlignBottom,
  AlignCentreAcross,
  AlignCentreUpright,
  RearrangeAll,
  SplitToFit,
  ToggleTextures,
  ToggleTree,
  ToggleOverlaps,
  ToggleHeat,
  ToggleRoot,
  TogglePages,
  ToggleTabs,
  ToggleXray,
  ToggleNumbers,
  ToggleSide,
  OpenMenus,
  Keys,
  About,
};

/// A key with the modifiers held; key numbers are those of the window's events (capital ASCII, GLFW's
/// others).
struct Shortcut {
  int key = 0;
  int modifiers = 0;
  bool operator==(const Shortcut&) const = default;
};

/// "Ctrl+O", "Space", "F9"; empty for none.
std::string shortcut_text(const Shortcut& shortcut);

struct Action {
  ActionId id;
  std::string_view name;  ///< as the menus and tests call it
  const char* icon;
  Shortcut shortcut;
  std::string_view what;                     ///< one short line for tooltips and the list of keys
  std::string (*why_not)(const UiContext&);  ///< empty when it is possible now
  void (*run)(UiContext&);
  bool (*is_on)(const UiContext&);         ///< null unless it is a switch
  std::string (*label)(const UiContext&);  ///< null unless the name changes with what it would do
};

/// In menu order.
std::span<const Action> actions();
const Action& action(ActionId id);

bool is_possible(const UiContext& context, ActionId id);
std::string label_of(const UiContext& context, const Action& action);
/// What it does and its key, or why it cannot be done now.
std::string tip_of(const UiContext& context, const Action& action);
/// Does it, or says why not.
void run_action(UiContext& context, ActionId id);
/// Runs the action of a key; false when no action has it.
bool run_shortcut(UiContext& context, const Shortcut& pressed);

/// Tells the user something in the corner for a few seconds.
void add_toast(UiState& ui, const std::string& text, bool is_good);

}  // namespace netwright
