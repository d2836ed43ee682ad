// Runs one portfolio per component of the mesh, then lays the whole out, detects anew, has it proved, and
// finishes it.
#include "core/solve/solve.h"

#include <algorithm>

#include "core/base/cpu_time.h"
#include "core/base/error.h"
#include "core/base/predicates.h"
#include "core/solve/finish.h"
#include "core/solve/portfolio.h"
#include "core/solve/prove_impossible.h"
#include "core/solve/showing.h"
#include "core/unfold/obstruction.h"

namespace netwright {

namespace {

// A net that the search claims and the proof refuses is searched for again with other random numbers: the two
// use different arithmetic, and a contact may sit between their tolerances.
constexpr int kAttempts = 3;

// Iterations after which it is asked, once, whether there is a net at all; nearly all searches are over long
// before. Larger models would take too long to ask.
constexpr std::int64_t kProveAfter = 5000;
constexpr std::size_t kMostFacesToProve = 1000;

SearchSettings settings(const SolveOptions& options) {
  return options.search == SearchStyle::Paper ? SearchSettings::paper() : SearchSettings::fast();
}

class SolveJob {
 public:
  SolveJob(std::shared_ptr<const DualGraph> dual, const SolveOptions& options, Progress& progress,
           const SolveHooks& hooks)
      : dual_(std::move(dual)),
        options_(options),
        progress_(progress),
        hooks_(hooks),
        models_(search_models(*dual_, options.pins)),
        own_pool_(hooks.pool == nullptr ? std::make_unique<ThreadPool>(n_threads(options)) : nullptr),
        pool_(hooks.pool == nullptr ? *own_pool_ : *hooks.pool),
        whole_(dual_, options.pins.root) {}

  SolveResult run() {
    find_isolated();
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      search(attempt);
      collect();
      if (result_.overlaps.empty()) prove();
      if (result_.is_proved || !is_claimed() || progress_.is_cancelled()) break;
    }
    if (result_.is_proved && !progress_.is_cancelled())
      Finish(dual_, models_, options_, progress_, whole_, *showing_, result_).run();
    showing_->finish(result_.net, result_.overlaps);
    result_.was_cancelled = progress_.is_cancelled() && !result_.is_proved;
    return std::move(result_);
  }

 private:
  void search(int attempt) {
    portfolios_.clear();
    for (std::size_t c = 0; c < models_.size(); ++c) {
      const std::uint64_t first_stream = (static_cast<std::uint64_t>(attempt) << 48) + (c << 16);
      portfolios_.push_back(std::make_unique<Portfolio>(*dual_, models_[c], settings(options_), options_.seed,
                                                        options_.streams, first_stream, pool_, progress_,
                                                        folds_to_start_from(models_[c])));
      whole_.set(models_[c], portfolios_[c]->stream(portfolios_[c]->lead()).state().folds());
    }
    showing_ = std::make_unique<Showing>(whole_, models_, portfolios_, hooks_);
    for (std::size_t c = 0; c < models_.size(); ++c) {
      Portfolio& portfolio = *portfolios_[c];
      showing_->begin(c);
      while (!is_impossible() && !portfolio.is_solved() && !progress_.is_cancelled() &&
             (options_.max_iterations == 0 || portfolio.mark() < options_.max_iterations)) {
        showing_->before_round();
        portfolio.advance(options_.max_iterations);
        if (!showing_->after_round()) progress_.cancel();
        if (portfolio.mark() >= kProveAfter && !portfolio.is_solved()) ask_if_possible();
      }
      if (options_.stays_near) portfolio.return_home();
      whole_.set(models_[c], portfolio.stream(portfolio.best()).best_folds());
    }
    const double before = thread_cpu_seconds();
    result_.net = whole_.net();
    result_.overlaps = find_overlaps(result_.net, kShownDepth);
    result_.cpu_seconds += thread_cpu_seconds() - before;
  }

  [[nodiscard]] bool is_impossible() const {
    return result_.isolated_face.is_valid() || result_.impossible != nullptr;
  }

  void find_isolated() {
    result_.isolated_face = find_isolated_face(*dual_);
    if (!result_.isolated_face.is_valid()) return;
    auto proof =
        std::make_shared<ImpossibilityProof>(isolated_face_proof(dual_->mesh(), result_.isolated_face));
    if (verify_impossible(dual_->mesh(), *proof).is_proved) result_.impossible = std::move(proof);
  }

