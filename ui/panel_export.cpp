// Files of the sheets: which format, what is special about it, and the button that writes them.
#include <array>
#include <string>

#include "ui/actions.h"
#include "ui/export_rows.h"
#include "ui/panels.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

struct Target {
  const char* extension;
  const char* name;
  ActionId id;
};
constexpr std::array<Target, 9> kTargets{
    Target{"pdf", "PDF to print", ActionId::ExportPdf},
    Target{"svg", "SVG drawing", ActionId::ExportSvg},
    Target{"dxf", "DXF drawing", ActionId::ExportDxf},
    Target{"png", "PNG pictures", ActionId::ExportPng},
    Target{"obj", "OBJ to paint on", ActionId::ExportObj},
    Target{"fold", "FOLD file", ActionId::ExportFold},
    Target{"silhouette", "Silhouette folder", ActionId::ExportSilhouette},
    Target{"cricut", "Cricut folder", ActionId::ExportCricut},
    Target{"laser", "Laser cutter folder", ActionId::ExportLaser}};

const Target& chosen_target(const UiState& ui) {
  for (const Target& target : kTargets)
    if (ui.export_extension == target.extension) return target;
  return kTargets.front();
}

void format_row(UiContext& c) {
  const Target& chosen = chosen_target(c.ui);
  ImGui::SetNextItemWidth(row(c.ui, "Format") - c.ui.look.px(16));
  const bool is_open = begin_combo(c.ui, "export/target", chosen.name);
  if (!is_open) return tooltip(c.ui, std::string(action(chosen.id).what));
  for (const Target& target : kTargets) {
    if (ImGui::Selectable(target.name, &target == &chosen)) c.ui.export_extension = target.extension;
    note_widget(c.ui, std::string("export/target/") + target.name);
  }
  ImGui::EndCombo();
}

}  // namespace

void panel_export(UiContext& context) {
  if (!context.session.has_model()) {
    text_muted(context.ui, "Open a model to export its net.");
    return;
  }
  format_row(context);
  export_rows(context, false);
  const Action& wanted = action(chosen_target(context.ui).id);
  ButtonSpec spec{"export/write", "Export…", "", tip_of(context, wanted), ButtonKind::Outlined};
  spec.is_enabled = is_possible(context, wanted.id);
  spec.width = ImGui::GetContentRegionAvail().x - context.ui.look.px(16);
  if (button(context.ui, spec)) run_action(context, wanted.id);
}

}  // namespace netwright
