// Decides the hinges of a region one after the other, fold and cut, and drops what overlaps, closes a loop or
// leaves faces without a door. In a net of one piece every tree of the region is joined to a face outside, so
// each has a door.
#include "core/unfold/impossibility_region.h"

#include <algorithm>

namespace netwright::proof {
namespace {

constexpr std::size_t kMostFaces = 64;

/// The folds chosen so far: what belongs together, and where it lies.
struct Forest {
  std::vector<int> tree;      ///< per face of the region: the number of one face of its tree
  std::vector<Laid> laid;     ///< per face of the region, within its tree
  std::vector<char> is_fold;  ///< per hinge of the region
};

class RegionTrial {
 public:
  RegionTrial(const RolledFaces& rolled, const ImpossibilityProof::Region& region, std::int64_t& steps)
      : rolled_(rolled), mesh_(rolled.mesh()), region_(region), steps_(steps) {}

  std::string fault() {
    if (std::string wrong = shape_fault(); !wrong.empty()) return wrong;
    collect_hinges();
    Forest none;
    for (std::size_t i = 0; i < region_.faces.size(); ++i) none.tree.push_back(static_cast<int>(i));
    none.laid.resize(region_.faces.size());
    none.is_fold.assign(hinges_.size(), 0);
    if (try_from(0, none)) return "";
    return steps_ < 0 ? "The proof takes too long to check."
                      : "A region can be joined in a way that is not listed.";
  }

 private:
  [[nodiscard]] std::string shape_fault() {
    const std::vector<FaceId>& faces = region_.faces;
    if (faces.empty() || faces.size() > kMostFaces) return "A region has no faces or too many.";
    for (std::size_t i = 0; i < faces.size(); ++i) {
      if (!faces[i].is_valid() || faces[i].index() >= mesh_.n_faces() || (i > 0 && faces[i] <= faces[i - 1]))
        return "A region does not list its faces in order.";
      if (mesh_.component(faces[i]) != mesh_.component(faces[0])) return "A region spans parts of the model.";
    }
    doors_ = region_doors(mesh_, faces);
    if (doors_.empty()) return "A region has no way out.";
    for (const std::vector<int>& joins : region_.joins)
      if (joins.size() != doors_.size()) return "A region does not say how its doors are joined.";
    return "";
  }

  [[nodiscard]] int local(FaceId f) const {
    const auto at = std::lower_bound(region_.faces.begin(), region_.faces.end(), f);
    return at != region_.faces.end() && *at == f ? static_cast<int>(at - region_.faces.begin()) : -1;
  }

  void collect_hinges() {
    for (const FaceId f : region_.faces)
      for (const HalfedgeId h : mesh_.halfedges(f)) {
        const FaceId g = mesh_.neighbour(h);
        if (g.is_valid() && mesh_.halfedge(mesh_.edge(h)) == h && local(g) >= 0) hinges_.push_back(h);
      }
    for (const FaceId door : doors_) door_index_.push_back(local(door));
  }

  /// True when all forests that begin with these folds are listed.
  bool try_from(std::size_t hinge, const Forest& forest) {
    if (--steps_ < 0) return false;
    if (hinge == hinges_.size()) return is_listed(forest);
    const int a = local(mesh_.face(hinges_[hinge]));
    const int b = local(mesh_.neighbour(hinges_[hinge]));
    if (at(forest.tree, a) != at(forest.tree, b)) {
      Forest folded = forest;
      folded.is_fold[hinge] = 1;
      if (lay_other(folded, a, hinges_[hinge]) && !try_from(hinge + 1, folded)) return false;
    }
    return leaves_shut_in(hinge + 1, forest) || try_from(hinge + 1, forest);
  }

