// Each dialog is a modal window in the middle; Esc and Cancel leave it without doing anything.
#include "ui/dialogs.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "core/mesh/read.h"
#include "core/project/project_file.h"
#include "core/sheet/cutter_package.h"
#include "core/sheet/write.h"
#include "ui/actions.h"
#include "ui/export_rows.h"
#include "ui/leave.h"
#include "ui/recent_files.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

constexpr std::array<const char*, 12> kTitles{"",
                                              "Open a model or project",
                                              "Export the net",
                                              "Keys and mouse",
                                              "About Netwright",
                                              "Repair",
                                              "Save the project",
                                              "Save the changes?",
                                              "Recover unsaved work",
                                              "Preferences",
                                              "Replace the model",
                                              "Print"};

std::vector<std::string> readable_extensions() {
  std::vector<std::string> all{std::string(kProjectExtension)};
  for (const ModelFormat& format : model_formats()) {
    for (const std::string_view extension : format.extensions) all.emplace_back(extension);
  }
  return all;
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

void key_line(const UiState& ui, const std::string& keys, const std::string& what) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushFont(ui.look.fonts.bold);
  ImGui::TextUnformatted(keys.c_str());
  ImGui::PopFont();
  ImGui::TableNextColumn();
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(what.c_str());
  ImGui::PopTextWrapPos();
}

/// What comes up by itself.
Dialog due_dialog(const UiContext& context) {
  if (context.ui.leaving && !context.ui.leaves_when_saved) return Dialog::Unsaved;
  if (context.session.pending() != nullptr) return Dialog::Repair;
  if (!context.ui.has_offered_recovery && !context.session.leftovers().empty()) return Dialog::Recover;
  return Dialog::None;
}

}  // namespace

std::string file_stem(const Session& session) {
  if (!session.has_model()) return "net";
  const std::string stem = std::filesystem::path(session.project().dual->mesh().name()).stem().string();
  return stem.empty() ? "net" : stem;
}

void Dialogs::begin(UiContext& context) {
  UiState& ui = context.ui;
  present_ = ui.dialog;
  if (present_ == Dialog::Replace) {
    if (begin_replace(context)) return;
  } else if (present_ == Dialog::Open) {
    const auto folder = latest_folder(ui.settings);
    if (ask_desktop(context, {false, "Open a model", folder, readable_extensions()})) return;
    browser_.begin({FileBrowser::Mode::Open, folder, "", readable_extensions()});
  } else if (present_ == Dialog::Export) {
    const auto& path = context.session.project().path;
    const auto& last = ui.settings.export_folder;
    const auto folder = !last.empty() ? last : (path.empty() ? home_folder() : path.parent_path());
    const std::string name = file_stem(context.session) + "." + ui.export_extension;
    if (ask_desktop(context, {true, "Export the net", folder / name, {ui.export_extension}})) return;
    browser_.begin({FileBrowser::Mode::Save, folder, name, {ui.export_extension}});
  }
  if (present_ == Dialog::Print) context.session.look_for_printers();
  if (present_ == Dialog::Save) begin_save(context);
  if (present_ == Dialog::Repair) {
    ui.error.clear();
    repair_height_ = 0;
  }
  ImGui::OpenPopup(kTitles[static_cast<std::size_t>(present_)]);
}

void Dialogs::finish(UiContext& context) {
  context.ui.dialog = present_ = Dialog::None;
  context.ui.frames_wanted = std::max(context.ui.frames_wanted, 3);
  ImGui::CloseCurrentPopup();
}

bool Dialogs::begin_window(const UiState& ui, float width, float height, const std::string& title) const {
  const ImVec2 room = ImGui::GetIO().DisplaySize;
  const ImVec2 size(std::min(ui.look.px(width), room.x - ui.look.px(32)),
                    std::min(ui.look.px(height), room.y - ui.look.px(32)));
  ImGui::SetNextWindowSize(size);
  ImGui::SetNextWindowPos(ImVec2(room.x / 2, room.y / 2), ImGuiCond_Always, ImVec2(0.5F, 0.5F));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.look.px(20), ui.look.px(16)));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ui.look.px(6));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  const char* name = kTitles[static_cast<std::size_t>(present_)];
  constexpr auto kFlags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                          ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
  const bool is_open = ImGui::BeginPopupModal(name, nullptr, kFlags);
  ImGui::PopStyleVar(3);
  if (!is_open) return false;
  ImGui::PushFont(ui.look.fonts.title);
  const std::string shown = shortened(title.empty() ? name : title, ImGui::GetContentRegionAvail().x);
  ImGui::TextUnformatted(shown.c_str());
  ImGui::PopFont();
  note_widget(ui, "dialog/title");
  ImGui::Dummy(ImVec2(0, ui.look.px(2)));
  return true;
}

