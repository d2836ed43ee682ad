// Three steps of heat rather than a gradient: they can be told apart on shaded faces and named in a legend.
#include "ui/heat.h"

#include <algorithm>

#include "ui/lit.h"

namespace netwright {
namespace {

// Shares of the hottest face's collisions.
constexpr float kSeldom = 0.04F;
constexpr float kOften = 0.25F;
constexpr float kMost = 0.6F;

/// The trouble, where it is to be shown and speaks of the present mesh.
std::shared_ptr<const Trouble> shown_trouble(const UiContext& context) {
  if (!context.ui.settings.show_heat) return nullptr;
  const auto trouble = context.session.trouble();
  const auto& dual = context.session.project().dual;
  const bool fits = trouble && dual && trouble->heat.size() == dual->mesh().n_faces();
  return fits ? trouble : nullptr;
}

std::vector<HalfedgeId> corners_at(const Mesh& mesh, VertexId vertex) {
  std::vector<HalfedgeId> corners;
  for (const HalfedgeId h : mesh.halfedges())
    if (mesh.from(h) == vertex) corners.push_back(h);
  return corners;
}

}  // namespace

bool shows_heat(const UiContext& context) { return shown_trouble(context) != nullptr; }

int heat_level(float heat) {
  if (heat < kSeldom) return 0;
  return heat < kOften ? 1 : heat < kMost ? 2 : 3;
}

void mark_heat(const UiContext& context, FaceStates& states) {
  const auto trouble = shown_trouble(context);
  if (trouble == nullptr) return;
  for (const FaceId f : trouble->heat.ids()) {
    const int level = heat_level(trouble->heat[f]);
    if (level == 1 || level == 3) states.add(f, FaceState::Warm);
    if (level >= 2) states.add(f, FaceState::Hot);
  }
}

void add_excess_points(const UiContext& context, const ModelPose& pose, const Net* net, OverlayLines& lines) {
  const auto trouble = shown_trouble(context);
  if (trouble == nullptr) return;
  const Mesh& mesh = pose.mesh();
  IdVector<VertexId, char> is_marked(mesh.n_vertices(), 0);
  const std::size_t n = std::min(trouble->points.size(), kMostExcessPoints);
  for (std::size_t i = 0; i < n; ++i) is_marked[trouble->points[i].vertex] = 1;
  IdVector<VertexId, char> is_done(mesh.n_vertices(), 0);
  for (const HalfedgeId h : mesh.halfedges()) {
    const VertexId v = mesh.from(h);
    if (is_marked[v] == 0) continue;
    const bool is_new = !pose.is_model() || is_done[v] == 0;
    if (is_new) lines.add_in_space(pose.position(h), pose.position(h), OverlayStyle::CulpritDot);
    is_done[v] = 1;
    if (net != nullptr) lines.add_in_plane(net->corner(h), net->corner(h), OverlayStyle::CulpritDot);
  }
}

void show_excess_point(UiContext& context, VertexId vertex) {
  UiState& ui = context.ui;
  const Mesh& mesh = context.session.project().dual->mesh();
  const std::vector<glm::dvec3> place{mesh.position(vertex)};
  const bool was_lit = ui.lit.points == place;
  clear_lit(ui);
  if (was_lit) return;
  ui.lit.points = place;
  for (const HalfedgeId h : corners_at(mesh, vertex)) ui.lit.faces.push_back(mesh.face(h));
  ui.wants_lit_in_view = true;
  ui.wants_flight = ui.lit.faces;
}

}  // namespace netwright
