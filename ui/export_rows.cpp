// Instructions go where there are pages, lines and text matter to drawings, dots to pictures. The settings
// belong to the project, since the machine they are for stays the same.
#include "ui/export_rows.h"

#include <algorithm>
#include <string>

#include "core/sheet/export_settings.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

void flag(UiContext& c, const char* name, const char* label, const char* step, const char* tip,
          bool ExportSettings::*place) {
  ExportSettings exports = c.session.project().exports;
  if (!checkbox(c.ui, name, label, exports.*place, tip)) return;
  c.session.set_exports(exports, step);
}

void drawing_rows(UiContext& c, bool is_wide) {
  const auto next = [&] {
    if (is_wide) ImGui::SameLine(0, c.ui.look.px(24));
  };
  flag(c, "export/one-file", "All sheets in one file", "sheets in one file",
       "Side by side, instead of one file per sheet", &ExportSettings::is_one_file);
  next();
  flag(c, "export/real-dashes", "Dashes as single lines", "dashes as single lines",
       "For machines and programs that ignore dash patterns", &ExportSettings::real_dashes);
  next();
  flag(c, "export/live-text", "Words stay text", "words as text",
       "They can be edited then, but look different where the font is missing; else they are outlines",
       &ExportSettings::live_text);
}

void dpi_row(UiContext& c, bool is_wide) {
  ExportSettings exports = c.session.project().exports;
  auto dpi = static_cast<std::uint64_t>(exports.png_dpi);
  const float room = row(c.ui, "Dots per inch") - c.ui.look.px(16);
  ImGui::SetNextItemWidth(is_wide ? c.ui.look.px(220) : room);
  const bool is_entered = number_field(c.ui, "export/dpi", dpi);
  tooltip(c.ui, "72 to 600; the files say so, and print at true size");
  if (!is_entered) return;
  exports.png_dpi = static_cast<int>(std::clamp<std::uint64_t>(dpi, kLeastDpi, kMostDpi));
  c.session.set_exports(exports, "dots per inch");
}

}  // namespace

void instructions_row(UiContext& context, bool is_wide) {
  ExportSettings exports = context.session.project().exports;
  int chosen = static_cast<int>(exports.instructions);
  const float room = row(context.ui, "Instructions") - context.ui.look.px(16);
  const float width = is_wide ? context.ui.look.px(220) : room;
  if (segments(context.ui, "export/instructions", width, {"None", "First", "Last"}, chosen)) {
    exports.instructions = static_cast<InstructionPage>(chosen);
    context.session.set_exports(exports, "instructions");
  }
  tooltip(context.ui,
          "A page with pictures of the folding, time and difficulty, before or behind the others");
}

void export_rows(UiContext& context, bool is_wide) {
  const std::string& format = context.ui.export_extension;
  if (format == "pdf" || format == "svg" || format == "png") instructions_row(context, is_wide);
  if (format == "svg" || format == "dxf") drawing_rows(context, is_wide);
  if (format == "png") dpi_row(context, is_wide);
}

}  // namespace netwright
