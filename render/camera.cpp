// The maths of both cameras. The orbit camera keeps angles rather than a matrix, so that the model can never
// tilt sideways; near and far planes follow from the scene's size, so that depth is spent where the model is.
#include "render/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat3x3.hpp>
#include <numbers>

namespace netwright {
namespace {

// Angles in radians.
constexpr double kHalfFieldOfView = 17.5 * std::numbers::pi / 180;
constexpr double kStartYaw = 0.6;
constexpr double kStartPitch = 0.35;
constexpr double kMostPitch = std::numbers::pi / 2 - 0.001;
constexpr double kFrameShare = 0.86;    // of the view is filled when a box is framed
constexpr double kNearestZoom = 0.002;  // in scene radii
constexpr double kFarthestZoom = 60;
constexpr double kSmallestScene = 1e-34;  // below this, single precision has no digits left

}  // namespace

void OrbitCamera::set_size(glm::dvec2 size_px) { size_px_ = glm::max(size_px, glm::dvec2(1)); }

void OrbitCamera::reset_direction() {
  yaw_rad_ = kStartYaw;
  pitch_rad_ = kStartPitch;
}

glm::dmat3 OrbitCamera::axes() const {
  const double cp = std::cos(pitch_rad_);
  const double sp = std::sin(pitch_rad_);
  const double cy = std::cos(yaw_rad_);
  const double sy = std::sin(yaw_rad_);
  const glm::dvec3 right(cy, 0, -sy);
  const glm::dvec3 backward(sy * cp, sp, cy * cp);
  const glm::dvec3 up = glm::cross(backward, right);
  if (up_axis_ == UpAxis::Y) return {right, up, backward};
  const auto stand_up = [](const glm::dvec3& v) { return glm::dvec3(v.x, -v.z, v.y); };
  return {stand_up(right), stand_up(up), stand_up(backward)};
}

void OrbitCamera::frame(const Box3& box) {
  if (box.is_empty()) return;
  scene_centre_ = box.centre();
  scene_radius_ = std::max(box.diagonal() / 2, kSmallestScene);
  target_ = scene_centre_;
  // Each corner asks for a distance at which it is still inside the picture, sideways and in height.
  const glm::dmat3 to_view = glm::transpose(axes());
  const double tan_y = std::tan(kHalfFieldOfView) * kFrameShare;
  const double tan_x = tan_y * size_px_.x / size_px_.y;
  distance_ = scene_radius_ * kNearestZoom;
  for (int k = 0; k < 8; ++k) {
    const glm::dvec3 corner((k & 1) != 0 ? box.max.x : box.min.x, (k & 2) != 0 ? box.max.y : box.min.y,
                            (k & 4) != 0 ? box.max.z : box.min.z);
    const glm::dvec3 p = to_view * (corner - target_);
    distance_ = std::max({distance_, p.z + std::abs(p.x) / tan_x, p.z + std::abs(p.y) / tan_y});
  }
}

void OrbitCamera::orbit(glm::dvec2 drag_px) {
  const double rad_per_px = std::numbers::pi / std::max(300.0, std::min(size_px_.x, size_px_.y));
  yaw_rad_ = std::remainder(yaw_rad_ - drag_px.x * rad_per_px, 2 * std::numbers::pi);
  pitch_rad_ = std::clamp(pitch_rad_ + drag_px.y * rad_per_px, -kMostPitch, kMostPitch);
}

double OrbitCamera::pixels_per_unit() const {
  return size_px_.y / (2 * distance_ * std::tan(kHalfFieldOfView));
}

void OrbitCamera::pan(glm::dvec2 drag_px) {
  const glm::dmat3 a = axes();
  target_ += (a[1] * drag_px.y - a[0] * drag_px.x) / pixels_per_unit();
}

void OrbitCamera::zoom(double factor, glm::dvec2 pointer_px) {
  const double wished = distance_ / factor;
  const double distance = std::clamp(wished, kNearestZoom * scene_radius_, kFarthestZoom * scene_radius_);
  const glm::dvec2 off = pointer_px - size_px_ * 0.5;
  const glm::dmat3 a = axes();
  const glm::dvec3 held = target_ + (a[0] * off.x - a[1] * off.y) / pixels_per_unit();
  target_ = held + (target_ - held) * (distance / distance_);
  distance_ = distance;
}

void OrbitCamera::centre_on(const glm::dvec3& point) { target_ = point; }

void OrbitCamera::look_from(const glm::dvec3& outward) {
  const double length = glm::length(outward);
  if (!(length > 0)) return;
  glm::dvec3 way = outward / length;
  if (up_axis_ == UpAxis::Z) way = {way.x, way.z, -way.y};
  pitch_rad_ = std::clamp(std::asin(std::clamp(way.y, -1.0, 1.0)), -kMostPitch, kMostPitch);
  if (std::hypot(way.x, way.z) > 1e-9) yaw_rad_ = std::atan2(way.x, way.z);
}

OrbitCamera OrbitCamera::between(const OrbitCamera& from, const OrbitCamera& to, double t) {
  OrbitCamera camera = to;
  const double turn = std::remainder(to.yaw_rad_ - from.yaw_rad_, 2 * std::numbers::pi);
  camera.yaw_rad_ = std::remainder(from.yaw_rad_ + turn * t, 2 * std::numbers::pi);
  camera.pitch_rad_ = from.pitch_rad_ + (to.pitch_rad_ - from.pitch_rad_) * t;
  camera.target_ = from.target_ + (to.target_ - from.target_) * t;
  camera.distance_ = from.distance_ * std::pow(to.distance_ / from.distance_, t);
  return camera;
}

glm::dvec3 OrbitCamera::eye() const { return target_ + axes()[2] * distance_; }

glm::dmat4 OrbitCamera::view() const {
  const glm::dmat3 a = axes();
  return glm::dmat4(glm::transpose(a)) * glm::translate(glm::dmat4(1), -(target_ + a[2] * distance_));
}

glm::dmat4 OrbitCamera::projection() const {
  const double depth = glm::dot(eye() - scene_centre_, axes()[2]);
  const double reach = scene_radius_ * 1.05;
  const double far_plane = std::max(depth + reach, distance_ * 2);
  const double near_plane = std::max(depth - reach, std::min(distance_, reach) * 0.01);
  // A factor of all four changes nothing but their size: that is near one for models of any unit, while
  // graphics cards clip away whatever is all but zero.
  return glm::perspective(2 * kHalfFieldOfView, size_px_.x / size_px_.y, near_plane, far_plane) / distance_;
}

glm::dvec3 OrbitCamera::project(const glm::dvec3& point) const {
  const glm::dvec4 clip = view_projection() * glm::dvec4(point, 1);
  const glm::dvec3 ndc = glm::dvec3(clip) / clip.w;
  return {(ndc.x + 1) / 2 * size_px_.x, (1 - ndc.y) / 2 * size_px_.y, (ndc.z + 1) / 2};
}

glm::dvec3 OrbitCamera::unproject(const glm::dvec3& pixel_and_depth) const {
  const glm::dvec4 ndc(pixel_and_depth.x / size_px_.x * 2 - 1, 1 - pixel_and_depth.y / size_px_.y * 2,
                       pixel_and_depth.z * 2 - 1, 1);
  const glm::dvec4 p = glm::inverse(view_projection()) * ndc;
  return glm::dvec3(p) / p.w;
}

Ray OrbitCamera::ray(glm::dvec2 pixel) const {
  const double tan_y = std::tan(kHalfFieldOfView);
  const glm::dvec2 ndc(pixel.x / size_px_.x * 2 - 1, 1 - pixel.y / size_px_.y * 2);
  const glm::dvec3 in_view(ndc.x * tan_y * size_px_.x / size_px_.y, ndc.y * tan_y, -1);
  return {eye(), glm::normalize(axes() * in_view)};
}

glm::dvec2 OrbitCamera::screen_direction(const glm::dvec3& direction) const {
  const glm::dvec3 in_view = glm::transpose(axes()) * direction;
  return {in_view.x, -in_view.y};
}

void PanZoomCamera::frame(const Box2& box, double margin_px) {
  if (box.is_empty()) return;
  centre_ = box.centre();
  const glm::dvec2 room = glm::max(size_px_ - 2 * margin_px, size_px_ * 0.25);
  const glm::dvec2 size = box.size();
  const double widest = std::max({size.x / room.x, size.y / room.y, 1e-300});
  pixels_per_unit_ = 1 / widest;
  framed_pixels_per_unit_ = pixels_per_unit_;
}

void PanZoomCamera::approach(const Box2& box, double share, double most_magnified) {
  const glm::dvec2 scale = share * size_px_ / glm::max(box.size(), glm::dvec2(1e-300));
  centre_ = box.centre();
  pixels_per_unit_ = std::min({scale.x, scale.y, most_magnified * framed_pixels_per_unit_});
}

PanZoomCamera PanZoomCamera::between(const PanZoomCamera& from, const PanZoomCamera& to, double t) {
  PanZoomCamera camera = to;
  camera.centre_ = from.centre_ + (to.centre_ - from.centre_) * t;
  camera.pixels_per_unit_ = from.pixels_per_unit_ * std::pow(to.pixels_per_unit_ / from.pixels_per_unit_, t);
  return camera;
}

void PanZoomCamera::pan(glm::dvec2 drag_px) {
  centre_ += glm::dvec2(-drag_px.x, drag_px.y) / pixels_per_unit_;
}

void PanZoomCamera::zoom(double factor, glm::dvec2 pointer_px) {
  const glm::dvec2 held = to_world(pointer_px);
  pixels_per_unit_ =
      std::clamp(pixels_per_unit_ * factor, framed_pixels_per_unit_ / 20, framed_pixels_per_unit_ * 5000);
  centre_ += held - to_world(pointer_px);
}

glm::dvec2 PanZoomCamera::to_pixel(glm::dvec2 point) const {
  const glm::dvec2 off = (point - centre_) * pixels_per_unit_;
  return {size_px_.x / 2 + off.x, size_px_.y / 2 - off.y};
}

glm::dvec2 PanZoomCamera::to_world(glm::dvec2 pixel) const {
  const glm::dvec2 off = pixel - size_px_ * 0.5;
  return centre_ + glm::dvec2(off.x, -off.y) / pixels_per_unit_;
}

Box2 PanZoomCamera::visible() const {
  Box2 box;
  box.add(to_world({0, 0}));
  box.add(to_world(size_px_));
  return box;
}

glm::dmat4 PanZoomCamera::view_projection() const {
  const glm::dvec2 scale = 2 * pixels_per_unit_ / size_px_;
  return glm::translate(glm::scale(glm::dmat4(1), glm::dvec3(scale, 1)), glm::dvec3(-centre_, 0));
}

}  // namespace netwright
