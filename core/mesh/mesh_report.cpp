// Turns counts into a report's figures and lines.
#include "core/mesh/mesh_report.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "core/base/predicates.h"
#include "core/mesh/mesh.h"
#include "core/mesh/self_intersection.h"

namespace netwright {
namespace {

using Kind = MeshReport::Line::Kind;

std::string counted(int n, const std::string& one, const std::string& many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

/// "faces 3, 8, 12 and 4 more", numbered as in the file.
template <class Faces>
std::string face_list(const Mesh& mesh, const Faces& faces) {
  constexpr std::size_t kShown = 5;
  std::string list = faces.size() == 1 ? "face " : "faces ";
  for (std::size_t i = 0; i < std::min(faces.size(), kShown); ++i) {
    list += (i > 0 ? ", " : "") + std::to_string(mesh.face_source(faces[i]) + 1);
  }
  if (faces.size() > kShown) list += " and " + std::to_string(faces.size() - kShown) + " more";
  return list;
}

void add_uneven_faces(const Mesh& mesh, MeshReport& report) {
  std::vector<FaceId> uneven;
  for (const FaceId f : mesh.faces()) {
    report.worst_unevenness = std::max(report.worst_unevenness, mesh.unevenness(f));
    if (mesh.unevenness(f) > kFlatness) uneven.push_back(f);
  }
  report.n_uneven_faces = static_cast<int>(uneven.size());
  if (uneven.empty()) return;
  std::ranges::sort(uneven, [&](FaceId a, FaceId b) { return mesh.unevenness(a) > mesh.unevenness(b); });
  report.lines.push_back({Kind::Problem, counted(report.n_uneven_faces, "face is", "faces are") +
                                             " not flat, by up to " + percent(report.worst_unevenness) +
                                             " of the face's size (" + face_list(mesh, uneven) +
                                             "); triangulate before unfolding."});
}

void add_self_intersections(const Mesh& mesh, MeshReport& report) {
  const auto pairs = self_intersections(mesh);
  report.n_self_intersections = static_cast<int>(pairs.size());
  if (pairs.empty()) return;
  const auto& [a, b] = pairs.front();
  report.lines.push_back(
      {Kind::Notice, "The model cuts through itself in " +
                         counted(report.n_self_intersections, "place", "places") + ", first where faces " +
                         std::to_string(mesh.face_source(a) + 1) + " and " +
                         std::to_string(mesh.face_source(b) + 1) +
                         " cross: it unfolds, but the paper cannot be glued through itself."});
}

}  // namespace

std::string percent(double share) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), share < 0.001 ? "%.2g %%" : "%.1f %%", 100 * share);
  return text.data();
}

MeshReport report_on(const Mesh& mesh) {
  MeshReport report;
  report.n_faces = static_cast<int>(mesh.n_faces());
  report.n_vertices = static_cast<int>(mesh.n_vertices());
  report.n_components = static_cast<int>(mesh.n_components());
  report.genus = mesh.genus();
  report.n_border_edges = static_cast<int>(mesh.n_border_edges());
  report.n_border_loops = static_cast<int>(mesh.n_border_loops());
  report.is_closed = mesh.is_closed();
  report.is_manifold = true;
  report.lines.push_back({Kind::Fact, counted(report.n_faces, "face", "faces") + ", " +
                                          counted(report.n_vertices, "corner", "corners")});
  report.lines.push_back({Kind::Fact, report.is_closed
                                          ? "closed, genus " + std::to_string(report.genus)
                                          : "open, " + counted(report.n_border_loops, "border", "borders") +
                                                ", genus " + std::to_string(report.genus)});
  if (report.n_components > 1) {
    report.lines.push_back({Kind::Fact, std::to_string(report.n_components) +
                                            " separate parts; each becomes a piece of its own"});
  }
  add_uneven_faces(mesh, report);
  add_self_intersections(mesh, report);
  return report;
}

MeshReport report_on(const PolygonSoup& soup, const std::string& problem) {
  MeshReport report;
  report.n_faces = soup.n_faces();
  std::vector<int> used = soup.corners;
  std::ranges::sort(used);
  report.n_vertices = static_cast<int>(std::ranges::unique(used).begin() - used.begin());
  report.lines.push_back({Kind::Fact, counted(report.n_faces, "face", "faces") + ", " +
                                          counted(report.n_vertices, "corner", "corners")});
  report.lines.push_back({Kind::Problem, problem});
  return report;
}

}  // namespace netwright
