// The dual graph: one node per face, one hinge per interior edge, with the rigid motion that unrolls the
// neighbour across it into the face's own plane. It also holds every face's flat shape, in a frame of its
// own.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/mesh/mesh.h"

namespace netwright {

class DualGraph {
 public:
  /// Throws Error(Unfit) when a face is not flat (side_unevenness over kFlatness), saying how far off it is.
  /// `hidden`: edges whose folds are not to be drawn.
  explicit DualGraph(std::shared_ptr<const Mesh> mesh, const std::vector<EdgeId>& hidden = {});

  [[nodiscard]] const Mesh& mesh() const { return *mesh_; }
  [[nodiscard]] const std::shared_ptr<const Mesh>& shared_mesh() const { return mesh_; }

  /// Where corner h of its face lies in the face's own flat frame: origin at the corners' mean, outside up
  /// (counter-clockwise), lengths as in space (projected to the face's best plane).
  [[nodiscard]] const glm::dvec2& flat(HalfedgeId h) const { return flat_[h]; }

  /// Placement of the face beyond h in the frame of h's own face: P(neighbour) = P(face) * unroll(h).
  /// Shared edges are aligned by direction and midpoint. Meaningless at a border.
  [[nodiscard]] const Rigid2& unroll(HalfedgeId h) const { return unroll_[h]; }

  /// Dihedral bend at an edge in radians, 0 = flat, positive = convex (a mountain seen from outside),
  /// negative = reflex (a valley); 0 at a border. Within (-pi, pi].
  [[nodiscard]] double bend(EdgeId e) const { return bend_[e]; }

  /// A fold that is as good as flat, where its faces could not be merged: nobody need see it.
  [[nodiscard]] bool is_hidden(EdgeId e) const { return is_hidden_[e] != 0; }

  /// Average number of neighbours of a face: `val` in the paper's section 4.4.
  [[nodiscard]] double mean_valence() const { return mean_valence_; }

  /// Convex parts of a face as runs of corner indices (0 … degree-1) into the face's corners,
  /// counter-clockwise: one part for a convex face, several for a concave one. Together they cover the face.
  [[nodiscard]] int n_parts(FaceId f) const { return part_begin_[f.index() + 1] - part_begin_[f.index()]; }
  [[nodiscard]] std::span<const int> part(FaceId f, int k) const {
    const auto p = static_cast<std::size_t>(part_begin_[f.index()] + k);
    return std::span(part_corners_)
        .subspan(static_cast<std::size_t>(part_corner_begin_[p]),
                 static_cast<std::size_t>(part_corner_begin_[p + 1] - part_corner_begin_[p]));
  }

 private:
  void flatten_faces();
  void split_faces();
  void place_hinges();

  std::shared_ptr<const Mesh> mesh_;
  IdVector<HalfedgeId, glm::dvec2> flat_;
  IdVector<HalfedgeId, Rigid2> unroll_;
  IdVector<EdgeId, double> bend_;
  IdVector<EdgeId, char> is_hidden_;
  double mean_valence_ = 0;
  std::vector<int> part_begin_{0};
  std::vector<int> part_corner_begin_{0};
  std::vector<int> part_corners_;
};

}  // namespace netwright
