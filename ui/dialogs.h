// The modal dialogs: open, save and export, keys, about, what to do with a broken file, with unsaved changes
// and with work that can be recovered. Which one is up stands in UiState::dialog.
#pragma once

#include <filesystem>
#include <string>

#include "render/gl_objects.h"
#include "ui/desktop_picker.h"
#include "ui/file_browser.h"

namespace netwright {

class Dialogs {
 public:
  /// Opens and draws what UiState::dialog asks for; call once per frame, outside of all windows.
  void draw(UiContext& context);
  /// Is one up? Then shortcuts rest.
  [[nodiscard]] bool is_open() const { return present_ != Dialog::None; }
  /// Esc and Enter, as the window's events bring them.
  void cancel() { is_cancelled_ = true; }
  void accept() { is_accepted_ = true; }

 private:
  void begin(UiContext& context);
  void finish(UiContext& context);
  void draw_open(UiContext& context);
  void draw_formats(const UiState& ui) const;  // dialog_formats.cpp
  bool begin_replace(UiContext& context);      // dialog_replace.cpp; true when the desktop was asked
  void draw_replace(UiContext& context);
  void draw_print(UiContext& context);  // dialog_print.cpp
  void choose_format(UiState& ui);
  void draw_export(UiContext& context);
  void draw_keys(UiContext& context);
  void draw_about(UiContext& context);
  // dialog_repair.cpp
  void draw_repair(UiContext& context);
  void draw_trying(UiContext& context);
  void draw_choices(UiContext& context, const Session::Pending& pending);
  // dialog_project.cpp
  void begin_save(const UiContext& context);
  void draw_save(UiContext& context);
  void draw_unsaved(UiContext& context);
  void draw_recover(UiContext& context);
  void draw_leftover(UiContext& context, const Leftover& leftover, std::size_t index);
  // dialog_desktop.cpp
  void draw_preferences(UiContext& context);
  /// True when the desktop's dialog was asked for the file; take_desktop() brings the answer.
  bool ask_desktop(UiContext& context, const PickRequest& request);
  void take_desktop(UiContext& context);
  static void export_net(UiContext& context, const std::filesystem::path& path);
  bool begin_window(const UiState& ui, float width, float height, const std::string& title = "") const;
  /// What stands at the bottom: a notice at the left, Cancel (where there is something to cancel) and the
  /// main button at the right.
  struct Footer {
    std::string label = {};
    bool is_enabled = true;
    bool has_cancel = true;
    std::string notice = {};
    std::string why_not = "Choose a file first.";  ///< said when it is not enabled
  };
  /// True when the main button was pressed.
  bool footer(UiContext& context, const Footer& what);

  FileBrowser browser_;
  DesktopPicker picker_;
  bool wants_own_once_ = false;  ///< the desktop's dialog failed: ours for this time
  Dialog present_ = Dialog::None;
  bool is_cancelled_ = false;
  bool is_accepted_ = false;
  std::vector<Texture> pictures_;  ///< of the work that can be recovered
  bool finish_recovery_ = false;   ///< one was chosen
  float repair_height_ = 0;        ///< of the text about a broken file, as it was drawn last
};

/// The model's name as a file name: without folder and extension.
std::string file_stem(const Session& session);

}  // namespace netwright
