// The net in four layers: sheets, a rim behind the cuts where the desk is dark, the faces, and the lines. A
// live net changes with every snapshot, so its buffers are rebuilt whole; a thousand faces are some tens of
// kilobytes.
#include "render/net_renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "render/gl.h"

namespace netwright {
namespace {

struct NetVertex {
  glm::vec2 position;
  std::uint32_t face;
};

// Indices into the styles of the net's lines.
constexpr std::uint32_t kCutLine = 0;
constexpr std::uint32_t kMountainLine = 1;
constexpr std::uint32_t kValleyLine = 2;
constexpr std::uint32_t kFlatLine = 3;
constexpr std::uint32_t kBorderLine = 4;

glm::vec3 flat_point(glm::dvec2 p) { return {static_cast<float>(p.x), static_cast<float>(p.y), 0.0F}; }

std::uint32_t style_of(EdgeKind kind) {
  switch (kind) {
    case EdgeKind::Mountain:
      return kMountainLine;
    case EdgeKind::Valley:
      return kValleyLine;
    case EdgeKind::Flat:
      return kFlatLine;
    case EdgeKind::Border:
      return kBorderLine;
    case EdgeKind::Cut:
    case EdgeKind::Hidden:  // never drawn
      break;
  }
  return kCutLine;
}

/// Fills a rectangle of the world by clearing it: axis-parallel, so no triangle is needed.
void clear_box(const PanZoomCamera& camera, const Box2& box, const Colour& colour) {
  const glm::dvec2 low = camera.to_pixel({box.min.x, box.min.y});
  const glm::dvec2 high = camera.to_pixel({box.max.x, box.max.y});
  const glm::ivec2 size(camera.size_px());
  const glm::ivec2 from =
      glm::clamp(glm::ivec2(glm::round(glm::dvec2(low.x, size.y - low.y))), glm::ivec2(0), size);
  const glm::ivec2 to =
      glm::clamp(glm::ivec2(glm::round(glm::dvec2(high.x, size.y - high.y))), glm::ivec2(0), size);
  if (to.x <= from.x || to.y <= from.y) return;
  glScissor(from.x, from.y, to.x - from.x, to.y - from.y);
  glEnable(GL_SCISSOR_TEST);
  glClearColor(colour.r, colour.g, colour.b, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glDisable(GL_SCISSOR_TEST);
}

void append_box(const Box2& box, std::uint32_t style, std::vector<LineSegment>& out) {
  const std::array<glm::dvec2, 4> corners{box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
  for (std::size_t k = 0; k < 4; ++k)
    out.push_back({flat_point(corners[k]), flat_point(corners[(k + 1) % 4]), style});
}

}  // namespace

NetRenderer::NetRenderer(const LineRenderer& lines) : lines_(lines), shader_("net") {
  constexpr std::size_t kStride = sizeof(NetVertex);
  face_array_.attribute(0, face_buffer_, 2, AttributeType::Float, kStride, offsetof(NetVertex, position));
  face_array_.attribute(1, face_buffer_, 1, AttributeType::UnsignedInt, kStride, offsetof(NetVertex, face));
}

void NetRenderer::set_net(const Net& net, const IdVector<EdgeId, EdgeKind>& kinds, std::uint64_t version,
                          bool has_folds) {
  if (!face_buffer_.holds(version)) {
    upload_faces(net, version);
    upload_cuts(net, kinds, version);
    folds_.upload({}, 0);
    are_outlines_stale_ = true;
    mean_edge_ = net.mesh().mean_edge();
  }
  if (has_folds && !folds_.holds(version)) upload_folds(net, kinds, version);
}

void NetRenderer::clear() {
  n_face_vertices_ = 0;
  corners_.clear();
  face_begin_.clear();
  face_buffer_.stamp(0);
  cuts_.upload({}, 0);
  folds_.upload({}, 0);
  outlines_.upload({}, 0);
}

void NetRenderer::set_sheets(std::span<const SheetOutline> sheets) {
  std::vector<LineSegment> segments;
  sheets_.clear();
  for (const SheetOutline& sheet : sheets) {
    sheets_.push_back(sheet.border);
    append_box(sheet.border, 0, segments);
    append_box(sheet.printable, 1, segments);
  }
  sheet_lines_.upload(segments, 1);
}

void NetRenderer::upload_faces(const Net& net, std::uint64_t version) {
  const Mesh& mesh = net.mesh();
  std::vector<NetVertex> vertices;
  vertices.reserve(3 * mesh.n_halfedges());
  corners_.resize(mesh.n_halfedges());
  face_begin_.assign(1, 0);
  for (const HalfedgeId h : mesh.halfedges()) corners_[h.index()] = glm::vec2(net.corner(h));
  for (const FaceId f : mesh.faces()) {
    const auto first = static_cast<std::size_t>(face_begin_.back());
    for (int p = 0; p < net.dual->n_parts(f); ++p) {
      const std::span<const int> part = net.dual->part(f, p);
      for (std::size_t k = 2; k < part.size(); ++k)
        for (const int c : {part[0], part[k - 1], part[k]})
          vertices.push_back(
              {corners_[first + static_cast<std::size_t>(c)], static_cast<std::uint32_t>(f.index())});
    }
    face_begin_.push_back(face_begin_.back() + mesh.degree(f));
  }
  face_buffer_.upload(std::as_bytes(std::span(vertices)));
  face_buffer_.stamp(version);
  n_face_vertices_ = static_cast<int>(vertices.size());
}

void NetRenderer::upload_cuts(const Net& net, const IdVector<EdgeId, EdgeKind>& kinds,
                              std::uint64_t version) {
  const Mesh& mesh = net.mesh();
  segments_.clear();
  for (const HalfedgeId h : mesh.halfedges()) {
    const std::uint32_t style = style_of(kinds[mesh.edge(h)]);
    if (kinds[mesh.edge(h)] == EdgeKind::Hidden || (style != kCutLine && style != kBorderLine)) continue;
    segments_.push_back(
        {glm::vec3(corners_[h.index()], 0), glm::vec3(corners_[mesh.next(h).index()], 0), style});
  }
  cuts_.upload(segments_, version);
}

void NetRenderer::upload_folds(const Net& net, const IdVector<EdgeId, EdgeKind>& kinds,
                               std::uint64_t version) {
  const Mesh& mesh = net.mesh();
  segments_.clear();
  for (const EdgeId e : mesh.edges()) {
    const std::uint32_t style = style_of(kinds[e]);
    if (kinds[e] == EdgeKind::Hidden || style == kCutLine || style == kBorderLine) continue;
    const HalfedgeId h = mesh.halfedge(e);
    segments_.push_back(
        {glm::vec3(corners_[h.index()], 0), glm::vec3(corners_[mesh.next(h).index()], 0), style});
  }
  folds_.upload(segments_, version);
}

void NetRenderer::upload_outlines() {
  std::vector<LineSegment> segments;
  const std::size_t n_faces = face_begin_.empty() ? 0 : face_begin_.size() - 1;
  for (std::size_t f = 0; f < std::min(n_faces, states_.size()); ++f) {
    if (!states_.has(FaceId(f), FaceState::Selected)) continue;
    const auto first = static_cast<std::size_t>(face_begin_[f]);
    const auto count = static_cast<std::size_t>(face_begin_[f + 1]) - first;
    for (std::size_t k = 0; k < count; ++k)
      segments.push_back(
          {glm::vec3(corners_[first + k], 0.0F), glm::vec3(corners_[first + (k + 1) % count], 0.0F), 0});
  }
  outlines_.upload(segments, 1);
  are_outlines_stale_ = false;
}

void NetRenderer::upload_states(const FaceStates& states) {
  const std::size_t n_faces = face_begin_.empty() ? 0 : face_begin_.size() - 1;
  if (states != states_ || !state_table_.holds(n_faces + 1)) {
    states_ = states;
    std::vector<std::uint8_t> bits = states.bits();
    bits.resize(n_faces, 0);
    state_table_.upload_table(bits);
    state_table_.stamp(n_faces + 1);
    are_outlines_stale_ = true;
  }
  if (are_outlines_stale_) upload_outlines();
}

void NetRenderer::draw(const PanZoomCamera& camera, const Palette& palette, const FaceStates& states,
                       const NetLook& look) {
  upload_states(states);
  if (look.draws_sheets) draw_sheets(camera, palette, look);
  draw_faces(camera, palette, look);
  draw_lines(camera, palette, look);
}

void NetRenderer::draw_sheets(const PanZoomCamera& camera, const Palette& palette,
                              const NetLook& look) const {
  for (const Box2& sheet : sheets_) clear_box(camera, sheet, look.is_printed ? palette.paper : palette.sheet);
  Colour margin = palette.sheet_margin;
  if (look.is_printed) margin.a = 0;  // what lies outside cannot be printed, and nothing does
  const std::array<LineStyle, 2> styles{LineStyle{palette.sheet_border, 1, {}, false},
                                        LineStyle{margin, 1, {2, 3, 0, 0}, false}};
  lines_.draw(sheet_lines_, styles, look_through(camera, look.scale));
}

void NetRenderer::draw_faces(const PanZoomCamera& camera, const Palette& palette, const NetLook& look) const {
  if (n_face_vertices_ == 0) return;
  if (palette.cut_halo.a > 0 && !look.is_printed) {
    std::array<LineStyle, 5> halo;
    halo[kCutLine] = halo[kBorderLine] = {palette.cut_halo, 3.6F, {}, false};
    lines_.draw(cuts_, halo, look_through(camera, look.scale));
  }
  shader_.use();
  shader_.set("clip_from_world", glm::mat4(camera.view_projection()));
  shader_.set("paper", palette.paper);
  shader_.set("root", palette.root);
  shader_.set("overlap", palette.overlap);
  shader_.set("hover", palette.hover);
  shader_.set("chosen", palette.chosen);
  shader_.set("climbed", palette.climbed);
  shader_.set("seldom", palette.heat[0]);
  shader_.set("often", palette.heat[1]);
  shader_.set("most", palette.heat[2]);
  shader_.set("hatch", palette.overlap_hatch);
  const glm::dvec2 origin = camera.to_pixel({0, 0});
  shader_.set("hatch_origin", glm::vec2(origin.x, camera.size_px().y - origin.y));
  shader_.set("hatch_scale", 1 / look.scale);
  shader_.set("states", 0);
  shader_.set("is_glass", look.is_printed ? 1 : 0);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, state_table_.name());
  glDisable(GL_DEPTH_TEST);
  if (look.is_printed) {
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  } else {
    glDisable(GL_BLEND);
  }
  glDisable(GL_CULL_FACE);
  glBindVertexArray(face_array_.name());
  glDrawArrays(GL_TRIANGLES, 0, n_face_vertices_);
}

void NetRenderer::draw_lines(const PanZoomCamera& camera, const Palette& palette, const NetLook& look) const {
  const LineView view = look_through(camera, look.scale);
  const float thin = thinning(mean_edge_ * camera.pixels_per_unit(), look.scale);
  std::array<LineStyle, 5> styles;
  styles[kCutLine] = {palette.cut, 1.3F * thin, {}, false};
  styles[kMountainLine] = {palette.mountain, 1.1F * thin, {6, 2.5F, 1.2F, 2.5F}, false};
  styles[kValleyLine] = {palette.valley, 1.1F * thin, {4, 3, 0, 0}, false};
  styles[kFlatLine] = {palette.flat, 1, {}, false};
  styles[kBorderLine] = {palette.border, 1.3F * thin, {}, false};
  if (look.shows_folds && !look.is_printed) lines_.draw(folds_, styles, view);
  if (look.shows_cuts && !look.is_printed) lines_.draw(cuts_, styles, view);
  const std::array<LineStyle, 1> selected{LineStyle{palette.selection, 3, {}, false}};
  lines_.draw(outlines_, selected, view);
}

}  // namespace netwright
