// The finished runs, the newest on top: a picture of the net, how it was found, and what it is worth. A click
// looks at one without changing anything; what can be done with it stands below the list.
#include <algorithm>
#include <array>
#include <cmath>

#include "assets/icons.h"
#include "ui/actions.h"
#include "ui/panels.h"
#include "ui/run_actions.h"
#include "ui/run_pictures.h"
#include "ui/status.h"
#include "ui/view_parts.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

constexpr float kRowHeight = 76;
constexpr float kGap = 4;
constexpr float kMostRows = 3.5F;    ///< more are scrolled; the half one shows that there are more
constexpr float kPictureWidth = 78;  ///< as run pictures have it
constexpr float kPictureHeight = 64;

constexpr const char* kScoreMeaning =
    "Score: how much of its smallest rectangle the net fills. A compact net prints larger on the same page.";

std::string size_text(const UiContext& c, const FinishedRun& run) {
  const auto size = size_on_paper(run.measures, c.session.project().paper, c.session.project().size);
  return size ? area_text(size->x, size->y, c.ui.settings.unit) : "";
}

std::string pieces_text(const FinishedRun& run) {
  return run.measures.n_pieces == 1 ? "one piece" : counted(run.measures.n_pieces, "piece", "pieces");
}

/// Three short lines: how it was found, at what cost, what came out.
std::array<std::string, 3> lines_of(const UiContext& c, const FinishedRun& run) {
  const RunSummary& summary = run.summary;
  std::array<std::string, 3> lines;
  lines[0] = "seed " + std::to_string(summary.seed) + " · " + counted(summary.moves, "move", "moves");
  lines[1] = (summary.seconds > 0 ? duration_text(summary.seconds) + " · " : "") + pieces_text(run);
  lines[2] =
      summary.is_proved ? size_text(c, run) : counted(summary.overlaps, "overlap", "overlaps") + " left";
  return lines;
}

std::string tip_text(const UiContext& c, const FinishedRun& run) {
  const PrintSize& size = c.session.project().size;
  std::string tip;
  for (const std::string& line : lines_of(c, run)) tip += line.empty() ? "" : line + "\n";
  if (run.summary.is_proved && size.kind == PrintSize::Kind::Height && run.measures.model_height > 0) {
    const double scale = size.height_mm / run.measures.model_height;
    tip += "to cut: " + length_text(run.measures.cut_length * scale, c.ui.settings.unit) + "\n";
  }
  tip += kScoreMeaning;
  if (run.summary.is_proved && run.number == c.session.best_run()) tip += " This one is the best so far.";
  return tip;
}

/// A word on a tinted field.
void pill(const UiState& ui, const char* word, ImVec2 at, ImU32 back, ImU32 text) {
  ImFont* font = ui.look.fonts.small;
  const ImVec2 extent = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, word);
  const float width = extent.x + ui.look.px(12);
  const float height = ui.look.px(18);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(at, ImVec2(at.x + width, at.y + height), back, height / 2);
  draw.AddText(font, font->FontSize, ImVec2(at.x + ui.look.px(6), std::floor(at.y + (height - extent.y) / 2)),
               text, word);
}

void draw_picture(const UiState& ui, const RunList::Entry& run, ImVec2 min) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec2 max(min.x + ui.look.px(kPictureWidth), min.y + ui.look.px(kPictureHeight));
  const Palette& palette = palette_of(ui);
  draw.AddRectFilled(min, max, to_u32(palette.desk), ui.look.px(4));
  if (ui.run_pictures == nullptr) return;
  draw.AddImage(ui.run_pictures->of(run), min, max, ImVec2(0, 1), ImVec2(1, 0), to_u32(palette.paper));
}

/// Ends at `right_top`; the best one's stands out.
void draw_score(const UiContext& c, const FinishedRun& run, ImVec2 right_top) {
  const Look& look = c.ui.look;
  const bool is_best = run.number == c.session.best_run();
  const std::string score = std::to_string(run.score());
  ImFont* bold = look.fonts.bold;
  const ImVec2 extent = bold->CalcTextSizeA(bold->FontSize, FLT_MAX, 0, score.c_str());
  const ImVec2 at(right_top.x - extent.x, right_top.y);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  if (is_best)
    draw.AddRectFilled(ImVec2(at.x - look.px(7), at.y - look.px(1)),
                       ImVec2(right_top.x + look.px(7), at.y + extent.y + look.px(1)), look.colours.accent,
                       look.px(9));
  draw.AddText(bold, bold->FontSize, at, is_best ? look.colours.on_accent : look.colours.text, score.c_str());
}

