// The dialogs about project files: save as, unsaved changes, and work that can be recovered.
#include <algorithm>
#include <chrono>
#include <utility>

#include "assets/icons.h"
#include "core/project/project_file.h"
#include "ui/actions.h"
#include "ui/dialogs.h"
#include "ui/leave.h"
#include "ui/recovery.h"
#include "ui/status.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

constexpr float kLeftoverHeight = 96;
constexpr float kMostShown = 4;  ///< then the list scrolls

std::string when_saved(const Leftover& leftover) {
  const auto moment = std::chrono::file_clock::to_sys(leftover.saved_at);
  return moment_text(std::chrono::time_point_cast<std::chrono::system_clock::duration>(moment),
                     std::chrono::system_clock::now());
}

/// What the work is called: the file it belongs to, else its model.
std::string name_of(const Leftover& leftover) {
  const auto& file = leftover.outline.belongs_to;
  return file.empty() ? leftover.outline.name : file.filename().string();
}

std::string facts_of(const Leftover& leftover) {
  return counted(leftover.outline.n_faces, "face", "faces") +
         (leftover.outline.is_proved ? " · with a proved net" : " · without a net");
}

}  // namespace

void Dialogs::begin_save(const UiContext& context) {
  const Session& session = context.session;
  std::filesystem::path folder = session.file().parent_path();
  if (folder.empty()) folder = session.project().path.parent_path();
  if (folder.empty()) folder = home_folder();
  const std::string extension(kProjectExtension);
  const std::string stem = session.file().empty() ? file_stem(session) : session.file().stem().string();
  browser_.begin({FileBrowser::Mode::Save, folder, stem + "." + extension, {extension}});
}

void Dialogs::draw_save(UiContext& context) {
  UiState& ui = context.ui;
  if (!begin_window(ui, 720, 520)) return;
  const float height = ImGui::GetContentRegionAvail().y - ui.look.px(44);
  auto chosen = browser_.draw(ui, height);
  const bool is_overwriting = browser_.is_asking_to_overwrite();
  const std::string notice = is_overwriting ? "This file exists. Replace it?" : "";
  if (footer(context, {is_overwriting ? "Replace" : "Save", browser_.can_accept(), true, notice}) && !chosen)
    chosen = browser_.accept();
  if (chosen) {
    ui.leaves_when_saved = ui.leaving != nullptr;
    context.session.save(*chosen);
    finish(context);
  } else if (present_ == Dialog::None) {
    ui.leaving = nullptr;  // who does not want to save now does not want to leave either
  }
  ImGui::EndPopup();
}

void Dialogs::draw_unsaved(UiContext& context) {
  UiState& ui = context.ui;
  if (!begin_window(ui, 480, 168)) return;
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(("What you changed in " + shortened(project_name(context.session), ui.look.px(220)) +
                          " is not saved yet. Without saving it is lost.")
                             .c_str());
  ImGui::PopTextWrapPos();
  note_widget(ui, "unsaved/text");
  ButtonSpec drop{"dialog/drop", "Don’t save"};
  drop.kind = ButtonKind::Outlined;
  ImGui::SetCursorPos(ImVec2(ui.look.px(20), ImGui::GetWindowHeight() - ui.look.px(48)));
  const bool is_dropped = button(ui, drop);
  const bool is_saved = footer(context, {"Save"});
  if (present_ == Dialog::None) {
    ui.leaving = nullptr;
  } else if (is_dropped) {
    finish(context);
    const std::function<void(UiContext&)> next = std::exchange(ui.leaving, nullptr);
    next(context);
  } else if (is_saved) {
    finish(context);
    ui.leaves_when_saved = !context.session.file().empty();
    save_project_of(context);
  }
  ImGui::EndPopup();
}