  /// Joins the tree beyond h to the one of face a; false when they overlap.
  bool lay_other(Forest& forest, int a, HalfedgeId h) const {
    const int kept = at(forest.tree, a);
    std::vector<int> before;
    for (std::size_t i = 0; i < forest.tree.size(); ++i)
      if (forest.tree[i] == kept) before.push_back(static_cast<int>(i));
    std::vector<int> reached;
    lay(forest, rolled_.across(at(forest.laid, a), h), local(mesh_.neighbour(h)), reached);
    for (std::size_t i = 0; i < reached.size(); ++i) {  // grows as faces are reached
      const FaceId f = face(reached[i]);
      for (const HalfedgeId k : mesh_.halfedges(f)) {
        const int next = mesh_.neighbour(k).is_valid() ? local(mesh_.neighbour(k)) : -1;
        if (next < 0 || !is_fold(forest, k) || at(forest.tree, next) == kLaid ||
            at(forest.tree, next) == kept)
          continue;
        lay(forest, rolled_.across(at(forest.laid, reached[i]), k), next, reached);
      }
    }
    for (const int i : reached) forest.tree[static_cast<std::size_t>(i)] = kept;
    return std::none_of(before.begin(), before.end(), [&](int i) {
      return std::any_of(reached.begin(), reached.end(), [&](int j) {
        return rolled_.overlap(face(i), at(forest.laid, i), face(j), at(forest.laid, j));
      });
    });
  }

  static void lay(Forest& forest, const Laid& where, int i, std::vector<int>& reached) {
    forest.laid[static_cast<std::size_t>(i)] = where;
    forest.tree[static_cast<std::size_t>(i)] = kLaid;
    reached.push_back(i);
  }

  [[nodiscard]] bool is_fold(const Forest& forest, HalfedgeId h) const {
    const auto found = std::find(hinges_.begin(), hinges_.end(), mesh_.halfedge(mesh_.edge(h)));
    return forest.is_fold[static_cast<std::size_t>(found - hinges_.begin())] != 0;
  }

  /// Is some tree without a door and without a hinge that may still become a fold?
  [[nodiscard]] bool leaves_shut_in(std::size_t hinge, const Forest& forest) const {
    std::vector<char> has_way_out(forest.tree.size(), 0);
    const auto note = [&](int i) { has_way_out[static_cast<std::size_t>(at(forest.tree, i))] = 1; };
    for (const int door : door_index_) note(door);
    for (std::size_t k = hinge; k < hinges_.size(); ++k) {
      note(local(mesh_.face(hinges_[k])));
      note(local(mesh_.neighbour(hinges_[k])));
    }
    return std::any_of(forest.tree.begin(), forest.tree.end(),
                       [&](int tree) { return has_way_out[static_cast<std::size_t>(tree)] == 0; });
  }

  /// Where the last hinge was a fold, trees without a door are still to be told.
  [[nodiscard]] bool is_listed(const Forest& forest) const {
    if (leaves_shut_in(hinges_.size(), forest)) return true;
    const std::size_t n = doors_.size();
    return std::any_of(region_.joins.begin(), region_.joins.end(), [&](const std::vector<int>& joins) {
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < i; ++j)
          if (at(forest.tree, door_index_[i]) == at(forest.tree, door_index_[j]) && joins[i] != joins[j])
            return false;
      return true;
    });
  }

  template <class T>
  static const T& at(const std::vector<T>& items, int i) {
    return items[static_cast<std::size_t>(i)];
  }
  [[nodiscard]] FaceId face(int i) const { return at(region_.faces, i); }

  static constexpr int kLaid = -1;  ///< instead of a tree's number while that tree is being laid

  const RolledFaces& rolled_;
  const Mesh& mesh_;
  const ImpossibilityProof::Region& region_;
  std::int64_t& steps_;
  std::vector<FaceId> doors_;
  std::vector<int> door_index_;
  std::vector<HalfedgeId> hinges_;  ///< one halfedge each
};

}  // namespace

std::vector<FaceId> region_doors(const Mesh& mesh, const std::vector<FaceId>& faces) {
  std::vector<FaceId> doors;
  for (const FaceId f : faces)
    for (const HalfedgeId h : mesh.halfedges(f)) {
      const FaceId g = mesh.neighbour(h);
      if (!g.is_valid() || std::binary_search(faces.begin(), faces.end(), g)) continue;
      doors.push_back(f);
      break;
    }
  return doors;
}

std::string region_fault(const RolledFaces& rolled, const ImpossibilityProof::Region& region,
                         std::int64_t& steps) {
  return RegionTrial(rolled, region, steps).fault();
}

}  // namespace netwright::proof