bool Dialogs::footer(UiContext& context, const Footer& what) {
  UiState& ui = context.ui;
  ButtonSpec main{"dialog/accept", what.label};
  main.kind = ButtonKind::Accent;
  main.is_enabled = what.is_enabled;
  if (!what.is_enabled) main.tip = what.why_not;
  main.width = std::max(button_width(ui, main), ui.look.px(96));
  ButtonSpec cancel{"dialog/cancel", "Cancel"};
  cancel.kind = ButtonKind::Outlined;
  cancel.width = ui.look.px(96);
  const float bottom = ImGui::GetWindowHeight() - ui.look.px(16) - ui.look.px(32);
  ImGui::SetCursorPosY(bottom);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(what.notice.c_str());
  const float right = ImGui::GetWindowWidth() - ui.look.px(20) - main.width;
  bool is_cancelled = std::exchange(is_cancelled_, false);
  if (what.has_cancel) {
    ImGui::SetCursorPos(ImVec2(right - ui.look.px(8) - cancel.width, bottom));
    is_cancelled = button(ui, cancel) || is_cancelled;
  }
  ImGui::SetCursorPos(ImVec2(right, bottom));
  bool is_accepted = std::exchange(is_accepted_, false) && what.is_enabled;
  is_accepted = button(ui, main) || is_accepted;
  if (is_cancelled) finish(context);
  return is_accepted && !is_cancelled;
}

void Dialogs::draw_open(UiContext& context) {
  UiState& ui = context.ui;
  if (!begin_window(ui, 720, 520)) return;
  const float height = ImGui::GetContentRegionAvail().y - ui.look.px(44);
  auto chosen = browser_.draw(ui, height);
  ImGui::SetCursorPosY(ImGui::GetWindowHeight() - ui.look.px(48));
  draw_formats(ui);
  if (footer(context, {"Open", browser_.can_accept()}) && !chosen) chosen = browser_.accept();
  if (chosen) {
    finish(context);
    open_file(context, *chosen);
  }
  ImGui::EndPopup();
}

void Dialogs::choose_format(UiState& ui) {
  if (cutter_named(ui.export_extension)) {
    text_muted(ui, "A folder with a PDF to print, and SVG and DXF files to cut");
    return;
  }
  int chosen = 0;
  std::vector<std::string> labels;
  for (const ExportFormat& format : export_formats()) {
    const std::string extension(format.extension.substr(1));
    if (extension == ui.export_extension) chosen = static_cast<int>(labels.size());
    labels.push_back(upper(extension));
  }
  const bool is_changed = segments(ui, "export/format", ui.look.px(320), labels, chosen);
  const ExportFormat& format = export_formats()[static_cast<std::size_t>(chosen)];
  text_muted(ui, std::string(format.description));
  if (!is_changed) return;
  ui.export_extension = format.extension.substr(1);
  browser_.set_extension(ui.export_extension);
}

void Dialogs::draw_export(UiContext& context) {
  UiState& ui = context.ui;
  const std::string title =
      ui.export_run == 0 ? "" : "Export the net of run " + std::to_string(ui.export_run);
  if (!begin_window(ui, 720, 560, title)) return;
  choose_format(ui);
  export_rows(context, true);
  const float height = ImGui::GetContentRegionAvail().y - ui.look.px(44);
  auto chosen = browser_.draw(ui, height);
  const bool is_overwriting = browser_.is_asking_to_overwrite();
  const std::string notice = is_overwriting ? "This file exists. Replace it?" : "";
  if (footer(context, {is_overwriting ? "Replace" : "Export", browser_.can_accept(), true, notice}) &&
      !chosen) {
    chosen = browser_.accept();
  }
  if (chosen) {
    ui.settings.export_folder = browser_.folder();
    export_net(context, *chosen);
    finish(context);
  }
  ImGui::EndPopup();
}

