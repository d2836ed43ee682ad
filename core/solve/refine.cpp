// A tabu search of its own over overlap-free nets: the climb is the loop that a new fold closes, the memory
// keeps what was inserted.
#include "core/solve/refine.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/solve/disjoint_sets.h"

namespace netwright {

namespace {

constexpr std::size_t kMostOnLoop = 16;  ///< folds of a loop that are tried for one troubled cut
constexpr int kMemory = 12;              ///< steps for which an inserted fold may not be removed
constexpr double kTemperature = 0.5;     ///< of worsening moves, in units of cost
constexpr int kShareOfPatience = 6;      ///< this part of all looks without anything better is the end
constexpr int kAppliesBetweenChecks = 2000;

class Refiner {
 public:
  Refiner(SearchState& state, const NetJudge& judge, int most_looks, Random& random, const Progress* progress)
      : state_(state),
        model_(state.model()),
        judge_(judge),
        most_looks_(most_looks),
        random_(random),
        progress_(progress),
        held_until_(static_cast<std::size_t>(model_.n_halfedges), -1) {
    find_vertices();
  }

  RefineResult run() {
    start_ = state_.folds();
    now_ = judge_(state_);
    result_.cost_before = best_cost_ = now_.cost;
    while (now_.cost > 0 && !now_.trouble.empty() && n_looks_ < most_looks_ &&
           n_looks_ - looks_at_best_ < most_looks_ / kShareOfPatience && !is_cancelled()) {
      ++step_;
      improve(now_.trouble[static_cast<std::size_t>(random_.below(static_cast<int>(now_.trouble.size())))]);
    }
    return finish();
  }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  [[nodiscard]] bool is_cancelled() const { return progress_ != nullptr && progress_->is_cancelled(); }

  struct Swap {
    int removed;
    int inserted;
  };

  /// The cut becomes a fold, in place of one on the loop that it closes.
  void add_closing_swaps(int wanted) {
    state_.find_path(model_.face_of[at(wanted)], model_.beyond(wanted), path_);
    const std::size_t first = swaps_.size();
    for (const PathStep& step : path_) {
      const int up = state_.up(step.child);
      add_swap(step.near_is_child ? up : model_.twin[at(up)], wanted);
    }
    // Long loops are tried at both ends, where the trouble is, and here and there between.
    while (swaps_.size() > first + kMostOnLoop)
      swaps_.erase(swaps_.begin() + static_cast<std::ptrdiff_t>(first + 4) +
                   random_.below(static_cast<int>(swaps_.size() - first) - 8));
  }

  /// A fold at either end of the cut becomes a cut, so that cuts pass through the point instead of ending at
  /// it; a cut that meets it at its other end, or at this one, becomes a fold instead.
  void add_passing_swaps(int wanted) {
    for (const int point : {vertex_of_[at(wanted)], vertex_of_[at(model_.twin[at(wanted)])]})
      for (const int h : around_[at(point)]) {
        if (model_.twin[at(h)] < 0 || !state_.is_fold(h)) continue;
        const int child = child_of(h);
        for (const int end : {vertex_of_[at(model_.twin[at(h)])], point})
          for (const int c : around_[at(end)]) {
            const int twin = model_.twin[at(c)];
            if (twin < 0 || state_.is_fold(c)) continue;
            const bool is_inside = state_.in_subtree(model_.face_of[at(c)], child);
            if (is_inside != state_.in_subtree(model_.face_of[at(twin)], child))
              add_swap(state_.up(child), is_inside ? c : twin);
          }
      }
  }

  void add_swap(int removed, int inserted) {
    if (held_until_[at(removed)] < step_ && model_.may_exchange(removed, inserted))
      swaps_.push_back({removed, inserted});
  }

  [[nodiscard]] int child_of(int fold) const {
    const int face = model_.face_of[at(fold)];
    return state_.up(face) == fold ? face : model_.beyond(fold);
  }

  void apply(int removed, int inserted) {
    state_.apply(state_.exchange(child_of(removed), removed, inserted));
    ++n_applies_;
  }

