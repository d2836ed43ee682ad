// Keeps a collapse from pushing faces through other parts of the surface: a grid of cells over the live faces
// and a test of the few that are near. Only simplify*.cpp include it.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/mesh/simplify_guards.h"
#include "core/mesh/simplify_surface.h"

namespace netwright::simplify {

class CrossingGuard {
 public:
  /// Sorts all live faces into cells about as large as their edges.
  void rebuild(const TriangleSurface& surface);

  /// After a collapse: the faces around the merged point lie elsewhere now.
  void update(const TriangleSurface& surface, VertexId merged, int n_live);

  /// True when a moved face would cut through a face that none of the moved ones has cut before.
  bool would_cross(const TriangleSurface& surface, HalfedgeId h, std::span<const RingFace> ring);

 private:
  struct Entry {
    FaceId face;
    int next;
  };
  void insert(const TriangleSurface& surface, FaceId f);
  void gather_near(const TriangleSurface& surface, HalfedgeId h, std::span<const RingFace> ring);
  template <class Visit>
  void for_each_cell(const Box3& box, Visit&& visit) const;

  glm::dvec3 origin_{0};
  double cell_ = 1;
  std::array<int, 3> size_{1, 1, 1};
  std::vector<int> head_;  ///< of each cell's list of entries, -1: none
  std::vector<Entry> entries_;
  std::size_t n_entries_when_new_ = 0;
  int n_live_when_new_ = 0;
  IdVector<FaceId, int> seen_;  ///< the number of the last query that met the face
  int query_ = 0;
  std::vector<FaceId> near_;
};

}  // namespace netwright::simplify
