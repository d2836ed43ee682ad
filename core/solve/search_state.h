// The search's net: which hinges are folds, where every face lies, and which faces overlap, kept in step move
// by move. The tree has no root that matters: a net is the set of its folds (paper, section 4.5: one unfold
// pattern has many isomorphic trees), and a rooted preorder view is made for the root each step asks for.
#pragma once

#include <vector>

#include "core/solve/boxes16.h"
#include "core/solve/search_model.h"

namespace netwright {

/// An exchange of hinges (the paper's "move", section 4.3): the faces of one side of a fold move rigidly, the
/// fold becomes a cut and a cut between the same two sides becomes a fold.
struct Exchange {
  int first = 0;  ///< the moved side in preorder positions: first … last-1
  int last = 0;
  Rigid2 motion;      ///< what moves it (moving the rest by the inverse is the same net)
  int removed = -1;   ///< halfedge of the re-attached face towards its old neighbour
  int inserted = -1;  ///< halfedge of the re-attached face towards its new neighbour
};

class SearchState {
 public:
  /// `depth`: overlaps count from this depth on, in mean edges.
  SearchState(const SearchModel& model, double depth);

  [[nodiscard]] const SearchModel& model() const { return *model_; }

  /// Replaces the tree: one flag per halfedge, set on both sides of every fold. Places everything and finds
  /// all overlaps anew.
  void set_tree(std::vector<char> is_fold);
  [[nodiscard]] const std::vector<char>& folds() const { return is_fold_; }
  [[nodiscard]] bool is_fold(int h) const { return is_fold_[at(h)] != 0; }

  /// Number of overlapping pairs: f of the paper's section 4 (pairs, as its Algorithm 2 counts).
  [[nodiscard]] int overlaps() const { return static_cast<int>(pairs_.size()); }
  [[nodiscard]] const std::vector<std::pair<int, int>>& pairs() const { return pairs_; }
  /// Faces that overlap something, in no particular but a reproducible order.
  [[nodiscard]] const std::vector<int>& overlapping_faces() const { return overlapping_; }
  [[nodiscard]] const Rigid2& placement(int f) const { return placement_[at(f)]; }

  /// Makes the preorder view for this root; positions, parents and boxes below refer to it until the next
  /// exchange.
  void root_at(int face);
  [[nodiscard]] int face_at(int position) const { return order_[at(position)]; }
  [[nodiscard]] int position(int f) const { return position_[at(f)]; }
  /// Subtree of f: positions position(f) … end(f)-1.
  [[nodiscard]] int end(int f) const { return end_[at(f)]; }
  /// Halfedge of f towards its parent, -1 for the root.
  [[nodiscard]] int up(int f) const { return up_[at(f)]; }

  /// Overlaps between the moved side and the rest after the exchange's motion; stops counting at `limit`.
  [[nodiscard]] int count_after(const Exchange& exchange, int limit);

  /// Carries the exchange out: O(faces of the smaller side × what lies near them).
  void apply(const Exchange& exchange);

  /// Places every face again from the tree and finds all overlaps anew: ends the drift of long runs and
  /// proves the incremental count. Keeps face 0 where it is.
  void recompute();

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  void place_face(int f, const Rigid2& placement);
  void place_from_tree();
  void find_all_pairs();
  void set_pairs(std::vector<std::pair<int, int>> pairs);
  void count_face(int f, int change);
  void gather_boxes();
  [[nodiscard]] bool faces_overlap(const glm::dvec2* moved, int moved_face, int face) const;

  template <class Visit>
  void visit_meetings(const Exchange& exchange, Visit&& visit);
  template <class Visit>
  bool visit_query_block(int block, unsigned members, Visit&& visit);
  template <class Visit>
  bool visit_query_face(int face, const std::vector<int>& blocks, Visit&& visit);
  [[nodiscard]] unsigned side_mask(int block) const;

  const SearchModel* model_;
  double depth_;
  std::vector<char> is_fold_;
  std::vector<Rigid2> placement_;
  std::vector<glm::dvec2> world_;  // placed vertices of all parts
  std::vector<BoxF> box_;          // per face
  std::vector<std::pair<int, int>> pairs_;
  std::vector<int> n_overlaps_;  // per face
  std::vector<int> overlapping_;
  std::vector<int> overlapping_index_;  // face -> index in overlapping_, -1

  std::vector<int> order_, position_, end_, up_;
  std::vector<int> stack_;
  BoxLanes lanes_;        // faces' boxes in preorder
  BoxLanes block_lanes_;  // boxes of 16 consecutive ones

  // What visit_meetings works on.
  Rigid2 motion_;
  int side_first_ = 0;
  int side_last_ = 0;
  bool queries_side_ = true;
  std::vector<int> all_blocks_, hit_blocks_;
  std::vector<glm::dvec2> moved_;
};

}  // namespace netwright
