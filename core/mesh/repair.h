// From a soup to a Mesh that can be unfolded: equal points become one, faces are turned to run the same way
// and outward, and what was found and done is told in a report. Nothing is dropped behind the user's back.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/mesh/mesh_report.h"

namespace netwright {

/// Makes corners at one place use one point, the first of them; unused points stay in the soup, so point
/// numbers in messages remain those of the file. Equal points always merge; where the file gave each face
/// points of its own (!is_indexed) also points within kWeldDistance of the model's diagonal. Returns how many
/// points merged into others.
int weld(PolygonSoup& soup);

/// Turns faces until neighbours run the same way and each closed component's volume is positive; open
/// components keep the way that most of their faces had. Returns one flag per face: turned or not.
/// Throws Error(Unfit), naming an edge and its two faces, when the surface has only one side.
std::vector<bool> orient(PolygonSoup& soup);

/// A model as it is after reading: the report always, the mesh when there can be one.
struct PreparedModel {
  std::shared_ptr<const Mesh> mesh;  ///< null when the model is no orientable manifold
  MeshReport report;
  std::string refusal;  ///< why it cannot be unfolded, one sentence with the cure; empty when it can
  [[nodiscard]] bool is_fit() const { return refusal.empty(); }
};

/// Weld, orient, build, report. Never throws for a bad model; face f of the mesh is face f of the file.
/// Closed parts that have points of their own in the file and merely touch are kept apart.
PreparedModel prepare(const PolygonSoup& soup);

}  // namespace netwright
