// The search itself: Algorithm 3 of "Unfolding Polyhedra via Tabu Search", one step at a time. Seeded, no
// thread, no clock. Every departure from the paper is a setting, and SearchSettings::paper() switches them
// all off.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/progress.h"
#include "core/base/random.h"
#include "core/solve/search_state.h"
#include "core/solve/snapshot.h"

namespace netwright {

struct SearchSettings {
  /// Overlap-aware greedy tree; otherwise the paper's steepest edge (4.2).
  bool greedy_start = true;
  /// Also re-attach the parent to the moved side: the same tree path, more moves.
  bool two_sided = true;
  /// Per fold also re-attach the smaller side at so many of its faces, drawn at random. The paper moves a
  /// side by its one face on the path; these moves swing a large branch out of a crowd at once.
  int sampled_faces = 2;
  /// The paper roots at random (4.5). The rest roots at an overlap partner, so that the climb covers exactly
  /// the tree path that has to change.
  double random_root_share = 0.07;
  /// Metropolis bound on the best worsening move, drawn before the climb; its temperature, in overlaps.
  bool bounds_worsening = true;
  double temperature = 12;
  /// Ask the face that ruled an exchange out last time first; changes no answer.
  bool uses_killers = true;
  /// Stop counting once a candidate cannot win; changes no answer.
  bool counts_bounded = true;
  /// Count by the paper's log n rule (4.7) instead; changes no answer.
  bool counts_as_paper = false;
  /// Iterations per face without a new fewest before a new start tree.
  int restart_after = 3;
  /// Every new start tree gets twice the patience of the one before and half its temperature, which begins
  /// anew with every so many trees. 0: all are treated alike.
  int cooling_restarts = 4;

  static SearchSettings fast() { return {}; }
  static SearchSettings paper() {
    SearchSettings s;
    s.greedy_start = false;
    s.two_sided = false;
    s.sampled_faces = 0;
    s.random_root_share = 1;
    s.bounds_worsening = false;
    s.counts_bounded = false;
    s.counts_as_paper = true;
    s.restart_after = 50;
    s.cooling_restarts = 0;
    return s;
  }
};

/// A stretch of the search from one start tree, in the component's own numbering.
struct SearchEpisode {
  std::vector<char> start_folds;
  int overlaps_at_start = 0;
  struct Move {
    int chosen, root, removed, inserted, overlaps_after;
  };
  std::vector<Move> moves;
};

class TabuSolver {
 public:
  /// `stream` tells searches of one seed apart. The dual graph, the model and `progress` (may be null) must
  /// outlive the solver. Once `progress` is cancelled, a start tree or a climb under way is cut short; the
  /// state stays a valid tree with all its overlaps. `from`, where it isn't empty, has one flag per halfedge:
  /// the folds to start from, mended so that they keep the model's pins.
  TabuSolver(const DualGraph& dual, const SearchModel& model, const SearchSettings& settings,
             std::uint64_t seed, std::uint64_t stream, const Progress* progress = nullptr,
             std::vector<char> from = {});

  /// One iteration: choose an overlapping face, climb, move (or find every way barred). Does nothing when
  /// solved.
  void step();

  /// When solved: takes back what was changed since `from` and need not have been, as long as there is no
  /// overlap. Such moves are logged like others.
  void return_home();

  /// No overlaps, after placing and detecting everything anew.
  [[nodiscard]] bool is_solved() const { return is_solved_; }
  [[nodiscard]] const SearchState& state() const { return state_; }
  [[nodiscard]] const std::vector<char>& best_folds() const { return best_folds_; }
  [[nodiscard]] int best_overlaps() const { return best_overlaps_; }
  [[nodiscard]] std::int64_t iterations() const { return iterations_; }
  [[nodiscard]] std::int64_t moves() const { return moves_; }
  [[nodiscard]] int restarts() const { return restarts_; }
  /// Per face: in how many iterations it was the overlapping face to be cleared. Drawn evenly among those
  /// that overlap, so that faces which still do when few are left count most.
  [[nodiscard]] const std::vector<std::int64_t>& collisions() const { return collisions_; }
  /// What happened since the start; early episodes of very long searches are dropped.
  [[nodiscard]] const std::vector<SearchEpisode>& episodes() const { return episodes_; }

 private:
  struct Choice {
    Exchange exchange;
    int delta = 0;
    bool is_found = false;
  };
  struct Climb {
    int chosen = -1;
    int root = -1;
    std::vector<PathStep> path;  // folds from the chosen face to the root
    std::vector<int> crossings;  // per fold of the path: stored overlaps between its two sides
    int bound = 0;               // only a change below this can win
    bool saw_tabu = false;
    bool saw_free = false;
    Choice best;
  };

  void start();
  [[nodiscard]] std::vector<char> start_folds();
  void choose_face();
  void choose_root();
  void count_crossings();
  void climb();
  void try_fold(const PathStep& step, int crossing);
  [[nodiscard]] bool is_kept(const PathStep& step) const;
  [[nodiscard]] bool take_back(int wanted);
  void carry_out(const Exchange& exchange);
  void try_sampled(const PathStep& step, int crossing);
  void try_across(int face, const PathStep& step, int crossing, int removed);
  void try_reattach(int halfedge, const PathStep& step, int crossing, int removed);
  [[nodiscard]] int first_side_with(int face) const;
  [[nodiscard]] int face_behind_stuck();
  void move();
  void memorize(int halfedge);
  void clear_memory();
  void check_solved();
  void note_best();
  [[nodiscard]] int draw_bound();
  [[nodiscard]] int fresh_restarts() const;
  [[nodiscard]] bool has_lost_patience() const;
  [[nodiscard]] bool is_cancelled() const { return progress_ != nullptr && progress_->is_cancelled(); }
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  const DualGraph* dual_;
  const SearchModel* model_;
  SearchSettings settings_;
  const Progress* progress_;
  std::vector<char> from_;  // folds to start from, or empty
  Random random_;
  SearchState state_;
  Climb climb_;
  std::size_t n_up_ = 0;  // how many folds of the path lead towards the preorder's root
  int stuck_face_ = -1;

  std::vector<int> memory_;      // the tabu list: a ring of re-attachments that may not be undone
  std::vector<int> times_tabu_;  // per halfedge
  std::size_t memory_next_ = 0;

  std::vector<std::int64_t> collisions_;  // per face
  std::vector<char> best_folds_;
  int best_overlaps_ = 0;
  bool is_solved_ = false;
  std::int64_t iterations_ = 0;
  std::int64_t last_gain_ = 0;  // iteration of the episode's last new fewest
  int episode_best_ = 0;
  std::int64_t moves_ = 0;
  std::int64_t moves_since_check_ = 0;
  std::int64_t logged_moves_ = 0;
  int restarts_ = 0;
  std::vector<SearchEpisode> episodes_;
};

}  // namespace netwright
