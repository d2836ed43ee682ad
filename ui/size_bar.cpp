// A bar above the views: it asks, but keeps nobody from going on.
#include "ui/size_bar.h"

#include <imgui.h>

#include <algorithm>
#include <string>

#include "assets/icons.h"
#include "ui/bar_layout.h"
#include "ui/lengths.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

constexpr float kFieldWidth = 88;
constexpr double kLeastHeight_mm = 5;
constexpr double kMostHeight_mm = 5000;

ButtonSpec set_button() {
  ButtonSpec spec{"size/set", "Set height"};
  spec.kind = ButtonKind::Accent;
  spec.tip = "Prints the model that tall, over as many pages as it takes";
  return spec;
}

ButtonSpec keep_button(const UiContext& context) {
  const bool fits_page = context.session.project().size.kind == PrintSize::Kind::FitPage;
  ButtonSpec spec{"size/keep", fits_page ? "Keep fitting the page" : "Keep"};
  spec.kind = ButtonKind::Outlined;
  spec.tip =
      fits_page ? "Prints it as large as one page allows, as it would be now" : "Leaves its size as it is";
  return spec;
}

float controls_width(const UiContext& context) {
  const UiState& ui = context.ui;
  return ui.look.px(kFieldWidth) + button_width(ui, set_button()) + button_width(ui, keep_button(context)) +
         ui.look.px(2 * kBarGap);
}

std::string question(const UiContext& context) {
  const double height_mm = context.session.asked_size()->height_mm;
  const bool is_inch = context.ui.settings.unit == LengthUnit::Inch;
  return "By its file the model is " +
         (is_inch ? length_text(height_mm, LengthUnit::Inch) : real_length_text(height_mm)) +
         " tall. How tall shall it be?";
}

BarContent content_of(const UiContext& context) {
  return {icon::kRuler, question(context), controls_width(context)};
}

}  // namespace

float size_bar_height(const UiContext& context, float width) {
  if (!context.session.asked_size() || !context.session.has_model()) return 0;
  return bar_height(context.ui, content_of(context), width);
}

void draw_size_bar(UiContext& context) {
  UiState& ui = context.ui;
  const Look& look = ui.look;
  begin_bar(ui, content_of(context));
  const LengthUnit unit = ui.settings.unit;
  if (ui.asked_height_mm <= 0) ui.asked_height_mm = kUsualHeight;
  double height = ui.asked_height_mm / in_millimetres(unit);
  ImGui::SetNextItemWidth(look.px(kFieldWidth));
  if (number_field(ui, "size/height", height, field_format(unit)))
    ui.asked_height_mm = std::clamp(height * in_millimetres(unit), kLeastHeight_mm, kMostHeight_mm);
  ImGui::SameLine(0, look.px(kBarGap));
  const bool is_set = button(ui, set_button());
  ImGui::SameLine(0, look.px(kBarGap));
  if (button(ui, keep_button(context))) context.session.leave_size();
  if (is_set) context.session.set_size({PrintSize::Kind::Height, ui.asked_height_mm});
  if (!context.session.asked_size()) ui.asked_height_mm = 0;
}

}  // namespace netwright
