// Ruin and recreate: a neighbourhood of faces is taken out of its pieces and everything is joined again where
// it can be, cheap cuts last. What is no worse is kept. An exact search has the last word on small models.
#include "core/solve/fewest_pieces.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "core/base/predicates.h"
#include "core/base/random.h"
#include "core/solve/piece_forest.h"
#include "core/solve/prove_hinges.h"
#include "core/solve/prove_regions.h"
#include "core/unfold/flat_net.h"

namespace netwright {
namespace {

constexpr int kStarts = 8;               ///< orders in which the first forest is tried to be joined
constexpr std::size_t kExactFaces = 40;  ///< of models on which fewer pieces are searched for exactly
constexpr int kMostTries = 20'000;       ///< for each choice
constexpr double kPieceCost = 1e6;       ///< of a piece too many, in mean edges: more than any cuts

class PieceSearch {
 public:
  PieceSearch(const std::shared_ptr<const DualGraph>& dual, const PiecesOptions& options,
              const Progress& progress)
      : dual_(dual),
        mesh_(dual->mesh()),
        options_(options),
        progress_(progress),
        random_(options.seed),
        cost_(mesh_.n_edges(), 0),
        is_fixed_(mesh_.n_edges(), 0),
        may_fold_(mesh_.n_edges(), 0),
        forest_(*dual, kSolveDepth * mesh_.mean_edge()) {
    for (const EdgeId e : mesh_.edges()) {
      if (mesh_.is_border(e)) continue;
      cost_[e] = cut_cost(*dual, e) / mesh_.mean_edge();
      if (pin_of(options.pins, e) == EdgePin::MustCut) continue;
      hinges_.push_back(e);
      may_fold_[e] = 1;
    }
    fix_pins();
  }

  PiecesResult run() {
    result_.at_least = static_cast<int>(mesh_.n_components());
    if (!begin()) return std::move(result_);
    improve(result_.at_least);
    if (forest_.n_pieces() > result_.at_least) look_exactly();
    const int fewest = forest_.n_pieces();
    for (int n = fewest; n < fewest + options_.n_choices; ++n) {
      if (n > fewest) {
        const EdgeId e = cheapest_fold();
        if (!e.is_valid()) break;
        forest_.exchange({e}, {});
      }
      improve(n);
      take();
      if (progress_.is_cancelled()) break;
    }
    result_.was_cancelled = progress_.is_cancelled();
    return std::move(result_);
  }

 private:
  /// Must-folds, and the folds by which the tree to begin with keeps patches together.
  void fix_pins() {
    for (const EdgeId e : options_.pins.must_fold) is_fixed_[e] = 1;
    if (options_.from == nullptr) return;
    for (const EdgeId e : hinges_) {
      const HalfedgeId h = mesh_.halfedge(e);
      const int patch = patch_of(options_.pins, mesh_.face(h));
      if (patch >= 0 && patch == patch_of(options_.pins, mesh_.neighbour(h)) &&
          options_.from->is_fold(mesh_, e))
        is_fixed_[e] = 1;
    }
  }

  /// The folds to begin with, in several orders, each fold that brings an overlap left out.
  bool begin() {
    for (const EdgeId e : mesh_.edges())
      if (is_fixed_[e] != 0 && !forest_.join(e)) return false;
    if (!are_patches_whole()) return false;
    const PieceForest fixed = forest_;
    std::optional<PieceForest> best;
    double best_worth = 0;
    for (int start = 0; start < kStarts; ++start) {
      if (progress_.is_cancelled() && best) break;
      forest_ = fixed;
      join(hinges_, start % 2 == 0);
      if (!best || worth(1) < best_worth) {
        best = forest_;
        best_worth = worth(1);
      }
    }
    forest_ = std::move(*best);
    return true;
  }

  [[nodiscard]] bool are_patches_whole() const {
    return std::all_of(
        options_.pins.together.begin(), options_.pins.together.end(), [&](const std::vector<FaceId>& patch) {
          return std::all_of(patch.begin(), patch.end(),
                             [&](FaceId f) { return forest_.piece(f) == forest_.piece(patch.front()); });
        });
  }

