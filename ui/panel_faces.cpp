// The number of faces: a slider from the fewest to all of them, each stop unfolded at once, and whether
// neighbours of one plane become one face.
#include <algorithm>
#include <cmath>

#include "ui/actions.h"
#include "ui/panels.h"
#include "ui/status.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

constexpr int kUsualLeast = 20;  ///< what simplifying aims at, as long as it has not been tried

struct Range {
  int fewest = 0;
  int all = 0;
  int wanted = 0;
  [[nodiscard]] bool is_open() const { return fewest < all; }
};

Range range_of(const Session& session) {
  Range range;
  const int known = session.project().made->n_faces_least;
  range.all = session.n_faces_before_simplifying();
  range.fewest = std::min(known > 0 ? known : kUsualLeast, range.all);
  const int faces = session.wanted_recipe().faces;
  range.wanted = faces == 0 ? range.all : std::clamp(faces, range.fewest, range.all);
  return range;
}

void wish(Session& session, const Range& range, int faces, bool is_dragging) {
  session.simplify_to(faces >= range.all ? 0 : std::max(faces, range.fewest), is_dragging);
}

std::string why_no_range(const Range& range) {
  return "A model of " + counted(range.all, "face", "faces") + " has none to spare.";
}

void slider_row(UiContext& context, const Range& range) {
  UiState& ui = context.ui;
  const float field = ui.look.px(72);
  // A scroll bar that comes while the slider is held must not change what the slider says.
  if (!ui.is_dragging_faces)
    ui.faces_slider_width = ImGui::GetContentRegionAvail().x - ui.look.px(24) - field;
  auto t = static_cast<float>(slider_of_faces(range.wanted, range.fewest, range.all));
  const std::string tip = range.is_open() ? "Fewer faces, same look: the net follows" : why_no_range(range);
  const bool is_moved = slim_slider(ui, "model/faces", ui.faces_slider_width, t, tip, range.is_open());
  ui.is_dragging_faces = ImGui::IsItemActive();
  const int faces = is_moved ? faces_of_slider(t, range.fewest, range.all) : range.wanted;
  if (ImGui::IsItemDeactivated()) {
    wish(context.session, range, faces, false);
  } else if (is_moved) {
    wish(context.session, range, faces, true);
  }
  ImGui::SameLine();
  ImGui::SetNextItemWidth(field);
  auto typed = static_cast<std::uint64_t>(faces);
  if (!range.is_open()) ImGui::BeginDisabled();
  if (number_field(ui, "model/faces-field", typed)) {
    const auto most = static_cast<std::uint64_t>(range.all);
    wish(context.session, range, static_cast<int>(std::min(typed, most)), false);
  }
  if (!range.is_open()) ImGui::EndDisabled();
  tooltip(ui, range.is_open() ? "At most so many faces" : why_no_range(range));
}

/// How far the model is from the file's, and what the search will make of it.
void figures(const UiContext& context, const Range& range) {
  const UiState& ui = context.ui;
  const Session& session = context.session;
  const auto faces = static_cast<std::int64_t>(session.project().dual->mesh().n_faces());
  const bool is_simplified = session.recipe().faces > 0 && faces < range.all;
  ImGui::BeginGroup();
  ImGui::PushFont(ui.look.fonts.small);
  text_muted(ui, faces_text(faces, range.all));
  if (is_simplified) {
    const std::optional<double> off = session.deviation_mm();
    text_muted(ui, off ? "off by at most " + length_text(*off, ui.settings.unit) : "measuring how far off…");
  }
  const double moves = session.project().made->difficulty;
  text_muted(ui, difficulty_text(moves));
  ImGui::PopFont();
  ImGui::EndGroup();
  note_widget(ui, "model/figures");
  tooltip(ui, "To unfold: a guess from the model's shape, before any search");
}

void all_faces_button(UiContext& context) {
  const UiState& ui = context.ui;
  const Action& all = action(ActionId::AllFaces);
  ButtonSpec spec{"model/all", std::string(all.name)};
  spec.kind = ButtonKind::Outlined;
  spec.tip = tip_of(context, all);
  spec.height = ui.look.px(30);
  spec.is_enabled = is_possible(context, ActionId::AllFaces);
  const float right = ImGui::GetWindowContentRegionMax().x - ui.look.px(16);
  ImGui::SameLine(right - button_width(ui, spec));
  if (button(ui, spec)) run_action(context, ActionId::AllFaces);
}

/// A place of its own that is always there, so that nothing jumps when work begins.
void work_line(const UiContext& context) {
  const UiState& ui = context.ui;
  const float width = ImGui::GetContentRegionAvail().x - ui.look.px(16);
  const auto chore = context.session.is_making() ? context.session.chore() : nullptr;
  if (chore == nullptr) {
    ImGui::Dummy(ImVec2(width, ui.look.px(4)));
    return;
  }
  progress_line(ui, width, chore->fraction());
  note_widget(ui, "model/progress");
  const std::string percent = std::to_string(std::lround(chore->fraction() * 100)) + " %";
  tooltip(ui, chore->phase() + "… " + percent);
}

void merge_row(UiContext& context, const Range& range) {
  const UiState& ui = context.ui;
  const Session& session = context.session;
  const Action& merge = action(ActionId::MergeFaces);
  bool is_merging = merge.is_on(context);
  if (checkbox(ui, "model/merge", std::string(merge.name), is_merging, tip_of(context, merge)))
    run_action(context, ActionId::MergeFaces);
  if (!session.recipe().merges) return;
  // The sentences come in the recipe's order; those about merging are the last ones.
  const MadeModel& made = *session.project().made;
  const bool is_simplified = session.recipe().faces > 0 && session.recipe().faces < range.all;
  ImGui::PushFont(ui.look.fonts.small);
  ImGui::PushTextWrapPos(ImGui::GetWindowContentRegionMax().x - ui.look.px(16));
  for (std::size_t i = made.stages->done.size() + (is_simplified ? 1 : 0); i < made.done.size(); ++i)
    text_muted(ui, made.done[i]);
  ImGui::PopTextWrapPos();
  ImGui::PopFont();
}

}  // namespace

void panel_faces(UiContext& context) {
  UiState& ui = context.ui;
  const Range range = range_of(context.session);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.look.px(8), ui.look.px(4)));
  ImGui::Dummy(ImVec2(0, ui.look.px(2)));
  ImGui::PushFont(ui.look.fonts.bold);
  ImGui::TextUnformatted("Faces");
  ImGui::PopFont();
  slider_row(context, range);
  work_line(context);
  figures(context, range);
  all_faces_button(context);
  ImGui::Dummy(ImVec2(0, 0));
  merge_row(context, range);
  ImGui::PopStyleVar();
}

}  // namespace netwright
