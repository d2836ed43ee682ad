// Lines and points laid over both views to point something out: hovered and selected edges, what a tool
// measures, culprits. Few, and sent to the graphics card only when they change.
#pragma once

#include <cstdint>
#include <vector>

#include "render/camera.h"
#include "render/line_renderer.h"

namespace netwright {

/// What a line of the overlay means; decides its colour and width.
enum class OverlayStyle : std::uint32_t {
  Hovered,
  Selected,
  Partner,     ///< thin: leads from one side of a cut to the other
  Culprit,     ///< what is wrong, or what the report speaks of
  Measured,    ///< a measured distance
  Dot,         ///< an end of a measured distance or of a partner's curve: a segment without length
  PinnedFold,  ///< has to be a fold
  PinnedCut,   ///< has to be a cut
  Patch,       ///< around faces that stay together
  CulpritDot,  ///< the same as a point: a segment without length
  Rim,         ///< under a measured distance and dots, so that they stand out on everything
};

struct OverlayLines {
  std::vector<LineSegment> space;  ///< on the model; `style` is an OverlayStyle
  std::vector<LineSegment> plane;  ///< on the net, z = 0

  void add_in_space(const glm::dvec3& from, const glm::dvec3& to, OverlayStyle style);
  void add_in_plane(glm::dvec2 from, glm::dvec2 to, OverlayStyle style);
  bool operator==(const OverlayLines&) const = default;
};

class OverlayRenderer {
 public:
  explicit OverlayRenderer(const LineRenderer& lines);
  /// Takes the lines over when they differ from those it holds.
  void set_lines(OverlayLines lines);
  /// Changes whenever the lines do.
  [[nodiscard]] std::uint64_t version() const { return version_; }
  [[nodiscard]] const OverlayLines& lines() const { return held_; }
  /// Over the model drawn before with the same camera; what the surface hides shines through faintly.
  void draw_on_model(const OrbitCamera& camera, const Palette& palette, float scale) const;
  void draw_on_net(const PanZoomCamera& camera, const Palette& palette, float scale) const;

 private:
  const LineRenderer& lines_;
  OverlayLines held_;
  std::uint64_t version_ = 1;
  LineBatch in_space_;
  LineBatch in_plane_;
};

}  // namespace netwright