  void ask_if_possible() {
    if (has_asked_ || dual_->mesh().n_faces() > kMostFacesToProve) return;
    has_asked_ = true;
    const double before = thread_cpu_seconds();
    ProveResult answer = prove_impossible(dual_, {}, progress_);
    if (answer.answer == ProveAnswer::Proved)
      result_.impossible = std::make_shared<const ImpossibilityProof>(std::move(answer.proof));
    result_.cpu_seconds += thread_cpu_seconds() - before;
  }

  [[nodiscard]] std::vector<char> folds_to_start_from(const SearchModel& model) const {
    std::vector<char> folds;
    if (options_.from != nullptr)
      for (const HalfedgeId h : model.mesh_halfedge)
        folds.push_back(options_.from->is_fold(dual_->mesh(), dual_->mesh().edge(h)) ? 1 : 0);
    return folds;
  }

  [[nodiscard]] bool is_claimed() const {
    return std::all_of(portfolios_.begin(), portfolios_.end(), [](const auto& p) { return p->is_solved(); });
  }

  // Figures and the replay's log of the streams that won (or came nearest).
  void collect() {
    result_.iterations = result_.moves = result_.restarts = 0;
    result_.log.clear();
    WholeTree replay(dual_, options_.pins.root);
    result_.collisions = IdVector<FaceId, std::int64_t>(dual_->mesh().n_faces(), 0);
    for (std::size_t c = 0; c < models_.size(); ++c)
      replay.set(models_[c], portfolios_[c]->stream(portfolios_[c]->best()).episodes().front().start_folds);
    for (std::size_t c = 0; c < models_.size(); ++c) {
      const Portfolio& portfolio = *portfolios_[c];
      const TabuSolver& solver = portfolio.stream(portfolio.best());
      result_.stream = portfolio.best();
      result_.iterations += solver.iterations();
      result_.moves += solver.moves();
      result_.restarts += solver.restarts();
      result_.cpu_seconds += portfolio.cpu_seconds();
      add_collisions(c);
      for (const SearchEpisode& episode : solver.episodes()) {
        replay.set(models_[c], episode.start_folds);
        Episode shown{replay.tree(), episode.overlaps_at_start, {}, false};
        for (const auto& move : episode.moves) shown.moves.push_back(to_record(models_[c], move));
        result_.log.push_back(std::move(shown));
      }
      replay.set(models_[c], solver.best_folds());
    }
  }

  void add_collisions(std::size_t c) {
    for (int k = 0; k < portfolios_[c]->n_streams(); ++k) {
      const std::vector<std::int64_t>& counts = portfolios_[c]->stream(k).collisions();
      for (std::size_t f = 0; f < counts.size(); ++f)
        result_.collisions[models_[c].mesh_face[f]] += counts[f];
    }
  }

  void prove() {
    const double before = thread_cpu_seconds();
    result_.proof = verify(to_flat_net(result_.net, 1), static_cast<int>(models_.size()));
    result_.is_proved = result_.proof.is_net;
    result_.verify_seconds += thread_cpu_seconds() - before;
  }

  std::shared_ptr<const DualGraph> dual_;
  const SolveOptions& options_;
  Progress& progress_;
  const SolveHooks& hooks_;
  std::vector<SearchModel> models_;
  std::unique_ptr<ThreadPool> own_pool_;
  ThreadPool& pool_;
  WholeTree whole_;
  std::vector<std::unique_ptr<Portfolio>> portfolios_;
  std::unique_ptr<Showing> showing_;
  SolveResult result_;
  bool has_asked_ = false;  ///< whether there can be a net
};

}  // namespace

int n_threads(const SolveOptions& options) {
  const int wanted = options.threads > 0 ? options.threads : ThreadPool::hardware_threads();
  return std::clamp(wanted, 1, std::max(1, options.streams));
}

SolveResult solve(std::shared_ptr<const DualGraph> dual, const SolveOptions& options, Progress& progress,
                  const SolveHooks& hooks) {
  if (const auto contradiction = find_contradiction(*dual, options.pins))
    throw Error(ErrorKind::Unfit, contradiction->sentence);
  return SolveJob(std::move(dual), options, progress, hooks).run();
}

}  // namespace netwright
