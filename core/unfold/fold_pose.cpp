// Every face follows its parent by a turn about their hinge. The tiny motion that is missing to the model
// after a full bend is added in proportion, so that a path of hundreds of folds ends exactly on it.
#include "core/unfold/fold_pose.h"

#include <algorithm>
#include <cmath>

namespace netwright {
namespace {

Rigid3 in_space(const Rigid2& motion) {
  const double angle = std::atan2(motion.sin, motion.cos);
  return {glm::angleAxis(angle, glm::dvec3(0, 0, 1)), {motion.x, motion.y, 0}};
}

/// About a line through `point`.
Rigid3 turn_about(const glm::dvec3& point, const glm::dvec3& axis, double angle_rad) {
  const glm::dquat turn = glm::angleAxis(angle_rad, axis);
  return {turn, point - turn * point};
}

/// Where a face's flat frame lies on the model: through the corners' mean, along the longest side.
Rigid3 frame_on_model(const DualGraph& dual, FaceId f) {
  const Mesh& mesh = dual.mesh();
  glm::dvec2 side(0);
  glm::dvec3 along(0);
  for (const HalfedgeId h : mesh.halfedges(f)) {
    const glm::dvec2 candidate = dual.flat(mesh.next(h)) - dual.flat(h);
    if (glm::length(candidate) <= glm::length(side)) continue;
    side = candidate;
    along = mesh.position(mesh.next(h)) - mesh.position(h);
  }
  const glm::dvec3 n = mesh.normal(f);
  const glm::dvec3 u = glm::normalize(along - n * glm::dot(along, n));
  const glm::dvec2 s = glm::normalize(side);
  const glm::dvec3 x = u * s.x - glm::cross(n, u) * s.y;
  return {glm::normalize(glm::quat_cast(glm::dmat3(x, glm::cross(n, x), n))), mesh.centre(f)};
}

}  // namespace

Rigid3 operator*(const Rigid3& a, const Rigid3& b) {
  return {glm::normalize(a.turn * b.turn), a.turn * b.shift + a.shift};
}

Rigid3 between(const Rigid3& from, const Rigid3& to, double t) {
  return {glm::normalize(glm::slerp(from.turn, to.turn, t)), from.shift + (to.shift - from.shift) * t};
}

FoldPath::FoldPath(const Net& net) : dual_(net.dual) {
  const Mesh& mesh = net.mesh();
  on_model_.assign(mesh.n_faces(), Rigid3());
  off_plane_.assign(mesh.n_halfedges(), 0);
  for (const FaceId f : mesh.faces()) {
    on_model_[f] = frame_on_model(*dual_, f);
    for (const HalfedgeId h : mesh.halfedges(f))
      off_plane_[h] = glm::dot(mesh.position(h) - mesh.centre(f), mesh.normal(f));
  }
  steps_.reserve(mesh.n_faces());
  for (const FaceId f : net.tree.preorder(mesh)) {
    if (net.tree.is_root(f)) {
      add_root(net, f);
    } else {
      add_child(net, f);
    }
  }
}

void FoldPath::add_root(const Net& net, FaceId f) {
  Step step;
  step.face = f;
  step.folded = on_model_[f];
  const FaceId first = steps_.empty() ? f : held();
  step.unrolled = on_model_[first] * in_space(net.placement[first]).inverse() * in_space(net.placement[f]);
  steps_.push_back(step);
}

void FoldPath::add_child(const Net& net, FaceId f) {
  const Mesh& mesh = net.mesh();
  const HalfedgeId down = mesh.twin(net.tree.to_parent(f));
  Step step;
  step.face = f;
  step.parent = mesh.face(down);
  step.unrolled = in_space(dual_->unroll(down));
  const glm::dvec2 from = dual_->flat(down);
  step.hinge = {from, 0};
  step.axis = {glm::normalize(dual_->flat(mesh.next(down)) - from), 0};
  step.bend_rad = dual_->bend(mesh.edge(down));
  const Rigid3 turned = turn_about(step.hinge, step.axis, step.bend_rad) * step.unrolled;
  step.rest = turned.inverse() * on_model_[step.parent].inverse() * on_model_[f];
  steps_.push_back(step);
}

IdVector<HalfedgeId, glm::dvec3> FoldPath::corners(double amount) const {
  const double t = std::clamp(amount, 0.0, 1.0);
  const Mesh& mesh = dual_->mesh();
  IdVector<FaceId, Rigid3> motion(mesh.n_faces());
  IdVector<HalfedgeId, glm::dvec3> points(mesh.n_halfedges());
  for (const Step& step : steps_) {
    Rigid3& own = motion[step.face];
    if (step.parent.is_valid()) {
      own = motion[step.parent] * turn_about(step.hinge, step.axis, t * step.bend_rad) * step.unrolled *
            between(Rigid3(), step.rest, t);
    } else {
      own = between(step.unrolled, step.folded, t);
    }
    for (const HalfedgeId h : mesh.halfedges(step.face))
      points[h] = own(glm::dvec3(dual_->flat(h), t * off_plane_[h]));
  }
  return points;
}

}  // namespace netwright
