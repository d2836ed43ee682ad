// Which edge is under the pointer. Looks only at the faces under and right around it, so that a model of
// thousands of faces costs no more than one of ten.
#pragma once

#include <glm/vec2.hpp>

#include "render/model_pose.h"
#include "render/picker.h"

namespace netwright {

struct Pointed {
  FaceId face;      ///< under the pointer; invalid on empty ground
  HalfedgeId side;  ///< the nearest edge within reach, as a side of the face that shows it; may be invalid
};

/// `reach_px`: how far an edge may be from the pointer. Less on a face that is small on screen, so that its
/// middle stays free to be pointed at.
Pointed point_at(const ModelPicker& picker, const ModelPose& pose, const OrbitCamera& camera,
                 glm::dvec2 pixel, double reach_px);
/// The two copies of a cut are different sides.
Pointed point_at(const NetPicker& picker, const Net& net, const PanZoomCamera& camera, glm::dvec2 pixel,
                 double reach_px);

/// From a point to the segment from a to b.
double distance_to_segment(glm::dvec2 point, glm::dvec2 a, glm::dvec2 b);

}  // namespace netwright
