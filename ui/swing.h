// Short animations of a net that has changed: the part that a join by hand moves swings over to its new place
// around the edge that was joined, while all else lies still; and a net glides into the better one that
// polish has found. Only pictures; what they show has changed already.
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
  /// From any net of a model, as it was drawn, to another one, as it is laid out. The net turns as a whole as
  /// far as the two lie differently; what holds together in both holds together on its way, if it does to
  /// begin with.
  Swing(const Net& before, const Net& after, double now);

  /// The net at this moment, drawn where `before` was.
  [[nodiscard]] const Net& net() const { return net_; }
  [[nodiscard]] const UnfoldTree& goal() const { return net_.tree; }
  /// Moves on; false when it is over.
  bool advance(double now);

 private:
  struct Way {
    double angle_rad = 0;
    glm::dvec2 pivot{0};
    glm::dvec2 shift{0};  ///< of the pivot
  };
  static Way way_of(const Rigid2& whole, glm::dvec2 pivot);

  [[nodiscard]] static Rigid2 part_of(const Way& way, double share);

  Net net_;
  Way whole_;  ///< of the net, after what each face does
  IdVector<FaceId, Rigid2> from_;
  IdVector<FaceId, Way> ways_;
  double since_;
  bool starts_fast_ = false;
};

/// The same net moved as a whole to where its paper lies as much as can be where it lies in `drawn`, a net of
/// the same model.
Net laid_over(Net net, const Net& drawn);

}  // namespace netwright
