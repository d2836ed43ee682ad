// Printing: which printer, which sheets, with or without colours. Without a printing system a PDF is
// exported.
#include "assets/icons.h"
#include "core/base/error.h"
#include "ui/actions.h"
#include "ui/dialogs.h"
#include "ui/export_rows.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

void printer_row(UiContext& c, const std::vector<std::string>& printers) {
  UiState& ui = c.ui;
  std::string& chosen = ui.printing.printer;
  if (chosen.empty()) chosen = printers.front();
  row(ui, "Printer");
  if (!begin_combo(ui, "print-dialog/printer", chosen)) return;
  for (const std::string& printer : printers) {
    if (ImGui::Selectable(printer.c_str(), printer == chosen)) chosen = printer;
    note_widget(ui, "print-dialog/printer/" + printer);
  }
  ImGui::EndCombo();
}

/// Empty when the text names sheets.
std::string why_no_sheets(const UiContext& c) {
  const auto sheets = c.session.sheets();
  if (sheets == nullptr) return "There is nothing to print.";
  try {
    static_cast<void>(chosen_sheets(c.ui.printing.sheets, sheets->size()));
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

void Dialogs::draw_print(UiContext& context) {
  UiState& ui = context.ui;
  const std::vector<std::string>* printers = context.session.printers();
  const bool has_printers = printers != nullptr && !printers->empty();
  if (!begin_window(ui, 460, has_printers ? 304 : 152)) return;
  if (has_printers) {
    printer_row(context, *printers);
    row(ui, "Sheets");
    text_field(ui, "print-dialog/sheets", ui.printing.sheets, "all, or as in 1-3, 5");
    instructions_row(context, true);
    checkbox(ui, "print-dialog/grey", "Shades of grey", ui.printing.is_grey, "For this time; saves colour");
  } else {
    ImGui::TextWrapped("%s", printers == nullptr
                                 ? "Looking for printers…"
                                 : "No printer was found. Export a PDF and print it at 100 %.");
  }
  const std::string reason = has_printers ? why_no_sheets(context) : "";
  if (!reason.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, ui.look.colours.bad);
    ImGui::TextWrapped("%s", reason.c_str());
    ImGui::PopStyleColor();
  }
  Footer buttons;
  buttons.label = has_printers ? "Print" : "Export PDF…";
  buttons.is_enabled = reason.empty();
  buttons.why_not = reason;
  if (footer(context, buttons)) {
    finish(context);
    if (has_printers)
      context.session.print(ui.printing);
    else
      run_action(context, ActionId::ExportPdf);
  }
  ImGui::EndPopup();
}

}  // namespace netwright
