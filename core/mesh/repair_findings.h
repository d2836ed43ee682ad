// What can be found out about a soup, broken or not: culprits by number, without words (mesh_report finds
// those).
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <vector>

#include "core/mesh/soup.h"

namespace netwright::repair {

struct Findings {
  int n_vertices = 0;  ///< points that faces use, after joining
  int n_merged = 0;    ///< points that joined others
  int n_parts = 0;
  int n_border_loops = 0;
  int genus = 0;  ///< of the surface cut along its crowded edges
  double border_length = 0;
  glm::dvec3 size{0};
  // Edges and points are looked at without broken and doubled faces.
  std::vector<std::array<int, 2>> border_edges{};
  std::vector<std::array<int, 2>> crowded_edges{};  ///< more than two sides, or twice the same face
  std::vector<int> pinched_points{};                ///< several fans meet there, away from crowded edges
  std::vector<int> isolated_points{};
  std::vector<int>
      doubled_points{};  ///< those that joined others, ascending; only of a file with shared points
  std::vector<int> broken_faces{};     ///< a corner twice, or fewer than three
  std::vector<int> zero_area_faces{};  ///< of those that are not broken
  std::vector<int> doubled_faces{};    ///< all but the first with the same corners, if not broken
  std::vector<int> turned_faces{};
  bool is_one_sided = false;
  std::vector<int> uneven_faces{};  ///< worst first
  double worst_unevenness = 0;
};

/// n log n. Points in the findings are the first ones at their place.
Findings find_faults(const PolygonSoup& soup);

}  // namespace netwright::repair
