// An oriented manifold polygon mesh: any face size, any genus, closed or with borders, one or more
// components. Valid by construction and immutable; shared between threads as shared_ptr<const Mesh>. After it
// nobody checks.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/ids.h"
#include "core/mesh/soup.h"

namespace netwright {

class Mesh {
 public:
  /// Checks everything the class promises and throws Error(Unfit) with one sentence that names the place
  /// (face and point numbers count from 1, as OBJ files do) and the cure: a face with under three corners or
  /// a repeated corner, an edge with more than two faces, two faces that run the same way along an edge, a
  /// point where faces meet in more than one fan, a face without area. Faces must be oriented consistently
  /// already (see repair.h); points no face uses are dropped. `is_flipped[f]` (empty or one per face) says
  /// that the soup's face runs against the source file's.
  explicit Mesh(const PolygonSoup& soup, const std::vector<bool>& is_flipped = {},
                const std::vector<int>& face_source = {});

  [[nodiscard]] std::size_t n_vertices() const { return positions_.size(); }
  [[nodiscard]] std::size_t n_faces() const { return face_begin_.size() - 1; }
  [[nodiscard]] std::size_t n_halfedges() const { return from_.size(); }
  [[nodiscard]] std::size_t n_edges() const { return edge_halfedge_.size(); }
  [[nodiscard]] std::size_t n_components() const { return n_components_; }
  [[nodiscard]] IdRange<VertexId> vertices() const { return IdRange<VertexId>(n_vertices()); }
  [[nodiscard]] IdRange<FaceId> faces() const { return IdRange<FaceId>(n_faces()); }
  [[nodiscard]] IdRange<EdgeId> edges() const { return IdRange<EdgeId>(n_edges()); }
  [[nodiscard]] IdRange<HalfedgeId> halfedges() const { return IdRange<HalfedgeId>(n_halfedges()); }

  /// The halfedges of a face, counter-clockwise seen from outside.
  [[nodiscard]] IdRange<HalfedgeId> halfedges(FaceId f) const {
    return {face_begin_[f.index()], face_begin_[f.index() + 1]};
  }
  [[nodiscard]] int degree(FaceId f) const { return face_begin_[f.index() + 1] - face_begin_[f.index()]; }
  [[nodiscard]] HalfedgeId first(FaceId f) const { return HalfedgeId(face_begin_[f.index()]); }
  [[nodiscard]] HalfedgeId next(HalfedgeId h) const {
    const FaceId f = face_[h];
    return h.value + 1 == face_begin_[f.index() + 1] ? first(f) : HalfedgeId(h.value + 1);
  }
  [[nodiscard]] HalfedgeId prev(HalfedgeId h) const {
    const FaceId f = face_[h];
    return h.value == face_begin_[f.index()] ? HalfedgeId(face_begin_[f.index() + 1] - 1)
                                             : HalfedgeId(h.value - 1);
  }
  /// The same edge seen from the face on its other side; invalid at a border.
  [[nodiscard]] HalfedgeId twin(HalfedgeId h) const { return twin_[h]; }
  [[nodiscard]] FaceId face(HalfedgeId h) const { return face_[h]; }
  /// The face on the other side; invalid at a border.
  [[nodiscard]] FaceId neighbour(HalfedgeId h) const {
    return twin_[h].is_valid() ? face_[twin_[h]] : FaceId();
  }
  [[nodiscard]] EdgeId edge(HalfedgeId h) const { return edge_[h]; }
  /// One of the edge's halfedges (the one with the smaller index).
  [[nodiscard]] HalfedgeId halfedge(EdgeId e) const { return edge_halfedge_[e]; }
  [[nodiscard]] bool is_border(EdgeId e) const { return !twin_[edge_halfedge_[e]].is_valid(); }
  [[nodiscard]] VertexId from(HalfedgeId h) const { return from_[h]; }
  [[nodiscard]] VertexId to(HalfedgeId h) const { return from_[next(h)]; }

