// Takes a cut at random and makes it a fold in place of one on the loop that it closes. What that changes of
// cuts, spread and necks is known without moving anything; only exchanges that pass are asked for overlaps,
// and only nets that were made are measured as a whole.
#include "core/solve/polish.h"

#include <algorithm>
#include <cmath>

#include "core/base/predicates.h"

namespace netwright {

namespace {

// Temperatures, in units of cost: in a model of 200 faces a cut of average length costs about 0.02.
constexpr double kHot = 0.03;
constexpr double kWarm = 0.01;  ///< where further cycles begin
constexpr double kCold = 0.001;
constexpr double kUsualFaces = 400;

constexpr int kMostTries = 4;              ///< exchanges for one cut that are asked for overlaps
constexpr double kWorkOfSecond = 920'000;  ///< tests for overlaps, as a two-core x86-64 machine does them
constexpr double kWorkPerFace = 4'600;     ///< small models are done sooner
constexpr double kFacesPerTest = 60;       ///< making an exchange costs as much as testing one per so many
constexpr double kStepsPerTest = 40;       ///< folds on a loop that take as long to look at as one test
constexpr int kRounds = 16;                ///< in an effort of 1
constexpr int kAppliesBetweenChecks = 2000;
constexpr double kNothing = 1e-9;  ///< of cost

}  // namespace

class Polisher::Search {
 public:
  Search(const DualGraph& dual, const SearchModel& model, const std::vector<char>& folds, PolishTask task,
         Random random, const Progress& progress)
      : model_(model),
        progress_(progress),
        random_(random),
        state_(model, kSolveDepth),
        cost_(dual, model, state_with(folds), std::move(task)),
        best_folds_(folds),
        proved_folds_(folds) {
    now_ = best_ = proved_ = cost_.measure();
    cooling_ = std::min(1.0, kUsualFaces / model.n_faces);
    unit_ = std::min(kWorkOfSecond, kWorkPerFace * model.n_faces);
    left_ = settings().effort * unit_;
    for (int h = 0; h < model.n_halfedges; ++h)
      if (model.twin[at(h)] >= 0) hinges_.push_back(h);
    cycle_ = settings().fits_paper > 0 ? std::min(unit_, left_) : left_;
  }

  bool advance() {
    // A tree that has all hinges as folds is the only one.
    if (left_ <= 0 || is_content() || hinges_.size() < 2 * at(model_.n_faces)) return false;
    const double end = std::min(cycle_, done_ + std::min(cycle_, unit_) / kRounds);
    while (done_ < end && !progress_.is_cancelled()) improve();
    keep_best();
    if (done_ >= cycle_) end_cycle();
    return left_ > 0 && !is_content();
  }

  [[nodiscard]] double fraction() const {
    const double all = settings().effort * unit_;
    return all > 0 ? std::clamp((all - left_ + done_) / all, 0.0, 1.0) : 1;
  }
  [[nodiscard]] const std::vector<char>& folds() const { return proved_folds_; }
  [[nodiscard]] const NetCosts& costs() const { return proved_; }

 private:
  struct Candidate {
    double cost;
    int child;
    int removed;
    int necks;
  };
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  [[nodiscard]] const PolishSettings& settings() const { return cost_.task().settings; }

  const SearchState& state_with(const std::vector<char>& folds) {
    state_.set_tree(folds);
    return state_;
  }

  // A net that has to fit is tried for again and again, for longer each time, from the best one so far.
  void end_cycle() {
    left_ -= done_;
    done_ = 0;
    has_cycled_ = true;
    hot_ = kWarm;
    if (left_ <= 0 || is_content()) return;
    restore(proved_folds_);
    cycle_ = std::min(2 * cycle_, left_);
  }

  /// Nothing left to wish for; where a page is to be fit, that it fits, once a cycle has been done.
  [[nodiscard]] bool is_content() const {
    return proved_.sum <= kNothing || (settings().fits_paper > 0 && has_cycled_ && proved_.size <= 1);
  }

  void improve() {
    const double temperature = cooling_ * hot_ * std::pow(kCold / hot_, done_ / cycle_);
    done_ += 1 / kStepsPerTest;
    const int wanted = hinges_[at(random_.below(static_cast<int>(hinges_.size())))];
    if (state_.is_fold(wanted)) return;
    // Drawn first, so that hopeless exchanges are seen early.
    const double bound = -temperature * std::log(1 - random_.unit());
    find_candidates(wanted, bound, temperature);
    for (int tries = 0; tries < kMostTries && !candidates_.empty(); ++tries) {
      const auto best = std::ranges::min_element(candidates_, {}, &Candidate::cost);
      const Candidate candidate = *best;
      *best = candidates_.back();
      candidates_.pop_back();
      if (take(candidate, wanted, bound)) return;
    }
  }

