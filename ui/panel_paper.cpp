// What is in the printer and how large the model gets. Each change is one undo step.
#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/paper.h"
#include "ui/actions.h"
#include "ui/panels.h"
#include "ui/status.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

void format_row(UiContext& c) {
  UiState& ui = c.ui;
  ImGui::SetNextItemWidth(row(ui, "Format") - ui.look.px(16));
  PaperSetup paper = c.session.project().paper;
  if (!begin_combo(ui, "paper/format", paper.format)) return;
  for (const PaperFormat& format : paper_formats()) {
    const std::string name(format.name);
    if (ImGui::Selectable(
            (name + "   " + area_text(format.width_mm, format.height_mm, c.ui.settings.unit)).c_str(),
            name == paper.format) &&
        name != paper.format) {
      paper.format = name;
      c.session.set_paper(paper);
      c.ui.settings.paper = name;  // what is in the printer stays there for the next model
      c.session.set_desk_paper(name);
    }
    note_widget(ui, "paper/format/" + name);
  }
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

void size_row(UiContext& c) {
  PrintSize size = c.session.project().size;
  int chosen = static_cast<int>(size.kind);
  const float width = row(c.ui, "Size") - c.ui.look.px(16);
  if (segments(c.ui, "paper/size", width, {"Fit page", "Height"}, chosen)) {
    size.kind = static_cast<PrintSize::Kind>(chosen);
    c.session.set_size(size);
  }
  if (size.kind != PrintSize::Kind::Height) return;
  ImGui::SetNextItemWidth(row(c.ui, "Model height") - c.ui.look.px(16));
  const bool is_entered = length_field(c.ui, "paper/height", size.height_mm);
  tooltip(c.ui,
          "How tall the finished model stands; a net larger than the paper is spread over several pages");
  if (!is_entered) return;
  size.height_mm = std::clamp(size.height_mm, 5.0, 5000.0);
  c.session.set_size(size);
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

}  // namespace

void panel_paper(UiContext& context) {
  if (!context.session.has_model()) {
    text_muted(context.ui, "Open a model to set its paper.");
    return;
  }
  format_row(context);
  orientation_row(context);
  margin_row(context);
  size_row(context);
  placed_rows(context);
  if (const auto sheets = context.session.sheets(); sheets != nullptr) {
    text_muted(context.ui,
               "Prints on " + counted(static_cast<std::int64_t>(sheets->size()), "page", "pages") + ".");
  }
}

}  // namespace netwright
