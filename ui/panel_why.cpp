// Why a search found no single piece: the heat map and its scale, the corners with too much paper around
// them, and which pins to release.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "assets/icons.h"
#include "core/base/counted.h"
#include "ui/actions.h"
#include "ui/heat.h"
#include "ui/panels.h"
#include "ui/status.h"
#include "ui/view_parts.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

constexpr int kRowsSeen = 6;
constexpr float kRowHeight = 26;
constexpr float kSwatch = 14;
constexpr std::size_t kMostWays = 12;

void wrapped(const UiState& ui, const std::string& text) {
  ImGui::PushTextWrapPos(ImGui::GetWindowContentRegionMax().x - ui.look.px(16));
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
}

int percent(double share) { return static_cast<int>(std::lround(100 * share)); }

std::string degrees_text(double angle_rad) {
  return std::to_string(std::lround(angle_rad * 180 / std::numbers::pi)) + "°";
}

void heat_scale(const UiState& ui) {
  const Look& look = ui.look;
  const Palette& p = palette_of(ui);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  ImVec2 at = ImGui::GetCursorScreenPos();
  const char* const names[] = {"seldom", "often", "most"};
  const float line = look.px(20);
  for (std::size_t i = 0; i < p.heat.size(); ++i) {
    const float top = std::floor(at.y + (line - look.px(kSwatch)) / 2);
    const ImVec2 end(at.x + look.px(kSwatch), top + look.px(kSwatch));
    draw.AddRectFilled(ImVec2(at.x, top), end, to_u32(p.paper), look.px(2));
    draw.AddRectFilled(ImVec2(at.x, top), end, to_u32(p.heat[i]), look.px(2));
    draw.AddText(ImVec2(end.x + look.px(6), std::floor(at.y + (line - ImGui::GetTextLineHeight()) / 2)),
                 look.colours.muted, names[i]);
    at.x = end.x + look.px(6 + 14) + ImGui::CalcTextSize(names[i]).x;
  }
  ImGui::Dummy(ImVec2(look.px(1), line));
}

void heat_rows(UiContext& c, const Trouble& trouble) {
  wrapped(c.ui, "Four of five collisions were at " +
                    counted(static_cast<std::int64_t>(trouble.hot.size()), "face.", "faces."));
  bool is_on = c.ui.settings.show_heat;
  const Action& heat = action(ActionId::ToggleHeat);
  if (checkbox(c.ui, "why/heat", std::string(heat.name), is_on, tip_of(c, heat)))
    run_action(c, ActionId::ToggleHeat);
  if (c.ui.settings.show_heat) heat_scale(c.ui);
}

void point_row(UiContext& c, const ExcessPoint& point, std::size_t index) {
  UiState& ui = c.ui;
  const Look& look = ui.look;
  const Mesh& mesh = c.session.project().dual->mesh();
  const std::string name = "why/point/" + std::to_string(index);
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x, look.px(kRowHeight));
  const bool is_clicked = ImGui::InvisibleButton(name.c_str(), size);
  if (pressed_by_key(ui, name) || is_clicked) show_excess_point(c, point.vertex);
  note_widget(ui, name);
  const bool is_lit = ui.lit.points == std::vector<glm::dvec3>{mesh.position(point.vertex)};
  const ImVec2 max(min.x + size.x, min.y + size.y);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  if (is_lit || ImGui::IsItemHovered())
    draw.AddRectFilled(min, max, is_lit ? look.colours.tint : look.colours.hover, look.px(4));
  const float y = std::floor(min.y + (size.y - ImGui::GetTextLineHeight()) / 2);
  const std::string share = "in " + std::to_string(percent(point.share)) + " %";
  const float right = max.x - look.px(8) - ImGui::CalcTextSize(share.c_str()).x;
  draw.AddText(ImVec2(min.x + look.px(8), y), is_lit ? look.colours.on_tint : look.colours.text,
               (degrees_text(point.angle_rad) + " around it").c_str());
  draw.AddText(ImVec2(right, y), is_lit ? look.colours.on_tint : look.colours.muted, share.c_str());
  if (ImGui::IsItemHovered())
    ui.hint = is_lit ? "Click again to let go of this corner"
                     : "Click shows this corner in both views; % of all collisions are at its faces";
}

void point_rows(UiContext& c, const Trouble& trouble) {
  if (trouble.points.empty()) return;
  const std::size_t n = std::min(trouble.points.size(), kMostExcessPoints);
  const auto n_all = static_cast<std::int64_t>(trouble.points.size());
  wrapped(c.ui, counted(n_all, "corner there has", "corners there have") +
                    " more than 360° of paper around: each needs a cut to lie flat.");
  const float width = ImGui::GetContentRegionAvail().x - c.ui.look.px(16);
  const float n_seen = static_cast<float>(std::min(static_cast<int>(n), kRowsSeen));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  ImGui::BeginChild("##points", ImVec2(width, n_seen * c.ui.look.px(kRowHeight)));
  for (std::size_t i = 0; i < n; ++i) point_row(c, trouble.points[i], i);
  ImGui::EndChild();
  ImGui::PopStyleVar();
}

/// What is being tried, how far, and a way out.
void trial_row(UiContext& c, const Progress& progress) {
  UiState& ui = c.ui;
  wrapped(ui, progress.phase() + "…");
  ButtonSpec stop{"why/stop", "Stop", icon::kStop, "Gives up trying"};
  stop.kind = ButtonKind::Outlined;
  const float width = ImGui::GetContentRegionAvail().x - ui.look.px(16 + 8) - button_width(ui, stop);
  const float y = ImGui::GetCursorPosY();
  ImGui::SetCursorPosY(y + ui.look.px(14));
  progress_line(ui, width, progress.fraction());
  ImGui::SameLine();
  ImGui::SetCursorPosY(y);
  if (button(ui, stop)) c.session.stop_trial();
}

