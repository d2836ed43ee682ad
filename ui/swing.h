// The short animation of a join by hand: the part that moved swings over to its new place around the edge
// that was joined, while all else lies still. Only a picture; the project has changed already.
#pragma once

#include <vector>

#include "core/unfold/net.h"

namespace netwright {

/// What a join moves, noted when it is made.
struct SwingWish {
  EdgeId edge;   ///< joined
  FaceId still;  ///< a face that stays where it is
  FaceId moved;  ///< the face at the edge that comes over
};

class Swing {
 public:
  static constexpr double kSeconds = 0.25;

  /// `before`: the net as it was drawn; `after`: the same model's net with the edge joined, laid out
  /// anywhere.
  Swing(Net before, const Net& after, const SwingWish& wish, double now);

  /// The net at this moment, drawn where `before` was.
  [[nodiscard]] const Net& net() const { return net_; }
  [[nodiscard]] const UnfoldTree& goal() const { return net_.tree; }
  /// Moves on; false when it is over.
  bool advance(double now);

 private:
  struct Way {
    double angle_rad = 0;
    glm::dvec2 shift{0};  ///< of the pivot
  };
  Net net_;
  IdVector<FaceId, Rigid2> from_;
  IdVector<FaceId, Way> ways_;
  glm::dvec2 pivot_{0};
  double since_;
};

}  // namespace netwright