  /// Joins what can be joined by these, dear cuts first but for some chance; the given tree's folds before
  /// others. Returns what it made folds.
  std::vector<EdgeId> join(const std::vector<EdgeId>& hinges, bool prefers_given) {
    std::vector<std::pair<double, EdgeId>> order;
    for (const EdgeId e : hinges) {
      const bool is_given = prefers_given && options_.from != nullptr && options_.from->is_fold(mesh_, e);
      const double chance = 0.3 + 1.4 * random_.unit();
      if (!forest_.is_fold(e)) order.emplace_back((is_given ? -kPieceCost : 0) - cost_[e] * chance, e);
    }
    std::sort(order.begin(), order.end());
    std::vector<EdgeId> joined;
    for (const auto& [rank, e] : order)
      if (forest_.join(e)) joined.push_back(e);
    return joined;
  }

  /// Less is better: pieces beyond `n_pieces`, then the cuts.
  [[nodiscard]] double worth(int n_pieces) const {
    double sum = kPieceCost * std::max(0, forest_.n_pieces() - n_pieces);
    for (const EdgeId e : mesh_.edges())
      if (!forest_.is_fold(e)) sum += cost_[e];
    return sum;
  }

  [[nodiscard]] double cost_of(const std::vector<EdgeId>& edges) const {
    double sum = 0;
    for (const EdgeId e : edges) sum += cost_[e];
    return sum;
  }

  /// Brings forest_ to the best one of `n_pieces` pieces, or as few more as can be, that is found from it.
  void improve(int n_pieces) {
    IdVector<EdgeId, char> best = forest_.folds();
    double best_worth = worth(n_pieces);
    double now_worth = best_worth;
    const int n_tries = std::min(kMostTries, options_.tries_per_face * static_cast<int>(mesh_.n_faces()));
    for (int k = 0; k < n_tries && !progress_.is_cancelled(); ++k) {
      const int before = std::max(0, forest_.n_pieces() - n_pieces);
      std::vector<EdgeId> cut = ruin();
      std::vector<EdgeId> joined = join(hinges_around(cut), false);
      while (forest_.n_pieces() < n_pieces) {
        cut.push_back(cheapest_fold());
        forest_.exchange({cut.back()}, {});
      }
      const int after = std::max(0, forest_.n_pieces() - n_pieces);
      const double change = kPieceCost * (after - before) + cost_of(cut) - cost_of(joined);
      const double slack = 0.5 * (1 - static_cast<double>(k) / n_tries);  // in mean edges; none at the end
      if (change > slack) {
        take_back(cut, joined);
        continue;
      }
      now_worth += change;
      if (now_worth >= best_worth - 1e-9) continue;
      best = forest_.folds();
      best_worth = now_worth;
    }
    become(best);
  }

  /// An edge may have been cut and joined again, or joined and cut.
  void take_back(std::vector<EdgeId>& cut, std::vector<EdgeId>& joined) {
    std::sort(cut.begin(), cut.end());
    std::sort(joined.begin(), joined.end());
    std::vector<EdgeId> folds;
    std::vector<EdgeId> cuts;
    std::set_difference(joined.begin(), joined.end(), cut.begin(), cut.end(), std::back_inserter(folds));
    std::set_difference(cut.begin(), cut.end(), joined.begin(), joined.end(), std::back_inserter(cuts));
    forest_.exchange(folds, cuts);
  }

  void become(const IdVector<EdgeId, char>& is_fold) {
    std::vector<EdgeId> folds;
    std::vector<EdgeId> cuts;
    for (const EdgeId e : hinges_) {
      if (forest_.is_fold(e) && is_fold[e] == 0) folds.push_back(e);
      if (!forest_.is_fold(e) && is_fold[e] != 0) cuts.push_back(e);
    }
    forest_.exchange(folds, cuts);
  }

  /// Takes a face and those around it out of their pieces; returns the folds it cut.
  std::vector<EdgeId> ruin() {
    std::vector<FaceId> taken{FaceId(random_.below(static_cast<int>(mesh_.n_faces())))};
    const std::size_t most = 1 + static_cast<std::size_t>(random_.below(12));
    std::vector<EdgeId> folds;
    for (std::size_t i = 0; i < taken.size(); ++i)
      for (const HalfedgeId h : mesh_.halfedges(taken[i])) {
        const EdgeId e = mesh_.edge(h);
        if (forest_.is_fold(e) && is_fixed_[e] == 0) folds.push_back(e);
        const FaceId g = mesh_.neighbour(h);
        if (g.is_valid() && taken.size() < most && std::find(taken.begin(), taken.end(), g) == taken.end())
          taken.push_back(g);
      }
    std::sort(folds.begin(), folds.end());
    folds.erase(std::unique(folds.begin(), folds.end()), folds.end());
    forest_.exchange(folds, {});
    return folds;
  }