  [[nodiscard]] const glm::dvec3& position(VertexId v) const { return positions_[v]; }
  [[nodiscard]] const glm::dvec3& position(HalfedgeId h) const { return positions_[from_[h]]; }
  /// Unit normal of the face's best plane (Newell's vector area), outward when the mesh is.
  [[nodiscard]] const glm::dvec3& normal(FaceId f) const { return normals_[f]; }
  /// Mean of the corners.
  [[nodiscard]] const glm::dvec3& centre(FaceId f) const { return centres_[f]; }
  [[nodiscard]] double area(FaceId f) const { return areas_[f]; }
  /// Longest side or diagonal of the face.
  [[nodiscard]] double size(FaceId f) const { return sizes_[f]; }
  /// Largest distance of a corner from the best plane, as a share of the face's size.
  [[nodiscard]] double unevenness(FaceId f) const { return unevenness_[f]; }
  /// The same as a share of the face's longest side, as the proof has it (flat: <= kFlatness). A disc of many
  /// short sides would lose far more of them, laid flat, than its width tells.
  [[nodiscard]] double side_unevenness(FaceId f) const { return side_unevenness_[f]; }
  [[nodiscard]] double length(EdgeId e) const {
    const HalfedgeId h = edge_halfedge_[e];
    return glm::length(position(to(h)) - position(from(h)));
  }

  [[nodiscard]] int component(FaceId f) const { return component_[f]; }
  [[nodiscard]] bool is_closed() const { return n_border_edges_ == 0; }
  [[nodiscard]] std::size_t n_border_edges() const { return n_border_edges_; }
  [[nodiscard]] std::size_t n_border_loops() const { return n_border_loops_; }
  /// Sum of the components' genus: handles, as (2·components − loops − V + E − F) / 2.
  [[nodiscard]] int genus() const;
  [[nodiscard]] double mean_edge() const { return mean_edge_; }
  [[nodiscard]] const Box3& box() const { return box_; }
  /// Extent along the up axis, in model units.
  [[nodiscard]] double height() const { return up_axis_ == UpAxis::Y ? box_.size().y : box_.size().z; }
  [[nodiscard]] UpAxis up_axis() const { return up_axis_; }

  [[nodiscard]] const std::string& name() const { return name_; }
  /// Index of the face in the file it came from, and whether it runs the other way round there.
  [[nodiscard]] int face_source(FaceId f) const { return face_source_[f]; }
  [[nodiscard]] bool is_flipped(FaceId f) const { return is_flipped_[f] != 0; }
  [[nodiscard]] bool has_uv() const { return !uv_.empty(); }
  [[nodiscard]] glm::dvec2 uv(HalfedgeId h) const { return uv_[h]; }
  [[nodiscard]] const std::vector<Material>& materials() const { return materials_; }
  /// Index into materials(), or -1.
  [[nodiscard]] int material(FaceId f) const { return face_material_.empty() ? -1 : face_material_[f]; }

 private:
  void copy_faces(const PolygonSoup& soup, const std::vector<bool>& is_flipped,
                  const std::vector<int>& face_source);
  void copy_looks(const PolygonSoup& soup);
  void measure_faces();
  void pair_halfedges(const std::vector<int>& point_of);
  void check_fans(const std::vector<int>& point_of) const;
  void find_components();
  void find_border_loops();

  std::string name_;
  UpAxis up_axis_ = UpAxis::Y;
  IdVector<VertexId, glm::dvec3> positions_;
  std::vector<int> face_begin_{0};
  IdVector<HalfedgeId, VertexId> from_;
  IdVector<HalfedgeId, HalfedgeId> twin_;
  IdVector<HalfedgeId, FaceId> face_;
  IdVector<HalfedgeId, EdgeId> edge_;
  IdVector<EdgeId, HalfedgeId> edge_halfedge_;
  IdVector<FaceId, glm::dvec3> normals_;
  IdVector<FaceId, glm::dvec3> centres_;
  IdVector<FaceId, double> areas_;
  IdVector<FaceId, double> sizes_;
  IdVector<FaceId, double> unevenness_;
  IdVector<FaceId, double> side_unevenness_;
  IdVector<FaceId, int> component_;
  IdVector<FaceId, int> face_source_;
  IdVector<FaceId, char> is_flipped_;
  IdVector<HalfedgeId, glm::dvec2> uv_;
  IdVector<FaceId, int> face_material_;
  std::vector<Material> materials_;
  std::size_t n_components_ = 0;
  std::size_t n_border_edges_ = 0;
  std::size_t n_border_loops_ = 0;
  double mean_edge_ = 0;
  Box3 box_;
};

}  // namespace netwright
