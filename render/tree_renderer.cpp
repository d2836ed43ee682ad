// The tree's lines for both views, built together from one net. Where the lines meet they have round ends, so
// a bend needs no joint; a root's mark is a line without length, which is a disc.
#include "render/tree_renderer.h"

#include <array>
#include <vector>

namespace netwright {
namespace {

// Indices into the styles of the lines, and into those of the marks.
constexpr std::uint32_t kTreeLine = 0;
constexpr std::uint32_t kClimbedLine = 1;
constexpr std::uint32_t kCandidateLine = 2;
constexpr std::uint32_t kRootRim = 0;
constexpr std::uint32_t kRootDisc = 1;

/// The same strokes in space and in the plane.
struct Strokes {
  std::vector<LineSegment> space;
  std::vector<LineSegment> plane;
};

glm::vec3 raised(glm::dvec2 p) { return {static_cast<float>(p.x), static_cast<float>(p.y), 0.0F}; }

/// Index of the largest convex part, by area in the face's flat frame.
int largest_part(const DualGraph& dual, FaceId f) {
  int best = 0;
  double best_area = -1;
  for (int p = 0; p < dual.n_parts(f); ++p) {
    const std::span<const int> part = dual.part(f, p);
    const auto at = [&](std::size_t k) {
      return dual.flat(HalfedgeId(dual.mesh().first(f).value + part[k]));
    };
    double area = 0;
    for (std::size_t k = 2; k < part.size(); ++k) area += cross(at(k - 1) - at(0), at(k) - at(0));
    if (area > best_area) {
      best_area = area;
      best = p;
    }
  }
  return best;
}

template <class Point, class At>
Point part_mean(const DualGraph& dual, FaceId f, At at) {
  Point sum(0);
  const std::span<const int> part = dual.part(f, largest_part(dual, f));
  for (const int c : part) sum += at(HalfedgeId(dual.mesh().first(f).value + c));
  return sum / static_cast<double>(part.size());
}

/// Half of a hinge's stroke: from the face's middle to the middle of its side h.
void add_half(const Net& net, HalfedgeId h, std::uint32_t style, Strokes& out) {
  const Mesh& mesh = net.mesh();
  const FaceId f = mesh.face(h);
  const HalfedgeId g = mesh.next(h);
  out.space.push_back(
      {glm::vec3(face_anchor(*net.dual, f)), glm::vec3((mesh.position(h) + mesh.position(g)) * 0.5), style});
  out.plane.push_back({raised(face_anchor(net, f)), raised((net.corner(h) + net.corner(g)) * 0.5), style});
}

void add_hinge(const Net& net, HalfedgeId h, std::uint32_t style, Strokes& out) {
  add_half(net, h, style, out);
  if (net.mesh().twin(h).is_valid()) add_half(net, net.mesh().twin(h), style, out);
}

/// A cut that could become a fold: on the net its two sides lie apart, and a stroke leads across.
void add_candidate(const Net& net, EdgeId e, Strokes& out) {
  const Mesh& mesh = net.mesh();
  const HalfedgeId h = mesh.halfedge(e);
  if (!mesh.twin(h).is_valid()) return;
  add_hinge(net, h, kCandidateLine, out);
  const auto middle = [&](HalfedgeId g) { return (net.corner(g) + net.corner(mesh.next(g))) * 0.5; };
  out.plane.push_back({raised(middle(h)), raised(middle(mesh.twin(h))), kCandidateLine});
}

}  // namespace

glm::dvec3 face_anchor(const DualGraph& dual, FaceId face) {
  if (dual.n_parts(face) <= 1) return dual.mesh().centre(face);
  return part_mean<glm::dvec3>(dual, face, [&](HalfedgeId h) { return dual.mesh().position(h); });
}

glm::dvec2 face_anchor(const Net& net, FaceId face) {
  const auto flat = [&](HalfedgeId h) { return net.dual->flat(h); };
  if (net.dual->n_parts(face) <= 1) return net.placement[face](glm::dvec2(0));
  return net.placement[face](part_mean<glm::dvec2>(*net.dual, face, flat));
}

TreeRenderer::TreeRenderer(const LineRenderer& lines) : lines_(lines) {}

void TreeRenderer::set_tree(const Net& net, std::span<const FaceId> climbed,
                            std::span<const EdgeId> candidates, std::uint64_t version, bool has_folds) {
  mean_edge_ = net.mesh().mean_edge();
  if (!in_space_.holds(version)) {
    upload_marks(net, climbed, candidates, version);
    for (LineBatch* batch : {&folds_in_space_, &folds_in_plane_}) batch->upload({}, 0);
  }
  if (has_folds && !folds_in_space_.holds(version)) upload_folds(net, version);
}

void TreeRenderer::upload_folds(const Net& net, std::uint64_t version) {
  Strokes strokes;
  strokes.space.reserve(2 * net.mesh().n_faces());
  strokes.plane.reserve(2 * net.mesh().n_faces());
  for (const FaceId f : net.mesh().faces())
    if (!net.tree.is_root(f)) add_hinge(net, net.tree.to_parent(f), kTreeLine, strokes);
  folds_in_space_.upload(strokes.space, version);
  folds_in_plane_.upload(strokes.plane, version);
}

void TreeRenderer::upload_marks(const Net& net, std::span<const FaceId> climbed,
                                std::span<const EdgeId> candidates, std::uint64_t version) {
  const Mesh& mesh = net.mesh();
  Strokes strokes;
  Strokes roots;
  for (const FaceId f : net.tree.roots()) {
    for (const std::uint32_t style : {kRootRim, kRootDisc}) {
      const glm::vec3 in_space(face_anchor(*net.dual, f));
      const glm::vec3 in_plane = raised(face_anchor(net, f));
      roots.space.push_back({in_space, in_space, style});
      roots.plane.push_back({in_plane, in_plane, style});
    }
  }
  for (std::size_t k = 0; k + 1 < climbed.size(); ++k) {
    for (const HalfedgeId h : mesh.halfedges(climbed[k]))
      if (mesh.neighbour(h) == climbed[k + 1] && net.tree.is_fold(mesh, mesh.edge(h)))
        add_hinge(net, h, kClimbedLine, strokes);
  }
  for (const EdgeId e : candidates) add_candidate(net, e, strokes);
  in_space_.upload(strokes.space, version);
  in_plane_.upload(strokes.plane, version);
  roots_in_space_.upload(roots.space, version);
  roots_in_plane_.upload(roots.plane, version);
}

void TreeRenderer::clear() {
  for (LineBatch* batch :
       {&folds_in_space_, &folds_in_plane_, &in_space_, &in_plane_, &roots_in_space_, &roots_in_plane_})
    batch->upload({}, 0);
}

namespace {

std::array<LineStyle, 3> tree_styles(const Palette& palette, const TreeLook& look, float width_px) {
  const auto shown_if = [](bool is_shown, Colour colour) {
    if (!is_shown) colour.a = 0;
    return colour;
  };
  std::array<LineStyle, 3> styles;
  styles[kTreeLine] = {shown_if(look.shows_tree, palette.tree), width_px, {}, false};
  Colour climbed = palette.chosen;
  climbed.a = 1;
  styles[kClimbedLine] = {shown_if(look.shows_search, climbed), width_px + 1.6F, {}, false};
  styles[kCandidateLine] = {shown_if(look.shows_search, palette.candidate), width_px, {5, 3.5F, 0, 0}, false};
  return styles;
}

std::array<LineStyle, 2> root_styles(const Palette& palette) {
  Colour disc = palette.root;
  disc.a = 1;
  std::array<LineStyle, 2> styles;
  styles[kRootRim] = {palette.root_rim, 11, {}, false};
  styles[kRootDisc] = {disc, 8, {}, false};
  return styles;
}

}  // namespace

void TreeRenderer::draw_on_model(const OrbitCamera& camera, const Palette& palette,
                                 const TreeLook& look) const {
  const float width = 2.0F * thinning(mean_edge_ * camera.pixels_per_unit(), look.scale);
  if (look.is_seen_through) {
    auto hidden = tree_styles(palette, look, width);
    for (LineStyle& style : hidden) style.colour.a *= 0.35F;
    LineView through = look_through(camera, look.scale);
    through.is_depth_tested = false;
    if (look.shows_tree) lines_.draw(folds_in_space_, hidden, through);
    lines_.draw(in_space_, hidden, through);
  }
  const LineView view = look_through(camera, look.scale, 2.5);
  if (look.shows_tree) lines_.draw(folds_in_space_, tree_styles(palette, look, width), view);
  lines_.draw(in_space_, tree_styles(palette, look, width), view);
  if (look.shows_roots)
    lines_.draw(roots_in_space_, root_styles(palette), look_through(camera, look.scale, 10));
}

void TreeRenderer::draw_on_net(const PanZoomCamera& camera, const Palette& palette,
                               const TreeLook& look) const {
  const LineView view = look_through(camera, look.scale);
  const float width = 1.5F * thinning(mean_edge_ * camera.pixels_per_unit(), look.scale);
  if (look.shows_tree) lines_.draw(folds_in_plane_, tree_styles(palette, look, width), view);
  lines_.draw(in_plane_, tree_styles(palette, look, width), view);
  if (look.shows_roots) lines_.draw(roots_in_plane_, root_styles(palette), view);
}

}  // namespace netwright
