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
  int first = 0;  ///< one side in preorder positions: first … last-1
  int last = 0;
  Rigid2 motion;      ///< what moves that side (moving the rest by the inverse is the same net)
  int removed = -1;   ///< halfedge of the fold that becomes a cut, on the re-attached side
  int inserted = -1;  ///< halfedge of the cut that becomes a fold, on the re-attached side
};

/// A fold on the way from one face to another.
struct PathStep {
  int near = -1;  ///< its face on the side where the path starts
  int far = -1;
  int child = -1;  ///< the one of the two whose subtree is one side of the fold
  bool near_is_child = false;
};

class SearchState {
 public:
  /// `depth`: overlaps count from this depth on, in mean edges. The kernel changes only the speed, and so
  /// does the memory of killers: the faces that last ruled an exchange out are asked first when it is
  /// considered again.
  SearchState(const SearchModel& model, double depth, const BoxKernel& kernel = best_box_kernel(),
              bool uses_killers = true);

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

  /// Where a vertex of the model's parts lies.
  [[nodiscard]] const glm::dvec2& placed(int vert) const { return world_[at(vert)]; }

  [[nodiscard]] int face_at(int position) const { return order_[at(position)]; }
  [[nodiscard]] int position(int f) const { return position_[at(f)]; }
  /// Subtree of f: positions position(f) … end(f)-1.
  [[nodiscard]] int end(int f) const { return position_[at(f)] + size_[at(f)]; }
  [[nodiscard]] bool in_subtree(int f, int top) const {
    return position(f) >= position(top) && position(f) < end(top);
  }
  /// Halfedge of f towards its parent, -1 for face 0, the root of the preorder.
  [[nodiscard]] int up(int f) const { return up_[at(f)]; }
  /// The folds from one face to another, in order.
  void find_path(int from, int to, std::vector<PathStep>& path) const;

  /// The exchange of the fold between a child and its parent (`removed`, on either side of it) for the cut at
  /// `inserted` (on the same side). It is told as a motion of the child's subtree; when the re-attached face
  /// is not in that, the rest moves, which is the same as moving the subtree by the inverse.
  [[nodiscard]] Exchange exchange(int child, int removed, int inserted) const;

  /// Overlaps between the moved side and the rest after the exchange's motion; stops counting at `limit`.
  [[nodiscard]] int count_after(const Exchange& exchange, int limit);

  /// The same, counted to the end in the paper's way (4.7): under log n moved faces one by one, more by a
  /// sweep.
  [[nodiscard]] int count_as_paper(const Exchange& exchange);

  /// Carries the exchange out: O(faces of the smaller side × what lies near them + the stretch of preorder
  /// between the old and the new place of the side).
  void apply(const Exchange& exchange);

  /// Places every face again from the tree and finds all overlaps anew: ends the drift of long runs and
  /// proves the incremental count. Keeps face 0 where it is.
  void recompute();

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  void place_face(int f, const Rigid2& placement);
  void build_preorder();
  void traverse(int top, std::vector<int>& order);
  void relink(const Exchange& exchange);
  [[nodiscard]] int insertion_place(int parent, const Exchange& exchange) const;
  void drop_crossing_pairs(const Exchange& exchange);
  void place_from_tree();
  void find_all_pairs();
  [[nodiscard]] std::vector<std::pair<int, int>> sweep() const;
  int count_naively();
  int count_by_sweep();
  void set_pairs(std::vector<std::pair<int, int>> pairs);
  void count_face(int f, int change);
  void gather_boxes(int first, int last);
  [[nodiscard]] bool faces_overlap(const glm::dvec2* moved, int moved_face, int face) const;

  template <class Visit>
  void visit_meetings(const Exchange& exchange, int killer, Visit&& visit);
  template <class Visit>
  bool visit_killer(int face, Visit&& visit);
  template <class Visit>
  bool visit_query_block(int block, unsigned members, int killer, Visit&& visit);
  template <class Visit>
  bool visit_query_face(int face, Visit&& visit);
  BoxF move_query(int face);
  void find_hit_blocks(const BoxF& box);
  [[nodiscard]] unsigned side_mask(int block) const;

  const SearchModel* model_;
  double depth_;
  const BoxKernel* kernel_;
  bool uses_killers_;
  std::vector<char> is_fold_;
  std::vector<Rigid2> placement_;
  std::vector<glm::dvec2> world_;  // placed vertices of all parts
  std::vector<BoxF> box_;          // per face
  std::vector<std::pair<int, int>> pairs_;
  std::vector<int> n_overlaps_;  // per face
  std::vector<int> overlapping_;
  std::vector<int> overlapping_index_;  // face -> index in overlapping_, -1

  std::vector<int> order_, position_, size_, up_;
  std::vector<int> stack_, moved_order_;
  BoxLanes lanes_;        // faces' boxes in preorder
  BoxLanes block_lanes_;  // boxes of 16 consecutive ones
  BoxLanes group_lanes_;  // boxes of 16 consecutive blocks

  // What visit_meetings works on.
  Rigid2 motion_;
  int side_first_ = 0;
  int side_last_ = 0;
  bool queries_side_ = true;
  std::vector<int> hit_groups_;  // room for all groups
  std::vector<int> hit_blocks_;  // room for all blocks; the first n_hit_blocks_ count
  int n_hit_blocks_ = 0;
  std::vector<int> killers_;  // per halfedge: the face that last ruled its re-attachment out, or -1
  std::vector<glm::dvec2> moved_;
};

}  // namespace netwright
