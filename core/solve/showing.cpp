// Snapshots of a search in progress. Costs nothing when nobody takes them.
#include "core/solve/showing.h"

#include <algorithm>

#include "core/base/predicates.h"

namespace netwright {

namespace {

constexpr std::int64_t kHistoryValues = 2000;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

WholeTree::WholeTree(std::shared_ptr<const DualGraph> dual, FaceId root) : dual_(std::move(dual)) {
  const Mesh& mesh = dual_->mesh();
  is_fold_.assign(mesh.n_edges(), 0);
  roots_.resize(mesh.n_components());
  for (const FaceId f : mesh.faces()) {
    FaceId& largest = roots_[at(mesh.component(f))];
    if (!largest.is_valid() || mesh.area(f) > mesh.area(largest)) largest = f;
  }
  if (root.is_valid()) roots_[at(mesh.component(root))] = root;
}

void WholeTree::set(const SearchModel& model, const std::vector<char>& folds) {
  for (int h = 0; h < model.n_halfedges; ++h)
    is_fold_[dual_->mesh().edge(model.mesh_halfedge[at(h)])] = folds[at(h)];
}

void WholeTree::exchange(const SearchModel& model, int removed, int inserted) {
  is_fold_[dual_->mesh().edge(model.mesh_halfedge[at(removed)])] = 0;
  is_fold_[dual_->mesh().edge(model.mesh_halfedge[at(inserted)])] = 1;
}

UnfoldTree WholeTree::tree() const {
  UnfoldTree tree = tree_from_folds(dual_->mesh(), is_fold_);
  for (const FaceId root : roots_) tree.reroot(dual_->mesh(), root);
  return tree;
}

MoveRecord to_record(const SearchModel& model, const SearchEpisode::Move& move) {
  return {model.mesh_face[at(move.chosen)], model.mesh_face[at(move.root)],
          model.mesh_halfedge[at(move.removed)], model.mesh_halfedge[at(move.inserted)], move.overlaps_after};
}

Showing::Showing(WholeTree& whole, const std::vector<SearchModel>& models,
                 const std::vector<std::unique_ptr<Portfolio>>& portfolios, const SolveHooks& hooks)
    : whole_(&whole), models_(&models), portfolios_(&portfolios), hooks_(&hooks) {}

void Showing::begin(std::size_t component) {
  if (component > 0) {
    const Portfolio& done = *(*portfolios_)[component - 1];
    earlier_moves_ += done.stream(done.lead()).moves();
  }
  component_ = component;
  const Portfolio& portfolio = *(*portfolios_)[component];
  stream_ = portfolio.lead();
  place_ = end_of(portfolio.stream(stream_));
  if (hooks_->snapshots != nullptr) post(portfolio.stream(stream_), nullptr, true);
}

void Showing::before_round() {
  const Portfolio& portfolio = *(*portfolios_)[component_];
  round_start_.clear();
  for (int k = 0; k < portfolio.n_streams(); ++k) round_start_.push_back(end_of(portfolio.stream(k)));
}

bool Showing::after_round() {
  if (hooks_->snapshots == nullptr) return true;
  const Portfolio& portfolio = *(*portfolios_)[component_];
  if (stream_ != portfolio.lead()) {
    stream_ = portfolio.lead();
    place_ = round_start_[at(stream_)];
  }
  return reveal_moves(portfolio.stream(stream_));
}

const SearchEpisode* Showing::episode(const TabuSolver& solver, int number) {
  const int first = solver.restarts() + 1 - static_cast<int>(solver.episodes().size());
  return number < first ? nullptr : &solver.episodes()[at(number - first)];
}

void Showing::load(const TabuSolver& solver, Place place) {
  const SearchModel& model = (*models_)[component_];
  const SearchEpisode& from = *episode(solver, place.episode);
  whole_->set(model, from.start_folds);
  for (std::size_t i = 0; i < place.move; ++i)
    whole_->exchange(model, from.moves[i].removed, from.moves[i].inserted);
}

bool Showing::reveal_moves(const TabuSolver& solver) {
  const SearchModel& model = (*models_)[component_];
  const Place end = end_of(solver);
  bool is_loaded = false;
  while (place_ != end) {
    const Pace pace = hooks_->pace ? hooks_->pace() : Pace::Full;
    if (pace == Pace::Stop) return false;
    const SearchEpisode* current = episode(solver, place_.episode);
    if (pace == Pace::Full || current == nullptr) break;
    if (!is_loaded) load(solver, place_);
    is_loaded = true;
    if (place_.move == current->moves.size()) {
      place_ = {place_.episode + 1, 0};
      load(solver, place_);
      post(solver, nullptr, false);
    } else {
      const SearchEpisode::Move& move = current->moves[place_.move++];
      whole_->exchange(model, move.removed, move.inserted);
      const MoveRecord record = to_record(model, move);
      post(solver, &record, false);
    }
  }
  const bool is_behind = place_ != end;
  place_ = end;
  if (is_behind && hooks_->snapshots->is_empty()) post(solver, nullptr, true);
  return true;
}

std::vector<Overlap> Showing::known_overlaps() const {
  std::vector<Overlap> result;
  for (std::size_t c = component_; c < portfolios_->size(); ++c) {
    const Portfolio& portfolio = *(*portfolios_)[c];
    const int stream = c == component_ ? stream_ : portfolio.lead();
    for (const auto& [a, b] : portfolio.stream(stream).state().pairs()) {
      const FaceId first = (*models_)[c].mesh_face[at(a)];
      const FaceId second = (*models_)[c].mesh_face[at(b)];
      result.push_back({std::min(first, second), std::max(first, second)});
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

void Showing::add_history(const TabuSolver& solver, Snapshot& snapshot) const {
  std::int64_t total = 0;
  const int first = solver.restarts() + 1 - static_cast<int>(solver.episodes().size());
  for (int e = first; e <= place_.episode; ++e)
    total += e < place_.episode ? static_cast<std::int64_t>(episode(solver, e)->moves.size()) + 1
                                : static_cast<std::int64_t>(place_.move) + 1;
  snapshot.history_stride = std::max<std::int64_t>(1, (total + kHistoryValues - 1) / kHistoryValues);
  std::int64_t next = 0;
  std::int64_t base = 0;
  for (int e = first; e <= place_.episode; ++e) {
    const SearchEpisode& from = *episode(solver, e);
    const auto n = static_cast<std::int64_t>(e < place_.episode ? from.moves.size() : place_.move) + 1;
    for (; next < base + n; next += snapshot.history_stride) {
      const std::int64_t i = next - base;
      snapshot.history.push_back(i == 0 ? from.overlaps_at_start
                                        : from.moves[static_cast<std::size_t>(i - 1)].overlaps_after);
    }
    base += n;
  }
}

void Showing::post(const TabuSolver& solver, const MoveRecord* last_move, bool is_at_end) {
  auto snapshot = std::make_shared<Snapshot>();
  if (is_at_end) {
    for (std::size_t c = component_; c < portfolios_->size(); ++c) {
      const Portfolio& portfolio = *(*portfolios_)[c];
      whole_->set((*models_)[c],
                  portfolio.stream(c == component_ ? stream_ : portfolio.lead()).state().folds());
    }
    snapshot->overlaps = known_overlaps();
  }
  snapshot->net = whole_->net();
  if (!is_at_end) snapshot->overlaps = find_overlaps(snapshot->net, kSolveDepth);
  const Portfolio& portfolio = *(*portfolios_)[component_];
  snapshot->moves_of_all = earlier_moves_;
  for (int k = 0; k < portfolio.n_streams(); ++k) {
    snapshot->iterations += portfolio.stream(k).iterations();
    snapshot->moves_of_all += portfolio.stream(k).moves();
  }
  snapshot->moves = earlier_moves_ + solver.moves();
  if (!is_at_end) {
    for (int e = place_.episode; e <= solver.restarts(); ++e)
      snapshot->moves -= static_cast<std::int64_t>(episode(solver, e)->moves.size());
    snapshot->moves += static_cast<std::int64_t>(place_.move);
  }
  snapshot->restarts = place_.episode;
  snapshot->stream = stream_;
  snapshot->best_overlaps = portfolio.stream(portfolio.best()).best_overlaps();
  add_history(solver, *snapshot);
  if (last_move != nullptr) snapshot->last_move = *last_move;
  hooks_->snapshots->post(std::move(snapshot));
}

std::shared_ptr<Snapshot> Showing::at_end(const Net& net, std::vector<Overlap> overlaps) const {
  const TabuSolver& solver = (*portfolios_)[component_]->stream(stream_);
  auto snapshot = std::make_shared<Snapshot>();
  snapshot->net = net;
  snapshot->overlaps = std::move(overlaps);
  snapshot->iterations = solver.iterations();
  snapshot->moves = earlier_moves_ + solver.moves();
  snapshot->restarts = solver.restarts();
  snapshot->stream = stream_;
  snapshot->best_overlaps = static_cast<int>(snapshot->overlaps.size());
  snapshot->polish = polish_;
  add_history(solver, *snapshot);
  return snapshot;
}

bool Showing::show_polished(const Net& net, const PolishView& view) {
  if (hooks_->snapshots == nullptr) return true;
  polish_ = view;
  if (hooks_->pace && hooks_->pace() == Pace::Stop) return false;
  hooks_->snapshots->post(at_end(net, {}));
  return true;
}

void Showing::finish(const Net& net, std::vector<Overlap> overlaps) {
  if (hooks_->snapshots == nullptr) return;
  auto snapshot = at_end(net, std::move(overlaps));
  snapshot->is_final = true;
  hooks_->snapshots->post(std::move(snapshot));
}

}  // namespace netwright
