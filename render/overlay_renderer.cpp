// The overlay's lines are drawn twice over the model: faintly everywhere, then in full where nothing hides
// them.
#include "render/overlay_renderer.h"

#include <algorithm>
#include <array>
#include <utility>

namespace netwright {
namespace {

constexpr std::size_t kOverlayStyles = static_cast<std::size_t>(OverlayStyle::Rim) + 1;  // the last one
static_assert(kOverlayStyles <= kMaxLineStyles);

constexpr float kThroughTheModel = 0.3F;
constexpr float kMeasuredThrough = 0.75F;

Colour full(Colour colour) {
  colour.a = 1;
  return colour;
}

std::array<LineStyle, kOverlayStyles> overlay_styles(const Palette& palette, float strength) {
  std::array<LineStyle, kOverlayStyles> styles;
  const auto set = [&](OverlayStyle style, Colour colour, float width_px, float least = 0) {
    colour.a *= std::max(strength, least);
    styles[static_cast<std::size_t>(style)] = {colour, width_px, {}, false};
  };
  set(OverlayStyle::Hovered, palette.hover_edge, 4.5F);
  set(OverlayStyle::Selected, palette.selection, 4);
  set(OverlayStyle::Partner, palette.hover_edge, 1.8F);
  set(OverlayStyle::Culprit, full(palette.overlap), 4);
  set(OverlayStyle::PinnedFold, palette.pinned_fold, 3.5F);
  set(OverlayStyle::PinnedCut, palette.pinned_cut, 3.5F);
  set(OverlayStyle::Patch, palette.patch, 3);
  set(OverlayStyle::CulpritDot, full(palette.overlap), 9);
  // What is measured goes straight through the model and must be seen on all its way.
  set(OverlayStyle::Measured, palette.measure, 2, kMeasuredThrough);
  set(OverlayStyle::Dot, palette.measure, 7, kMeasuredThrough);
  set(OverlayStyle::Rim, palette.measure_rim, 10, kMeasuredThrough);
  return styles;
}

}  // namespace

void OverlayLines::add_in_space(const glm::dvec3& from, const glm::dvec3& to, OverlayStyle style) {
  space.push_back({glm::vec3(from), glm::vec3(to), static_cast<std::uint32_t>(style)});
}

void OverlayLines::add_in_plane(glm::dvec2 from, glm::dvec2 to, OverlayStyle style) {
  plane.push_back(
      {glm::vec3(glm::vec2(from), 0), glm::vec3(glm::vec2(to), 0), static_cast<std::uint32_t>(style)});
}

OverlayRenderer::OverlayRenderer(const LineRenderer& lines) : lines_(lines) {}

void OverlayRenderer::set_lines(OverlayLines lines) {
  if (lines == held_) return;
  held_ = std::move(lines);
  ++version_;
  in_space_.upload(held_.space, version_);
  in_plane_.upload(held_.plane, version_);
}

void OverlayRenderer::draw_on_model(const OrbitCamera& camera, const Palette& palette, float scale) const {
  LineView through = look_through(camera, scale);
  through.is_depth_tested = false;
  lines_.draw(in_space_, overlay_styles(palette, kThroughTheModel), through);
  lines_.draw(in_space_, overlay_styles(palette, 1), look_through(camera, scale, 4));
}

void OverlayRenderer::draw_on_net(const PanZoomCamera& camera, const Palette& palette, float scale) const {
  lines_.draw(in_plane_, overlay_styles(palette, 1), look_through(camera, scale));
}

}  // namespace netwright
