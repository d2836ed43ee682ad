// The list is sorted by the file's faces, since that is what is asked for most.
#include "core/project/origins.h"

#include <algorithm>

namespace netwright {

namespace {

void tidy(Origins& origins) {
  std::ranges::sort(origins);
  origins.erase(std::ranges::unique(origins).begin(), origins.end());
}

std::span<const Origin> run_of(const Origins& origins, int file_face) {
  const auto run = std::ranges::equal_range(origins, file_face, {}, &Origin::file_face);
  return {run.begin(), run.end()};
}

}  // namespace

Origins origins_of(const Mesh& mesh) { return origins_of(mesh, {}); }

Origins origins_of(const Mesh& mesh, const IdVector<FaceId, std::vector<int>>& groups) {
  Origins origins;
  origins.reserve(mesh.n_faces());
  for (const FaceId f : mesh.faces()) {
    if (mesh.face_source(f) >= 0) origins.push_back({mesh.face_source(f), f});
    if (groups.empty()) continue;
    for (const int file_face : groups[f])
      if (file_face >= 0) origins.push_back({file_face, f});
  }
  tidy(origins);
  return origins;
}

Origins passed_on(const Origins& origins, const std::vector<int>& heirs) {
  Origins next;
  next.reserve(origins.size());
  for (const Origin& origin : origins) {
    const int heir = heirs[origin.face.index()];
    if (heir >= 0) next.push_back({origin.file_face, FaceId(heir)});
  }
  tidy(next);
  return next;
}

std::vector<FaceId> faces_made_of(const Origins& origins, std::span<const int> file_faces) {
  std::vector<FaceId> faces;
  for (const int file_face : file_faces)
    for (const Origin& origin : run_of(origins, file_face)) faces.push_back(origin.face);
  std::ranges::sort(faces);
  faces.erase(std::ranges::unique(faces).begin(), faces.end());
  if (file_faces.empty()) return faces;
  const std::span<const Origin> first = run_of(origins, file_faces.front());
  std::ranges::stable_partition(
      faces, [&](FaceId f) { return std::ranges::find(first, f, &Origin::face) != first.end(); });
  return faces;
}

std::vector<int> file_faces_of(const Origins& origins, FaceId face) {
  std::vector<int> file_faces;
  for (const Origin& origin : origins)
    if (origin.face == face) file_faces.push_back(origin.file_face);
  return file_faces;
}

}  // namespace netwright
