// The rubber band: a left drag with Shift held selects the faces inside a rectangle.
#pragma once

#include <vector>

#include "core/base/geometry.h"
#include "ui/view_parts.h"

namespace netwright {

class RubberBand {
 public:
  /// Call once per frame; true while a band is drawn, and then the drag means nothing else.
  bool follow(const UiState& ui, const Gesture& gesture);
  /// Does it hold this pixel of the picture?
  [[nodiscard]] bool holds(glm::dvec2 pixel) const;
  /// The faces that were selected when it began.
  [[nodiscard]] const std::vector<FaceId>& before() const { return before_; }
  /// `corner`: of the picture, in the window.
  void draw(const UiState& ui, ImVec2 corner) const;

 private:
  bool is_armed_ = false;  ///< the button went down with Shift
  bool is_drawn_ = false;
  glm::dvec2 from_{0};
  Box2 box_;
  std::vector<FaceId> before_;
};

}  // namespace netwright
