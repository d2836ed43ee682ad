// Lines that keep their width on screen: anti-aliased without multisampling, solid or dashed, in the plane
// and in space. Every segment is one instance of a quad, so a batch of thousands is one draw call.
#pragma once

#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "render/camera.h"
#include "render/gl_objects.h"
#include "render/palette.h"
#include "render/shader.h"

namespace netwright {

struct LineStyle {
  Colour colour{0, 0, 0, 1};  ///< alpha 0 hides all lines of this style
  float width_px = 1;
  /// Lengths of dash, gap, dash, gap; all zero is a solid line. The pattern is centred on the segment.
  std::array<float, 4> dash{};
  bool is_dash_in_world = false;  ///< dash lengths in world units instead of pixels
};

/// One straight line; `style` is an index into the styles given when it is drawn (under kMaxLineStyles).
struct LineSegment {
  glm::vec3 from{0};
  glm::vec3 to{0};
  std::uint32_t style = 0;
  bool operator==(const LineSegment&) const = default;
};
inline constexpr std::size_t kMaxLineStyles = 16;

/// Segments on the graphics card.
class LineBatch {
 public:
  LineBatch();
  void upload(std::span<const LineSegment> segments, std::uint64_t version);
  [[nodiscard]] bool holds(std::uint64_t version) const { return buffer_.holds(version); }
  [[nodiscard]] int size() const { return n_segments_; }
  void bind() const;

 private:
  Buffer buffer_;
  VertexArray array_;
  int n_segments_ = 0;
};

/// Where and how a batch is seen.
struct LineView {
  glm::mat4 clip_from_world{1};
  glm::vec2 size_px{1, 1};
  float scale = 1;  ///< pixels per design pixel: widths and pixel dashes are multiplied by it
  bool is_depth_tested = false;
  float pull = 0;  ///< taken off the depth in clip space, so that lines win against what they lie on
};

/// Seen by a camera: in space tested against the depth of what was drawn before, lifted towards the eye by so
/// many pixels' worth of distance; in the plane untested.
LineView look_through(const OrbitCamera& camera, float scale, double lift_px = 2);
LineView look_through(const PanZoomCamera& camera, float scale);

/// Lines of a crowded picture are drawn thinner: 1 where edges are long on screen, down to 0.45 where they
/// are short.
float thinning(double mean_edge_px, float scale);

class LineRenderer {
 public:
  LineRenderer();
  void draw(const LineBatch& batch, std::span<const LineStyle> styles, const LineView& view) const;

 private:
  Shader shader_;
};

}  // namespace netwright
