// One component of the model as the search wants it: plain arrays with plain indices, lengths scaled so that
// the mean edge is 1. Faces and halfedges are numbered from 0 within the component; built once, shared by all
// streams.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "core/mesh/dual_graph.h"
#include "core/solve/constraints.h"

namespace netwright {

struct SearchModel {
  int n_faces = 0;
  int n_halfedges = 0;
  std::vector<int> face_begin{0};   ///< face -> its first halfedge
  std::vector<int> face_of;         ///< halfedge -> face
  std::vector<int> twin;            ///< halfedge -> the other side, -1 at a border and at a must-cut
  std::vector<Rigid2> unroll;       ///< halfedge -> placement of the face beyond, in the face's frame
  std::vector<double> edge_length;  ///< per halfedge
  std::vector<int> part_begin{0};   ///< face -> its convex parts
  std::vector<int> vert_begin{0};   ///< part -> its vertices
  std::vector<glm::dvec2> verts;    ///< in the face's frame, counter-clockwise
  double total_area = 0;            ///< in square mean edges
  double mean_valence = 3;          ///< `val` of the paper's section 4.4
  bool is_pinned = false;           ///< there are must-folds or patches:
  std::vector<char> is_kept;        ///< halfedge -> it must be a fold; empty unless is_pinned
  std::vector<int> patch;  ///< halfedge -> number of the patch both its faces belong to, or -1; likewise
  std::vector<FaceId> mesh_face;  ///< back to the mesh
  std::vector<HalfedgeId> mesh_halfedge;

  /// The face beyond a halfedge that is not on a border.
  [[nodiscard]] int beyond(int h) const { return face_of[at(twin[at(h)])]; }
  [[nodiscard]] int first_vert(int f) const { return vert_begin[at(part_begin[at(f)])]; }
  [[nodiscard]] int last_vert(int f) const { return vert_begin[at(part_begin[at(f) + 1])]; }

  /// May one of these halfedges take the other's place as a fold, as far as pins go? A patch that a removed
  /// fold has parted can be joined again only inside.
  [[nodiscard]] bool may_exchange(int removed, int inserted) const {
    return !is_pinned || (is_kept[at(removed)] == 0 &&
                          (patch[at(removed)] < 0 || patch[at(removed)] == patch[at(inserted)]));
  }

  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
};

/// One model per component of the mesh, in the order of the components' numbers. The pins must not contradict
/// each other.
std::vector<SearchModel> search_models(const DualGraph& dual, const Constraints& pins = {});

}  // namespace netwright
