// The measuring tool: two clicks in either view, snapped to corners and edges, give the distance at the size
// it will be printed, in the net and on the model.
#pragma once

#include <string>

#include "render/edge_picker.h"
#include "render/overlay_renderer.h"
#include "ui/view_parts.h"

namespace netwright {

/// Where a point of the paper is, flat and in space.
[[nodiscard]] glm::dvec2 place_in_net(const Net& net, const PaperPoint& point);
[[nodiscard]] glm::dvec3 place_in_space(const DualGraph& dual, const ModelPose& pose,
                                        const PaperPoint& point);

/// The point under the pointer; nothing on empty ground. `snaps`: takes corners and edges near by instead.
PaperPoint paper_point(const Pointed& pointed, const DualGraph& dual, const ModelPose& pose,
                       const OrbitCamera& camera, glm::dvec2 pixel, double reach_px, bool snaps);
PaperPoint paper_point(const Pointed& pointed, const Net& net, const PanZoomCamera& camera, glm::dvec2 pixel,
                       double reach_px, bool snaps);

/// What the pointer does while the tool is in hand.
void take_measure(UiContext& context, const PaperPoint& point, const Gesture& gesture, const Net* net);
/// Lets go of what is measured, and of the tool when nothing is.
void end_measure(UiState& ui);

/// The two points of what is measured or about to be; false while there is only one.
bool measured_points(const Measuring& measuring, PaperPoint& from, PaperPoint& to);
void add_measure(const Measuring& measuring, const DualGraph& dual, const ModelPose& pose, const Net* net,
                 OverlayLines& lines);
/// How far apart they are on the finished model, in model units.
[[nodiscard]] double distance_on_model(const DualGraph& dual, const PaperPoint& a, const PaperPoint& b);
/// Beside the measured line, in either view.
void draw_measure_label(const UiContext& context, double distance, glm::dvec2 from_px, glm::dvec2 to_px,
                        ImVec2 corner);

}  // namespace netwright
