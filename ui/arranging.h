// The tool that arranges pieces on the page: drag a piece to move it, drag the handle to turn it. What lies
// badly turns red while it is dragged; the project changes when the button is released.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/sheet/placing_edits.h"
#include "render/edge_picker.h"
#include "render/overlay_renderer.h"
#include "ui/scene.h"
#include "ui/view_parts.h"

namespace netwright {

/// The tool is in hand and the net lies on its pages.
[[nodiscard]] bool is_arranging(const UiContext& context, const Scene& scene);

/// What the pointer does while the tool is in hand.
void take_arrange(UiContext& context, const Scene& scene, const Pointed& pointed, const Gesture& gesture,
                  const PanZoomCamera& camera);
/// A press beside all pieces begins a rubber band, with or without Shift.
Gesture with_band(UiContext& context, const Scene& scene, const Pointed& pointed, Gesture gesture,
                  const PanZoomCamera& camera);
/// What is selected of a piece stands for all of it.
void select_whole_pieces(UiContext& context);
/// Pieces of which anything is selected, in order.
[[nodiscard]] std::vector<int> chosen_pieces(const UiContext& context);

/// "2 pieces selected".
[[nodiscard]] std::string pieces_hint(const UiContext& context);
/// What to do with the tool in hand.
[[nodiscard]] std::string arranging_hint(const UiContext& context);

/// Lets go of a motion whose pages have come, or that has lost its net; once a frame, before the scene.
void follow_pages(UiContext& context);
/// The drag in hand first, then the selection, then the tool.
void escape_arranging(UiContext& context);
void end_arranging(UiState& ui);

/// Outlines of the chosen pieces.
void add_arranging(const UiContext& context, const Net& drawn, OverlayLines& lines);
/// The handle that turns the chosen pieces, in pixels of the picture; nothing without any.
[[nodiscard]] std::optional<glm::dvec2> turn_handle(const UiContext& context, const Net& drawn,
                                                    const PanZoomCamera& camera);
/// Frame, handle and guides over the picture, whose corner this is.
void draw_arranging(const UiContext& context, const Scene& scene, const PanZoomCamera& camera, ImVec2 corner);

// Actions.
void toggle_arranging(UiContext& context);
void align_chosen(UiContext& context, Align where);
void turn_chosen_by_a_quarter(UiContext& context);
void rearrange(UiContext& context);
/// Why it cannot be done now; empty when it can.
[[nodiscard]] std::string why_not_arrange(const UiContext& context);
[[nodiscard]] std::string why_not_align(const UiContext& context);
[[nodiscard]] std::string why_not_rearrange(const UiContext& context);
/// Cuts pieces that are larger than the paper into ones that fit.
void split_to_fit(UiContext& context);
[[nodiscard]] std::string why_not_split(const UiContext& context);

}  // namespace netwright
