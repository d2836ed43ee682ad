// Texture coordinates and materials while edges collapse: which edges are seams, and what becomes of the
// texture points of two corners that become one. Only simplify*.cpp include it.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "core/mesh/simplify_collapse.h"
#include "core/mesh/simplify_surface.h"

namespace netwright::simplify {

class Looks {
 public:
  Looks(const Mesh& mesh, const TriangleSurface& surface);

  /// True when the texture or the material changes across the edge; false at a border.
  [[nodiscard]] bool is_seam(const TriangleSurface& surface, HalfedgeId h) const;

  /// Hands the texture points of the start over to the history.
  void begin(CollapseHistory& history) const;

  /// Before the ends of h become one point at `place`: each texture point of theirs moves to where `place`
  /// lies in the picture, and those on both sides of a shared face become one.
  void merge(const TriangleSurface& surface, HalfedgeId h, const glm::dvec3& place, CollapseHistory& history);

 private:
  struct Group {
    int point;  ///< texture point before
    int group;  ///< smallest index into groups_ that it belongs with
  };
  void gather_groups(const TriangleSurface& surface, HalfedgeId h);
  void unite(int a, int b);
  [[nodiscard]] int find(int point) const;
  [[nodiscard]] glm::dvec2 uv_at(const TriangleSurface& surface, HalfedgeId h, int group,
                                 const glm::dvec3& place, const CollapseHistory& history) const;

  const Mesh& mesh_;
  IdVector<HalfedgeId, int> point_;  ///< texture point of each corner; empty without texture coordinates
  std::vector<glm::dvec2> first_uv_;
  std::vector<Group> groups_;
};

}  // namespace netwright::simplify
