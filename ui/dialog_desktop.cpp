// Choosing files with the desktop's own dialog instead of ours, and the preferences, which offer it.
#include <algorithm>

#include "ui/actions.h"
#include "ui/dialogs.h"
#include "ui/preferences.h"

namespace netwright {

bool Dialogs::ask_desktop(UiContext& context, const PickRequest& request) {
  const std::filesystem::path program = desktop_picker_program();
  if (!context.ui.settings.uses_desktop_dialogs || program.empty() || std::exchange(wants_own_once_, false))
    return false;
  picker_.begin(program, request, context.ui.wake);
  return true;
}

void Dialogs::take_desktop(UiContext& context) {
  UiState& ui = context.ui;
  if (std::exchange(is_cancelled_, false)) {
    picker_.cancel();
    ui.dialog = present_ = Dialog::None;
    return;
  }
  const auto answer = picker_.take();
  if (!answer) return;
  const Dialog asked = present_;
  ui.frames_wanted = std::max(ui.frames_wanted, 3);
  present_ = Dialog::None;
  if (answer->has_failed) {
    wants_own_once_ = true;  // ui.dialog still asks for it
    add_toast(ui, "The desktop's file dialog did not come up; this is Netwright's own.", false);
    return;
  }
  ui.dialog = Dialog::None;
  if (answer->path.empty()) return;
  if (asked == Dialog::Open) {
    context.session.open(answer->path);
  } else if (asked == Dialog::Replace) {
    context.session.replace_model(answer->path);
  } else {
    std::filesystem::path path = answer->path;
    if (path.extension() != "." + ui.export_extension) path += "." + ui.export_extension;
    context.ui.settings.export_folder = path.parent_path();
    export_net(context, path);
  }
}

void Dialogs::export_net(UiContext& context, const std::filesystem::path& path) {
  if (const auto cutter = cutter_named(context.ui.export_extension)) {
    context.session.export_for_cutter(path, *cutter);
  } else if (context.ui.export_run == 0) {
    context.session.export_to(path);
  } else {
    context.session.export_run(context.ui.export_run, path);
  }
}

void Dialogs::draw_preferences(UiContext& context) {
  if (!begin_window(context.ui, 600, 404)) return;
  preference_rows(context);
  if (footer(context, {"Close", true, false})) finish(context);
  ImGui::EndPopup();
}

}  // namespace netwright
