// Backtracking with three prunings: a fold that closes a loop or brings two faces over each other becomes a
// cut, a hinge that alone joins two parts becomes a fold, and parts that are cut off end the case. Each
// contradiction tells which decisions it rests on; choices it does not rest on are jumped over and struck out
// of the proof.
#include "core/solve/prove_hinges.h"

#include <algorithm>
#include <cmath>

#include "core/base/predicates.h"
#include "core/solve/proof_writer.h"
#include "core/solve/reason.h"
#include "core/unfold/overlap.h"

namespace netwright {
namespace {

using Step = ImpossibilityProof::Step;

enum class Choice : char { Open, Fold, Cut };

/// A hinge of the component, by local numbers of faces.
struct Hinge {
  HalfedgeId halfedge;  ///< a side of face `a`
  int a = 0;
  int b = 0;
  Choice choice = Choice::Open;
};

/// Faces joined by folds, laid out together. The stamp tells one state of a cluster from every other.
struct Cluster {
  std::vector<int> faces;
  std::int64_t stamp = 0;
};

/// Two faces that a fold would bring over each other; -1 where it brings none.
struct Clash {
  int a = -1;
  int b = -1;
};

class Search {
 public:
  Search(const DualGraph& dual, const std::vector<FaceId>& component, int most_trees, std::int64_t max_steps,
         const Progress& progress)
      : dual_(dual),
        mesh_(dual.mesh()),
        faces_(component),
        most_trees_(most_trees),
        max_steps_(max_steps),
        progress_(progress) {
    IdVector<FaceId, int> local(mesh_.n_faces(), -1);
    for (std::size_t i = 0; i < faces_.size(); ++i) local[faces_[i]] = static_cast<int>(i);
    hinges_of_.resize(faces_.size());
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      radius_.push_back(0);
      for (const HalfedgeId h : mesh_.halfedges(faces_[i])) {
        radius_.back() = std::max(radius_.back(), glm::length(dual_.flat(h)));
        if (mesh_.neighbour(h).is_valid() && mesh_.halfedge(mesh_.edge(h)) == h)
          add_hinge({h, static_cast<int>(i), local[mesh_.neighbour(h)]});
      }
      clusters_.push_back({{static_cast<int>(i)}, next_stamp_++});
      cluster_of_.push_back(static_cast<int>(i));
    }
    placement_.resize(faces_.size());
    clashes_.resize(hinges_.size());
    depth_ = 2 * kImpossibleDepth * mesh_.mean_edge();
  }

  HingeSearch run() {
    Reason reason(hinges_.size());
    HingeSearch result;
    result.is_refuted = refute(reason);
    if (result.is_refuted && most_trees_ == 1) result.proof = ImpossibilityProof{{}, writer_.nodes()};
    result.is_found = is_found_;
    result.folds = found_;
    result.steps = steps_;
    return result;
  }

 private:
  struct KnownClash {
    std::int64_t a_stamp = -1;
    std::int64_t b_stamp = -1;
    Clash clash;
  };

  void add_hinge(const Hinge& hinge) {
    hinges_of_[static_cast<std::size_t>(hinge.a)].push_back(static_cast<int>(hinges_.size()));
    hinges_of_[static_cast<std::size_t>(hinge.b)].push_back(static_cast<int>(hinges_.size()));
    hinges_.push_back(hinge);
  }

  // True when no tree continues the present choices; `reason` says on which of them that rests.
  bool refute(Reason& reason) {
    if (++steps_ > max_steps_ || progress_.is_cancelled()) return false;
    label_parts();
    if (n_parts_ > most_trees_) {
      writer_.add(Step::Topology);
      reason = reason_of_parting();
      return true;
    }
    bool is_open = false;
    for (std::size_t h = 0; h < hinges_.size(); ++h) {
      if (hinges_[h].choice != Choice::Open) continue;
      is_open = true;
      if (cluster(hinges_[h].a) == cluster(hinges_[h].b)) return cut_loop(h, reason);
      if (const Clash clash = clash_of(h); clash.a >= 0) return cut_clash(h, clash, reason);
    }
    if (!is_open) {
      is_found_ = true;
      for (const Hinge& hinge : hinges_)
        if (hinge.choice == Choice::Fold) found_.push_back(mesh_.edge(hinge.halfedge));
      return false;
    }
    return branch(next_hinge(), reason);
  }

  bool cut_loop(std::size_t h, Reason& reason) {
    Reason why = reason_of_path(hinges_[h].a, hinges_[h].b);
    return cut_forced(h, {Step::Topology, 0, 0}, why, reason);
  }

  bool cut_clash(std::size_t h, Clash clash, Reason& reason) {
    Reason why = reason_of_path(hinges_[h].a, clash.a);
    why.add(reason_of_path(hinges_[h].b, clash.b));
    return cut_forced(h, {Step::Overlap, face(clash.a).value, face(clash.b).value}, why, reason);
  }

