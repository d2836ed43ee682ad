// Lines as instanced quads. Styles travel as uniforms, so a change of theme or of scale uploads no geometry.
#include "render/line_renderer.h"

#include <algorithm>
#include <cstddef>

#include "render/gl.h"

namespace netwright {

LineBatch::LineBatch() {
  constexpr std::size_t kStride = sizeof(LineSegment);
  array_.attribute(0, buffer_, 3, AttributeType::Float, kStride, offsetof(LineSegment, from), true);
  array_.attribute(1, buffer_, 3, AttributeType::Float, kStride, offsetof(LineSegment, to), true);
  array_.attribute(2, buffer_, 1, AttributeType::UnsignedInt, kStride, offsetof(LineSegment, style), true);
}

void LineBatch::upload(std::span<const LineSegment> segments, std::uint64_t version) {
  buffer_.upload(std::as_bytes(segments));
  buffer_.stamp(version);
  n_segments_ = static_cast<int>(segments.size());
}

void LineBatch::bind() const { glBindVertexArray(array_.name()); }

LineView look_through(const OrbitCamera& camera, float scale, double lift_px) {
  LineView view;
  const glm::dmat4 projection = camera.projection();
  view.clip_from_world = glm::mat4(projection * camera.view());
  view.size_px = glm::vec2(camera.size_px());
  view.scale = scale;
  view.is_depth_tested = true;
  // Moving a point at distance w to w (1 - s) leaves its pixel and takes this much off its depth in clip
  // space.
  const double focal = projection[1][1] / -projection[2][3];
  const double share = lift_px * static_cast<double>(scale) * 2 / (focal * camera.size_px().y);
  view.pull = static_cast<float>(-projection[3][2] * share / (1 - share));
  return view;
}

LineView look_through(const PanZoomCamera& camera, float scale) {
  return {glm::mat4(camera.view_projection()), glm::vec2(camera.size_px()), scale, false, 0};
}

float thinning(double mean_edge_px, float scale) {
  constexpr double kRoomyEdge = 18;  // pixels
  return static_cast<float>(std::clamp(mean_edge_px / (kRoomyEdge * static_cast<double>(scale)), 0.45, 1.0));
}

LineRenderer::LineRenderer() : shader_("line") {}

void LineRenderer::draw(const LineBatch& batch, std::span<const LineStyle> styles,
                        const LineView& view) const {
  if (batch.size() == 0) return;
  std::array<glm::vec4, kMaxLineStyles> colours{};
  std::array<glm::vec4, kMaxLineStyles> dashes{};
  std::array<glm::vec4, kMaxLineStyles> shapes{};
  for (std::size_t k = 0; k < std::min(styles.size(), kMaxLineStyles); ++k) {
    const LineStyle& s = styles[k];
    colours[k] = s.colour;
    dashes[k] = {s.dash[0], s.dash[1], s.dash[2], s.dash[3]};
    shapes[k] = {s.width_px * view.scale, s.is_dash_in_world ? 1.0F : 0.0F, view.scale, 0};
  }
  shader_.use();
  shader_.set("clip_from_world", view.clip_from_world);
  shader_.set("size_px", view.size_px);
  shader_.set("pull", view.pull);
  shader_.set("style_colour", std::span<const glm::vec4>(colours));
  shader_.set("style_dash", std::span<const glm::vec4>(dashes));
  shader_.set("style_shape", std::span<const glm::vec4>(shapes));
  if (view.is_depth_tested)
    glEnable(GL_DEPTH_TEST);
  else
    glDisable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDisable(GL_CULL_FACE);
  batch.bind();
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, batch.size());
  glDepthMask(GL_TRUE);
}

}  // namespace netwright
