// Asks the face pickers at the pointer and on a ring around it, which also finds the rims of the net and of
// the model's outline from outside, and takes the nearest of those faces' edges. What hides an edge has an
// edge of its own nearer to the pointer, so hidden edges lose by themselves.
#include "render/edge_picker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace netwright {
namespace {

constexpr int kRing = 12;
constexpr double kShareOfFace = 0.45;  ///< of its inner circle's radius that belongs to the edges

/// At the pointer first, then around it.
std::array<glm::dvec2, kRing + 1> places_around(glm::dvec2 pixel, double radius_px) {
  std::array<glm::dvec2, kRing + 1> places{};
  places.front() = pixel;
  for (int k = 0; k < kRing; ++k) {
    const double angle = 2 * std::numbers::pi * k / kRing;
    places[static_cast<std::size_t>(k) + 1] =
        pixel + radius_px * glm::dvec2(std::cos(angle), std::sin(angle));
  }
  return places;
}

/// `pixel_of`: where a corner is on screen.
template <class PixelOf>
double inner_radius(const Mesh& mesh, FaceId f, const PixelOf& pixel_of) {
  double doubled_area = 0;
  double rim = 0;
  const glm::dvec2 start = pixel_of(mesh.first(f));
  for (const HalfedgeId h : mesh.halfedges(f)) {
    const glm::dvec2 a = pixel_of(h);
    const glm::dvec2 b = pixel_of(mesh.next(h));
    doubled_area += cross(a - start, b - start);
    rim += glm::length(b - a);
  }
  return rim > 0 ? std::abs(doubled_area) / rim : 0;
}

template <class PickAt, class PixelOf>
Pointed nearest(const Mesh& mesh, glm::dvec2 pixel, double reach_px, const PickAt& pick_at,
                const PixelOf& pixel_of) {
  Pointed pointed;
  std::array<FaceId, kRing + 1> asked{};
  std::size_t n_asked = 0;
  double reach = reach_px;
  for (const glm::dvec2 place : places_around(pixel, 0.95 * reach_px)) {
    const FaceId f = pick_at(place);
    if (n_asked == 0 && place == pixel && f.is_valid()) {
      pointed.face = f;
      reach = std::min(reach, kShareOfFace * inner_radius(mesh, f, pixel_of));
    }
    if (!f.is_valid() || std::find(asked.begin(), asked.end(), f) != asked.end()) continue;
    asked[n_asked++] = f;
    for (const HalfedgeId h : mesh.halfedges(f)) {
      const double away = distance_to_segment(pixel, pixel_of(h), pixel_of(mesh.next(h)));
      if (away >= reach) continue;
      reach = away;
      pointed.side = h;
    }
  }
  return pointed;
}

}  // namespace

double distance_to_segment(glm::dvec2 point, glm::dvec2 a, glm::dvec2 b) {
  const glm::dvec2 along = b - a;
  const double squared = glm::dot(along, along);
  const double t = squared > 0 ? std::clamp(glm::dot(point - a, along) / squared, 0.0, 1.0) : 0;
  return glm::length(point - (a + along * t));
}

Pointed point_at(const ModelPicker& picker, const ModelPose& pose, const OrbitCamera& camera,
                 glm::dvec2 pixel, double reach_px) {
  const glm::dmat4 clip_from_world = camera.view_projection();
  const glm::dvec2 size = camera.size_px();
  const auto pixel_of = [&](HalfedgeId h) {
    const glm::dvec4 clip = clip_from_world * glm::dvec4(pose.position(h), 1);
    if (clip.w <= 0) return glm::dvec2(-1e9);  // behind the eye: out of everybody's reach
    return glm::dvec2((clip.x / clip.w + 1) / 2 * size.x, (1 - clip.y / clip.w) / 2 * size.y);
  };
  return nearest(
      pose.mesh(), pixel, reach_px, [&](glm::dvec2 place) { return picker.pick(camera.ray(place)); },
      pixel_of);
}

Pointed point_at(const NetPicker& picker, const Net& net, const PanZoomCamera& camera, glm::dvec2 pixel,
                 double reach_px) {
  return nearest(
      net.mesh(), pixel, reach_px, [&](glm::dvec2 place) { return picker.pick(camera.to_world(place)); },
      [&](HalfedgeId h) { return camera.to_pixel(net.corner(h)); });
}

}  // namespace netwright
