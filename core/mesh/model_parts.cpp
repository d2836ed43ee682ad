// Lists a mesh's parts with the means of repair, and writes a mesh anew without some.
#include "core/mesh/model_parts.h"

#include <algorithm>
#include <unordered_set>

#include "core/mesh/repair_parts.h"

namespace netwright {
namespace {

/// What the mesh's constructor takes.
struct MeshInput {
  PolygonSoup soup;
  std::vector<bool> is_flipped;
  std::vector<int> face_source;
};

template <class IsKept>
MeshInput input_of(const Mesh& mesh, IsKept is_kept) {
  MeshInput input;
  PolygonSoup& soup = input.soup;
  soup.name = mesh.name();
  soup.up_axis = mesh.up_axis();
  soup.materials = mesh.materials();
  soup.is_joined = true;
  for (const VertexId v : mesh.vertices()) soup.points.push_back(mesh.position(v));
  for (const FaceId f : mesh.faces()) {
    if (!is_kept(f)) continue;
    for (const HalfedgeId h : mesh.halfedges(f)) {
      soup.corners.push_back(mesh.from(h).value);
      if (mesh.has_uv()) soup.corner_uv.push_back(mesh.uv(h));
    }
    soup.face_begin.push_back(static_cast<int>(soup.corners.size()));
    if (!mesh.materials().empty()) soup.face_material.push_back(mesh.material(f));
    input.is_flipped.push_back(mesh.is_flipped(f));
    input.face_source.push_back(mesh.face_source(f));
  }
  return input;
}

int first_face_of(const Mesh& mesh, const std::vector<int>& faces) {
  int first = -1;
  for (const int f : faces) {
    const int source = mesh.face_source(FaceId(f));
    if (source >= 0 && (first < 0 || source < first)) first = source;
  }
  return first;
}

}  // namespace

std::vector<ModelPart> parts_of(const Mesh& mesh) {
  const PolygonSoup soup = input_of(mesh, [](FaceId /*f*/) { return true; }).soup;
  std::vector<repair::Part> found = repair::find_parts(soup);
  const std::vector<bool> is_inner = repair::find_inner_parts(soup, found);
  const std::vector<bool> is_small = repair::find_small_parts(soup, found, kSmallPartShare);
  std::vector<ModelPart> parts;
  for (std::size_t p = 0; p < found.size(); ++p) {
    const int first = first_face_of(mesh, found[p].faces);
    parts.push_back({first, std::move(found[p].faces), found[p].box.size(), is_inner[p], is_small[p]});
  }
  const auto diagonal = [](const ModelPart& part) { return glm::length(part.size); };
  std::ranges::stable_sort(parts, [&](const ModelPart& a, const ModelPart& b) {
    return diagonal(a) != diagonal(b) ? diagonal(a) > diagonal(b) : a.first_face < b.first_face;
  });
  return parts;
}

std::shared_ptr<const Mesh> without_parts(const Mesh& mesh, std::span<const int> left_out) {
  const std::unordered_set<int> named(left_out.begin(), left_out.end());
  std::vector<bool> is_left_out(mesh.n_components(), false);
  const auto component = [&](FaceId f) { return static_cast<std::size_t>(mesh.component(f)); };
  for (const FaceId f : mesh.faces())
    if (named.contains(mesh.face_source(f))) is_left_out[component(f)] = true;
  if (std::ranges::find(is_left_out, false) == is_left_out.end()) return nullptr;
  const MeshInput rest = input_of(mesh, [&](FaceId f) { return !is_left_out[component(f)]; });
  return std::make_shared<const Mesh>(rest.soup, rest.is_flipped, rest.face_source);
}

}  // namespace netwright