void draw_words(const UiContext& c, const FinishedRun& run, ImVec2 min, ImVec2 max) {
  const UiState& ui = c.ui;
  const Look& look = ui.look;
  const Colours& colours = look.colours;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float left = min.x + look.px(kPictureWidth + 14);
  const float right = max.x - look.px(8);
  const float top = min.y + look.px(6);
  ImFont* bold = look.fonts.bold;
  const std::string name = "Run " + std::to_string(run.number);
  draw.AddText(bold, bold->FontSize, ImVec2(left, top), colours.text, name.c_str());
  const float x = left + bold->CalcTextSizeA(bold->FontSize, FLT_MAX, 0, name.c_str()).x + look.px(8);
  if (run.number == c.session.accepted_run())
    pill(ui, "in use", ImVec2(x, top), colours.tint, colours.on_tint);
  if (run.summary.is_proved) draw_score(c, run, ImVec2(right, top));
  ImFont* small = look.fonts.small;
  const std::array<std::string, 3> lines = lines_of(c, run);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    ImGui::PushFont(small);
    const std::string text = shortened(lines[i], right - left);
    ImGui::PopFont();
    const bool is_bad = i == 2 && !run.summary.is_proved;
    draw.AddText(small, small->FontSize,
                 ImVec2(left, top + look.px(3) + static_cast<float>(i + 1) * look.px(16)),
                 is_bad ? colours.bad : colours.muted, text.c_str());
  }
}

void run_row(UiContext& c, const RunList::Entry& run, float width) {
  UiState& ui = c.ui;
  const Look& look = ui.look;
  const bool is_viewed = run->number == c.session.viewed_run();
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const ImVec2 max(min.x + width, min.y + look.px(kRowHeight));
  const std::string name = "runs/" + std::to_string(run->number);
  const std::string reason = needs_runs(c);
  if (!reason.empty()) ImGui::BeginDisabled();
  bool is_clicked = ImGui::InvisibleButton(name.c_str(), ImVec2(max.x - min.x, max.y - min.y));
  note_widget(ui, name);
  is_clicked = pressed_by_key(ui, name) || is_clicked;
  if (!reason.empty()) ImGui::EndDisabled();
  const bool is_hovered = ImGui::IsItemHovered();
  tooltip(ui, reason.empty() ? tip_text(c, *run) : tip_text(c, *run) + "\n" + reason);
  if (is_viewed && ui.wants_run_in_view) ImGui::SetScrollHereY();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  if (is_viewed || is_hovered)
    draw.AddRectFilled(min, max, is_viewed ? look.colours.field : look.colours.hover, look.px(4));
  if (is_viewed) draw.AddRect(min, max, look.colours.accent, look.px(4), 0, look.px(1.5F));
  const float inset = std::floor((max.y - min.y - look.px(kPictureHeight)) / 2);
  draw_picture(ui, run, ImVec2(min.x + inset, min.y + inset));
  draw_words(c, *run, min, max);
  if (is_clicked) c.session.view_run(is_viewed ? 0 : run->number);
}

void run_list(UiContext& c, const std::vector<RunList::Entry>& runs) {
  UiState& ui = c.ui;
  const float row = ui.look.px(kRowHeight) + ui.look.px(kGap);
  const auto n = static_cast<float>(runs.size());
  const float width = ImGui::GetContentRegionAvail().x - ui.look.px(16);
  const bool is_scrolled = n > kMostRows;
  const float height = std::floor(row * std::min(n, kMostRows));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, ui.look.px(kGap)));
  ImGui::PushStyleVar(ImGuiStyleVar_ScrollbarSize, ui.look.px(8));
  ImGui::BeginChild("runs", ImVec2(width + (is_scrolled ? ui.look.px(12) : 0), height));
  for (auto run = runs.rbegin(); run != runs.rend(); ++run) run_row(c, *run, width);
  ImGui::EndChild();
  ImGui::PopStyleVar(2);
  ui.wants_run_in_view = false;
}

void action_button(UiContext& c, ActionId id, const char* name, const char* label, ButtonKind kind,
                   float width) {
  const Action& wanted = action(id);
  ButtonSpec spec{name, label, *label == 0 ? wanted.icon : "", tip_of(c, wanted)};
  spec.kind = kind;
  spec.width = width;
  spec.height = c.ui.look.px(30);
  spec.is_enabled = is_possible(c, id);
  if (button(c.ui, spec)) run_action(c, id);
}

void buttons(UiContext& c) {
  const UiState& ui = c.ui;
  const float gap = ui.look.px(8);
  const float square = ui.look.px(32);
  const float width = ImGui::GetContentRegionAvail().x - ui.look.px(16);
  const float wide = std::ceil(ImGui::CalcTextSize("Export best…").x) + 2 * ui.look.px(10);
  const bool can_accept = is_possible(c, ActionId::AcceptRun);
  action_button(c, ActionId::AcceptRun, "runs/accept", "Use net",
                can_accept ? ButtonKind::Accent : ButtonKind::Outlined, width - wide - square - 2 * gap);
  ImGui::SameLine(0, gap);
  action_button(c, ActionId::ExportBestRun, "runs/export-best", "Export best…", ButtonKind::Outlined, wide);
  ImGui::SameLine(0, gap);
  action_button(c, ActionId::DeleteRun, "runs/delete", "", ButtonKind::Outlined, square);
}

}  // namespace

void panel_runs(UiContext& context) {
  const UiState& ui = context.ui;
  const auto runs = context.session.runs();
  if (runs.empty()) {
    ImGui::PushTextWrapPos(ImGui::GetWindowContentRegionMax().x - ui.look.px(16));
    text_muted(ui, "Every finished run is kept here, to be looked at again and compared.");
    ImGui::PopTextWrapPos();
    return;
  }
  text_small(ui, "Score: % of its rectangle a net fills");
  tooltip(ui, kScoreMeaning);
  run_list(context, runs);
  buttons(context);
}

}  // namespace netwright
