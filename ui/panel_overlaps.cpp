// The side panel's list of overlaps: one line per pair of faces, a click flies there.
#include <algorithm>
#include <array>
#include <cstdio>

#include "core/unfold/overlap_depth.h"
#include "ui/panels.h"
#include "ui/selection.h"
#include "ui/status.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

constexpr int kRowsSeen = 8;
constexpr float kRowHeight = 26;

/// On paper, or as a share of a mean edge while the size on paper is not known.
std::string depth_text(const UiContext& context, double depth) {
  const double scale = print_scale(context.session);
  if (scale > 0) return length_text(depth * scale, context.ui.settings.unit);
  std::array<char, 32> text{};
  const double percent = 100 * depth / context.session.project().dual->mesh().mean_edge();
  std::snprintf(text.data(), text.size(), percent < 0.1 ? "under 0.1 %%" : "%.1f %%", percent);
  return text.data();
}

void show(UiState& ui, const Overlap& overlap) {
  if (ui.shown_overlap == overlap) {
    ui.shown_overlap.reset();
    return;
  }
  ui.shown_overlap = overlap;
  ui.wants_flight = {overlap.first, overlap.second};
}

void draw_row(UiContext& context, const OverlapList::Row& row, std::size_t index) {
  UiState& ui = context.ui;
  const Look& look = ui.look;
  const std::string name = "overlaps/" + std::to_string(index);
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x, look.px(kRowHeight));
  const bool is_clicked = ImGui::InvisibleButton(name.c_str(), size);
  if (pressed_by_key(ui, name) || is_clicked) show(ui, row.overlap);
  note_widget(ui, name);
  const bool is_lit = ui.shown_overlap == row.overlap;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec2 max(min.x + size.x, min.y + size.y);
  if (is_lit || ImGui::IsItemHovered())
    draw.AddRectFilled(min, max, is_lit ? look.colours.tint : look.colours.hover, look.px(4));
  const std::string depth = depth_text(context, row.depth);
  const float y = std::floor(min.y + (size.y - ImGui::GetTextLineHeight()) / 2);
  const float right = max.x - look.px(8) - ImGui::CalcTextSize(depth.c_str()).x;
  const std::string faces =
      "Faces " + grouped(row.overlap.first.value + 1) + " and " + grouped(row.overlap.second.value + 1);
  const std::string text = shortened(faces, right - look.px(16) - min.x);
  draw.AddText(ImVec2(min.x + look.px(8), y), is_lit ? look.colours.on_tint : look.colours.text,
               text.c_str());
  draw.AddText(ImVec2(right, y), is_lit ? look.colours.on_tint : look.colours.muted, depth.c_str());
  // A tooltip would cover the lines below.
  if (ImGui::IsItemHovered())
    ui.hint = is_lit ? "Click again to let go of this overlap" : "Click shows this overlap in both views";
}

}  // namespace

void OverlapList::list(const ShownNet& shown) {
  if (version == shown.version) return;
  version = shown.version;
  rows.clear();
  for (const Overlap& overlap : shown.overlaps) {
    if (rows.size() == kMostRows) break;
    rows.push_back({overlap, overlap_depth(shown.net, overlap)});
  }
  std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.depth > b.depth; });
}

void panel_overlaps(UiContext& context) {
  UiState& ui = context.ui;
  const auto shown = context.session.shown();
  if (shown == nullptr) return;
  OverlapList& list = ui.overlaps;
  list.list(*shown);
  const bool is_measured = print_scale(context.session) > 0;
  const auto n_listed = static_cast<std::int64_t>(list.rows.size());
  const auto n_all = static_cast<std::int64_t>(shown->overlaps.size());
  std::string what =
      n_listed == n_all ? "" : "The first " + grouped(n_listed) + " of " + grouped(n_all) + ". ";
  what += is_measured ? "Depth on paper." : "Depth in % of a mean edge.";
  text_muted(ui, what);
  const int n_seen = std::min(static_cast<int>(n_listed), kRowsSeen);
  const float width = ImGui::GetContentRegionAvail().x - ui.look.px(16);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  ImGui::BeginChild("##overlaps", ImVec2(width, static_cast<float>(n_seen) * ui.look.px(kRowHeight)));
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(list.rows.size()), ui.look.px(kRowHeight));
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
      draw_row(context, list.rows[static_cast<std::size_t>(i)], static_cast<std::size_t>(i));
  }
  ImGui::EndChild();
  ImGui::PopStyleVar();
}

}  // namespace netwright
