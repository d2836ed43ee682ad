// The two cameras: one that orbits the model, one that pans and zooms over the net. Pure maths in double
// precision; pixels have their origin at the top left of the view and y pointing down, as the mouse has it.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/base/geometry.h"
#include "core/mesh/soup.h"

namespace netwright {

struct Ray {
  glm::dvec3 origin{0};
  glm::dvec3 direction{0, 0, -1};  ///< unit length
};

/// Perspective view of the model, turning about a target point with the up axis kept upright.
class OrbitCamera {
 public:
  void set_size(glm::dvec2 size_px);
  void set_up_axis(UpAxis axis) { up_axis_ = axis; }
  [[nodiscard]] glm::dvec2 size_px() const { return size_px_; }

  /// Shows the whole box from the present direction, with a margin; an empty box changes nothing.
  void frame(const Box3& box);
  /// Back to the three-quarter view from which a model is first seen.
  void reset_direction();
  /// Turns with a mouse drag: the surface follows the pointer.
  void orbit(glm::dvec2 drag_px);
  /// Moves with a mouse drag: the target plane sticks to the pointer.
  void pan(glm::dvec2 drag_px);
  /// Comes closer by a factor (over 1 = closer) and keeps what is under the pointer in place.
  void zoom(double factor, glm::dvec2 pointer_px);
  /// Turns about this point from now on and brings it to the middle.
  void centre_on(const glm::dvec3& point);
  /// Stands on the side to which this direction points, at the same distance; zero changes nothing.
  void look_from(const glm::dvec3& outward);
  /// Part of the way from one view to another one, the shorter way round; t is 0…1.
  static OrbitCamera between(const OrbitCamera& from, const OrbitCamera& to, double t);

  [[nodiscard]] glm::dvec3 eye() const;
  [[nodiscard]] const glm::dvec3& target() const { return target_; }
  [[nodiscard]] double distance() const { return distance_; }
  /// Scale at the distance of the target.
  [[nodiscard]] double pixels_per_unit() const;
  [[nodiscard]] glm::dmat4 view() const;
  [[nodiscard]] glm::dmat4 projection() const;
  [[nodiscard]] glm::dmat4 view_projection() const { return projection() * view(); }

  /// Pixel (x, y) and depth (z: 0 near … 1 far) of a point in space.
  [[nodiscard]] glm::dvec3 project(const glm::dvec3& point) const;
  /// The inverse of project.
  [[nodiscard]] glm::dvec3 unproject(const glm::dvec3& pixel_and_depth) const;
  /// From the eye through a pixel.
  [[nodiscard]] Ray ray(glm::dvec2 pixel) const;
  /// Where a direction in space points on the screen (x right, y down, unit when parallel to it), for an axis
  /// cross.
  [[nodiscard]] glm::dvec2 screen_direction(const glm::dvec3& direction) const;

  bool operator==(const OrbitCamera&) const = default;

 private:
  [[nodiscard]] glm::dmat3 axes() const;  ///< right, up, backward

  glm::dvec2 size_px_{1, 1};
  UpAxis up_axis_ = UpAxis::Y;
  glm::dvec3 target_{0};
  double distance_ = 3;
  double yaw_rad_ = 0.6;
  double pitch_rad_ = 0.35;
  double scene_radius_ = 1;  ///< for the near and far planes and the limits of zoom
  glm::dvec3 scene_centre_{0};
};

/// Flat view of the net: y up in the world, down in pixels.
class PanZoomCamera {
 public:
  void set_size(glm::dvec2 size_px) { size_px_ = size_px; }
  [[nodiscard]] glm::dvec2 size_px() const { return size_px_; }

  /// Shows the whole box with a margin on every side; an empty box changes nothing.
  void frame(const Box2& box, double margin_px = 32);
  void pan(glm::dvec2 drag_px);
  /// Comes closer by a factor (over 1 = closer) and keeps the point under the pointer in place.
  void zoom(double factor, glm::dvec2 pointer_px);
  void centre_on(glm::dvec2 point) { centre_ = point; }
  /// Shows the box so that it fills this share of the view, but no closer than that many times the framed
  /// net.
  void approach(const Box2& box, double share, double most_magnified);
  /// Part of the way from one view to another one; t is 0…1.
  static PanZoomCamera between(const PanZoomCamera& from, const PanZoomCamera& to, double t);

  [[nodiscard]] glm::dvec2 to_pixel(glm::dvec2 point) const;
  [[nodiscard]] glm::dvec2 to_world(glm::dvec2 pixel) const;
  [[nodiscard]] double pixels_per_unit() const { return pixels_per_unit_; }
  [[nodiscard]] glm::dvec2 centre() const { return centre_; }
  /// The part of the world that is in view.
  [[nodiscard]] Box2 visible() const;
  /// World to clip space, for points with z = 0.
  [[nodiscard]] glm::dmat4 view_projection() const;

  bool operator==(const PanZoomCamera&) const = default;

 private:
  glm::dvec2 size_px_{1, 1};
  glm::dvec2 centre_{0};
  double pixels_per_unit_ = 100;
  double framed_pixels_per_unit_ = 100;  ///< limits of zoom are relative to it
};

}  // namespace netwright
