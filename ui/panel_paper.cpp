// What is in the printer and how large the model gets. Each change is one undo step.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/base/paper.h"
#include "ui/actions.h"
#include "ui/arranging.h"
#include "ui/panels.h"
#include "ui/selection.h"
#include "ui/status.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

constexpr const char* kOwnSize = "Own size";

bool is_own_size(const PaperSetup& paper) {
  const auto format = find_paper(paper.format);
  return format && format->name == kCustomPaper;
}

/// What is in the printer stays there for the next model.
void take_format(UiContext& c, const std::string& name) {
  PaperSetup paper = c.session.project().paper;
  paper.format = name;
  c.session.set_paper(paper);
  c.ui.settings.paper = name;
  c.session.set_desk_paper(name);
}

void own_size_row(UiContext& c) {
  const auto format = find_paper(c.session.project().paper.format);
  double width_mm = format->width_mm;
  double height_mm = format->height_mm;
  const float each = (row(c.ui, "Its sides") - c.ui.look.px(24)) / 2;
  ImGui::SetNextItemWidth(each);
  bool is_entered = length_field(c.ui, "paper/own-width", width_mm);
  ImGui::SameLine();
  ImGui::SetNextItemWidth(each);
  is_entered = length_field(c.ui, "paper/own-height", height_mm) || is_entered;
  tooltip(c.ui, "The shorter side comes first; which one is upright the orientation says");
  if (is_entered)
    take_format(c, custom_paper(std::clamp(width_mm, kLeastPaperSide, kMostPaperSide),
                                std::clamp(height_mm, kLeastPaperSide, kMostPaperSide)));
}

void format_row(UiContext& c) {
  UiState& ui = c.ui;
  ImGui::SetNextItemWidth(row(ui, "Format") - ui.look.px(16));
  const PaperSetup paper = c.session.project().paper;
  const bool is_own = is_own_size(paper);
  if (!begin_combo(ui, "paper/format", is_own ? kOwnSize : paper.format)) return;
  for (const PaperFormat& format : paper_formats()) {
    const std::string name(format.name);
    if (ImGui::Selectable(
            (name + "   " + area_text(format.width_mm, format.height_mm, c.ui.settings.unit)).c_str(),
            name == paper.format) &&
        name != paper.format)
      take_format(c, name);
    note_widget(ui, "paper/format/" + name);
  }
  if (ImGui::Selectable(kOwnSize, is_own) && !is_own) {
    const auto format = find_paper(paper.format);
    take_format(c, custom_paper(format->width_mm, format->height_mm));
  }
  note_widget(ui, std::string("paper/format/") + kOwnSize);
  ImGui::EndCombo();
}

void orientation_row(UiContext& c) {
  PaperSetup paper = c.session.project().paper;
  int chosen = static_cast<int>(paper.orientation);
  const float width = row(c.ui, "Orientation") - c.ui.look.px(16);
  if (segments(c.ui, "paper/orientation", width, {"Auto", "Tall", "Wide"}, chosen)) {
    paper.orientation = static_cast<Orientation>(chosen);
    c.session.set_paper(paper);
  }
}

void margin_row(UiContext& c) {
  PaperSetup paper = c.session.project().paper;
  ImGui::SetNextItemWidth(row(c.ui, "Margin") - c.ui.look.px(16));
  const bool is_entered = length_field(c.ui, "paper/margin", paper.margin_mm);
  tooltip(c.ui, "What the printer cannot reach; nothing is drawn there");
  if (!is_entered) return;
  paper.margin_mm = std::clamp(paper.margin_mm, 0.0, 50.0);
  c.session.set_paper(paper);
}

void height_row(UiContext& c) {
  PrintSize size = c.session.project().size;
  ImGui::SetNextItemWidth(row(c.ui, "Model height") - c.ui.look.px(16));
  const bool is_entered = length_field(c.ui, "paper/height", size.height_mm);
  tooltip(c.ui,
          "How tall the finished model stands; a net larger than the paper is spread over several pages");
  if (!is_entered) return;
  size.height_mm = std::clamp(size.height_mm, 5.0, 5000.0);
  c.session.set_size(size);
}

/// The edge selected last, as long as nothing else was said.
void edge_row(UiContext& c) {
  PrintSize size = c.session.project().size;
  const Mesh& mesh = c.session.project().dual->mesh();
  if (!c.ui.selected_edges.empty() && size.edge != c.ui.selected_edges.front()) {
    const EdgeId edge = c.ui.selected_edges.front();
    if (button(c.ui, {"paper/this-edge", "Take edge " + grouped(edge.value + 1), "",
                      "The length is that of the selected edge", ButtonKind::Outlined})) {
      const double scale = print_scale(c.session);
      size.edge = edge;
      if (scale > 0) size.edge_mm = mesh.length(edge) * scale;
      c.session.set_size(size);
    }
  }
  if (!size.edge.is_valid()) {
    text_muted(c.ui, "Select an edge in one of the views.");
    return;
  }
  const std::string label = "Edge " + grouped(size.edge.value + 1);
  ImGui::SetNextItemWidth(row(c.ui, label.c_str()) - c.ui.look.px(16));
  if (!length_field(c.ui, "paper/edge", size.edge_mm)) return;
  size.edge_mm = std::clamp(size.edge_mm, 0.1, 5000.0);
  c.session.set_size(size);
}

