// From the leaves of the tree to its root, each branch remembers the ways to cut it with the fewest cuts. To
// cut as high as possible is never worse: what is cut off fits by itself, and less of it hangs on.
#include "core/sheet/split_to_fit.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>

#include "core/base/best_angle.h"
#include "core/base/error.h"
#include "core/sheet/arranger.h"
#include "core/sheet/page_frame.h"

namespace netwright {

namespace {

constexpr std::size_t kMostWays = 48;  ///< that are remembered of one branch for each number of cuts
constexpr double kTolerance = 1e-9;

/// One way to cut a branch: what is left of it at its top, and the folds that are cut.
struct Way {
  Hull hull;
  std::vector<FaceId> cut_above;  ///< faces whose fold to their parent is cut
  double length_mm = 0;
};

double fill_of(const Hull& hull, glm::dvec2 room) {
  const auto cost = [&](glm::dvec2 size) { return fill_factor(size, room); };
  return cost(turned_box(hull, best_angle(hull, cost)).size());
}

bool fits(const Hull& hull, glm::dvec2 room) {
  Box2 box;
  for (const glm::dvec2 p : hull) box.add(p);
  if (fill_factor(box.size(), room) <= 1) return true;
  if (std::max(box.size().x, box.size().y) > glm::length(room) * (1 + kTolerance)) return false;
  return fill_of(hull, room) <= 1 + kTolerance;
}

Hull joined(const Hull& a, const Hull& b) {
  Hull points = a;
  points.insert(points.end(), b.begin(), b.end());
  return convex_hull(std::move(points));
}

/// Faces that must stay together, as one node of the tree.
struct Group {
  FaceId top;  ///< hangs on the parent group
  Hull hull;
  std::vector<int> children;
};

class Splitter {
 public:
  Splitter(const Net& net, double scale, glm::dvec2 room, const MayCut& may_cut)
      : net_(net), scale_(scale), room_(room), may_cut_(may_cut), group_(net.mesh().n_faces(), -1) {
    for (const FaceId f : net.tree.preorder(net.mesh())) add_face(f);
    for (Group& group : groups_) group.hull = convex_hull(std::move(group.hull));
  }

  /// Faces whose fold to their parent is cut; nothing when a group is larger than the room.
  [[nodiscard]] std::optional<std::vector<FaceId>> run() {
    for (const Group& group : groups_)
      if (!fits(group.hull, room_)) return std::nullopt;
    std::vector<std::vector<Way>> ways(groups_.size());
    std::vector<FaceId> cuts;
    // Preorder: what hangs on a group comes after it.
    for (std::size_t g = groups_.size(); g-- > 0;) {
      ways[g] = ways_of(groups_[g], ways);
      for (const int child : groups_[g].children) ways[static_cast<std::size_t>(child)].clear();
      if (!net_.tree.is_root(groups_[g].top)) continue;
      const Way& best = shortest(ways[g]);
      cuts.insert(cuts.end(), best.cut_above.begin(), best.cut_above.end());
    }
    shorten(cuts);
    return cuts;
  }

  [[nodiscard]] double length_of(const std::vector<FaceId>& cuts) const {
    return std::accumulate(cuts.begin(), cuts.end(), 0.0,
                           [this](double sum, FaceId f) { return sum + length_above(f); });
  }

 private:
  void add_face(FaceId f) {
    const bool is_root = net_.tree.is_root(f);
    const FaceId parent = net_.tree.parent(net_.mesh(), f);
    if (!is_root && !may_cut_above(f)) {
      group_[f] = group_[parent];
    } else {
      group_[f] = static_cast<int>(groups_.size());
      groups_.push_back({f, {}, {}});
      if (!is_root) groups_[static_cast<std::size_t>(group_[parent])].children.push_back(group_[f]);
    }
    Group& group = groups_[static_cast<std::size_t>(group_[f])];
    for (const HalfedgeId h : net_.mesh().halfedges(f)) group.hull.push_back(net_.corner(h) * scale_);
  }

