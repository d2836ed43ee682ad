// A net on its way from the plane to the model: where every corner is while all folds bend together along
// the tree. Amount 0 is the flat net, 1 the model.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "core/unfold/net.h"

namespace netwright {

/// A rotation followed by a shift in space: p -> turn p + shift.
struct Rigid3 {
  glm::dquat turn{1, 0, 0, 0};
  glm::dvec3 shift{0};

  [[nodiscard]] glm::dvec3 operator()(const glm::dvec3& p) const { return turn * p + shift; }
  [[nodiscard]] Rigid3 inverse() const {
    const glm::dquat back = glm::conjugate(turn);
    return {back, -(back * shift)};
  }
};
/// First b, then a.
Rigid3 operator*(const Rigid3& a, const Rigid3& b);
/// Part of the way from one motion to another: the rotation the shorter way round, the shift straight.
Rigid3 between(const Rigid3& from, const Rigid3& to, double t);

/// Prepared once per net; then each pose costs one motion per face.
class FoldPath {
 public:
  explicit FoldPath(const Net& net);

  /// Where every corner is at this amount (0 … 1, clamped), one point per halfedge, in the model's space.
  /// The first root stays where it is on the model, other pieces come to it in the plane as the net has
  /// them. At 1 every corner is where its vertex is on the model; faces that are not quite even are laid
  /// flat on the way down.
  [[nodiscard]] IdVector<HalfedgeId, glm::dvec3> corners(double amount) const;
  /// The face that stays.
  [[nodiscard]] FaceId held() const { return steps_.front().face; }

 private:
  /// How a face follows its parent: the neighbour's flat frame in the parent's, turned about the hinge.
  struct Step {
    FaceId face;
    FaceId parent;        ///< invalid for roots
    Rigid3 unrolled;      ///< flat; for roots the whole motion at amount 0
    Rigid3 folded;        ///< for roots: the whole motion at amount 1
    glm::dvec3 hinge{0};  ///< a point of the hinge, in the parent's frame
    glm::dvec3 axis{1, 0, 0};
    double bend_rad = 0;
    Rigid3 rest;  ///< what rounding and unevenness leave between turning about the hinge and the model
  };
  void add_root(const Net& net, FaceId f);
  void add_child(const Net& net, FaceId f);

  std::shared_ptr<const DualGraph> dual_;
  std::vector<Step> steps_;                 ///< parents before children
  IdVector<FaceId, Rigid3> on_model_;       ///< face frame -> model
  IdVector<HalfedgeId, double> off_plane_;  ///< how far a corner is off its face's plane
};

}  // namespace netwright
