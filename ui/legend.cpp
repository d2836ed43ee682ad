// A swatch of paper for each kind of line. Where room is short, swatches and gaps shrink before anything is
// left out.
#include "ui/legend.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>
#include <vector>

#include "ui/heat.h"
#include "ui/view_parts.h"

namespace netwright {
namespace {

enum class Mark { Line, Dot, Fill, Hatch };

struct Entry {
  std::string label;
  Mark mark = Mark::Line;
  Colour colour{0};
  std::vector<float> dash = {};  ///< ink, gap … in design pixels; empty = solid
};

bool has_kind(const ShownNet& shown, EdgeKind kind) {
  return std::find(shown.kinds.begin(), shown.kinds.end(), kind) != shown.kinds.end();
}

void add_pins(const Constraints& pins, const Palette& p, std::vector<Entry>& entries) {
  if (!pins.must_fold.empty()) entries.push_back({"must fold", Mark::Line, p.pinned_fold});
  if (!pins.must_cut.empty()) entries.push_back({"must cut", Mark::Line, p.pinned_cut});
  if (!pins.together.empty()) entries.push_back({"patch", Mark::Line, p.patch});
}

/// A printed line as large as it is drawn in a swatch.
Entry printed_entry(const char* label, const PrintedLine& line) {
  constexpr double kPixelsPerMm = 2;
  constexpr double kLeastPixels = 1.2;
  Entry entry{label, Mark::Line, Colour(glm::vec3(line.colour), 1)};
  for (const double part : line.dash_mm)
    entry.dash.push_back(static_cast<float>(std::max(part * kPixelsPerMm, kLeastPixels)));
  return entry;
}

/// The sheet's own lines; there is no tree on it, and the root is a face with a tint.
std::vector<Entry> printed_entries(const UiContext& context, const ShownNet& shown) {
  const Project& project = context.session.project();
  const LineStyles& lines = project.sheet.lines;
  const Palette& p = palette_of(context.ui);
  std::vector<Entry> entries{printed_entry("cut", lines.cut), printed_entry("mountain", lines.mountain)};
  if (has_kind(shown, EdgeKind::Valley)) entries.push_back(printed_entry("valley", lines.valley));
  if (const auto pages = context.session.pages(); pages != nullptr && !pages->tabs.tabs.empty())
    entries.push_back(printed_entry("tab", lines.tab_fold));
  add_pins(project.pins, p, entries);
  if (context.ui.settings.show_root) entries.push_back({"root", Mark::Fill, p.root});
  return entries;
}

/// While single moves are watched the moves are the topic, not the folds.
std::vector<Entry> entries_of(const UiContext& context, const ShownNet& shown) {
  const UiState& ui = context.ui;
  const Palette& p = palette_of(ui);
  const bool is_stepping = !shown.climbed.empty();
  std::vector<Entry> entries;
  if (shows_heat(context)) {
    entries.push_back({"seldom", Mark::Fill, p.heat[0]});
    entries.push_back({"often", Mark::Fill, p.heat[1]});
    entries.push_back({"most in collision", Mark::Fill, p.heat[2]});
    entries.push_back({"over 360°", Mark::Dot, Colour(glm::vec3(p.overlap), 1)});
  }
  if (is_stepping) {
    if (shown.last_move) entries.push_back({"chosen", Mark::Fill, p.chosen});
    entries.push_back({"climb", Mark::Line, Colour(glm::vec3(p.chosen), 1)});
    entries.push_back({"candidate", Mark::Line, p.candidate, {4, 3}});
  } else {
    entries.push_back({"cut", Mark::Line, p.cut});
    entries.push_back({"mountain", Mark::Line, p.mountain, {6, 2, 2, 2}});
    entries.push_back({"valley", Mark::Line, p.valley, {4, 3}});
    if (has_kind(shown, EdgeKind::Flat))
      entries.push_back({"flat", Mark::Line, Colour(glm::vec3(p.flat), 0.4F)});
    if (has_kind(shown, EdgeKind::Border)) entries.push_back({"border", Mark::Line, p.border});
    add_pins(context.session.project().pins, p, entries);
  }
  // Where room runs out the last ones go: tree and root have switches of their own that say what they are.
  if (ui.settings.show_overlaps && !shown.overlaps.empty() && !shows_heat(context))
    entries.push_back({"overlap", Mark::Hatch, p.overlap});
  if (ui.settings.show_pages && context.session.misplaced() != nullptr)
    entries.push_back({"misplaced", Mark::Hatch, p.overlap});
  if (ui.settings.show_tree) entries.push_back({"tree", Mark::Line, p.tree});
  if (ui.settings.show_root) entries.push_back({"root", Mark::Dot, p.root});
  return entries;
}

float label_width(const UiState& ui, const Entry& entry) {
  const ImFont* font = ui.look.fonts.small;
  return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, entry.label.c_str()).x;
}

struct Spacing {
  float swatch = 32;  ///< of a line; dots and fills are square
  float gap = 16;
};

float swatch_width(const UiState& ui, const Entry& entry, const Spacing& spacing) {
  return ui.look.px(entry.mark == Mark::Line ? spacing.swatch : 16);
}

Spacing spacing_for(const UiState& ui, const std::vector<Entry>& entries, float width) {
  for (const Spacing spacing : {Spacing{32, 16}, Spacing{26, 10}}) {
    float used = ui.look.px(32);
    for (const Entry& entry : entries) {
      used += swatch_width(ui, entry, spacing) + ui.look.px(6 + spacing.gap) + label_width(ui, entry);
    }
    if (used - ui.look.px(spacing.gap) <= width) return spacing;
  }
  return {18, 8};
}

void draw_dashes(const UiState& ui, const Entry& entry, ImVec2 from, float to_x) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImU32 colour = to_u32(entry.colour);
  const float thick = 1.5F * ui.look.scale;
  if (entry.dash.empty()) {
    draw.AddLine(from, ImVec2(to_x, from.y), colour, thick);
    return;
  }
  float x = from.x;
  for (std::size_t i = 0; x < to_x; ++i) {
    const float end = std::min(x + entry.dash[i % entry.dash.size()] * ui.look.scale, to_x);
    if (i % 2 == 0) draw.AddLine(ImVec2(x, from.y), ImVec2(end, from.y), colour, thick);
    x = end;
  }
}

