// One row per preference. There is nothing to confirm: what is chosen is seen behind the dialog.
#include "ui/preferences.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "core/base/paper.h"
#include "core/base/worker.h"
#include "ui/desktop_picker.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

constexpr float kLabelWidth = 168;
constexpr std::array<int, 6> kScales{0, 100, 125, 150, 175, 200};
constexpr std::uint64_t kMostMinutes = 60;
constexpr std::uint64_t kMostThreads = 64;

/// A label at the left; the rest of the line is the control's. Returns its width.
float preference_row(const UiState& ui, const char* label) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(label);
  ImGui::SameLine(ui.look.px(20 + kLabelWidth));
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::SetNextItemWidth(width);
  return width;
}

void theme_row(UiState& ui) {
  int chosen = static_cast<int>(ui.settings.theme);
  const float width = preference_row(ui, "Theme");
  if (segments(ui, "preferences/theme", width, {"As the desktop", "Light", "Dark"}, chosen))
    ui.settings.theme = static_cast<ThemeChoice>(chosen);
}

void scale_row(UiState& ui) {
  int chosen = 0;
  std::vector<std::string> labels;
  for (const int percent : kScales) {
    if (percent == ui.settings.scale_percent) chosen = static_cast<int>(labels.size());
    labels.push_back(percent == 0 ? "Screen" : std::to_string(percent) + " %");
  }
  const float width = preference_row(ui, "Size of the interface");
  if (segments(ui, "preferences/scale", width, labels, chosen))
    ui.settings.scale_percent = kScales[static_cast<std::size_t>(chosen)];
}

void unit_row(UiState& ui) {
  int chosen = static_cast<int>(ui.settings.unit);
  const float width = preference_row(ui, "Lengths in");
  if (segments(ui, "preferences/unit", width, {"Millimetres", "Inches"}, chosen))
    ui.settings.unit = static_cast<LengthUnit>(chosen);
}

bool paper_choice(UiState& ui, const std::string& label, const std::string& name) {
  const bool is_chosen = ImGui::Selectable(label.c_str(), ui.settings.paper == name);
  note_widget(ui, "preferences/paper/" + (name.empty() ? "locale" : name));
  if (is_chosen) ui.settings.paper = name;
  return is_chosen;
}

bool paper_row(UiState& ui) {
  const std::string by_locale = "As usual here (" + paper_of_locale(paper_locale()) + ")";
  preference_row(ui, "Paper of new models");
  const std::string& present = ui.settings.paper;
  if (!begin_combo(ui, "preferences/paper", present.empty() ? by_locale : present)) return false;
  bool has_changed = paper_choice(ui, by_locale, "");
  for (const PaperFormat& format : paper_formats()) {
    const std::string name(format.name);
    std::string label = name + "   ";
    label += area_text(format.width_mm, format.height_mm, ui.settings.unit);
    has_changed = paper_choice(ui, label, name) || has_changed;
  }
  ImGui::EndCombo();
  return has_changed;
}

void autosave_row(UiState& ui) {
  preference_row(ui, "Recovery copy");
  bool is_on = ui.settings.autosave_minutes > 0;
  if (checkbox(ui, "preferences/autosave", "every", is_on,
               "Keeps a copy for the case of a crash or a power cut"))
    ui.settings.autosave_minutes = is_on ? 1 : 0;
  ImGui::SameLine(0, ui.look.px(8));
  ImGui::SetNextItemWidth(ui.look.px(56));
  auto minutes = static_cast<std::uint64_t>(ui.settings.autosave_minutes);
  if (!is_on) ImGui::BeginDisabled();
  if (number_field(ui, "preferences/autosave-minutes", minutes))
    ui.settings.autosave_minutes = static_cast<int>(std::clamp<std::uint64_t>(minutes, 1, kMostMinutes));
  if (!is_on) ImGui::EndDisabled();
  tooltip(ui, is_on ? "1 to 60 minutes" : "Tick the box first.");
  ImGui::SameLine(0, ui.look.px(8));
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(ui.settings.autosave_minutes == 1 ? "minute of changes" : "minutes of changes");
}

bool threads_row(UiState& ui) {
  preference_row(ui, "Threads that search");
  ImGui::SetNextItemWidth(ui.look.px(56));
  auto threads = static_cast<std::uint64_t>(ui.settings.threads);
  const bool has_changed = number_field(ui, "preferences/threads", threads);
  tooltip(ui, "0 takes as many as there are streams and processors. Never changes which net is found");
  if (has_changed) ui.settings.threads = static_cast<int>(std::min(threads, kMostThreads));
  ImGui::SameLine(0, ui.look.px(8));
  ImGui::AlignTextToFramePadding();
  const std::string here = std::to_string(ThreadPool::hardware_threads()) + " here";
  text_muted(ui, ui.settings.threads == 0 ? "0: all, " + here : "of " + here);
  return has_changed;
}

void dialogs_row(UiState& ui) {
  const std::string program = desktop_picker_program().filename().string();
  const float width = preference_row(ui, "File dialogs");
  int chosen = ui.settings.uses_desktop_dialogs && !program.empty() ? 1 : 0;
  if (program.empty()) ImGui::BeginDisabled();
  if (segments(ui, "preferences/dialogs", width, {"Netwright's own", "The desktop's"}, chosen))
    ui.settings.uses_desktop_dialogs = chosen == 1;
  if (program.empty()) ImGui::EndDisabled();
  tooltip(ui, program.empty() ? "Install zenity or kdialog to choose files as in other programs."
                              : "The desktop's are shown by " + program);
}

}  // namespace

PolishSettings polish_of(const Settings& settings) {
  const auto weight = [](int percent) { return percent / 100.0; };
  return {.effort = static_cast<double>(settings.polish_s),
          .short_cuts = weight(settings.aim_cuts),
          .compact = weight(settings.aim_compact),
          .few_necks = weight(settings.aim_necks),
          .fits_paper = weight(settings.aim_paper),
          .root_in_middle = weight(settings.aim_root),
          .hidden_cuts = weight(settings.aim_hidden)};
}

void apply_preferences(Session& session, const Settings& settings) {
  session.set_threads(settings.threads);
  session.set_streams(settings.streams);
  session.set_time_limit(settings.time_limit_s);
  session.set_polish(polish_of(settings));
  session.set_desk_paper(paper_of(settings));
}

void preference_rows(UiContext& context) {
  UiState& ui = context.ui;
  theme_row(ui);
  scale_row(ui);
  unit_row(ui);
  const bool has_paper = paper_row(ui);
  autosave_row(ui);
  const bool has_threads = threads_row(ui);
  dialogs_row(ui);
  if (has_paper || has_threads) apply_preferences(context.session, ui.settings);
}

}  // namespace netwright
