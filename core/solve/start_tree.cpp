// Grows start trees. Both return fold flags per halfedge, which is all the search needs.
#include "core/solve/start_tree.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <queue>

#include "core/solve/boxes16.h"
#include "core/solve/disjoint_sets.h"
#include "core/unfold/overlap.h"
#include "core/unfold/steepest_edge.h"

namespace netwright {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

class GreedyTree {
 public:
  GreedyTree(const SearchModel& model, Random& random, double depth, const Progress* progress)
      : m_(model),
        random_(random),
        depth_(depth),
        progress_(progress),
        inverse_size_(1 / std::sqrt(model.total_area)) {
    folds_.assign(at(m_.n_halfedges), 0);
    is_placed_.assign(at(m_.n_faces), 0);
    placement_.resize(at(m_.n_faces));
    world_.resize(m_.verts.size());
    lanes_.resize(m_.n_faces);
    block_lanes_.resize((m_.n_faces + 15) / 16);
    blocks_.resize(block_lanes_.min_x.size());
  }

  std::vector<char> grow() {
    place(random_.below(m_.n_faces), Rigid2(), -1);
    while (n_placed_ < m_.n_faces)
      if (!add_one(inner_) && !force_one(inner_) && !add_one(outer_)) force_one(outer_);
    return std::move(folds_);
  }

 private:
  struct Candidate {
    double key;
    int halfedge;
    // Ties go to the smaller halfedge, so the order is the same everywhere.
    bool operator<(const Candidate& other) const {
      return key != other.key ? key < other.key : halfedge > other.halfedge;
    }
  };

  /// Faces that could come next: the best first, and those that would overlap something.
  struct Front {
    std::priority_queue<Candidate> heap;
    std::vector<int> aside;
  };

  [[nodiscard]] bool is_cancelled() const { return progress_ != nullptr && progress_->is_cancelled(); }
  [[nodiscard]] Rigid2 motion(int h) const { return placement_[at(m_.face_of[at(h)])] * m_.unroll[at(h)]; }

  void place(int f, const Rigid2& placement, int through) {
    placement_[at(f)] = placement;
    is_placed_[at(f)] = 1;
    if (through >= 0) folds_[at(through)] = folds_[at(m_.twin[at(through)])] = 1;
    note_box(move_vertices(f, placement, world_.data() + m_.first_vert(f)));
    placed_.push_back(f);
    for (int h = m_.face_begin[at(f)]; h < m_.face_begin[at(f) + 1]; ++h) {
      if (m_.twin[at(h)] < 0 || is_placed_[at(m_.beyond(h))]) continue;
      const Rigid2 there = placement * m_.unroll[at(h)];
      const double distance = std::sqrt(there.x * there.x + there.y * there.y);
      Front& front = m_.is_pinned && m_.patch[at(h)] >= 0 ? inner_ : outer_;
      front.heap.push({distance * inverse_size_ + 0.5 * m_.edge_length[at(h)] + 0.3 * random_.unit(), h});
      if (m_.is_pinned && m_.is_kept[at(h)] != 0) kept_.push_back(h);
    }
  }

  // Places the best candidate that overlaps nothing; false when there is none.
  bool add_one(Front& front) {
    if (place_kept()) return true;
    while (!front.heap.empty()) {
      const int h = front.heap.top().halfedge;
      front.heap.pop();
      if (is_placed_[at(m_.beyond(h))]) continue;
      if (is_cancelled() || count_overlaps(h, 1) == 0) {
        place(m_.beyond(h), motion(h), h);
        return true;
      }
      front.aside.push_back(h);
    }
    return false;
  }

  // A must-fold waits for nothing: were its face placed from elsewhere, the fold would close a ring.
  bool place_kept() {
    if (kept_.empty()) return false;
    const int h = kept_.back();
    kept_.pop_back();
    place(m_.beyond(h), motion(h), h);
    return true;
  }

  // Faces placed one after the other mostly grow along one arm, so sixteen of them share a small box.
  void note_box(const BoxF& box) {
    const int block = n_placed_ / 16;
    BoxF all = block_lanes_.get(block);
    all.add(box);
    block_lanes_.set(block, all);
    lanes_.set(n_placed_++, box);
  }

  BoxF move_vertices(int f, const Rigid2& placement, glm::dvec2* out) const {
    Box2 box;
    for (int v = m_.first_vert(f); v < m_.last_vert(f); ++v) {
      *out = placement(m_.verts[at(v)]);
      box.add(*out++);
    }
    return BoxF::around(box.min.x, box.min.y, box.max.x, box.max.y);
  }

