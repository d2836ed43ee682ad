// The menus. Entries come from the table of actions; what depends on files or lists stands here.
#include <array>
#include <string>
#include <utility>

#include "ui/actions.h"
#include "ui/frame_parts.h"
#include "ui/leave.h"
#include "ui/recent_files.h"
#include "ui/samples.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

void entry(UiContext& context, ActionId id) {
  const Action& wanted = action(id);
  const bool is_on = wanted.is_on != nullptr && wanted.is_on(context);
  const std::string shortcut = shortcut_text(wanted.shortcut);
  const bool is_enabled = is_possible(context, id);
  const std::string label = label_of(context, wanted) + "###" + std::string(wanted.name);
  const bool is_chosen = ImGui::MenuItem(label.c_str(), shortcut.c_str(), is_on, is_enabled);
  note_widget(context.ui, "menu/" + std::string(wanted.name));
  if (!is_enabled) tooltip(context.ui, wanted.why_not(context));
  if (is_chosen) run_action(context, id);
}

void recent_menu(UiContext& context) {
  UiState& ui = context.ui;
  const auto recent = ui.settings.recent;
  if (recent.empty()) return;
  const bool is_open = ImGui::BeginMenu("Recent");
  note_widget(ui, "menu/Recent");
  if (!is_open) return;
  for (const auto& file : recent) {
    const std::string label = file.filename().string() + "###" + file.string();
    const bool is_chosen = ImGui::MenuItem(label.c_str(), folder_text(file).c_str());
    note_widget(ui, "menu/Recent/" + file.string());
    tooltip(ui, file.string());
    if (is_chosen) open_recent(context, file);
  }
  ImGui::Separator();
  if (ImGui::MenuItem("Forget these files")) ui.settings.recent.clear();
  note_widget(ui, "menu/Recent/Forget these files");
  ImGui::EndMenu();
}

void file_menu(UiContext& context) {
  entry(context, ActionId::Open);
  recent_menu(context);
  const bool is_open = ImGui::BeginMenu("Samples");
  note_widget(context.ui, "menu/Samples");
  if (is_open) {
    for (const Sample& sample : samples()) {
      if (ImGui::MenuItem(std::string(sample.title).c_str()))
        leave(context, [&sample](UiContext& c) { open_sample(c.session, sample); });
      note_widget(context.ui, "menu/Samples/" + std::string(sample.title));
    }
    ImGui::EndMenu();
  }
  entry(context, ActionId::ReplaceModel);
  entry(context, ActionId::Recover);
  ImGui::Separator();
  entry(context, ActionId::Save);
  entry(context, ActionId::SaveAs);
  ImGui::Separator();
  entry(context, ActionId::PrintPages);
  entry(context, ActionId::ExportPdf);
  const bool is_exporting = ImGui::BeginMenu("Export as");
  note_widget(context.ui, "menu/Export as");
  if (is_exporting) {
    for (const ActionId id : {ActionId::ExportSvg, ActionId::ExportDxf, ActionId::ExportPng,
                              ActionId::ExportObj, ActionId::ExportFold})
      entry(context, id);
    ImGui::Separator();
    for (const ActionId id : {ActionId::ExportSilhouette, ActionId::ExportCricut, ActionId::ExportLaser})
      entry(context, id);
    ImGui::EndMenu();
  }
  ImGui::Separator();
  entry(context, ActionId::Quit);
}

void theme_menu(UiContext& context) {
  const bool is_open = ImGui::BeginMenu("Theme");
  note_widget(context.ui, "menu/Theme");
  if (!is_open) return;
  static constexpr std::array<const char*, 3> kNames{"As the desktop", "Light", "Dark"};
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    const auto choice = static_cast<ThemeChoice>(i);
    if (ImGui::MenuItem(kNames[i], "", context.ui.settings.theme == choice))
      context.ui.settings.theme = choice;
    note_widget(context.ui, std::string("menu/Theme/") + kNames[i]);
  }
  ImGui::EndMenu();
}

void scale_menu(UiContext& context) {
  if (!ImGui::BeginMenu("Size of the interface")) return;
  int& percent = context.ui.settings.scale_percent;
  if (ImGui::MenuItem("As the screen", "", percent == 0)) percent = 0;
  for (const int choice : {100, 125, 150, 175, 200}) {
    if (ImGui::MenuItem((std::to_string(choice) + " %").c_str(), "", percent == choice)) percent = choice;
  }
  ImGui::EndMenu();
}

void view_menu(UiContext& context) {
  for (const ActionId id : {ActionId::Frame, ActionId::Home}) entry(context, id);
  ImGui::Separator();
  for (const ActionId id : {ActionId::PlayFold, ActionId::FoldLess, ActionId::FoldMore, ActionId::Measure})
    entry(context, id);
  ImGui::Separator();
  for (const ActionId id : {ActionId::ToggleTextures, ActionId::ToggleTree, ActionId::ToggleOverlaps,
                            ActionId::ToggleHeat, ActionId::ToggleRoot, ActionId::TogglePages,
                            ActionId::ToggleTabs, ActionId::ToggleXray, ActionId::ToggleNumbers}) {
    entry(context, id);
  }
  ImGui::Separator();
  entry(context, ActionId::ToggleSide);
  theme_menu(context);
  scale_menu(context);
}

