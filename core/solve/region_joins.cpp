// Tries all forests of a region without overlap, hinge by hinge, and keeps the coarsest ways they join its
// doors.
#include <algorithm>

#include "core/base/predicates.h"
#include "core/base/random.h"
#include "core/solve/prove_regions.h"
#include "core/unfold/overlap.h"

namespace netwright {
namespace {

using Joins = std::vector<int>;

constexpr int kChances = 60;

/// Faces of the region that folds hold together, by the number of one of them, and where each lies.
struct Forest {
  std::vector<int> tree;
  std::vector<Rigid2> placement;
};

struct InnerHinge {
  HalfedgeId halfedge;
  int a = 0;
  int b = 0;
};

/// Is everything that `fine` joins joined by `coarse`?
bool is_finer(const Joins& fine, const Joins& coarse) {
  for (std::size_t i = 0; i < fine.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (fine[i] == fine[j] && coarse[i] != coarse[j]) return false;
  return true;
}

class Trial {
 public:
  Trial(const DualGraph& dual, std::vector<FaceId> faces, std::int64_t& steps)
      : dual_(dual), mesh_(dual.mesh()), steps_(steps) {
    region_.faces = std::move(faces);
    depth_ = 2 * kImpossibleDepth * mesh_.mean_edge();
    for (std::size_t i = 0; i < region_.faces.size(); ++i) {
      bool is_door = false;
      for (const HalfedgeId h : mesh_.halfedges(region_.faces[i])) {
        if (!mesh_.neighbour(h).is_valid()) continue;
        const int g = local(mesh_.neighbour(h));
        is_door |= g < 0;
        if (g > static_cast<int>(i)) hinges_.push_back({h, static_cast<int>(i), g});
      }
      if (is_door) doors_.push_back(static_cast<int>(i));
    }
  }

  std::optional<ImpossibilityProof::Region> run() {
    if (doors_.empty()) return std::nullopt;
    Forest none;
    for (std::size_t i = 0; i < region_.faces.size(); ++i) none.tree.push_back(static_cast<int>(i));
    none.placement.resize(region_.faces.size());
    if (is_whole_by_chance(none)) {
      region_.joins.emplace_back(doors_.size(), 0);
      return std::move(region_);
    }
    if (!go_on(0, none) && !is_whole_) return std::nullopt;
    return std::move(region_);
  }

 private:
  [[nodiscard]] int local(FaceId f) const {
    const auto at = std::lower_bound(region_.faces.begin(), region_.faces.end(), f);
    return at != region_.faces.end() && *at == f ? static_cast<int>(at - region_.faces.begin()) : -1;
  }

  /// Joins at random: where that joins everything, as it soon does in most regions, all is known.
  bool is_whole_by_chance(const Forest& none) {
    Random random(1);
    std::vector<InnerHinge> order = hinges_;
    for (int k = 0; k < kChances; ++k) {
      for (std::size_t i = order.size(); i > 1; --i)
        std::swap(order[i - 1], order[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
      Forest forest = none;
      std::size_t n_trees = region_.faces.size();
      for (const InnerHinge& hinge : order) {
        if (of(forest.tree, hinge.a) == of(forest.tree, hinge.b)) continue;
        Forest folded = forest;
        --steps_;
        if (!join(folded, hinge)) continue;
        forest = std::move(folded);
        --n_trees;
      }
      if (n_trees == 1) return true;
    }
    return false;
  }

  /// False when there are too many to try, or nothing is left to learn.
  bool go_on(std::size_t next, const Forest& forest) {
    if (--steps_ < 0) return false;
    if (!all_may_leave(next, forest)) return true;
    if (next == hinges_.size()) {
      note(forest);
      return !is_whole_;
    }
    const InnerHinge& hinge = hinges_[next];
    if (of(forest.tree, hinge.a) != of(forest.tree, hinge.b)) {
      Forest folded = forest;
      if (join(folded, hinge) && !go_on(next + 1, folded)) return false;
    }
    return go_on(next + 1, forest);
  }

  bool join(Forest& forest, const InnerHinge& hinge) const {
    const int kept = of(forest.tree, hinge.a);
    const int moved = of(forest.tree, hinge.b);
    const Rigid2 motion = of(forest.placement, hinge.a) * dual_.unroll(hinge.halfedge) *
                          of(forest.placement, hinge.b).inverse();
    for (std::size_t j = 0; j < forest.tree.size(); ++j) {
      if (forest.tree[j] != moved) continue;
      forest.placement[j] = motion * forest.placement[j];
      for (std::size_t i = 0; i < forest.tree.size(); ++i)
        if (forest.tree[i] == kept && faces_overlap(dual_, region_.faces[i], forest.placement[i],
                                                    region_.faces[j], forest.placement[j], depth_))
          return false;
    }
    std::replace(forest.tree.begin(), forest.tree.end(), moved, kept);
    return true;
  }

  /// Does every tree have a door, or a hinge through which it may get to one?
  [[nodiscard]] bool all_may_leave(std::size_t next, const Forest& forest) const {
    std::vector<char> may_leave(forest.tree.size(), 0);
    const auto let = [&](int face) { may_leave[static_cast<std::size_t>(of(forest.tree, face))] = 1; };
    for (const int door : doors_) let(door);
    for (std::size_t h = next; h < hinges_.size(); ++h) {
      let(hinges_[h].a);
      let(hinges_[h].b);
    }
    return std::all_of(forest.tree.begin(), forest.tree.end(),
                       [&](int tree) { return may_leave[static_cast<std::size_t>(tree)] != 0; });
  }

  void note(const Forest& forest) {
    Joins joins;
    for (const int door : doors_) {
      const int tree = of(forest.tree, door);
      joins.push_back(static_cast<int>(
          std::find_if(doors_.begin(), doors_.end(), [&](int d) { return of(forest.tree, d) == tree; }) -
          doors_.begin()));
    }
    std::vector<Joins>& all = region_.joins;
    if (std::any_of(all.begin(), all.end(), [&](const Joins& other) { return is_finer(joins, other); }))
      return;
    std::erase_if(all, [&](const Joins& other) { return is_finer(other, joins); });
    all.push_back(joins);
    is_whole_ = std::all_of(joins.begin(), joins.end(), [&](int group) { return group == joins.front(); });
  }

  template <class T>
  static const T& of(const std::vector<T>& items, int i) {
    return items[static_cast<std::size_t>(i)];
  }

  const DualGraph& dual_;
  const Mesh& mesh_;
  std::int64_t& steps_;
  double depth_ = 0;
  ImpossibilityProof::Region region_;
  std::vector<int> doors_;
  std::vector<InnerHinge> hinges_;
  bool is_whole_ = false;  ///< all doors can be joined: nothing is coarser
};

}  // namespace

std::optional<ImpossibilityProof::Region> region_joins(const DualGraph& dual, std::vector<FaceId> faces,
                                                       std::int64_t& steps) {
  return Trial(dual, std::move(faces), steps).run();
}

}  // namespace netwright