void way_row(UiContext& c, const std::vector<Pin>& way, std::size_t index) {
  UiState& ui = c.ui;
  const Mesh& mesh = c.session.project().dual->mesh();
  std::string words = pins_words(mesh, way, [](FaceId f) { return f.value + 1; });
  words.front() = 'T';
  wrapped(ui, words);
  const std::string number = std::to_string(index);
  ButtonSpec show{"why/show/" + number, "Show", icon::kSearch, "Shows it in both views"};
  show.kind = ButtonKind::Outlined;
  ButtonSpec release{"why/release/" + number, "Release", icon::kUnpin,
                     "Takes this back and unfolds again; one step to undo"};
  release.kind = ButtonKind::Outlined;
  if (button(ui, show)) {
    ui.wants_flight.clear();
    for (const Pin& pin : way)
      for (const FaceId f : faces_of(mesh, pin)) ui.wants_flight.push_back(f);
  }
  ImGui::SameLine();
  if (button(ui, release)) c.session.release(std::vector<Pin>(way));
}

void release_rows(UiContext& c) {
  UiState& ui = c.ui;
  if (c.session.project().pins.are_free() || c.session.trouble()->is_impossible) return;
  const auto found = c.session.releases();
  if (found == nullptr) {
    if (c.session.trial() != nullptr) return;
    const Action& look = action(ActionId::FindReleases);
    ButtonSpec spec{"why/find", std::string(look.name), icon::kUnpin, tip_of(c, look)};
    spec.kind = ButtonKind::Outlined;
    spec.is_enabled = is_possible(c, ActionId::FindReleases);
    if (button(ui, spec)) run_action(c, ActionId::FindReleases);
    return;
  }
  if (found->are_innocent) {
    wrapped(ui, "The pins are not to blame: no net was found without them either.");
    return;
  }
  wrapped(ui,
          found->ways.size() > 1 ? "Releasing any one of these gives a net:" : "Releasing this gives a net:");
  for (std::size_t i = 0; i < std::min(found->ways.size(), kMostWays); ++i) way_row(c, found->ways[i], i);
}

ButtonSpec take_button(const std::string& name, const std::string& label, const char* tip) {
  ButtonSpec spec{name, label, icon::kDone, tip};
  spec.kind = ButtonKind::Outlined;
  return spec;
}

void softening_rows(UiContext& c) {
  const auto found = c.session.softening();
  if (found == nullptr) return;
  if (!found->is_found()) return wrapped(c.ui, "No small change of shape gave a net.");
  const Project& project = c.session.project();
  const double diagonal = glm::length(project.dual->mesh().box().size());
  const double in_mm = guess_unit(*project.source).in_mm;
  std::array<char, 32> share{};
  std::snprintf(share.data(), share.size(), "%.1f %%", 100 * found->deviation / diagonal);
  wrapped(c.ui, "Moving " + counted(found->n_moved, "corner", "corners") +
                    " gives a net; the surface moves by " +
                    length_text(found->deviation * in_mm, c.ui.settings.unit) + " at most, " + share.data() +
                    " of the model's size.");
  if (button(c.ui, take_button("why/take-softening", "Soften",
                               "Changes the shape so and unfolds it; can be undone")))
    c.session.take_softening();
}

/// "2 pieces · 1 234 mm · 104 %", as much of it as there is room for; without millimetres while they are not
/// known.
ButtonSpec pieces_button(const UiContext& c, const PiecesResult& found, std::size_t i) {
  const PiecesChoice& choice = found.choices[i];
  const double shortest = std::ranges::min_element(found.choices, {}, &PiecesChoice::cut_length)->cut_length;
  const std::string share = " · " + std::to_string(percent(choice.cut_length / shortest)) + " %";
  const std::vector<double> cut_mm = c.session.pieces_cut_mm();
  std::string words = counted(choice.net.n_pieces, "piece", "pieces");
  if (i < cut_mm.size()) words += " · " + length_text(cut_mm[i], c.ui.settings.unit);
  const std::string name = "why/take-pieces/" + std::to_string(i);
  const char* tip = "Takes this net; can be undone. The length is that of all cuts at the present size";
  const ButtonSpec spec = take_button(name, words + share, tip);
  const float room = ImGui::GetContentRegionAvail().x - c.ui.look.px(16);
  const bool is_short = i >= cut_mm.size() || button_width(c.ui, spec) <= room;
  return is_short ? spec : take_button(name, words, tip);
}

void pieces_rows(UiContext& c) {
  const auto found = c.session.pieces();
  if (found == nullptr) return;
  if (found->choices.empty()) return wrapped(c.ui, "No net of several pieces was found.");
  wrapped(c.ui, "Nets of several pieces, and how long their cuts are:");
  for (std::size_t i = 0; i < found->choices.size(); ++i) {
    if (!button(c.ui, pieces_button(c, *found, i))) continue;
    c.session.take_pieces(i);
    return;
  }
}

}  // namespace

void panel_why(UiContext& context) {
  const auto trouble = context.session.trouble();
  if (trouble == nullptr) return;
  if (const auto trial = context.session.trial()) trial_row(context, *trial);
  release_rows(context);
  softening_rows(context);
  pieces_rows(context);
  if (!trouble->hot.empty()) heat_rows(context, *trouble);
  point_rows(context, *trouble);
}

}  // namespace netwright
