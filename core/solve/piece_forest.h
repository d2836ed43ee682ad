// A forest of folds that never overlaps, laid out, to which folds can be added and from which they can be
// taken: what the search for fewest pieces works on.
#pragma once

#include <vector>

#include "core/mesh/dual_graph.h"

namespace netwright {

class PieceForest {
 public:
  /// Every face by itself. `depth` as convex_overlap has it, a length.
  PieceForest(const DualGraph& dual, double depth);

  /// Makes the edge a fold where that joins two pieces without overlap; false where not.
  bool join(EdgeId edge);
  /// Makes folds of `cuts` and cuts of `folds`. No loop and no overlap may come of it: it is for cutting, and
  /// for going back.
  void exchange(const std::vector<EdgeId>& folds, const std::vector<EdgeId>& cuts);

  [[nodiscard]] bool is_fold(EdgeId e) const { return is_fold_[e] != 0; }
  [[nodiscard]] const IdVector<EdgeId, char>& folds() const { return is_fold_; }
  [[nodiscard]] int n_pieces() const { return n_pieces_; }
  /// The number of the piece; it may change when the piece does.
  [[nodiscard]] int piece(FaceId f) const { return piece_[f]; }
  [[nodiscard]] const std::vector<FaceId>& faces_of(int piece) const {
    return faces_of_[static_cast<std::size_t>(piece)];
  }

 private:
  void lay_out(FaceId from);
  [[nodiscard]] bool fits(int kept, int moved, const Rigid2& motion) const;

  const DualGraph* dual_;
  double depth_;
  IdVector<FaceId, double> radius_;  ///< around the origin of the face's frame
  IdVector<EdgeId, char> is_fold_;
  IdVector<FaceId, int> piece_;
  IdVector<FaceId, Rigid2> placement_;         ///< in the plane of its piece
  std::vector<std::vector<FaceId>> faces_of_;  ///< per piece
  int n_pieces_ = 0;
};

}  // namespace netwright