  [[nodiscard]] bool may_cut_above(FaceId f) const {
    return may_cut_(net_.mesh().edge(net_.tree.to_parent(f)));
  }

  [[nodiscard]] double length_above(FaceId f) const {
    return net_.mesh().length(net_.mesh().edge(net_.tree.to_parent(f))) * scale_;
  }

  static const Way& shortest(const std::vector<Way>& ways) {
    return *std::min_element(ways.begin(), ways.end(),
                             [](const Way& a, const Way& b) { return a.length_mm < b.length_mm; });
  }

  /// Child after child hangs on or is cut off; by the number of those cut off, the ways that fit.
  [[nodiscard]] std::vector<Way> ways_of(const Group& group,
                                         const std::vector<std::vector<Way>>& ways) const {
    std::vector<std::vector<Way>> by_cuts{{{group.hull, {}, 0}}};
    for (const int child : group.children) {
      const std::vector<Way>& below = ways[static_cast<std::size_t>(child)];
      std::vector<std::vector<Way>> next(by_cuts.size() + 1);
      for (std::size_t k = 0; k < by_cuts.size(); ++k)
        for (const Way& way : by_cuts[k]) {
          next[k + 1].push_back(with(way, shortest(below), groups_[static_cast<std::size_t>(child)].top));
          for (const Way& hanging : below) {
            Way kept = with(way, hanging, FaceId());
            if (fits(kept.hull, room_)) next[k].push_back(std::move(kept));
          }
        }
      for (std::vector<Way>& some : next) keep_the_smallest(some);
      by_cuts = std::move(next);
    }
    // One cut more is never worth it: the cut above this group would do as well.
    for (std::vector<Way>& some : by_cuts)
      if (!some.empty()) return std::move(some);
    return {};
  }

  /// The way together with one of a child that hangs on it, or is cut off above `top`.
  [[nodiscard]] Way with(const Way& way, const Way& child, FaceId top) const {
    Way both = way;
    both.cut_above.insert(both.cut_above.end(), child.cut_above.begin(), child.cut_above.end());
    both.length_mm += child.length_mm;
    if (top.is_valid()) {
      both.cut_above.push_back(top);
      both.length_mm += length_above(top);
    } else {
      both.hull = joined(way.hull, child.hull);
    }
    return both;
  }

  void keep_the_smallest(std::vector<Way>& ways) const {
    if (ways.size() <= kMostWays) return;
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < ways.size(); ++i) order.emplace_back(fill_of(ways[i].hull, room_), i);
    std::sort(order.begin(), order.end());
    std::vector<Way> kept;
    for (std::size_t i = 0; i < kMostWays; ++i) kept.push_back(std::move(ways[order[i].second]));
    ways = std::move(kept);
  }

  /// The faces of the piece that each face belongs to, told by the piece's top face.
  [[nodiscard]] IdVector<FaceId, FaceId> tops(const std::vector<FaceId>& cuts) const {
    IdVector<FaceId, FaceId> top(net_.mesh().n_faces());
    for (const FaceId f : net_.tree.preorder(net_.mesh())) {
      const bool is_top = net_.tree.is_root(f) || std::find(cuts.begin(), cuts.end(), f) != cuts.end();
      top[f] = is_top ? f : top[net_.tree.parent(net_.mesh(), f)];
    }
    return top;
  }

  [[nodiscard]] bool pieces_fit(const IdVector<FaceId, FaceId>& top, FaceId first, FaceId second) const {
    Hull one;
    Hull other;
    for (const FaceId f : net_.mesh().faces()) {
      if (top[f] != first && top[f] != second) continue;
      for (const HalfedgeId h : net_.mesh().halfedges(f))
        (top[f] == first ? one : other).push_back(net_.corner(h) * scale_);
    }
    return fits(convex_hull(std::move(one)), room_) && fits(convex_hull(std::move(other)), room_);
  }

