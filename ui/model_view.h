// The 3-D model: drag turns, right or middle drag pans, wheel zooms at the pointer, click selects,
// double-click centres a face in both views.
#pragma once

#include <optional>

#include "render/camera.h"
#include "ui/rubber_band.h"
#include "ui/scene.h"
#include "ui/view_parts.h"

namespace netwright {

class ModelView {
 public:
  /// Draws header and picture into the present ImGui window.
  void draw(UiContext& context, const Scene& scene, Renderers& renderers);
  [[nodiscard]] const OrbitCamera& camera() const { return camera_; }

 private:
  void follow_wishes(UiContext& context, const Scene& scene);
  /// Brings the wanted face to the middle, and to the front when it looks away.
  void show_face(const UiState& ui, const ModelPose& pose);
  /// Turns the camera to these faces, on a short flight.
  void start_flight(const Lit& lit, const ModelPose& pose, double now);
  void fly(UiState& ui, const Gesture& gesture);
  void handle(UiContext& context, const Scene& scene, const Gesture& gesture);
  /// Faces that look this way and whose middle lies in the rubber band, unless something hides it.
  [[nodiscard]] std::vector<FaceId> faces_in_band(const Scene& scene) const;
  void paint(const UiContext& context, const Scene& scene, Renderers& renderers);
  void draw_measured(const UiContext& context, const Scene& scene, ImVec2 corner) const;
  void draw_axes(const UiState& ui, const Mesh& mesh, ImVec2 corner, ImVec2 size) const;

  struct Flight {
    OrbitCamera from;
    OrbitCamera to;
    double since;  ///< on the clock of UiState::now
  };

  OrbitCamera camera_;
  std::optional<Flight> flight_;
  RubberBand band_;
  std::uint64_t file_version_ = 0;
};

}  // namespace netwright
