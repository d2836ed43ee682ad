// The 2-D net, live: right or middle drag pans (left drag, too, from the empty desk), wheel zooms at the
// pointer, click selects, double-click centres a face in both views.
#pragma once

#include <optional>
#include <vector>

#include "render/camera.h"
#include "ui/rubber_band.h"
#include "ui/scene.h"
#include "ui/view_parts.h"

namespace netwright {

class NetView {
 public:
  /// Draws header, picture and legend into the present ImGui window.
  void draw(UiContext& context, const Scene& scene, Renderers& renderers);
  [[nodiscard]] const PanZoomCamera& camera() const { return camera_; }
  /// How many numbers of faces and edges were drawn in the last frame that showed them.
  [[nodiscard]] int n_numbers() const { return n_numbers_; }

 private:
  void start_flight(const std::vector<FaceId>& faces, const Net& net, double now);
  void fly(UiState& ui, const Gesture& gesture);
  void follow_net(UiContext& context, const Scene& scene);
  void handle(UiContext& context, const Scene& scene, const Gesture& gesture);
  /// Faces whose middle lies in the rubber band.
  [[nodiscard]] std::vector<FaceId> faces_in_band(const Net& net) const;
  void tell_of_pages(const UiContext& context, const Scene& scene, ImVec2 corner);
  void show_numbers(const UiState& ui, const Scene& scene, ImVec2 corner);
  void draw_measured(const UiContext& context, const Scene& scene, ImVec2 corner) const;
  void paint(const UiContext& context, const Scene& scene, Renderers& renderers);

  struct Flight {
    PanZoomCamera from;
    PanZoomCamera to;
    double since;  ///< on the clock of UiState::now
  };

  PanZoomCamera camera_;
  std::optional<Flight> flight_;
  RubberBand band_;
  int n_numbers_ = 0;
  bool is_moved_by_user_ = false;  ///< then nets are no longer framed by themselves
  bool is_panning_ = false;        ///< a left drag that began on the empty desk
  std::uint64_t file_version_ = 0;
  std::uint64_t model_version_ = 0;
  std::uint64_t version_ = 0;
  bool was_on_pages_ = false;
  bool shows_desk_ = false;             ///< asked to keep all sheets in sight, not the net alone
  std::optional<double> laying_since_;  ///< a net waits for its pages on the desk
};

}  // namespace netwright
