// Algorithm 3 of the paper with the accelerations named in SearchSettings. Section numbers are the paper's.
#include "core/solve/tabu_solver.h"

#include <algorithm>
#include <cmath>

#include "core/base/predicates.h"
#include "core/solve/start_tree.h"

namespace netwright {

namespace {

// Incremental placements drift by a rounding per move; after so many they are computed anew from the tree.
constexpr std::int64_t kMovesBetweenChecks = 2000;
// The log feeds the replay; beyond this many moves the oldest episodes are let go.
constexpr std::int64_t kLoggedMoves = 500'000;
constexpr int kUnbounded = 1 << 29;
// A search from a given tree comes back to it this often before it starts anew like any other.
constexpr int kRestartsFromHere = 3;
// Patience ends at a million times the first: long before, whoever waits has stopped the search.
constexpr int kMostDoublings = 20;

// m = val · log_val |F| (4.4), at least one.
std::size_t memory_length(const SearchModel& model) {
  const double val = std::max(model.mean_valence, 1.5);
  return static_cast<std::size_t>(
      std::max(1.0, val * std::log(static_cast<double>(model.n_faces)) / std::log(val)));
}

}  // namespace

TabuSolver::TabuSolver(const DualGraph& dual, const SearchModel& model, const SearchSettings& settings,
                       std::uint64_t seed, std::uint64_t stream, const Progress* progress,
                       std::vector<char> from)
    : dual_(&dual),
      model_(&model),
      settings_(settings),
      progress_(progress),
      from_(std::move(from)),
      random_(seed, stream),
      state_(model, kSolveDepth, best_box_kernel(), settings.uses_killers) {
  memory_.assign(memory_length(model), -1);
  times_tabu_.assign(at(model.n_halfedges), 0);
  collisions_.assign(at(model.n_faces), 0);
  best_overlaps_ = kUnbounded;
  start();
  check_solved();
}

void TabuSolver::start() {
  state_.set_tree(start_folds());
  clear_memory();
  stuck_face_ = -1;
  last_gain_ = iterations_;
  episode_best_ = state_.overlaps();
  if (logged_moves_ > kLoggedMoves) {
    episodes_.clear();
    logged_moves_ = 0;
  }
  episodes_.push_back({state_.folds(), state_.overlaps(), {}});
  note_best();
}

// From where the user wants it, while that helps; else anew.
std::vector<char> TabuSolver::start_folds() {
  if (!from_.empty() && restarts_ <= kRestartsFromHere) return pinned_folds(*model_, from_);
  if (settings_.greedy_start) return greedy_folds(*model_, random_, kSolveDepth, progress_);
  return pinned_folds(*model_, steepest_edge_folds(*dual_, *model_, random_));
}

void TabuSolver::step() {
  if (is_solved_) return;
  ++iterations_;
  choose_face();
  choose_root();
  count_crossings();
  climb();
  if (climb_.best.is_found) {
    move();
    check_solved();
  } else if (!climb_.saw_free && climb_.saw_tabu) {
    clear_memory();  // every way is barred by the memory alone (4.4)
  } else if (!climb_.saw_free) {
    stuck_face_ = climb_.chosen;  // root lock: all neighbours lie in the face's own subtree (4.5)
  }
  if (!is_solved_ && has_lost_patience()) {
    ++restarts_;
    start();
    check_solved();
  }
}

// How often the search began with a tree of its own: coming back to a given tree teaches nothing about heat.
int TabuSolver::fresh_restarts() const {
  if (settings_.cooling_restarts == 0) return 0;
  return from_.empty() ? restarts_ : std::max(0, restarts_ - kRestartsFromHere);
}

bool TabuSolver::has_lost_patience() const {
  const std::int64_t patience = static_cast<std::int64_t>(settings_.restart_after) * model_->n_faces;
  return iterations_ - last_gain_ > patience << std::min(fresh_restarts(), kMostDoublings);
}

// A random overlapping face (4.3), or the one that was stuck.
void TabuSolver::choose_face() {
  const auto& faces = state_.overlapping_faces();
  climb_.chosen = faces[at(random_.below(static_cast<int>(faces.size())))];
  if (stuck_face_ >= 0 && std::find(faces.begin(), faces.end(), stuck_face_) != faces.end())
    climb_.chosen = stuck_face_;
  ++collisions_[at(climb_.chosen)];
}

// The paper roots the tree at random in every step (4.5). At an overlap partner, the climb covers exactly the
// folds between the two faces, at least one of which has to change.
void TabuSolver::choose_root() {
  const int x = climb_.chosen;
  if (x == stuck_face_) {
    climb_.root = face_behind_stuck();
    stuck_face_ = -1;
  } else if (settings_.random_root_share >= 1 || random_.unit() < settings_.random_root_share) {
    climb_.root = random_.below(model_->n_faces);
  } else {
    climb_.root = x;
  }
  if (climb_.root == x && settings_.random_root_share < 1) {
    int n = 0;
    for (const auto& [a, b] : state_.pairs())
      if ((a == x || b == x) && random_.below(++n) == 0) climb_.root = a == x ? b : a;
  }
  state_.find_path(x, climb_.root, climb_.path);
  n_up_ = 0;
  while (n_up_ < climb_.path.size() && climb_.path[n_up_].near_is_child) ++n_up_;
}

// Reroots into the stuck face's own subtree, so that the climb from it runs the other way (4.5).
int TabuSolver::face_behind_stuck() {
  if (climb_.path.empty()) return random_.below(model_->n_faces);
  const PathStep& step = climb_.path.front();
  const int first = state_.position(step.child);
  const int size = state_.end(step.child) - first;
  if (step.near_is_child) return state_.face_at(first + random_.below(size));
  const int i = random_.below(model_->n_faces - size);
  return state_.face_at(i < first ? i : i + size);
}

// The sides of the folds on the path that hold the chosen face are nested. Number of the first one that holds
// this face, or the number of folds: subtrees that grow up to the turn of the path, then the rest of subtrees
// that shrink.
int TabuSolver::first_side_with(int face) const {
  const auto turn = climb_.path.begin() + static_cast<std::ptrdiff_t>(n_up_);
  const auto above = std::partition_point(
      climb_.path.begin(), turn, [&](const PathStep& s) { return !state_.in_subtree(face, s.child); });
  if (above != turn) return static_cast<int>(above - climb_.path.begin());
  const auto below = std::partition_point(
      turn, climb_.path.end(), [&](const PathStep& s) { return state_.in_subtree(face, s.child); });
  return static_cast<int>(below - climb_.path.begin());
}

// How many stored overlaps every fold on the path separates: a pair whose faces first appear in sides a < b
// is separated by folds a … b-1.
void TabuSolver::count_crossings() {
  climb_.crossings.assign(climb_.path.size() + 1, 0);
  for (const auto& [a, b] : state_.pairs()) {
    const int x = first_side_with(a);
    const int y = first_side_with(b);
    if (x == y) continue;
    ++climb_.crossings[at(std::min(x, y))];
    --climb_.crossings[at(std::max(x, y))];
  }
  for (std::size_t i = 1; i < climb_.crossings.size(); ++i) climb_.crossings[i] += climb_.crossings[i - 1];
}

// The worst change a move may bring, drawn before the climb: a Metropolis rule turned into a bound, so that
// counting can stop early from the first candidate on. The paper takes the best move however bad. From
// one start tree the temperature stays the same: phases of cooling freeze large models.
int TabuSolver::draw_bound() {
  if (!settings_.bounds_worsening) return kUnbounded;
  const int n = fresh_restarts();
  const double temperature =
      n == 0 ? settings_.temperature : std::ldexp(settings_.temperature, -(n % settings_.cooling_restarts));
  return static_cast<int>(-temperature * std::log(1 - random_.unit())) + 1;
}

// From the chosen face to the root: the first fold with an improving exchange wins, else the best on the way
// (4.3).
void TabuSolver::climb() {
  climb_.bound = draw_bound();
  climb_.saw_tabu = climb_.saw_free = false;
  climb_.best = {};
  for (std::size_t i = 0; i < climb_.path.size() && !is_cancelled(); ++i) {
    if (!is_kept(climb_.path[i])) try_fold(climb_.path[i], climb_.crossings[i]);
    if (climb_.best.is_found && climb_.best.delta < 0) return;
  }
}

bool TabuSolver::is_kept(const PathStep& step) const {
  return model_->is_pinned && model_->is_kept[at(state_.up(step.child))] != 0;
}

// Exchanges that replace this fold: its near face re-attached on the far side (4.3); two-sided, its far face
// re-attached on the near side; and some that join the sides elsewhere along the cut between them.
void TabuSolver::try_fold(const PathStep& step, int crossing) {
  const int up = state_.up(step.child);
  const int near_link = step.near_is_child ? up : model_->twin[at(up)];
  try_across(step.near, step, crossing, near_link);
  if (settings_.two_sided) try_across(step.far, step, crossing, model_->twin[at(near_link)]);
  if (settings_.sampled_faces > 0) try_sampled(step, crossing);
}

void TabuSolver::try_sampled(const PathStep& step, int crossing) {
  const int first = state_.position(step.child);
  const int n_inside = state_.end(step.child) - first;
  const int n_outside = model_->n_faces - n_inside;
  const bool is_inside = n_inside <= n_outside;
  if (std::min(n_inside, n_outside) < 2) return;  // a single face has been tried
  const int up = state_.up(step.child);
  const int link = is_inside ? up : model_->twin[at(up)];
  for (int k = 0; k < settings_.sampled_faces; ++k) {
    const int i = random_.below(is_inside ? n_inside : n_outside);
    const int position = is_inside ? first + i : (i < first ? i : i + n_inside);
    try_across(state_.face_at(position), step, crossing, link);
  }
}

// All cuts of this face that lead to the other side of the fold, tried as folds.
void TabuSolver::try_across(int face, const PathStep& step, int crossing, int removed) {
  const SearchModel& m = *model_;
  const bool is_inside = state_.in_subtree(face, step.child);
  for (int h = m.face_begin[at(face)]; h < m.face_begin[at(face) + 1]; ++h)
    if (m.twin[at(h)] >= 0 && !state_.is_fold(h) && state_.in_subtree(m.beyond(h), step.child) != is_inside &&
        m.may_exchange(removed, h))
      try_reattach(h, step, crossing, removed);
}

void TabuSolver::try_reattach(int halfedge, const PathStep& step, int crossing, int removed) {
  if (times_tabu_[at(halfedge)] > 0) {
    climb_.saw_tabu = true;
    return;
  }
  climb_.saw_free = true;
  const int limit = climb_.bound + crossing;
  if (limit <= 0) return;
  const Exchange exchange = state_.exchange(step.child, removed, halfedge);
  const int count = settings_.counts_as_paper
                        ? state_.count_as_paper(exchange)
                        : state_.count_after(exchange, settings_.counts_bounded ? limit : kUnbounded);
  if (count >= limit) return;
  climb_.bound = count - crossing;
  climb_.best = {exchange, count - crossing, true};
}

void TabuSolver::move() {
  carry_out(climb_.best.exchange);
  memorize(climb_.best.exchange.removed);
  if (moves_since_check_ >= kMovesBetweenChecks) {
    state_.recompute();
    moves_since_check_ = 0;
  }
  if (state_.overlaps() < episode_best_) {
    episode_best_ = state_.overlaps();
    last_gain_ = iterations_;
  }
  note_best();
}

void TabuSolver::carry_out(const Exchange& exchange) {
  state_.apply(exchange);
  ++moves_;
  ++moves_since_check_;
  ++logged_moves_;
  episodes_.back().moves.push_back(
      {climb_.chosen, climb_.root, exchange.removed, exchange.inserted, state_.overlaps()});
}

// What left the tree may not come back while it is remembered (4.4).
void TabuSolver::memorize(int halfedge) {
  int& slot = memory_[memory_next_];
  if (slot >= 0) --times_tabu_[at(slot)];
  slot = halfedge;
  ++times_tabu_[at(halfedge)];
  memory_next_ = (memory_next_ + 1) % memory_.size();
}

void TabuSolver::clear_memory() {
  std::fill(memory_.begin(), memory_.end(), -1);
  std::fill(times_tabu_.begin(), times_tabu_.end(), 0);
  memory_next_ = 0;
}

void TabuSolver::note_best() {
  if (state_.overlaps() >= best_overlaps_) return;
  best_overlaps_ = state_.overlaps();
  best_folds_ = state_.folds();
}

void TabuSolver::return_home() {
  if (!is_solved_ || from_.empty()) return;
  const std::vector<char> folds = state_.folds();
  for (bool has_changed = true; has_changed && !is_cancelled();) {
    has_changed = false;
    for (int h = 0; h < model_->n_halfedges; ++h)
      if (from_[at(h)] != 0 && model_->twin[at(h)] > h && !state_.is_fold(h)) has_changed |= take_back(h);
  }
  state_.recompute();
  if (state_.overlaps() > 0) state_.set_tree(folds);
  best_folds_ = state_.folds();
}

// Makes a fold of the start a fold again, in place of one that was not there then.
bool TabuSolver::take_back(int wanted) {
  const SearchModel& m = *model_;
  state_.find_path(m.face_of[at(wanted)], m.beyond(wanted), climb_.path);
  for (const PathStep& step : climb_.path) {
    const int up = state_.up(step.child);
    const int removed = step.near_is_child ? up : m.twin[at(up)];
    if (from_[at(removed)] != 0 || !m.may_exchange(removed, wanted)) continue;
    const Exchange exchange = state_.exchange(step.child, removed, wanted);
    if (state_.count_after(exchange, 1) > 0) continue;
    climb_.chosen = step.near;
    climb_.root = step.far;
    carry_out(exchange);
    return true;
  }
  return false;
}

void TabuSolver::check_solved() {
  if (state_.overlaps() > 0) return;
  state_.recompute();
  moves_since_check_ = 0;
  is_solved_ = state_.overlaps() == 0;
  if (!is_solved_) best_overlaps_ = std::max(1, state_.overlaps());
}

}  // namespace netwright
