// The side panel: an accordion of short sections. Each draws its body only; side_panel draws the headers.
#pragma once

#include <vector>

#include "ui/ui_state.h"

namespace netwright {

/// The whole panel, into the present ImGui window.
void side_panel(UiContext& context);

void panel_model(UiContext& context);
/// Parts of the model's section: what was kept of the version before, which repairs, which parts,
void panel_replaced(UiContext& context);
void panel_repairs(UiContext& context);
void panel_parts(UiContext& context);
/// and how many faces.
void panel_faces(UiContext& context);
void panel_solve(UiContext& context);
/// Its rows about polish.
void panel_polish(UiContext& context);
/// Part of the search's section; nothing where nothing is pinned.
void panel_pins(UiContext& context);
/// Why a search found no single piece, and what can be done; nothing while there is nothing to tell.
void panel_why(UiContext& context);
void panel_runs(UiContext& context);
void panel_tabs(UiContext& context);
void panel_paper(UiContext& context);
void panel_print(UiContext& context);
void panel_export(UiContext& context);
void panel_check(UiContext& context);
void panel_assembly(UiContext& context);
void panel_overlaps(UiContext& context);
void panel_history(UiContext& context);

/// Overlaps over moves: a step line with axes, and a mark where the figures have one. Their history must not
/// be empty.
void overlap_chart(const UiState& ui, const RunFigures& figures, bool is_running);

/// Cuts and paper in percent of the first net's, over the work done, and a mark where the figures have one.
/// There must be stations of polish.
void polish_chart(const UiState& ui, const RunFigures& figures, bool is_running);
/// What the chart says of the last net: "Cuts 92 %, paper 61 % of the first net"; empty without stations.
std::string polish_shares(const RunFigures& figures);

}  // namespace netwright