  /// Hinges of the pieces that these folds fell into. What could not be joined elsewhere still cannot.
  [[nodiscard]] std::vector<EdgeId> hinges_around(const std::vector<EdgeId>& cut) const {
    std::vector<int> pieces;
    for (const EdgeId e : cut)
      for (const HalfedgeId h : {mesh_.halfedge(e), mesh_.twin(mesh_.halfedge(e))})
        pieces.push_back(forest_.piece(mesh_.face(h)));
    std::sort(pieces.begin(), pieces.end());
    pieces.erase(std::unique(pieces.begin(), pieces.end()), pieces.end());
    std::vector<EdgeId> found;
    for (const int piece : pieces)
      for (const FaceId f : forest_.faces_of(piece))
        for (const HalfedgeId h : mesh_.halfedges(f))
          if (may_fold_[mesh_.edge(h)] != 0 && !forest_.is_fold(mesh_.edge(h)))
            found.push_back(mesh_.edge(h));
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

  [[nodiscard]] EdgeId cheapest_fold() const {
    EdgeId best;
    for (const EdgeId e : hinges_)
      if (forest_.is_fold(e) && is_fixed_[e] == 0 && (!best.is_valid() || cost_[e] < cost_[best])) best = e;
    return best;
  }

  /// Fewer pieces than these where an exact search finds them, and how few there can be at all.
  void look_exactly() {
    result_.at_least = least_pieces(mesh_, telling_regions(*dual_, progress_));
    if (!options_.pins.are_free() || mesh_.n_components() > 1 || mesh_.n_faces() > kExactFaces) return;
    std::vector<FaceId> all;
    for (const FaceId f : mesh_.faces()) all.push_back(f);
    bool is_tight = true;
    for (int n = result_.at_least; n < forest_.n_pieces(); ++n) {
      const HingeSearch search = search_hinges(*dual_, all, n, options_.exact_steps, progress_);
      if (search.is_found) {
        PieceForest found(*dual_, kSolveDepth * mesh_.mean_edge());
        for (const EdgeId e : search.folds) found.join(e);
        if (found.n_pieces() < forest_.n_pieces()) forest_ = std::move(found);
        return;
      }
      is_tight &= search.is_refuted;
      if (is_tight) result_.at_least = n + 1;
    }
  }

  void take() {
    PiecesChoice choice;
    choice.net = layout(dual_, tree_from_folds(mesh_, forest_.folds(), options_.pins.root));
    for (const EdgeId e : mesh_.edges())
      if (!mesh_.is_border(e) && !forest_.is_fold(e)) choice.cut_length += mesh_.length(e);
    if (verify(to_flat_net(choice.net, 1), forest_.n_pieces()).is_net)
      result_.choices.push_back(std::move(choice));
  }

  std::shared_ptr<const DualGraph> dual_;
  const Mesh& mesh_;
  const PiecesOptions& options_;
  const Progress& progress_;
  Random random_;
  IdVector<EdgeId, double> cost_;  ///< of cutting, in mean edges
  IdVector<EdgeId, char> is_fixed_;
  IdVector<EdgeId, char> may_fold_;
  std::vector<EdgeId> hinges_;  ///< that may be folds
  PieceForest forest_;          ///< the one being worked on
  PiecesResult result_;
};

}  // namespace

PiecesResult fewest_pieces(const std::shared_ptr<const DualGraph>& dual, const PiecesOptions& options,
                           const Progress& progress) {
  return PieceSearch(dual, options, progress).run();
}

double cut_cost(const DualGraph& dual, EdgeId edge) {
  const Mesh& mesh = dual.mesh();
  if (mesh.is_border(edge)) return 0;
  const double bend = dual.bend(edge);
  double share = 1 - 0.4 * std::min(1.0, std::abs(bend) / (M_PI / 2));
  if (bend < -kFlatFold) share *= 0.8;
  const auto looks_down = [&](HalfedgeId h) {
    const glm::dvec3 normal = mesh.normal(mesh.face(h));
    return (mesh.up_axis() == UpAxis::Y ? normal.y : normal.z) < -0.5;
  };
  const HalfedgeId h = mesh.halfedge(edge);
  if (looks_down(h) || looks_down(mesh.twin(h))) share *= 0.7;
  return share * mesh.length(edge);
}

}  // namespace netwright
