// What the actions for pins work on: the edge or face under the pointer, else what is selected.
#pragma once

#include <string>
#include <vector>

#include "ui/ui_state.h"

namespace netwright {

/// The hovered edge alone, unless it is one of the selected ones; else all selected ones.
[[nodiscard]] std::vector<EdgeId> chosen_edges(const UiContext& context);
/// Likewise for faces.
[[nodiscard]] std::vector<FaceId> chosen_faces(const UiContext& context);

/// Pins the chosen edges so, or frees them when all of them are pinned so already. One undo step.
void pin_edges(UiContext& context, EdgePin pin);
/// Makes the chosen faces a patch, or lets it go when they are one already. One undo step.
void keep_faces_together(UiContext& context);
/// Frees the chosen edges and faces of their pins. One undo step.
void clear_pins(UiContext& context);
void clear_all_pins(UiContext& context);

/// Why it cannot be done now; empty when it can.
[[nodiscard]] std::string why_no_edge_pin(const UiContext& context);
[[nodiscard]] std::string why_no_patch(const UiContext& context);
[[nodiscard]] std::string why_no_clearing(const UiContext& context);
[[nodiscard]] std::string why_nothing_pinned(const UiContext& context);

/// What pressing the key would do.
[[nodiscard]] std::string must_fold_label(const UiContext& context);
[[nodiscard]] std::string must_cut_label(const UiContext& context);
[[nodiscard]] std::string patch_label(const UiContext& context);

/// "root · 3 folds · 2 cuts · 1 patch"; empty when nothing is pinned.
[[nodiscard]] std::string pins_text(const Constraints& pins);

}  // namespace netwright
