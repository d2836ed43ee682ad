// Turns outlines into a soup and that into the next mesh. Points are numbered as they come, which is how a
// Mesh numbers its vertices, so the two agree.
#include "core/mesh/merge_stage.h"

#include <algorithm>

#include "core/base/error.h"

namespace netwright {

MergeStage first_stage(const Mesh& given, std::span<const FaceId> left_alone) {
  MergeStage stage;
  stage.given = &given;
  stage.mesh = &given;
  for (const FaceId f : given.faces()) stage.sources.push_back({f});
  for (const VertexId v : given.vertices()) stage.point_source.push_back(v);
  stage.is_left_alone.assign(given.n_faces(), false);
  for (const FaceId f : left_alone) {
    if (!f.is_valid() || f.index() >= given.n_faces())
      throw Error(ErrorKind::Usage, "There is no face " + std::to_string(f.value + 1) +
                                        " to leave alone; the model has " + std::to_string(given.n_faces()) +
                                        " faces.");
    stage.is_left_alone[f.index()] = true;
  }
  return stage;
}

MergeStage stage_of(const MergeStage& from, std::vector<Outline> outlines) {
  std::sort(outlines.begin(), outlines.end(),
            [](const Outline& a, const Outline& b) { return a.sources.front() < b.sources.front(); });
  const Mesh& mesh = *from.mesh;
  const Mesh& given = *from.given;
  MergeStage to;
  to.given = from.given;
  to.soup.name = given.name();
  to.soup.up_axis = given.up_axis();
  to.soup.materials = given.materials();
  IdVector<VertexId, int> point_of(mesh.n_vertices(), -1);
  std::vector<int> corners;
  for (Outline& outline : outlines) {
    corners.clear();
    for (const HalfedgeId h : outline.corners) {
      int& point = point_of[mesh.from(h)];
      if (point < 0) {
        point = static_cast<int>(to.soup.points.size());
        to.soup.points.push_back(mesh.position(h));
        to.point_source.push_back(from.point_source[mesh.from(h).index()]);
      }
      corners.push_back(point);
      if (mesh.has_uv()) to.soup.corner_uv.push_back(mesh.uv(h));
    }
    to.soup.add_face(corners);
    const FaceId first = outline.sources.front();
    if (!given.materials().empty()) to.soup.face_material.push_back(given.material(first));
    to.is_flipped.push_back(given.is_flipped(first));
    to.face_source.push_back(given.face_source(first));
    to.is_left_alone.push_back(outline.is_left_alone);
    to.sources.push_back(std::move(outline.sources));
  }
  to.owner = std::make_shared<const Mesh>(to.soup, to.is_flipped, to.face_source);
  to.mesh = to.owner.get();
  return to;
}

}  // namespace netwright