  // Folds of the loop whose exchange is within the bound as far as can be told without making it. The costs
  // are blurred, so that not always the same fold is taken (Gumbel noise: as likely as by their weights).
  void find_candidates(int wanted, double bound, double temperature) {
    state_.find_path(model_.face_of[at(wanted)], model_.beyond(wanted), path_);
    done_ += static_cast<double>(path_.size()) / kStepsPerTest;
    candidates_.clear();
    // Size and root are not known before.
    const double hopeless = bound + (settings().fits_paper + settings().root_in_middle > 0 ? temperature : 0);
    for (const PathStep& step : path_) {
      const int up = state_.up(step.child);
      const int removed = step.near_is_child ? up : model_.twin[at(up)];
      if (!model_.may_exchange(removed, wanted)) continue;
      const auto [cost, necks] = cost_.change(now_, state_.exchange(step.child, removed, wanted), hopeless);
      if (cost >= hopeless) continue;
      const double noise = -temperature * std::log(-std::log(1 - random_.unit()) + 1e-300);
      candidates_.push_back({cost - noise, step.child, removed, necks});
    }
  }

  bool take(const Candidate& candidate, int wanted, double bound) {
    const Exchange exchange = state_.exchange(candidate.child, candidate.removed, wanted);
    done_ += 1;
    if (state_.count_after(exchange, 1) > 0) return false;
    apply(exchange);
    NetCosts next = now_;
    next.cuts += cost_.cut_cost(candidate.removed) - cost_.cut_cost(wanted);
    next.necks += candidate.necks;
    cost_.update(next);
    if (next.sum - now_.sum >= bound) {
      const int face = model_.face_of[at(wanted)];
      const int child = state_.up(face) == wanted ? face : model_.beyond(wanted);
      apply(state_.exchange(child, wanted, candidate.removed));
      cost_.update(now_);
      return false;
    }
    now_ = next;
    if (now_.sum < best_.sum - kNothing && state_.overlaps() == 0) {
      best_ = now_;
      best_folds_ = state_.folds();
    }
    if (n_applies_ >= kAppliesBetweenChecks) restore(std::vector<char>(state_.folds()));
    return true;
  }

  void apply(const Exchange& exchange) {
    state_.apply(exchange);
    done_ += model_.n_faces / kFacesPerTest;
    ++n_applies_;
  }

  // Places and counts anew: ends the drift of many small motions.
  void restore(const std::vector<char>& folds) {
    state_.set_tree(folds);
    n_applies_ = 0;
    if (state_.overlaps() > 0) {  // a contact that only the path of moves had hidden
      state_.set_tree(proved_folds_);
      best_ = proved_;
      best_folds_ = proved_folds_;
    }
    now_ = cost_.measure();
  }

  // The best net counts once it has been placed anew.
  void keep_best() {
    if (best_folds_ == proved_folds_) return;
    const std::vector<char> folds = state_.folds();
    state_.set_tree(best_folds_);
    const NetCosts costs = cost_.measure();
    if (state_.overlaps() == 0 && costs.sum < proved_.sum) {
      proved_folds_ = best_folds_;
      best_ = proved_ = costs;
    }
    restore(folds);
  }

  const SearchModel& model_;
  const Progress& progress_;
  Random random_;
  SearchState state_;
  NetCost cost_;
  std::vector<int> hinges_;  ///< halfedges that may be folds
  std::vector<PathStep> path_;
  std::vector<Candidate> candidates_;
  NetCosts now_;
  NetCosts best_;
  NetCosts proved_;
  std::vector<char> best_folds_;
  std::vector<char> proved_folds_;
  double unit_ = 0;          ///< work of an effort of 1
  double left_ = 0;          ///< work of this cycle and all after it
  double cycle_ = 0;         ///< work of this cycle
  double done_ = 0;          ///< of it
  bool has_cycled_ = false;  ///< one cycle at least is over
  double hot_ = kHot;
  double cooling_ = 1;  ///< of a large model, where an exchange changes less of the whole
  int n_applies_ = 0;
};

Polisher::Polisher(const DualGraph& dual, const SearchModel& model, const std::vector<char>& folds,
                   PolishTask task, Random random, const Progress& progress)
    : search_(std::make_unique<Search>(dual, model, folds, std::move(task), random, progress)) {}
Polisher::~Polisher() = default;

bool Polisher::advance() { return search_->advance(); }
double Polisher::fraction() const { return search_->fraction(); }
const std::vector<char>& Polisher::best_folds() const { return search_->folds(); }
const NetCosts& Polisher::best() const { return search_->costs(); }

}  // namespace netwright