  /// Moves each cut to the shortest fold of its two pieces that leaves both fitting.
  void shorten(std::vector<FaceId>& cuts) const {
    for (std::size_t i = 0; i < cuts.size(); ++i) {
      const IdVector<FaceId, FaceId> top = tops(cuts);
      const FaceId below = cuts[i];
      const FaceId above = top[net_.tree.parent(net_.mesh(), below)];
      std::vector<std::pair<double, FaceId>> shorter;
      for (const FaceId f : net_.mesh().faces()) {
        const bool is_fold = (top[f] == below || top[f] == above) && f != top[f] && may_cut_above(f);
        if (is_fold && length_above(f) < length_above(below)) shorter.emplace_back(length_above(f), f);
      }
      std::sort(shorter.begin(), shorter.end());
      for (const auto& [length, f] : shorter) {
        std::vector<FaceId> moved = cuts;
        moved[i] = f;
        if (!pieces_fit(tops(moved), f, above)) continue;
        cuts = std::move(moved);
        break;
      }
    }
  }

  const Net& net_;
  double scale_;
  glm::dvec2 room_;
  const MayCut& may_cut_;
  std::vector<Group> groups_;
  IdVector<FaceId, int> group_;
};

HandEdit edit_of(const Net& net, const std::vector<FaceId>& cuts) {
  HandEdit edit{net.tree, {}, {}, {}};
  for (const FaceId f : cuts) {
    edit.cut.push_back(net.mesh().edge(net.tree.to_parent(f)));
    edit.tree.set_parent(f, HalfedgeId());
  }
  std::sort(edit.cut.begin(), edit.cut.end());
  return edit;
}

bool all_fit(const Net& net, const HandEdit& edit, double scale, const TabSettings& tabs, glm::dvec2 room) {
  const PieceShapes shapes = piece_shapes(layout(net.dual, edit.tree), scale, tabs);
  return std::all_of(shapes.pieces.begin(), shapes.pieces.end(),
                     [&](const PieceShape& piece) { return fits(piece.hull, room); });
}

struct Split {
  HandEdit edit;
  double length_mm = 0;
};

/// Tabs are known only when the cuts are: so room is left for them, as much as it takes.
std::optional<Split> split_on(const Net& net, double scale, const PageFrame& frame, const TabSettings& tabs,
                              const MayCut& may_cut) {
  constexpr int kRounds = 4;
  const glm::dvec2 room = frame.net.size();
  for (int round = 0; round <= (tabs.is_on ? kRounds : 0); ++round) {
    // Most tabs reach out by no more than their width; those that were asked for may be wider.
    double width_mm = tabs.width_mm;
    for (const TabEdit& edit : tabs.edits) width_mm = std::max(width_mm, edit.width_mm.value_or(0));
    const glm::dvec2 left = room - 2 * width_mm * round / kRounds;
    if (!(left.x > 0 && left.y > 0)) break;
    Splitter splitter(net, scale, left, may_cut);
    const std::optional<std::vector<FaceId>> cuts = splitter.run();
    if (!cuts) break;
    Split split{edit_of(net, *cuts), splitter.length_of(*cuts)};
    if (!tabs.is_on || all_fit(net, split.edit, scale, tabs, room)) return split;
  }
  return std::nullopt;
}

}  // namespace

HandEdit split_to_fit(const Net& net, const PaperSetup& paper, const PrintSize& size, const TabSettings& tabs,
                      const MayCut& may_cut) {
  const std::vector<PageFrame> frames = possible_frames(paper);
  const std::optional<double> scale = scale_of(net.mesh(), size);
  if (!scale) return edit_of(net, {});
  std::optional<Split> best;
  for (const PageFrame& frame : frames) {
    std::optional<Split> split = split_on(net, *scale, frame, tabs, may_cut);
    if (split && (!best || std::pair(split->edit.cut.size(), split->length_mm) <
                               std::pair(best->edit.cut.size(), best->length_mm)))
      best = std::move(split);
  }
  if (!best)
    throw Error(ErrorKind::Usage,
                "With " + size_words(size) +
                    " some faces, or faces that must stay together, are larger than a page of " +
                    paper.format + "; print it smaller or on larger paper.");
  return best->edit;
}

}  // namespace netwright
