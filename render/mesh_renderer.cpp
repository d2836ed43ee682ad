// The model as one buffer of triangles, three vertices each and none shared, so that every face has one tone.
// What changes often, the state of faces, lives in a small table beside it.
#include "render/mesh_renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "render/gl.h"

namespace netwright {
namespace {

// Indices into the styles of the model's edges.
constexpr std::uint32_t kPlainLine = 0;
constexpr std::uint32_t kBorderLine = 1;
constexpr std::uint32_t kCutLine = 2;
constexpr std::uint32_t kMountainLine = 3;
constexpr std::uint32_t kValleyLine = 4;
constexpr std::uint32_t kFlatLine = 5;

constexpr float kGlass = 0.2F;       ///< opacity of a face of a model that is seen through
constexpr float kHiddenLine = 0.3F;  ///< of the strength of lines that nothing hides

std::uint32_t style_of(EdgeKind kind) {
  switch (kind) {
    case EdgeKind::Mountain:
      return kMountainLine;
    case EdgeKind::Valley:
      return kValleyLine;
    case EdgeKind::Flat:
    case EdgeKind::Hidden:
      return kFlatLine;
    case EdgeKind::Border:
      return kBorderLine;
    case EdgeKind::Cut:
      break;
  }
  return kCutLine;
}

std::uint8_t to_srgb_byte(double linear) {
  const double x = std::clamp(linear, 0.0, 1.0);
  const double s = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(s * 255));
}

bool has_picture(const Mesh& mesh, int material) {
  if (material < 0 || !mesh.has_uv()) return false;
  const auto& texture = mesh.materials()[static_cast<std::size_t>(material)].texture;
  return texture && !texture->is_empty();
}

/// Alpha 0 where the face has no material; white under a picture.
std::array<std::uint8_t, 4> material_colour(const Mesh& mesh, FaceId f) {
  const int material = mesh.material(f);
  if (material < 0) return {0, 0, 0, 0};
  if (has_picture(mesh, material)) return {255, 255, 255, 255};
  const glm::dvec3& c = mesh.materials()[static_cast<std::size_t>(material)].colour;
  return {to_srgb_byte(c.r), to_srgb_byte(c.g), to_srgb_byte(c.b), 255};
}

}  // namespace

MeshRenderer::MeshRenderer(const LineRenderer& lines) : lines_(lines), shader_("mesh") {
  constexpr std::size_t kStride = sizeof(Vertex);
  array_.attribute(0, buffer_, 3, AttributeType::Float, kStride, offsetof(Vertex, position));
  array_.attribute(1, buffer_, 3, AttributeType::Float, kStride, offsetof(Vertex, normal));
  array_.attribute(2, buffer_, 2, AttributeType::Float, kStride, offsetof(Vertex, uv));
  array_.attribute(3, buffer_, 4, AttributeType::NormalizedByte, kStride, offsetof(Vertex, material));
  array_.attribute(4, buffer_, 1, AttributeType::UnsignedInt, kStride, offsetof(Vertex, face));
}

void MeshRenderer::set_model(std::shared_ptr<const DualGraph> dual) {
  if (dual == dual_) return;
  dual_ = std::move(dual);
  groups_.clear();
  textures_.clear();
  vertices_.clear();
  corner_of_.clear();
  pose_version_ = kinds_version_ = 0;
  if (!dual_) return;
  collect_triangles();
  const ModelPose model(dual_->mesh());
  upload_triangles(model);
  upload_edges(model, nullptr);
  upload_textures();
  states_ = FaceStates();
  state_table_.stamp(0);
}

void MeshRenderer::set_pose(const Corners* corners, std::uint64_t pose_version,
                            const IdVector<EdgeId, EdgeKind>* kinds, std::uint64_t kinds_version) {
  if (!dual_ || (pose_version == pose_version_ && kinds_version == kinds_version_)) return;
  const ModelPose pose(dual_->mesh(), corners);
  if (pose_version != pose_version_) upload_triangles(pose);
  upload_edges(pose, kinds);
  upload_outlines();
  pose_version_ = pose_version;
  kinds_version_ = kinds_version;
}