  // Overlaps the face beyond h would have with all placed ones; stops at `limit`.
  int count_overlaps(int h, int limit) {
    const int f = m_.beyond(h);
    moved_.resize(at(m_.last_vert(f) - m_.first_vert(f)));
    const BoxF box = move_vertices(f, motion(h), moved_.data());
    int count = 0;
    const int n_blocks = kernel_.find(block_lanes_, box, blocks_.data());
    for (int i = 0; i < n_blocks && count < limit; ++i) {
      unsigned hits = kernel_.hits(lanes_, blocks_[at(i)], box);
      while (hits != 0 && count < limit) {
        const int other = placed_[at(16 * blocks_[at(i)] + std::countr_zero(hits))];
        hits &= hits - 1;
        count += overlaps_placed(f, other) ? 1 : 0;
      }
    }
    return count;
  }

  [[nodiscard]] bool overlaps_placed(int f, int other) const {
    const std::span<const glm::dvec2> world(world_);
    const std::span<const glm::dvec2> moved(moved_);
    const auto run = [&](std::span<const glm::dvec2> from, int part, int base) {
      return from.subspan(at(m_.vert_begin[at(part)] - base),
                          at(m_.vert_begin[at(part) + 1] - m_.vert_begin[at(part)]));
    };
    for (int i = m_.part_begin[at(f)]; i < m_.part_begin[at(f) + 1]; ++i)
      for (int j = m_.part_begin[at(other)]; j < m_.part_begin[at(other) + 1]; ++j)
        if (convex_overlap(run(moved, i, m_.first_vert(f)), run(world, j, 0), depth_)) return true;
    return false;
  }

  // Places the least overlapping of some candidates; false when there are none.
  bool force_one(Front& front) {
    std::vector<int>& aside = front.aside;
    std::erase_if(aside, [this](int h) { return is_placed_[at(m_.beyond(h))] != 0; });
    if (aside.empty()) return false;
    int best = -1;
    int least = std::numeric_limits<int>::max();
    const int n = static_cast<int>(aside.size());
    const int n_samples = is_cancelled() ? 1 : std::min(n, kSamples);
    for (int k = 0; k < n_samples && least > 1; ++k) {
      std::swap(aside[at(k)], aside[at(k + random_.below(n - k))]);
      const int count = count_overlaps(aside[at(k)], least);
      if (count < least) {
        least = count;
        best = aside[at(k)];
      }
    }
    place(m_.beyond(best), motion(best), best);
    return true;
  }

  static constexpr int kSamples = 48;
  const BoxKernel& kernel_ = best_box_kernel();
  const SearchModel& m_;
  Random& random_;
  double depth_;
  const Progress* progress_;
  double inverse_size_;
  int n_placed_ = 0;
  std::vector<char> folds_;
  std::vector<char> is_placed_;
  std::vector<Rigid2> placement_;
  std::vector<glm::dvec2> world_;
  std::vector<glm::dvec2> moved_;
  std::vector<int> placed_;
  BoxLanes lanes_;        // boxes in the order of placing
  BoxLanes block_lanes_;  // boxes of 16 of them
  std::vector<int> blocks_;
  Front inner_;            // inside a patch under way
  Front outer_;            // everywhere else
  std::vector<int> kept_;  // must-folds whose far face is not placed yet
};

}  // namespace

std::vector<char> greedy_folds(const SearchModel& model, Random& random, double depth,
                               const Progress* progress) {
  return GreedyTree(model, random, depth, progress).grow();
}

std::vector<char> pinned_folds(const SearchModel& model, const std::vector<char>& wished) {
  DisjointSets sets(at(model.n_faces));
  std::vector<char> folds(at(model.n_halfedges), 0);
  const auto add_where = [&](auto&& is_wanted) {
    for (int h = 0; h < model.n_halfedges; ++h)
      if (model.twin[at(h)] > h && is_wanted(h) && sets.join(model.face_of[at(h)], model.beyond(h)))
        folds[at(h)] = folds[at(model.twin[at(h)])] = 1;
  };
  const auto is_wished = [&](int h) { return wished[at(h)] != 0; };
  if (model.is_pinned) {
    const auto is_inner = [&](int h) { return model.patch[at(h)] >= 0; };
    add_where([&](int h) { return model.is_kept[at(h)] != 0; });
    add_where([&](int h) { return is_inner(h) && is_wished(h); });
    add_where(is_inner);
  }
  add_where(is_wished);
  add_where([](int) { return true; });
  return folds;
}

std::vector<char> steepest_edge_folds(const DualGraph& dual, const SearchModel& model, Random& random) {
  const UnfoldTree tree = steepest_edge_tree(dual, random);
  std::vector<char> folds(at(model.n_halfedges), 0);
  for (int h = 0; h < model.n_halfedges; ++h)
    folds[at(h)] = tree.is_fold(dual.mesh(), dual.mesh().edge(model.mesh_halfedge[at(h)])) ? 1 : 0;
  return folds;
}

}  // namespace netwright