  bool cut_forced(std::size_t h, const ImpossibilityProof::Node& end, const Reason& why, Reason& reason) {
    const std::size_t begin = writer_.size();
    writer_.add(Step::Hinge, mesh_.edge(hinges_[h].halfedge).value);
    writer_.add(end.step, end.a, end.b);
    hinges_[h].choice = Choice::Cut;
    const bool is_refuted = refute(reason);
    hinges_[h].choice = Choice::Open;
    if (!is_refuted) return false;
    if (!reason.has(h)) {
      writer_.strike(begin, begin + 2);
      return true;
    }
    reason.add(why);
    reason.drop(h);
    return true;
  }

  bool branch(std::size_t h, Reason& reason) {
    const std::size_t begin = writer_.size();
    writer_.add(Step::Hinge, mesh_.edge(hinges_[h].halfedge).value);
    Undo undo = fold(h);
    bool is_refuted = refute(reason);
    unfold(h, undo);
    if (!is_refuted) return false;
    if (!reason.has(h)) {
      writer_.strike(begin, begin + 1);
      return true;
    }
    const std::size_t middle = writer_.size();
    Reason of_cut(hinges_.size());
    hinges_[h].choice = Choice::Cut;
    is_refuted = refute(of_cut);
    hinges_[h].choice = Choice::Open;
    if (!is_refuted) return false;
    if (!of_cut.has(h)) {
      writer_.strike(begin, middle);
      reason = of_cut;
      return true;
    }
    reason.add(of_cut);
    reason.drop(h);
    return true;
  }

  struct Undo {
    int kept = 0;   ///< the cluster that was added to, and its state before
    int moved = 0;  ///< the cluster that was added
    std::size_t n_kept = 0;
    std::int64_t stamp = 0;
    std::vector<Rigid2> placement;  ///< of the faces that were moved
  };

  Undo fold(std::size_t h) {
    hinges_[h].choice = Choice::Fold;
    const bool keeps_a = at(clusters_, cluster(hinges_[h].a)).faces.size() >=
                         at(clusters_, cluster(hinges_[h].b)).faces.size();
    Undo undo;
    undo.kept = cluster(keeps_a ? hinges_[h].a : hinges_[h].b);
    undo.moved = cluster(keeps_a ? hinges_[h].b : hinges_[h].a);
    const Rigid2 motion = keeps_a ? motion_of_b(h) : motion_of_b(h).inverse();
    Cluster& kept = at(clusters_, undo.kept);
    undo.n_kept = kept.faces.size();
    undo.stamp = kept.stamp;
    for (const int f : at(clusters_, undo.moved).faces) {
      undo.placement.push_back(at(placement_, f));
      at(placement_, f) = motion * at(placement_, f);
      at(cluster_of_, f) = undo.kept;
      kept.faces.push_back(f);
    }
    kept.stamp = next_stamp_++;
    return undo;
  }

  void unfold(std::size_t h, const Undo& undo) {
    hinges_[h].choice = Choice::Open;
    Cluster& kept = at(clusters_, undo.kept);
    for (std::size_t i = undo.n_kept; i < kept.faces.size(); ++i) {
      at(cluster_of_, kept.faces[i]) = undo.moved;
      at(placement_, kept.faces[i]) = undo.placement[i - undo.n_kept];
    }
    kept.faces.resize(undo.n_kept);
    kept.stamp = undo.stamp;
  }

  /// What brings the cluster of b into the frame of that of a, when h becomes a fold.
  [[nodiscard]] Rigid2 motion_of_b(std::size_t h) const {
    const Hinge& hinge = hinges_[h];
    return at(placement_, hinge.a) * dual_.unroll(hinge.halfedge) * at(placement_, hinge.b).inverse();
  }

  Clash clash_of(std::size_t h) {
    const Cluster& a = at(clusters_, cluster(hinges_[h].a));
    const Cluster& b = at(clusters_, cluster(hinges_[h].b));
    KnownClash& known = clashes_[h];
    if (known.a_stamp != a.stamp || known.b_stamp != b.stamp) known = {a.stamp, b.stamp, find_clash(h, a, b)};
    return known.clash;
  }

  [[nodiscard]] Clash find_clash(std::size_t h, const Cluster& a, const Cluster& b) const {
    const Rigid2 motion = motion_of_b(h);
    for (const int g : b.faces) {
      const Rigid2 there = motion * at(placement_, g);
      for (const int f : a.faces) {
        const Rigid2& here = at(placement_, f);
        if (std::hypot(here.x - there.x, here.y - there.y) >= at(radius_, f) + at(radius_, g)) continue;
        if (faces_overlap(dual_, face(f), here, face(g), there, depth_)) return {f, g};
      }
    }
    return {};
  }

  // Parts that hinges not cut hold together, numbered.
  void label_parts() {
    part_.assign(faces_.size(), -1);
    n_parts_ = 0;
    std::vector<int> reached;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      if (part_[i] >= 0) continue;
      part_[i] = n_parts_;
      reached.assign(1, static_cast<int>(i));
      while (!reached.empty()) {
        const int f = reached.back();
        reached.pop_back();
        for (const int h : at(hinges_of_, f)) {
          const int g = other(h, f);
          if (at(hinges_, h).choice == Choice::Cut || at(part_, g) >= 0) continue;
          at(part_, g) = n_parts_;
          reached.push_back(g);
        }
      }
      ++n_parts_;
    }
  }