void MeshRenderer::collect_triangles() {
  const Mesh& mesh = dual_->mesh();
  const auto picture = [&](FaceId f) { return has_picture(mesh, mesh.material(f)) ? mesh.material(f) : -1; };
  std::vector<FaceId> order;
  order.reserve(mesh.n_faces());
  for (const FaceId f : mesh.faces()) order.push_back(f);
  std::stable_sort(order.begin(), order.end(), [&](FaceId a, FaceId b) { return picture(a) < picture(b); });
  corner_of_.reserve(3 * mesh.n_halfedges());
  for (const FaceId f : order) {
    const auto first = static_cast<int>(corner_of_.size());
    if (groups_.empty() || groups_.back().material != picture(f)) groups_.push_back({picture(f), first, 0});
    for (int p = 0; p < dual_->n_parts(f); ++p) {
      const std::span<const int> part = dual_->part(f, p);
      for (std::size_t k = 2; k < part.size(); ++k)
        for (const int c : {part[0], part[k - 1], part[k]})
          corner_of_.push_back(HalfedgeId(mesh.first(f).value + c));
    }
    groups_.back().count += static_cast<int>(corner_of_.size()) - first;
  }
  vertices_.reserve(corner_of_.size());
  for (const HalfedgeId h : corner_of_) {
    const FaceId f = mesh.face(h);
    vertices_.push_back({{},
                         {},
                         mesh.has_uv() ? glm::vec2(mesh.uv(h)) : glm::vec2(0),
                         material_colour(mesh, f),
                         static_cast<std::uint32_t>(f.index())});
  }
}

void MeshRenderer::upload_triangles(const ModelPose& pose) {
  const Mesh& mesh = pose.mesh();
  corners_.resize(mesh.n_halfedges());
  for (const HalfedgeId h : mesh.halfedges()) corners_[h.index()] = glm::vec3(pose.position(h));
  normals_.resize(mesh.n_faces());
  for (const FaceId f : mesh.faces()) normals_[f.index()] = glm::vec3(pose.normal(f));
  for (std::size_t k = 0; k < vertices_.size(); ++k) {
    vertices_[k].position = corners_[corner_of_[k].index()];
    vertices_[k].normal = normals_[vertices_[k].face];
  }
  buffer_.upload(std::as_bytes(std::span(vertices_)));
}

void MeshRenderer::upload_edges(const ModelPose& pose, const IdVector<EdgeId, EdgeKind>* kinds) {
  const Mesh& mesh = pose.mesh();
  segments_.clear();
  const auto add = [&](HalfedgeId h, std::uint32_t style) {
    segments_.push_back({corners_[h.index()], corners_[mesh.next(h).index()], style});
  };
  for (const EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e);
    const std::uint32_t plain = mesh.is_border(e) ? kBorderLine : kPlainLine;
    const std::uint32_t style = kinds == nullptr ? plain : style_of((*kinds)[e]);
    add(h, style);
    if (style == kCutLine && !pose.is_model()) add(mesh.twin(h), style);
  }
  edges_.upload(segments_, 1);
}

void MeshRenderer::upload_textures() {
  const Mesh& mesh = dual_->mesh();
  textures_.resize(mesh.materials().size());
  for (std::size_t m = 0; m < textures_.size(); ++m)
    if (has_picture(mesh, static_cast<int>(m))) textures_[m].upload(*mesh.materials()[m].texture);
}

void MeshRenderer::upload_states(const FaceStates& states) {
  if (state_table_.holds(1) && states == states_) return;
  const Mesh& mesh = dual_->mesh();
  states_ = states;
  std::vector<std::uint8_t> bits = states.bits();
  bits.resize(mesh.n_faces(), 0);
  state_table_.upload_table(bits);
  state_table_.stamp(1);
  upload_outlines();
}

void MeshRenderer::upload_outlines() {
  const Mesh& mesh = dual_->mesh();
  std::vector<LineSegment> segments;
  for (std::size_t f = 0; f < std::min(states_.size(), mesh.n_faces()); ++f) {
    if (!states_.has(FaceId(f), FaceState::Selected)) continue;
    for (const HalfedgeId h : mesh.halfedges(FaceId(f)))
      segments.push_back({corners_[h.index()], corners_[mesh.next(h).index()], 0});
  }
  outlines_.upload(segments, 1);
}

