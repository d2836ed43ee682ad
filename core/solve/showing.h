// What a watcher sees of a running search: follows the leading stream move by move at the pace the watcher
// asks for and posts snapshots. The search stays ahead by at most one round, so watching never changes the
// answer.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/solve/portfolio.h"
#include "core/solve/solve.h"

namespace netwright {

/// The folds of all components together, and how they become trees and nets of the whole mesh.
class WholeTree {
 public:
  /// `root` (may be invalid) roots its own component, the largest face every other one.
  WholeTree(std::shared_ptr<const DualGraph> dual, FaceId root);

  void set(const SearchModel& model, const std::vector<char>& folds);
  void exchange(const SearchModel& model, int removed, int inserted);
  [[nodiscard]] UnfoldTree tree() const;
  [[nodiscard]] Net net() const { return layout(dual_, tree()); }

 private:
  std::shared_ptr<const DualGraph> dual_;
  IdVector<EdgeId, char> is_fold_;
  std::vector<FaceId> roots_;
};

/// The moves of one stream as the mesh's own ids, for replay.
MoveRecord to_record(const SearchModel& model, const SearchEpisode::Move& move);

class Showing {
 public:
  Showing(WholeTree& whole, const std::vector<SearchModel>& models,
          const std::vector<std::unique_ptr<Portfolio>>& portfolios, const SolveHooks& hooks);

  /// Posts the present start of this component's search.
  void begin(std::size_t component);
  /// Remembers where every stream is; call before Portfolio::advance.
  void before_round();
  /// Shows what the round brought, as fast or slow as the watcher wants. False when the watcher said stop.
  bool after_round();
  /// Does anybody look at what is posted?
  [[nodiscard]] bool is_watched() const { return hooks_->snapshots != nullptr; }
  /// Posts a net that polish has reached, when it is due; waits while the watcher pauses. False when the
  /// watcher said stop.
  bool show_polished(const Net& net, const PolishView& view);
  /// The last snapshot tells this of polish.
  void tell_polish(const PolishView& view) { polish_ = view; }
  /// Posts the finished net.
  void finish(const Net& net, std::vector<Overlap> overlaps);

 private:
  struct Place {
    int episode = 0;  // numbered from the start of the search
    std::size_t move = 0;
    bool operator==(const Place&) const = default;
  };
  [[nodiscard]] static Place end_of(const TabuSolver& solver) {
    return {solver.restarts(), solver.episodes().back().moves.size()};
  }
  [[nodiscard]] static const SearchEpisode* episode(const TabuSolver& solver, int number);
  void load(const TabuSolver& solver, Place place);
  [[nodiscard]] bool reveal_moves(const TabuSolver& solver);
  void post(const TabuSolver& solver, const MoveRecord* last_move, bool is_at_end);
  [[nodiscard]] std::vector<Overlap> known_overlaps() const;
  void add_history(const TabuSolver& solver, Snapshot& snapshot) const;
  [[nodiscard]] std::shared_ptr<Snapshot> at_end(const Net& net, std::vector<Overlap> overlaps) const;

  WholeTree* whole_;
  const std::vector<SearchModel>* models_;
  const std::vector<std::unique_ptr<Portfolio>>* portfolios_;
  const SolveHooks* hooks_;
  std::size_t component_ = 0;
  int stream_ = 0;
  Place place_;
  std::vector<Place> round_start_;
  std::int64_t earlier_moves_ = 0;
  std::optional<PolishView> polish_;
};

}  // namespace netwright
