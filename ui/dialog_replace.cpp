// Choosing the file of a new version of the model: the dialog for opening, beginning where the old one lies.
#include <algorithm>

#include "core/mesh/read.h"
#include "ui/dialogs.h"
#include "ui/recent_files.h"
#include "ui/widgets.h"

namespace netwright {

bool Dialogs::begin_replace(UiContext& context) {
  std::vector<std::string> extensions;
  for (const ModelFormat& format : model_formats())
    for (const std::string_view extension : format.extensions) extensions.emplace_back(extension);
  const std::filesystem::path& old = context.session.project().path;
  std::error_code ignored;
  const bool is_there = !old.empty() && std::filesystem::is_directory(old.parent_path(), ignored);
  const auto folder = is_there ? old.parent_path() : latest_folder(context.ui.settings);
  if (ask_desktop(context, {false, "Replace the model", folder, extensions})) return true;
  browser_.begin({FileBrowser::Mode::Open, folder, "", extensions});
  return false;
}

void Dialogs::draw_replace(UiContext& context) {
  UiState& ui = context.ui;
  if (!begin_window(ui, 720, 520)) return;
  ImGui::PushTextWrapPos(0);
  text_muted(
      ui, "Pins, folds and settings go over to the new version as far as they fit; one undo takes it back.");
  ImGui::PopTextWrapPos();
  const float height = ImGui::GetContentRegionAvail().y - ui.look.px(44);
  auto chosen = browser_.draw(ui, height);
  if (footer(context, {"Replace", browser_.can_accept()}) && !chosen) chosen = browser_.accept();
  if (chosen) {
    finish(context);
    context.session.replace_model(*chosen);
  }
  ImGui::EndPopup();
}

}  // namespace netwright
