// What collapsing edges leaves behind: the history from which the model with any number of faces is put
// together. Only simplify*.cpp include it.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/simplify.h"

namespace netwright {

/// State 0 is the mesh cut into triangles; step s leads from state s to state s + 1. A step makes one new
/// point of two, so the points of all states form a forest: leaves are those of state 0, point
/// n_leaves + s was made by step s. Texture coordinates have a forest of their own, since a point on a seam
/// has several.
struct CollapseHistory {
  static constexpr int kNever = std::numeric_limits<int>::max();

  int n_steps = 0;
  std::vector<int> polygon;  ///< of each triangle: the mesh's face
  std::vector<int> death;    ///< the step each triangle dies in, or kNever
  std::vector<int> heir;     ///< the triangle that takes its place then
  std::vector<int> leaf;     ///< the point of each of its three corners in state 0

  int n_leaves = 0;
  std::vector<int> parent;           ///< of each point: what it became, or -1
  std::vector<glm::dvec3> position;  ///< of each point

  std::vector<int> uv_leaf;  ///< of each triangle's corners; empty without texture coordinates
  std::vector<int> uv_parent;
  std::vector<glm::dvec2> uv;
  std::vector<int> n_uv_at;  ///< how many texture points there are in each state

  std::vector<int> broken_at;   ///< for each face of the mesh: from which state on it is single triangles
  std::vector<int> n_faces_at;  ///< of each state
};

namespace simplify {

/// Collapses until options.least_faces is reached or nothing more can go.
CollapseHistory collapse_all(const Mesh& mesh, const SimplifyOptions& options, Progress& progress);

}  // namespace simplify
}  // namespace netwright
