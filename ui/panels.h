// The side panel: an accordion of short sections. Each draws its body only; side_panel draws the headers.
#pragma once

#include <vector>

#include "ui/ui_state.h"

namespace netwright {

/// The whole panel, into the present ImGui window.
void side_panel(UiContext& context);

void panel_model(UiContext& context);
/// Parts of the model's section: which repairs, which parts of the model,
void panel_repairs(UiContext& context);
void panel_parts(UiContext& context);
/// and how many faces.
void panel_faces(UiContext& context);
void panel_solve(UiContext& context);
/// Part of the search's section; nothing where nothing is pinned.
void panel_pins(UiContext& context);
void panel_paper(UiContext& context);
void panel_overlaps(UiContext& context);

/// Overlaps over moves: a step line with axes; `stride` moves lie between two values.
void overlap_chart(const UiState& ui, const std::vector<int>& history, std::int64_t stride, bool is_running);

}  // namespace netwright
