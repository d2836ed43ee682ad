// What is in the printer and how large the model gets. Each change is one undo step.
#include <algorithm>
#include <cmath>
#include <string>

#include "assets/icons.h"
#include "core/base/paper.h"
#include "ui/panels.h"
#include "ui/status.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

std::string size_text(const PaperFormat& format) {
  return std::to_string(std::lround(format.width_mm)) + " × " +
         std::to_string(std::lround(format.height_mm)) + " mm";
}

/// Over the right end of the last item, lighter than ImGui's own triangle.
void draw_chevron(const UiState& ui) {
  const ImVec2 max = ImGui::GetItemRectMax();
  const float y = (ImGui::GetItemRectMin().y + max.y - ImGui::GetTextLineHeight()) / 2;
  ImGui::GetWindowDrawList()->AddText(ImVec2(max.x - ui.look.px(28), y), ui.look.colours.muted,
                                      icon::kChevronDown);
}

void format_row(UiContext& c) {
  const UiState& ui = c.ui;
  ImGui::SetNextItemWidth(row(ui, "Format") - ui.look.px(16));
  PaperSetup paper = c.session.project().paper;
  const bool is_open = ImGui::BeginCombo("##format", paper.format.c_str(), ImGuiComboFlags_NoArrowButton);
  note_widget(ui, "paper/format");
  if (!is_open) draw_chevron(ui);
  if (!is_open) return;
  for (const PaperFormat& format : paper_formats()) {
    const std::string name(format.name);
    if (ImGui::Selectable((name + "   " + size_text(format)).c_str(), name == paper.format) &&
        name != paper.format) {
      paper.format = name;
      c.session.set_paper(paper);
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
  const bool is_entered = number_field(c.ui, "paper/margin", paper.margin_mm, "%.0f mm");
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
  const bool is_entered = number_field(c.ui, "paper/height", size.height_mm, "%.0f mm");
  tooltip(c.ui,
          "How tall the finished model stands; a net larger than the paper is spread over several pages");
  if (!is_entered) return;
  size.height_mm = std::clamp(size.height_mm, 5.0, 5000.0);
  c.session.set_size(size);
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
  if (const auto sheets = context.session.sheets(); sheets != nullptr) {
    text_muted(context.ui,
               "Prints on " + counted(static_cast<std::int64_t>(sheets->size()), "page", "pages") + ".");
  }
}

}  // namespace netwright