  /// The cuts around the part that has fewest; those around all where several parts are allowed.
  [[nodiscard]] Reason reason_of_parting() const {
    Reason reason(hinges_.size());
    if (most_trees_ > 1) {
      for (std::size_t h = 0; h < hinges_.size(); ++h)
        if (at(part_, hinges_[h].a) != at(part_, hinges_[h].b)) reason.add(h);
      return reason;
    }
    std::vector<int> n_cuts(static_cast<std::size_t>(n_parts_), 0);
    for (const Hinge& hinge : hinges_) {
      if (at(part_, hinge.a) == at(part_, hinge.b)) continue;
      ++n_cuts[static_cast<std::size_t>(at(part_, hinge.a))];
      ++n_cuts[static_cast<std::size_t>(at(part_, hinge.b))];
    }
    const auto fewest = static_cast<int>(std::min_element(n_cuts.begin(), n_cuts.end()) - n_cuts.begin());
    for (std::size_t h = 0; h < hinges_.size(); ++h)
      if ((at(part_, hinges_[h].a) == fewest) != (at(part_, hinges_[h].b) == fewest)) reason.add(h);
    return reason;
  }

  /// The folds on the way between two faces of one cluster.
  [[nodiscard]] Reason reason_of_path(int from, int to) const {
    std::vector<int> came_by(faces_.size(), -1);
    std::vector<int> reached{from};
    for (std::size_t i = 0; i < reached.size() && reached[i] != to; ++i)
      for (const int h : at(hinges_of_, reached[i])) {
        const int g = other(h, reached[i]);
        if (at(hinges_, h).choice != Choice::Fold || g == from || at(came_by, g) >= 0) continue;
        at(came_by, g) = h;
        reached.push_back(g);
      }
    Reason reason(hinges_.size());
    for (int f = to; f != from; f = other(at(came_by, f), f))
      reason.add(static_cast<std::size_t>(at(came_by, f)));
    return reason;
  }

  /// One of the cluster that has fewest ways left to go, towards the largest neighbour.
  [[nodiscard]] std::size_t next_hinge() const {
    std::vector<int> n_open(clusters_.size(), 0);
    for (const Hinge& hinge : hinges_) {
      if (hinge.choice != Choice::Open) continue;
      ++at(n_open, cluster(hinge.a));
      ++at(n_open, cluster(hinge.b));
    }
    const auto size = [&](int face) { return at(clusters_, cluster(face)).faces.size(); };
    std::size_t best = hinges_.size();
    std::pair<int, std::size_t> best_rank{};
    for (std::size_t h = 0; h < hinges_.size(); ++h) {
      const Hinge& hinge = hinges_[h];
      if (hinge.choice != Choice::Open) continue;
      const std::pair<int, std::size_t> rank{
          -std::min(at(n_open, cluster(hinge.a)), at(n_open, cluster(hinge.b))),
          size(hinge.a) + size(hinge.b)};
      if (best < hinges_.size() && rank <= best_rank) continue;
      best = h;
      best_rank = rank;
    }
    return best;
  }

  template <class T>
  static T& at(std::vector<T>& items, int i) {
    return items[static_cast<std::size_t>(i)];
  }
  template <class T>
  static const T& at(const std::vector<T>& items, int i) {
    return items[static_cast<std::size_t>(i)];
  }
  [[nodiscard]] FaceId face(int i) const { return at(faces_, i); }
  [[nodiscard]] int cluster(int f) const { return at(cluster_of_, f); }
  [[nodiscard]] int other(int h, int f) const {
    return at(hinges_, h).a == f ? at(hinges_, h).b : at(hinges_, h).a;
  }

  const DualGraph& dual_;
  const Mesh& mesh_;
  const std::vector<FaceId>& faces_;
  int most_trees_;
  std::int64_t max_steps_;
  const Progress& progress_;
  double depth_ = 0;
  std::vector<Hinge> hinges_;
  std::vector<std::vector<int>> hinges_of_;  ///< per face
  std::vector<double> radius_;               ///< per face, around its frame's origin
  std::vector<Rigid2> placement_;            ///< per face, in its cluster's frame
  std::vector<int> cluster_of_;
  std::vector<Cluster> clusters_;
  std::vector<KnownClash> clashes_;  ///< per hinge
  std::vector<int> part_;
  int n_parts_ = 0;
  ProofWriter writer_;
  bool is_found_ = false;
  std::vector<EdgeId> found_;
  std::int64_t next_stamp_ = 0;
  std::int64_t steps_ = 0;
};

}  // namespace

HingeSearch search_hinges(const DualGraph& dual, const std::vector<FaceId>& component, int most_trees,
                          std::int64_t max_steps, const Progress& progress) {
  return Search(dual, component, most_trees, max_steps, progress).run();
}

}  // namespace netwright