void draw_hatch(const UiState& ui, const Entry& entry, ImVec2 min, ImVec2 max) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(min, max, to_u32(entry.colour), ui.look.px(2));
  draw.PushClipRect(min, max, true);
  const float height = max.y - min.y;
  const ImU32 colour = to_u32(palette_of(ui).overlap_hatch);
  for (float x = min.x - height; x < max.x; x += ui.look.px(5)) {
    draw.AddLine(ImVec2(x, max.y), ImVec2(x + height, min.y), colour, ui.look.px(1.5F));
  }
  draw.PopClipRect();
}

void draw_swatch(const UiState& ui, const Entry& entry, ImVec2 min, ImVec2 max) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(min, max, to_u32(palette_of(ui).paper), ui.look.px(2));
  const ImVec2 middle((min.x + max.x) / 2, (min.y + max.y) / 2);
  if (entry.mark == Mark::Line) {
    draw_dashes(ui, entry, ImVec2(min.x + ui.look.px(4), middle.y), max.x - ui.look.px(4));
  } else if (entry.mark == Mark::Dot) {
    draw.AddCircleFilled(middle, ui.look.px(4.5F), to_u32(entry.colour), 16);
    draw.AddCircle(middle, ui.look.px(4.5F), to_u32(palette_of(ui).root_rim), 16, 1.5F * ui.look.scale);
  } else if (entry.mark == Mark::Fill) {
    draw.AddRectFilled(min, max, to_u32(entry.colour), ui.look.px(2));
  } else {
    draw_hatch(ui, entry, min, max);
  }
}

}  // namespace

float legend_height(const UiState& ui) { return ui.look.px(40); }

void draw_legend(const UiContext& context, const ShownNet* shown, bool is_printed) {
  const UiState& ui = context.ui;
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const ImVec2 max(min.x + ImGui::GetContentRegionAvail().x, min.y + legend_height(ui));
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(min, max, to_u32(palette_of(ui).desk));
  if (shown == nullptr) return;
  const std::vector<Entry> entries =
      is_printed ? printed_entries(context, *shown) : entries_of(context, *shown);
  const Spacing spacing = spacing_for(ui, entries, max.x - min.x);
  const ImFont* font = ui.look.fonts.small;
  const float middle = (min.y + max.y) / 2;
  float x = min.x + ui.look.px(16);
  for (const Entry& entry : entries) {
    const ImVec2 corner(x, std::floor(middle - ui.look.px(8)));
    const ImVec2 end(x + swatch_width(ui, entry, spacing), corner.y + ui.look.px(16));
    const float text = end.x + ui.look.px(6);
    if (text + label_width(ui, entry) > max.x) break;
    draw_swatch(ui, entry, corner, end);
    draw.AddText(font, font->FontSize, ImVec2(text, std::floor(middle - font->FontSize / 2)),
                 ui.look.colours.text, entry.label.c_str());
    x = text + label_width(ui, entry) + ui.look.px(spacing.gap);
  }
}

}  // namespace netwright