void Dialogs::draw_leftover(UiContext& context, const Leftover& leftover, std::size_t index) {
  UiState& ui = context.ui;
  const Look& look = ui.look;
  if (index >= pictures_.size()) {
    pictures_.emplace_back();
    if (!leftover.thumbnail.is_empty()) pictures_.back().upload(leftover.thumbnail);
  }
  const std::string name = "recover/" + std::to_string(index);
  const float top = ImGui::GetCursorPosY();
  const float side = look.px(kLeftoverHeight - 16);
  if (!leftover.thumbnail.is_empty()) {
    const auto picture = reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(pictures_[index].name()));
    ImGui::Image(picture, ImVec2(side, side), ImVec2(0, 1), ImVec2(1, 0));
  }
  ButtonSpec discard{name + "/discard", "Discard", "", "Throws this work away"};
  discard.kind = ButtonKind::Outlined;
  ButtonSpec recover{name + "/recover", "Recover", "", "Opens it as it was; it stays here until you save it"};
  recover.kind = ButtonKind::Accent;
  discard.width = recover.width = look.px(96);
  const float left = side + look.px(16);
  const float buttons = 2 * recover.width + look.px(8);
  const float room = ImGui::GetWindowContentRegionMax().x - left - buttons;
  const auto line = [&](float y) { ImGui::SetCursorPos(ImVec2(left, top + look.px(y))); };
  line(8);
  ImGui::PushFont(look.fonts.bold);
  ImGui::TextUnformatted(shortened(name_of(leftover), room - look.px(12)).c_str());
  ImGui::PopFont();
  tooltip(ui, leftover.outline.belongs_to.empty() ? "Never saved to a file"
                                                  : leftover.outline.belongs_to.string());
  note_widget(ui, name + "/name");
  line(32);
  text_muted(ui, "kept " + when_saved(leftover) + (leftover.is_outdated ? ", its file is newer" : ""));
  line(54);
  text_muted(ui, facts_of(leftover));
  ImGui::SetCursorPos(ImVec2(left + room, top + look.px(24)));
  const bool is_discarded = button(ui, discard);
  ImGui::SameLine(0, look.px(8));
  const bool is_recovered = button(ui, recover);
  ImGui::SetCursorPosY(top + look.px(kLeftoverHeight));
  const std::filesystem::path file = leftover.file;
  if (is_discarded) {
    pictures_.clear();
    context.session.discard(file);
  } else if (is_recovered) {
    finish_recovery_ = true;
    leave(context, [file](UiContext& c) { c.session.recover(file); });
  }
}

void Dialogs::draw_recover(UiContext& context) {
  UiState& ui = context.ui;
  const std::size_t n = context.session.leftovers().size();
  const float list = kLeftoverHeight * std::min(static_cast<float>(std::max<std::size_t>(n, 1)), kMostShown);
  if (!begin_window(ui, 640, 172 + list)) return;
  ui.has_offered_recovery = true;
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted("Netwright ended before this was saved.");
  ImGui::PopTextWrapPos();
  ImGui::Dummy(ImVec2(0, ui.look.px(4)));
  ImGui::BeginChild("leftovers", ImVec2(0, ImGui::GetContentRegionAvail().y - ui.look.px(44)));
  finish_recovery_ = n == 0;
  for (std::size_t i = 0; i < context.session.leftovers().size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    draw_leftover(context, context.session.leftovers()[i], i);
    ImGui::PopID();
    if (context.session.leftovers().size() != n) break;  // one went: the others come with the next frame
  }
  ImGui::EndChild();
  ButtonSpec later{"dialog/later", "Later"};
  later.kind = ButtonKind::Outlined;
  later.tip = "Asks again at the next start; until then it is in the menu File";
  later.width = ui.look.px(96);
  ImGui::SetCursorPos(ImVec2(ImGui::GetWindowWidth() - ui.look.px(20) - later.width,
                             ImGui::GetWindowHeight() - ui.look.px(48)));
  const bool is_later = button(ui, later) || std::exchange(is_cancelled_, false);
  if (is_later || finish_recovery_) {
    finish(context);
    pictures_.clear();
  }
  ImGui::EndPopup();
}

}  // namespace netwright