void MeshRenderer::draw(const OrbitCamera& camera, const Palette& palette, const FaceStates& states,
                        const MeshLook& look) {
  if (!dual_) return;
  upload_states(states);
  draw_faces(camera, palette, look);
  draw_lines(camera, palette, look);
}

void MeshRenderer::draw_faces(const OrbitCamera& camera, const Palette& palette, const MeshLook& look) const {
  shader_.use();
  shader_.set("clip_from_world", glm::mat4(camera.view_projection()));
  shader_.set("view_from_world", glm::mat4(camera.view()));
  shader_.set("paper", palette.model);
  shader_.set("paper_back", palette.model_back);
  shader_.set("root", palette.root);
  shader_.set("overlap", palette.overlap);
  shader_.set("hover", palette.hover);
  shader_.set("chosen", palette.chosen);
  shader_.set("climbed", palette.climbed);
  shader_.set("seldom", palette.heat[0]);
  shader_.set("often", palette.heat[1]);
  shader_.set("most", palette.heat[2]);
  shader_.set("shows_materials", look.shows_materials ? 1 : 0);
  shader_.set("hatch", palette.overlap_hatch);
  const glm::dvec3 target = camera.project(camera.target());
  shader_.set("hatch_origin", glm::vec2(target.x, camera.size_px().y - target.y));
  shader_.set("hatch_scale", 1 / look.scale);
  shader_.set("states", 0);
  shader_.set("picture", 1);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, state_table_.name());
  shader_.set("opacity", look.is_seen_through ? kGlass : 1.0F);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glBindVertexArray(array_.name());
  if (look.is_seen_through) {
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    draw_groups();
    // Once more for the depth alone, which tells hidden edges from others.
    glDisable(GL_BLEND);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  }
  glEnable(GL_DEPTH_TEST);
  draw_groups();
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glActiveTexture(GL_TEXTURE0);
}

void MeshRenderer::draw_groups() const {
  for (const Group& group : groups_) {
    shader_.set("has_texture", group.material >= 0 ? 1 : 0);
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D,
                  group.material >= 0 ? textures_[static_cast<std::size_t>(group.material)].name() : 0);
    glDrawArrays(GL_TRIANGLES, group.first, group.count);
  }
}

void MeshRenderer::draw_lines(const OrbitCamera& camera, const Palette& palette, const MeshLook& look) const {
  const LineView view = look_through(camera, look.scale);
  const float thin = thinning(dual_->mesh().mean_edge() * camera.pixels_per_unit(), look.scale);
  std::array<LineStyle, 6> edge_styles;
  edge_styles[kPlainLine] = {palette.model_edge, thin, {}, false};
  edge_styles[kBorderLine] = {palette.border, 1.4F, {}, false};
  edge_styles[kCutLine] = {palette.cut, 1.5F * thin, {}, false};
  edge_styles[kMountainLine] = {palette.mountain, 1.1F * thin, {6, 2.5F, 1.2F, 2.5F}, false};
  edge_styles[kValleyLine] = {palette.valley, 1.1F * thin, {4, 3, 0, 0}, false};
  edge_styles[kFlatLine] = {palette.flat, 1, {}, false};
  if (!look.shows_folds)
    for (const std::uint32_t style : {kMountainLine, kValleyLine, kFlatLine}) edge_styles[style].colour.a = 0;
  if (look.is_seen_through && look.shows_edges) {
    std::array<LineStyle, 6> hidden = edge_styles;
    for (LineStyle& style : hidden) style.colour.a *= kHiddenLine;
    LineView through = view;
    through.is_depth_tested = false;
    lines_.draw(edges_, hidden, through);
  }
  if (look.shows_edges) lines_.draw(edges_, edge_styles, view);
  const std::array<LineStyle, 1> selected{LineStyle{palette.selection, 3, {}, false}};
  lines_.draw(outlines_, selected, view);
}

}  // namespace netwright