void scale_row(UiContext& c) {
  PrintSize size = c.session.project().size;
  ImGui::SetNextItemWidth(row(c.ui, "mm per unit") - c.ui.look.px(16));
  if (!number_field(c.ui, "paper/scale", size.scale, "%.4g")) return;
  size.scale = std::clamp(size.scale, 1e-6, 1e6);
  c.session.set_size(size);
}

void sheets_row(UiContext& c) {
  PrintSize size = c.session.project().size;
  auto sheets = static_cast<std::uint64_t>(size.sheets);
  ImGui::SetNextItemWidth(row(c.ui, "Sheets") - c.ui.look.px(16));
  const bool is_entered = number_field(c.ui, "paper/sheets", sheets);
  tooltip(c.ui, "As large as fits on so many of them");
  if (!is_entered) return;
  size.sheets = static_cast<int>(std::clamp<std::uint64_t>(sheets, 1, kMostFittedSheets));
  c.session.set_size(size);
}

/// Chosen anew, a scale begins as what is printed now, and so does an edge's length.
void begin_by(UiContext& c, PrintSize size, PrintSize::Kind kind) {
  const double scale = print_scale(c.session);
  size.kind = kind;
  if (kind == PrintSize::Kind::Scale && scale > 0) size.scale = scale;
  if (kind == PrintSize::Kind::EdgeLength) {
    const Mesh& mesh = c.session.project().dual->mesh();
    if (!size.edge.is_valid())
      size.edge = c.ui.selected_edges.empty() ? EdgeId(0) : c.ui.selected_edges.front();
    if (scale > 0) size.edge_mm = mesh.length(size.edge) * scale;
  }
  c.session.set_size(size);
}

void other_rows(UiContext& c) {
  using Kind = PrintSize::Kind;
  static constexpr std::array<const char*, 3> kNames{"Length of an edge", "Scale", "Number of sheets"};
  const PrintSize size = c.session.project().size;
  const auto shown = static_cast<std::size_t>(size.kind) - static_cast<std::size_t>(Kind::EdgeLength);
  ImGui::SetNextItemWidth(row(c.ui, "By") - c.ui.look.px(16));
  if (begin_combo(c.ui, "paper/by", kNames[shown])) {
    for (std::size_t i = 0; i < kNames.size(); ++i) {
      if (ImGui::Selectable(kNames[i], i == shown) && i != shown)
        begin_by(c, size, static_cast<Kind>(i + static_cast<std::size_t>(Kind::EdgeLength)));
      note_widget(c.ui, std::string("paper/by/") + kNames[i]);
    }
    ImGui::EndCombo();
  }
  if (size.kind == Kind::EdgeLength) edge_row(c);
  if (size.kind == Kind::Scale) scale_row(c);
  if (size.kind == Kind::FitSheets) sheets_row(c);
}

void size_row(UiContext& c) {
  using Kind = PrintSize::Kind;
  const PrintSize size = c.session.project().size;
  int chosen = std::min(static_cast<int>(size.kind), 2);
  const float width = ImGui::GetContentRegionAvail().x - c.ui.look.px(16);
  if (segments(c.ui, "paper/size", width, {"Fit page", "Height", "Other"}, chosen))
    begin_by(c, size, chosen == 2 ? Kind::FitSheets : static_cast<Kind>(chosen));
  if (size.kind == Kind::Height) height_row(c);
  if (size.kind > Kind::Height) other_rows(c);
}

/// Only where the user arranged the pieces.
void placed_rows(UiContext& c) {
  if (!c.session.has_placed_pieces()) return;
  if (const Misplaced* const wrong = c.session.misplaced()) {
    ImGui::PushStyleColor(ImGuiCol_Text, c.ui.look.colours.bad);
    ImGui::TextWrapped("%s", misplaced_sentence(*wrong).c_str());
    ImGui::PopStyleColor();
  } else {
    text_muted(c.ui, "Pieces lie where you put them.");
  }
  const Action& back = action(ActionId::RearrangeAll);
  if (button(c.ui, {"paper/rearrange", std::string(back.name), "", tip_of(c, back), ButtonKind::Outlined}))
    run_action(c, ActionId::RearrangeAll);
}

/// How much paper it takes.
void pages_row(UiContext& c) {
  const auto sheets = c.session.sheets();
  const auto pages = c.session.pages();
  if (sheets == nullptr || pages == nullptr) return;
  const bool is_tiled = std::ranges::any_of(pages->canvases, &PageLayout::Canvas::is_tiled);
  std::string text = "Prints on " + counted(static_cast<std::int64_t>(sheets->size()), "page", "pages");
  text += is_tiled ? "; the key Home shows each as it is printed." : ".";
  ImGui::PushTextWrapPos(ImGui::GetWindowContentRegionMax().x - c.ui.look.px(16));
  text_muted(c.ui, text);
  ImGui::PopTextWrapPos();
}

}  // namespace

void panel_paper(UiContext& context) {
  if (!context.session.has_model()) {
    text_muted(context.ui, "Open a model to set its paper.");
    return;
  }
  format_row(context);
  if (is_own_size(context.session.project().paper)) own_size_row(context);
  orientation_row(context);
  margin_row(context);
  size_row(context);
  placed_rows(context);
  pages_row(context);
  if (why_not_split(context).empty() &&
      button(context.ui, {"paper/split", "Split to fit", "",
                          "Cuts the net into the fewest pieces that fit a page, instead of tiling it",
                          ButtonKind::Outlined}))
    split_to_fit(context);
}

}  // namespace netwright
