// Folds by the core's path, then a similarity that is none at all at the end: the folded net is the model.
#include "ui/folded_net.h"

#include <algorithm>
#include <cmath>

#include "render/camera.h"

namespace netwright {
namespace {

constexpr double kPlaySeconds = 3;
constexpr double kLongestFrame = 0.1;  ///< seconds: after a pause the fold goes on where it was

/// Right, up and towards the eye, as the model is first seen.
glm::dmat3 home_axes(UpAxis up_axis) {
  OrbitCamera home;
  home.set_up_axis(up_axis);
  home.reset_direction();
  return glm::transpose(glm::dmat3(home.view()));
}

/// The shortest turn from one direction to another.
glm::dquat turn_between(const glm::dvec3& from, const glm::dvec3& to) {
  const glm::dvec3 axis = glm::cross(from, to);
  const double angle = std::atan2(glm::length(axis), glm::dot(from, to));
  if (glm::length(axis) > 1e-9) return glm::angleAxis(angle, glm::normalize(axis));
  const glm::dvec3 any = std::abs(from.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  return glm::angleAxis(angle, glm::normalize(glm::cross(from, any)));
}

/// What of the screen the points take up in the home view: the middle, and the larger of width and height.
struct Extent {
  glm::dvec3 middle{0};
  double size = 0;
};

template <class Points>
Extent extent_of(const Points& points, const glm::dmat3& axes) {
  Box3 box;
  for (const glm::dvec3& p : points) box.add(glm::transpose(axes) * p);
  return {axes * box.centre(), std::max({box.size().x, box.size().y, 1e-300})};
}

}  // namespace

void FoldedNet::play(UiState& ui) {
  Folding& folding = ui.folding;
  if (!folding.is_playing) {
    played_at_ = -1;
    return;
  }
  const double passed = played_at_ < 0 ? 0 : std::clamp(ui.now - played_at_, 0.0, kLongestFrame);
  played_at_ = ui.now;
  const double step = ui.is_motion_reduced ? 1 : passed / kPlaySeconds;
  folding.amount = std::clamp(folding.amount + (folding.goes_up ? step : -step), 0.0, 1.0);
  if (folding.amount == (folding.goes_up ? 1 : 0)) folding.is_playing = false;
  ui.frames_wanted = std::max(ui.frames_wanted, 2);
}

void FoldedNet::update(UiState& ui, const ShownNet* shown, UpAxis up_axis) {
  if (shown == nullptr) ui.folding = Folding();
  play(ui);
  const double amount = ui.folding.amount;
  if (amount >= 1) {
    if (corners_) ++version_;
    corners_.reset();
    path_.reset();
    return;
  }
  const bool is_other_net = !path_ || net_version_ != shown->version;
  if (is_other_net) path_.emplace(shown->net);
  net_version_ = shown->version;
  if (!is_other_net && corners_ && amount == amount_) return;
  amount_ = amount;
  ++version_;
  pose(shown->net.mesh(), up_axis);
}

void FoldedNet::pose(const Mesh& mesh, UpAxis up_axis) {
  corners_ = path_->corners(amount_);
  const glm::dmat3 axes = home_axes(up_axis);
  // A flat net faces the eye, leaning back a little as paper on a desk does.
  const glm::dvec3 goal = glm::normalize(axes[2] + 0.35 * axes[1]);
  const glm::dquat whole = turn_between(mesh.normal(path_->held()), goal);
  const glm::dquat turn = glm::slerp(glm::dquat(1, 0, 0, 0), whole, 1 - amount_);
  for (glm::dvec3& p : *corners_) p = turn * p;
  std::vector<glm::dvec3> vertices;
  for (const VertexId v : mesh.vertices()) vertices.push_back(mesh.position(v));
  const Extent model = extent_of(vertices, axes);
  const Extent own = extent_of(*corners_, axes);
  const double scale = model.size / own.size;
  for (glm::dvec3& p : *corners_) p = model.middle + (p - own.middle) * scale;
}

}  // namespace netwright