void paper_menu(UiContext& context) {
  entry(context, ActionId::EditTabs);
  entry(context, ActionId::HideFolds);
  ImGui::Separator();
  for (const ActionId id : {ActionId::SeamOn, ActionId::SeamBack, ActionId::TickSeam}) entry(context, id);
  ImGui::Separator();
  entry(context, ActionId::ArrangePieces);
  entry(context, ActionId::TurnPieces);
  const bool is_open = ImGui::BeginMenu("Align");
  note_widget(context.ui, "menu/Align");
  if (is_open) {
    for (const ActionId id : {ActionId::AlignLeft, ActionId::AlignCentreAcross, ActionId::AlignRight})
      entry(context, id);
    ImGui::Separator();
    for (const ActionId id : {ActionId::AlignTop, ActionId::AlignCentreUpright, ActionId::AlignBottom})
      entry(context, id);
    ImGui::EndMenu();
  }
  entry(context, ActionId::RearrangeAll);
  entry(context, ActionId::SplitToFit);
  ImGui::Separator();
  entry(context, ActionId::TogglePages);
  entry(context, ActionId::ToggleTabs);
}

void plain_menu(UiContext& context, std::initializer_list<ActionId> ids) {
  for (const ActionId id : ids) entry(context, id);
}

void title_at_right(UiContext& context) {
  if (!context.session.has_model()) return;
  const std::string name = (context.session.is_modified() ? "• " : "") + project_name(context.session);
  const float width = ImGui::CalcTextSize(name.c_str()).x;
  const float left = ImGui::GetWindowWidth() - width - context.ui.look.px(16);
  if (left < ImGui::GetCursorPosX()) return;
  ImGui::SetCursorPosX(left);
  text_muted(context.ui, name);
}

}  // namespace

float draw_menu_bar(UiContext& context) {
  const Look& look = context.ui.look;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(look.px(8), look.px(7)));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(look.px(16), look.px(8)));
  if (!ImGui::BeginMainMenuBar()) {
    ImGui::PopStyleVar(2);
    return 0;
  }
  const auto menu = [&](const char* name, auto&& fill) {
    const bool is_open = ImGui::BeginMenu(name);
    note_widget(context.ui, std::string("menu/") + name);
    if (!is_open) return;
    fill();
    ImGui::EndMenu();
  };
  if (std::exchange(context.ui.wants_menus, false)) ImGui::OpenPopup("File");
  menu("File", [&] { file_menu(context); });
  menu("Edit", [&] {
    plain_menu(context, {ActionId::Undo, ActionId::Redo, ActionId::ShowHistory});
    ImGui::Separator();
    plain_menu(context, {ActionId::Preferences});
  });
  menu("Model", [&] {
    plain_menu(context, {ActionId::ShowReport});
    ImGui::Separator();
    plain_menu(context,
               {ActionId::MergeFaces, ActionId::SplitFace, ActionId::Simplify400, ActionId::AllFaces});
    ImGui::Separator();
    plain_menu(context, {ActionId::CentreFace, ActionId::ClearSelection});
  });
  menu("Solve", [&] {
    plain_menu(context, {ActionId::Unfold, ActionId::UnfoldFromHere, ActionId::Step, ActionId::Stop,
                         ActionId::NewSeed, ActionId::SkipReplay});
    ImGui::Separator();
    plain_menu(context, {ActionId::JoinAndCut, ActionId::MakeRoomForTabs});
    ImGui::Separator();
    plain_menu(context,
               {ActionId::AskWhy, ActionId::FindReleases, ActionId::FindSoftening, ActionId::FindPieces});
    ImGui::Separator();
    plain_menu(context, {ActionId::PinRoot, ActionId::MustFold, ActionId::MustCut, ActionId::KeepTogether,
                         ActionId::ClearPins, ActionId::ClearAllPins});
    ImGui::Separator();
    plain_menu(context, {ActionId::NewerRun, ActionId::OlderRun, ActionId::AcceptRun, ActionId::LeaveRun,
                         ActionId::DeleteRun, ActionId::ExportBestRun});
    ImGui::Separator();
    plain_menu(context, {ActionId::PlayMoves, ActionId::MoveBack, ActionId::MoveOn});
  });
  menu("Paper", [&] { paper_menu(context); });
  menu("View", [&] { view_menu(context); });
  menu("Help", [&] { plain_menu(context, {ActionId::Keys, ActionId::About}); });
  title_at_right(context);
  const float height = ImGui::GetWindowHeight();
  ImGui::EndMainMenuBar();
  ImGui::PopStyleVar(2);
  return height;
}

}  // namespace netwright
