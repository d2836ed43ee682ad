// Looks for pins that no tree can keep, from the plainest trouble to the one that takes a layout. With the
// patches contracted, must-folds have to be a forest and what is not cut has to be connected; then a tree
// that keeps all pins exists (the folds of a forest extend to a spanning tree).
#include <algorithm>
#include <deque>

#include "core/base/predicates.h"
#include "core/solve/constraints.h"
#include "core/solve/crowded_patch.h"
#include "core/solve/disjoint_sets.h"
#include "core/unfold/overlap.h"

namespace netwright {

namespace {

// Patches painted by hand are settled in a few dozen steps; what takes more is left to the search itself.
constexpr int kStepsPerPatch = 2000;

std::string count_of(std::size_t n, const char* one, const char* many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

class PinCheck {
 public:
  PinCheck(const DualGraph& dual, const Constraints& pins)
      : dual_(dual), mesh_(dual.mesh()), pins_(pins), pin_(mesh_.n_edges(), EdgePin::None) {
    for (const EdgeId e : pins.must_fold) pin_[e] = EdgePin::MustFold;
    for (const EdgeId e : pins.must_cut) pin_[e] = EdgePin::MustCut;
    patch_.assign(mesh_.n_faces(), -1);
    for (std::size_t k = 0; k < pins.together.size(); ++k)
      for (const FaceId f : pins.together[k]) patch_[f] = static_cast<int>(k);
  }

  std::optional<Contradiction> run() {
    if (auto found = find_broken_patch()) return found;
    if (auto found = find_loop()) return found;
    if (auto found = find_separated()) return found;
    if (auto found = find_crowding()) return found;
    return find_crowded_patch();
  }

 private:
  [[nodiscard]] int a(EdgeId e) const { return mesh_.face(mesh_.halfedge(e)).value; }
  [[nodiscard]] int b(EdgeId e) const { return mesh_.neighbour(mesh_.halfedge(e)).value; }
  [[nodiscard]] bool is_inner(EdgeId e) const {
    return !mesh_.is_border(e) && patch_[FaceId(a(e))] >= 0 && patch_[FaceId(a(e))] == patch_[FaceId(b(e))];
  }
  [[nodiscard]] bool may_fold(EdgeId e) const { return !mesh_.is_border(e) && pin_[e] != EdgePin::MustCut; }

  // A patch whose faces cannot be joined by folds inside it.
  std::optional<Contradiction> find_broken_patch() {
    DisjointSets sets(mesh_.n_faces());
    for (const EdgeId e : mesh_.edges())
      if (may_fold(e) && is_inner(e)) sets.join(a(e), b(e));
    for (const auto& patch : pins_.together) {
      const int first = sets.find(patch.front().value);
      Contradiction found;
      for (const FaceId f : patch)
        if (sets.find(f.value) != first) found.faces.push_back(f);
      if (found.faces.empty()) continue;
      for (const EdgeId e : pins_.must_cut)
        if (is_inner(e) && sets.find(a(e)) != sets.find(b(e))) found.edges.push_back(e);
      found.sentence =
          count_of(found.faces.size(), "face", "faces") +
          (found.edges.empty()
               ? " of a patch that is to stay together cannot be reached inside it: add the faces "
                 "between, or let these go."
               : " of a patch that is to stay together can only be reached across must-cuts: "
                 "release one of the cuts that are lit, or let the faces go.");
      return found;
    }
    return std::nullopt;
  }

  // Must-folds that close a ring: a net is a tree, so one of them has to be a cut.
  std::optional<Contradiction> find_loop() {
    DisjointSets alone(mesh_.n_faces());
    DisjointSets contracted(mesh_.n_faces());
    for (const auto& patch : pins_.together)
      for (const FaceId f : patch) contracted.join(patch.front().value, f.value);
    for (const EdgeId e : pins_.must_fold) {
      const bool closes_inside = !alone.join(a(e), b(e));
      if (!closes_inside && (is_inner(e) || contracted.join(a(e), b(e)))) continue;
      Contradiction found;
      find_ring(e, closes_inside, found);
      found.sentence = count_of(found.edges.size(), "must-fold closes", "must-folds close") + " a ring" +
                       (closes_inside ? "" : " through patches that stay together") +
                       ", which cannot lie flat in one piece: release one of the folds that are lit.";
      return found;
    }
    return std::nullopt;
  }

  // The ring that e closes: a path between its two faces over earlier must-folds (and inside patches).
  void find_ring(EdgeId closing, bool folds_only, Contradiction& found) const {
    IdVector<FaceId, HalfedgeId> came(mesh_.n_faces());
    const FaceId from(a(closing));
    const FaceId to(b(closing));
    std::deque<FaceId> open{from};
    while (!open.empty() && !came[to].is_valid()) {
      const FaceId f = open.front();
      open.pop_front();
      for (const HalfedgeId h : mesh_.halfedges(f)) {
        const EdgeId e = mesh_.edge(h);
        const FaceId g = mesh_.neighbour(h);
        const bool is_way =
            (pin_[e] == EdgePin::MustFold && e < closing) || (!folds_only && may_fold(e) && is_inner(e));
        if (!is_way || g == from || came[g].is_valid()) continue;
        came[g] = h;
        open.push_back(g);
      }
    }
    found.edges = {closing};
    found.faces = {from};
    for (FaceId f = to; f != from && came[f].is_valid(); f = mesh_.face(came[f])) {
      found.faces.push_back(f);
      if (pin_[mesh_.edge(came[f])] == EdgePin::MustFold) found.edges.push_back(mesh_.edge(came[f]));
    }
    std::sort(found.edges.begin(), found.edges.end());
  }

  // Must-cuts that take a component apart.
  std::optional<Contradiction> find_separated() {
    if (pins_.must_cut.empty()) return std::nullopt;
    DisjointSets sets(mesh_.n_faces());
    for (const EdgeId e : mesh_.edges())
      if (may_fold(e)) sets.join(a(e), b(e));
    for (const EdgeId e : pins_.must_cut) {
      if (mesh_.is_border(e) || sets.find(a(e)) == sets.find(b(e))) continue;
      Contradiction found = smaller_part(sets, sets.find(a(e)), sets.find(b(e)));
      found.sentence = "The must-cuts separate " + count_of(found.faces.size(), "face", "faces") +
                       " from the rest, so one piece is impossible: release one of the cuts that are lit.";
      return found;
    }
    return std::nullopt;
  }

  Contradiction smaller_part(DisjointSets& sets, int one, int other) const {
    Contradiction found;
    std::vector<FaceId> second;
    for (const FaceId f : mesh_.faces()) {
      if (sets.find(f.value) == one) found.faces.push_back(f);
      if (sets.find(f.value) == other) second.push_back(f);
    }
    const int kept = second.size() < found.faces.size() ? other : one;
    if (kept == other) found.faces = std::move(second);
    for (const EdgeId e : pins_.must_cut)
      if (!mesh_.is_border(e) && (sets.find(a(e)) == kept) != (sets.find(b(e)) == kept))
        found.edges.push_back(e);
    return found;
  }

  // Must-folds that join faces which then cover each other, whatever the rest of the net does.
  std::optional<Contradiction> find_crowding() {
    IdVector<EdgeId, char> is_fold(mesh_.n_edges(), 0);
    for (const EdgeId e : pins_.must_fold) is_fold[e] = 1;
    tree_ = tree_from_folds(mesh_, is_fold);
    placement_.assign(mesh_.n_faces(), Rigid2());
    std::vector<FaceId> cluster;
    for (const FaceId f : tree_.preorder(mesh_)) {
      if (tree_.is_root(f))
        cluster.clear();
      else
        placement_[f] = placement_[tree_.parent(mesh_, f)] * dual_.unroll(mesh_.twin(tree_.to_parent(f)));
      for (const FaceId g : cluster)
        if (do_overlap(f, g)) return crowding(f, g);
      cluster.push_back(f);
    }
    return std::nullopt;
  }

  // Deeper than the proof would ever let pass, so that a doubtful contact contradicts nothing.
  [[nodiscard]] bool do_overlap(FaceId f, FaceId g) const {
    const double reach = mesh_.size(f) + mesh_.size(g);
    const glm::dvec2 between =
        placement_[f](dual_.flat(mesh_.first(f))) - placement_[g](dual_.flat(mesh_.first(g)));
    if (between.x * between.x + between.y * between.y > reach * reach) return false;
    return faces_overlap(dual_, f, placement_[f], g, placement_[g], 2 * kProofDepth * mesh_.mean_edge());
  }

  // The folds between the two faces are to blame.
  [[nodiscard]] Contradiction crowding(FaceId f, FaceId g) const {
    UnfoldTree tree = tree_;
    tree.reroot(mesh_, f);
    Contradiction found;
    found.faces = {std::min(f, g), std::max(f, g)};
    for (; g != f; g = tree.parent(mesh_, g)) found.edges.push_back(mesh_.edge(tree.to_parent(g)));
    std::sort(found.edges.begin(), found.edges.end());
    found.sentence =
        "With these " + count_of(found.edges.size(), "must-fold", "must-folds") + " faces " +
        std::to_string(mesh_.face_source(found.faces[0]) + 1) + " and " +
        std::to_string(mesh_.face_source(found.faces[1]) + 1) +
        (meet_at_point(found.edges) ? " would cover each other around a point that cannot lie flat"
                                    : " would cover each other on the paper") +
        ": release one of the folds that are lit.";
    return found;
  }

  // Patches, with all that must-folds join to them, whose faces cover each other however they are joined.
  std::optional<Contradiction> find_crowded_patch() {
    if (pins_.together.empty()) return std::nullopt;
    IdVector<EdgeId, char> may_fold(mesh_.n_edges(), 0);
    IdVector<EdgeId, char> must_fold(mesh_.n_edges(), 0);
    DisjointSets sets(mesh_.n_faces());
    for (const EdgeId e : mesh_.edges()) {
      must_fold[e] = pin_[e] == EdgePin::MustFold ? 1 : 0;
      may_fold[e] = may_fold_inside(e) ? 1 : 0;
      if (must_fold[e] + may_fold[e] > 0) sets.join(a(e), b(e));
    }
    IdVector<FaceId, std::vector<FaceId>> clusters(mesh_.n_faces());
    for (const FaceId f : mesh_.faces()) clusters[FaceId(sets.find(f.value))].push_back(f);
    for (const std::vector<FaceId>& cluster : clusters) {
      const bool has_patch =
          std::any_of(cluster.begin(), cluster.end(), [&](FaceId f) { return patch_[f] >= 0; });
      if (has_patch && is_crowded(dual_, cluster, may_fold, must_fold, kStepsPerPatch) == true)
        return crowded(cluster);
    }
    return std::nullopt;
  }

  [[nodiscard]] bool may_fold_inside(EdgeId e) const { return may_fold(e) && is_inner(e); }

  [[nodiscard]] Contradiction crowded(const std::vector<FaceId>& cluster) const {
    Contradiction found;
    found.faces = cluster;
    const auto is_in = [&](int f) { return std::binary_search(cluster.begin(), cluster.end(), FaceId(f)); };
    for (const EdgeId e : mesh_.edges())
      if (pin_[e] != EdgePin::None && is_in(a(e)) && is_in(b(e))) found.edges.push_back(e);
    found.sentence =
        "The " + std::to_string(cluster.size()) +
        " faces that are lit cannot lie flat together, however they are joined: let some of them go" +
        (found.edges.empty() ? "." : ", or release one of the pins between them.");
    return found;
  }

  [[nodiscard]] bool meet_at_point(const std::vector<EdgeId>& edges) const {
    const HalfedgeId h = mesh_.halfedge(edges.front());
    for (const VertexId v : {mesh_.from(h), mesh_.to(h)})
      if (std::all_of(edges.begin(), edges.end(), [&](EdgeId e) {
            const HalfedgeId g = mesh_.halfedge(e);
            return mesh_.from(g) == v || mesh_.to(g) == v;
          }))
        return true;
    return false;
  }

  const DualGraph& dual_;
  const Mesh& mesh_;
  const Constraints& pins_;
  IdVector<EdgeId, EdgePin> pin_;
  IdVector<FaceId, int> patch_;
  UnfoldTree tree_;  // of the must-folds alone
  IdVector<FaceId, Rigid2> placement_;
};

}  // namespace

std::optional<Contradiction> find_contradiction(const DualGraph& dual, const Constraints& pins) {
  if (pins.are_free()) return std::nullopt;
  return PinCheck(dual, pins).run();
}

}  // namespace netwright