  void improve(int wanted) {
    ++n_looks_;  // so that cuts which can never be folds end the search, too
    if (model_.twin[at(wanted)] < 0) return;
    swaps_.clear();
    add_closing_swaps(wanted);
    add_passing_swaps(wanted);
    Swap best{-1, -1};
    Judgement best_judgement;
    // Drawn first, so that worse ones need not be remembered.
    double bound = now_.cost - kTemperature * std::log(1 - random_.unit());
    while (!swaps_.empty()) {
      const auto i = static_cast<std::size_t>(random_.below(static_cast<int>(swaps_.size())));
      const Swap swap = std::exchange(swaps_[i], swaps_.back());
      swaps_.pop_back();
      const Exchange exchange = state_.exchange(child_of(swap.removed), swap.removed, swap.inserted);
      if (state_.count_after(exchange, 1) > 0) continue;
      apply(swap.removed, swap.inserted);
      Judgement judgement = judge_(state_);
      ++n_looks_;
      apply(swap.inserted, swap.removed);
      if (judgement.cost >= bound) continue;
      bound = judgement.cost;
      best = swap;
      best_judgement = std::move(judgement);
      if (best_judgement.cost < now_.cost) break;
    }
    if (best.removed >= 0) take(best.removed, best.inserted, std::move(best_judgement));
  }

  void take(int removed, int inserted, Judgement judgement) {
    apply(removed, inserted);
    now_ = std::move(judgement);
    result_.moves.emplace_back(removed, inserted);
    held_until_[at(inserted)] = step_ + kMemory;
    held_until_[at(model_.twin[at(inserted)])] = step_ + kMemory;
    if (n_applies_ >= kAppliesBetweenChecks) check();
    if (now_.cost < best_cost_ && state_.overlaps() == 0) {
      best_cost_ = now_.cost;
      n_best_moves_ = result_.moves.size();
      best_folds_ = state_.folds();
      looks_at_best_ = n_looks_;
    }
  }

  void check() {
    state_.recompute();
    n_applies_ = 0;
  }

  /// Halfedges that start at one point of the model, by turning about it.
  void find_vertices() {
    DisjointSets sets(at(model_.n_halfedges));
    for (int f = 0; f < model_.n_faces; ++f) {
      const int first = model_.face_begin[at(f)];
      const int last = model_.face_begin[at(f) + 1];
      for (int h = first; h < last; ++h)
        if (const int twin = model_.twin[at(h)]; twin >= 0) {
          const int face = model_.face_of[at(twin)];
          const int next =
              twin + 1 < model_.face_begin[at(face) + 1] ? twin + 1 : model_.face_begin[at(face)];
          sets.join(h, next);
        }
    }
    around_.resize(at(model_.n_halfedges));
    for (int h = 0; h < model_.n_halfedges; ++h) {
      vertex_of_.push_back(sets.find(h));
      around_[at(vertex_of_.back())].push_back(h);
    }
  }

  RefineResult finish() {
    result_.moves.resize(n_best_moves_);
    state_.set_tree(best_folds_.empty() ? start_ : best_folds_);
    if (state_.overlaps() > 0) {  // a contact that only the path of moves had hidden
      state_.set_tree(start_);
      result_.moves.clear();
      best_cost_ = result_.cost_before;
    }
    result_.cost_after = best_cost_;
    return std::move(result_);
  }

  SearchState& state_;
  const SearchModel& model_;
  const NetJudge& judge_;
  int most_looks_;
  Random& random_;
  const Progress* progress_;
  std::vector<int> held_until_;           ///< per halfedge: the last step in which it may not be removed
  std::vector<int> vertex_of_;            ///< per halfedge: one that stands for all that start at its point
  std::vector<std::vector<int>> around_;  ///< per such halfedge: all of them
  std::vector<PathStep> path_;
  std::vector<Swap> swaps_;
  Judgement now_;
  RefineResult result_;
  std::vector<char> start_;
  std::vector<char> best_folds_;
  double best_cost_ = 0;
  std::size_t n_best_moves_ = 0;
  int n_looks_ = 0;
  int looks_at_best_ = 0;
  int step_ = 0;
  int n_applies_ = 0;
};

}  // namespace

RefineResult refine(SearchState& state, const NetJudge& judge, int most_looks, Random& random,
                    const Progress* progress) {
  return Refiner(state, judge, most_looks, random, progress).run();
}

}  // namespace netwright
