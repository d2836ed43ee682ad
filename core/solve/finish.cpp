// Works on one component after the other, in states of its own: the searches that found the net are over.
#include "core/solve/finish.h"

#include <limits>
#include <optional>

#include "core/base/cpu_time.h"
#include "core/base/predicates.h"
#include "core/solve/tab_room.h"
#include "core/unfold/net_size.h"

namespace netwright {

namespace {

// Random numbers apart from those of the streams, which are numbered from 0.
constexpr std::uint64_t kPolishStream = 1ULL << 62;
constexpr std::uint64_t kTabStream = 1ULL << 63;

/// How many cuts without a tab a unit of polish is worth: an exchange changes that by some hundredths.
constexpr double kTabsPerPolish = 10;

/// Down to this share of a cost there is no new net in the log.
constexpr double kLoggedGain = 0.99;

}  // namespace

Finish::Finish(std::shared_ptr<const DualGraph> dual, const std::vector<SearchModel>& models,
               const SolveOptions& options, Progress& progress, WholeTree& whole, Showing& showing,
               SolveResult& result)
    : dual_(std::move(dual)),
      models_(&models),
      options_(&options),
      progress_(&progress),
      whole_(&whole),
      showing_(&showing),
      result_(&result) {}

void Finish::run() {
  const double before = thread_cpu_seconds();
  if (options_->polish && options_->polish->settings.effort > 0 && !options_->stays_near) polish();
  if (options_->tabs && options_->tabs->settings.is_on) make_room_for_tabs();
  if (result_->polished) tell_what_is_left();
  result_->finish_seconds = thread_cpu_seconds() - before;
}

std::vector<char> Finish::folds_of(std::size_t c) const {
  std::vector<char> folds;
  for (const HalfedgeId h : (*models_)[c].mesh_halfedge)
    folds.push_back(result_->net.tree.is_fold(dual_->mesh(), dual_->mesh().edge(h)) ? 1 : 0);
  return folds;
}

// The net with these folds of one component takes the place of the present one, if it is one.
bool Finish::take(std::size_t c, const std::vector<char>& folds) {
  const std::vector<char> old = folds_of(c);
  if (folds == old) return false;
  whole_->set((*models_)[c], folds);
  Net net = whole_->net();
  const VerifyReport proof = verify(to_flat_net(net, 1), static_cast<int>(models_->size()));
  if (!proof.is_net) {
    whole_->set((*models_)[c], old);
    return false;
  }
  result_->net = std::move(net);
  result_->proof = proof;
  return true;
}

// One net in the log for every step of a hundredth: long runs make thousands of small ones.
void Finish::log(double cost) {
  std::vector<Episode>& log = result_->log;
  if (log.back().is_polish && cost > kLoggedGain * logged_cost_) {
    log.back().start = result_->net.tree;
    log.back().polish_fraction = view_.fraction;
    return;
  }
  log.push_back({result_->net.tree, 0, {}, true, view_.fraction});
  logged_cost_ = cost;
}

// What the chart shows of the present net: worth its while only where somebody looks.
void Finish::add_station() {
  if (!showing_->is_watched()) return;
  const Net& net = result_->net;
  view_.stations.push_back({view_.fraction, cut_length(net), paper_area(piece_hulls(net))});
}

// Told of the net that is the result: one that was refused, and what tabs cost afterwards, must not be left
// out.
void Finish::tell_what_is_left() {
  PolishReport& report = *result_->polished;
  report.necks_after = 0;
  report.size_after = 0;
  report.root_off = 0;
  for (std::size_t c = 0; c < models_->size(); ++c) {
    SearchState state((*models_)[c], kSolveDepth);
    state.set_tree(folds_of(c));
    const NetCosts costs = NetCost(*dual_, (*models_)[c], state, task_of(c)).measure();
    report.necks_after += costs.necks;
    report.size_after = std::max(report.size_after, costs.size);
    report.root_off = std::max(report.root_off, costs.root);
  }
}

PolishTask Finish::task_of(std::size_t c) const {
  return polish_task(*dual_, (*models_)[c], *options_->polish, result_->polished->scale, options_->pins.root);
}

void Finish::polish() {
  PolishReport& report = result_->polished.emplace();
  report.first = result_->net.tree;
  report.scale = options_->polish->scale(result_->net);
  add_station();
  for (std::size_t c = 0; c < models_->size() && !progress_->is_cancelled(); ++c) polish_component(c);
}

void Finish::polish_component(std::size_t c) {
  Polisher polisher(*dual_, (*models_)[c], folds_of(c), task_of(c), Random(options_->seed, kPolishStream + c),
                    *progress_);
  PolishReport& report = *result_->polished;
  report.necks_before += polisher.best().necks;
  report.size_before = std::max(report.size_before, polisher.best().size);
  const auto n = static_cast<double>(models_->size());
  double cost = polisher.best().sum;
  logged_cost_ = std::numeric_limits<double>::infinity();
  view_.costs.push_back(cost);
  bool goes_on = true;
  while (goes_on && !progress_->is_cancelled()) {
    goes_on = polisher.advance();
    view_.fraction = (static_cast<double>(c) + polisher.fraction()) / n;
    if (take(c, polisher.best_folds())) {
      log(cost = polisher.best().sum);
      add_station();
    }
    view_.costs.push_back(cost);
    if (!showing_->show_polished(result_->net, view_)) progress_->cancel();
  }
}

void Finish::make_room_for_tabs() {
  const double scale = options_->tabs->scale(result_->net);
  result_->tabless_before = result_->tabless_after = 0;
  for (std::size_t c = 0; c < models_->size(); ++c) find_room(c, scale);
}

void Finish::find_room(std::size_t c, double scale) {
  const SearchModel& model = (*models_)[c];
  SearchState state(model, kSolveDepth);
  state.set_tree(folds_of(c));
  const TabRoom room(*dual_, model, scale, options_->tabs->settings);
  std::optional<NetCost> polish;
  if (result_->polished) polish.emplace(*dual_, model, state, task_of(c));
  const auto judge = [&](const SearchState& net) {
    Judgement judgement = room(net);
    if (polish) judgement.cost += kTabsPerPolish * polish->measure().sum;
    return judgement;
  };
  Random random(options_->seed, kTabStream + c);
  const auto n_without = [&] { return static_cast<int>(room(state).cost); };
  const int before = n_without();
  refine(state, judge, options_->tabs->looks_per_face * model.n_faces, random, progress_);
  result_->tabless_before += before;
  const bool is_taken = take(c, state.folds());
  result_->tabless_after += is_taken ? n_without() : before;
  if (!is_taken) return;
  result_->log.push_back({result_->net.tree, 0, {}, true, 1});
  if (!polish) return;
  view_.fraction = 1;
  add_station();
  showing_->tell_polish(view_);
}

}  // namespace netwright
