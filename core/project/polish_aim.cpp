// Rooms are those that the pages themselves would offer.
#include "core/project/polish_aim.h"

#include <algorithm>
#include <cmath>

#include "core/sheet/page_frame.h"

namespace netwright {

namespace {

constexpr double kBottomSight = 0.25;  ///< of a cut between faces that look down
constexpr double kValleySight = 0.6;
constexpr double kDown = -0.5;  ///< upward part of a normal below which a face looks down

bool is_texture_seam(const Mesh& mesh, HalfedgeId h) {
  const HalfedgeId twin = mesh.twin(h);
  return mesh.has_uv() && (mesh.uv(h) != mesh.uv(mesh.next(twin)) || mesh.uv(mesh.next(h)) != mesh.uv(twin));
}

double sight(const DualGraph& dual, EdgeId e) {
  const Mesh& mesh = dual.mesh();
  const HalfedgeId h = mesh.halfedge(e);
  if (mesh.is_border(e) || is_texture_seam(mesh, h)) return 0;
  const auto looks_down = [&](FaceId f) {
    const glm::dvec3& normal = mesh.normal(f);
    return (mesh.up_axis() == UpAxis::Y ? normal.y : normal.z) < kDown;
  };
  if (looks_down(mesh.face(h)) && looks_down(mesh.neighbour(h))) return kBottomSight;
  return dual.bend(e) < 0 ? kValleySight : 1;
}

/// mm² of paper that the whole net takes at a scale; a page it fills completely.
double paper_of(const Mesh& mesh, double scale) {
  double area = 0;
  for (const FaceId f : mesh.faces()) area += mesh.area(f);
  return area * scale * scale;
}

std::vector<glm::dvec2> rooms(const Project& project) {
  const double tabs_mm = project.tabs.is_on ? 2 * project.tabs.width_mm : 0;
  std::vector<glm::dvec2> rooms;
  for (const PageFrame& frame : possible_frames(project.paper)) {
    const glm::dvec2 room = frame.net.size() - glm::dvec2(tabs_mm);
    if (room.x > 0 && room.y > 0) rooms.push_back(room);
  }
  return rooms;
}

}  // namespace

IdVector<EdgeId, double> edges_in_sight(const DualGraph& dual) {
  IdVector<EdgeId, double> result(dual.mesh().n_edges(), 0);
  for (const EdgeId e : dual.mesh().edges()) result[e] = sight(dual, e);
  return result;
}

std::optional<PolishAim> polish_aim(const Project& project, const PolishSettings& settings) {
  if (settings.effort <= 0) return std::nullopt;
  PolishAim aim{settings, {}, {}, {}};
  const bool is_as_large_as_can_be =
      project.size.kind == PrintSize::Kind::FitPage || project.size.kind == PrintSize::Kind::FitSheets;
  aim.scale = [paper = project.paper, size = project.size](const Net& net) {
    return arrange(net, paper, size).scale;
  };
  if (settings.fits_paper > 0) aim.rooms_mm = rooms(project);
  if (is_as_large_as_can_be && !aim.rooms_mm.empty()) {
    const Mesh& mesh = project.dual->mesh();
    const glm::dvec2 room = aim.rooms_mm.front();
    const double full = std::sqrt(room.x * room.y / paper_of(mesh, 1));
    aim.scale = [full](const Net&) { return full; };
  }
  if (settings.hidden_cuts > 0) aim.in_sight = edges_in_sight(*project.dual);
  return aim;
}

}  // namespace netwright
