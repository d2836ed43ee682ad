// What the fuzzers of all model formats demand of a soup, and of everything that it passes on its way to a
// mesh.
#pragma once

#include <cmath>
#include <cstdlib>

#include "core/mesh/merge_faces.h"
#include "core/mesh/repair.h"
#include "core/mesh/soup.h"
#include "core/mesh/split_faces.h"

namespace netwright::testing {

inline void demand(bool holds) {
  if (!holds) std::abort();
}

/// What read.h promises of every soup.
inline void check_promises(const PolygonSoup& soup) {
  demand(soup.n_faces() > 0);
  demand(soup.face_begin.front() == 0 && soup.face_begin.back() == static_cast<int>(soup.corners.size()));
  for (const int corner : soup.corners) demand(corner >= 0 && corner < static_cast<int>(soup.points.size()));
  for (const glm::dvec3& p : soup.points)
    demand(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
  demand(soup.corner_uv.empty() || soup.corner_uv.size() == soup.corners.size());
  demand(soup.face_material.empty() || soup.face_material.size() == static_cast<std::size_t>(soup.n_faces()));
  for (const int material : soup.face_material)
    demand(material >= -1 && material < static_cast<int>(soup.materials.size()));
}

inline void check_way_to_mesh(const PolygonSoup& soup) {
  const PreparedModel model = prepare(soup);
  if (!model.mesh) {
    demand(!model.refusal.empty());
    return;
  }
  const MergedFaces merged = merge_coplanar_faces(*model.mesh);
  const SplitFaces split = split_uneven_faces(*model.mesh);
  demand(merged.n_after() <= static_cast<int>(model.mesh->n_faces()));
  demand(split.soup.n_faces() >= static_cast<int>(model.mesh->n_faces()));
}

}  // namespace netwright::testing
