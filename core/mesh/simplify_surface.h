// The surface that simplification shrinks: triangles with three halfedges each (3f, 3f+1, 3f+2) in flat
// arrays, and the collapse of an edge as an exchange of a few indices. Only simplify*.cpp include it.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <vector>

#include "core/base/ids.h"
#include "core/mesh/mesh.h"

namespace netwright::simplify {

struct TriangleSurface {
  /// Cuts the polygons of the mesh into triangles. A polygon whose own corners do not allow it without a
  /// triangle of no area or a doubled edge gets a point in its middle; these points follow those of the mesh.
  explicit TriangleSurface(const Mesh& mesh);

  IdVector<VertexId, glm::dvec3> position;
  IdVector<VertexId, HalfedgeId> out;  ///< a halfedge that starts here: at a border the one without a twin
  IdVector<HalfedgeId, VertexId> from;
  IdVector<HalfedgeId, HalfedgeId> twin;    ///< invalid at a border
  IdVector<HalfedgeId, HalfedgeId> corner;  ///< of the mesh, for looks; invalid at a middle point
  IdVector<FaceId, FaceId> polygon;         ///< of the mesh
  IdVector<FaceId, char> is_dead;

  static FaceId face(HalfedgeId h) { return FaceId(h.value / 3); }
  static HalfedgeId next(HalfedgeId h) { return HalfedgeId(h.value % 3 == 2 ? h.value - 2 : h.value + 1); }
  static HalfedgeId prev(HalfedgeId h) { return HalfedgeId(h.value % 3 == 0 ? h.value + 2 : h.value - 1); }
  static IdRange<HalfedgeId> halfedges(FaceId f) { return {3 * f.value, 3 * f.value + 3}; }
  [[nodiscard]] VertexId to(HalfedgeId h) const { return from[next(h)]; }
  [[nodiscard]] IdRange<FaceId> faces() const { return IdRange<FaceId>(polygon.size()); }
  [[nodiscard]] bool is_border(VertexId v) const { return !twin[out[v]].is_valid(); }
  [[nodiscard]] std::array<glm::dvec3, 3> corners(FaceId f) const {
    const HalfedgeId h(3 * f.value);
    return {position[from[h]], position[from[HalfedgeId(h.value + 1)]],
            position[from[HalfedgeId(h.value + 2)]]};
  }

  /// Calls visit(h) for every halfedge that starts at v, once round.
  template <class Visit>
  void for_each_out(VertexId v, Visit&& visit) const {
    HalfedgeId h = out[v];
    do {
      visit(h);
      h = twin[prev(h)];
    } while (h.is_valid() && h != out[v]);
  }
  /// Calls visit(w) for every neighbour of v, once each.
  template <class Visit>
  void for_each_neighbour(VertexId v, Visit&& visit) const {
    HalfedgeId h = out[v];
    HalfedgeId last = h;
    do {
      visit(to(h));
      last = prev(h);
      h = twin[last];
    } while (h.is_valid() && h != out[v]);
    if (!h.is_valid()) visit(from[last]);
  }

  /// The link condition: the surface stays a manifold of the same kind when h's ends become one.
  [[nodiscard]] bool may_collapse(HalfedgeId h) const;

  /// Makes the two ends of h one point, the one that h starts from; the other end is gone. Its one or two
  /// faces die; position is left alone. May only be called when may_collapse(h).
  void collapse(HalfedgeId h);

 private:
  void add_polygon(const Mesh& mesh, FaceId f);
  void add_star(const Mesh& mesh, FaceId f);
  void add_triangle(const Mesh& mesh, FaceId f, const std::array<int, 3>& corners);
  void replace_doubled_diagonals(const Mesh& mesh);
  void pair_halfedges();
  void close_gap(HalfedgeId h);
  void set_out(VertexId v, HalfedgeId start);
};

}  // namespace netwright::simplify