void Dialogs::draw_keys(UiContext& context) {
  UiState& ui = context.ui;
  if (!begin_window(ui, 640, 672)) return;
  ImGui::BeginChild("keys", ImVec2(0, ImGui::GetContentRegionAvail().y - ui.look.px(44)));
  if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
    ImGui::TableSetupColumn("keys");
    ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthStretch);
    for (const Action& entry : actions()) {
      const std::string keys = shortcut_text(entry.shortcut);
      if (!keys.empty()) key_line(ui, keys + "    ", std::string(entry.what));
    }
    ImGui::TableNextRow(ImGuiTableRowFlags_None, ui.look.px(12));
    key_line(ui, "Tab, Shift+Tab", "Goes to the next control or back; Space presses it, arrows slide it");
    key_line(ui, "Left drag", "Turns the model; moves the net from an empty place");
    key_line(ui, "Right or middle drag    ", "Moves the model or the net");
    key_line(ui, "Wheel", "Zooms at the pointer");
    key_line(ui, "Click", "Selects a face; the same face lights up in the other view");
    key_line(ui, "Shift+click, Shift+drag", "Adds to the selection, or selects all in a rectangle");
    key_line(ui, "Arrange: drag, handle", "Moves and turns pieces; Ctrl switches snapping off");
    key_line(ui, "Double-click", "Brings a face to the middle of both views");
    ImGui::EndTable();
  }
  ImGui::EndChild();
  if (footer(context, {"Close", true, false})) finish(context);
  ImGui::EndPopup();
}

void Dialogs::draw_about(UiContext& context) {
  UiState& ui = context.ui;
  if (!begin_window(ui, 520, 290)) return;
  text_muted(ui, "Version " NETWRIGHT_VERSION);
  ImGui::TextWrapped(
      "Unfolds a 3-D model into one piece of paper without overlaps, shows how it is found, and prints it to "
      "scale.");
  ImGui::TextWrapped(
      "The search is a tabu search over the ways to unfold a model; the README says whose method it is. Set "
      "in Inter, "
      "with Material Design Icons.");
  text_muted(ui, "MIT licence");
  if (footer(context, {"Close", true, false})) finish(context);
  ImGui::EndPopup();
}

void Dialogs::draw(UiContext& context) {
  watch_leaving(context);
  if (context.ui.dialog == Dialog::None) context.ui.dialog = due_dialog(context);
  // Someone closes the window: what is open there has to make room for the question.
  const bool is_in_the_way =
      present_ != Dialog::None && present_ != Dialog::Unsaved && present_ != Dialog::Save;
  if (is_in_the_way && context.ui.leaving && !finish_recovery_) is_cancelled_ = true;
  if (context.ui.dialog != Dialog::None && present_ == Dialog::None) begin(context);
  if (picker_.is_up()) {
    take_desktop(context);
    return;
  }
  switch (present_) {
    case Dialog::None:
      return;
    case Dialog::Preferences:
      draw_preferences(context);
      break;
    case Dialog::Open:
      draw_open(context);
      break;
    case Dialog::Print:
      draw_print(context);
      break;
    case Dialog::Replace:
      draw_replace(context);
      break;
    case Dialog::Export:
      draw_export(context);
      break;
    case Dialog::Keys:
      draw_keys(context);
      break;
    case Dialog::About:
      draw_about(context);
      break;
    case Dialog::Repair:
      draw_repair(context);
      break;
    case Dialog::Save:
      draw_save(context);
      break;
    case Dialog::Unsaved:
      draw_unsaved(context);
      break;
    case Dialog::Recover:
      draw_recover(context);
      break;
  }
  // Closed from outside (Esc): ImGui took the popup down.
  if (present_ != Dialog::None && !ImGui::IsPopupOpen(kTitles[static_cast<std::size_t>(present_)])) {
    if (present_ == Dialog::Repair) context.session.drop_pending();
    if (present_ == Dialog::Save || present_ == Dialog::Unsaved) context.ui.leaving = nullptr;
    context.ui.dialog = present_ = Dialog::None;
  }
  is_cancelled_ = is_accepted_ = false;
}

}  // namespace netwright
