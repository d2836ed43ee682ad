// The weights of the aims against each other, and their sum.
#include "core/solve/net_cost.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "core/solve/disjoint_sets.h"

namespace netwright {

namespace {

// Costs of the aims at weight 1. With these the median cut length of models of 200 and 400 faces falls by 15
// % while the hull is filled one and a half times as well; more for the one takes from the other.
constexpr double kCutCost = 3;        ///< of all cuts, when they are as short as an overlapping net allows
constexpr double kSpreadCost = 0.03;  ///< of a disc
constexpr double kHullCost = 0.15;    ///< of a convex net
constexpr double kNeckCost = 3;       ///< if every face were a neck
constexpr double kSizeCost = 4;       ///< of a net e times too large
constexpr double kRootCost = 1;       ///< of a root as far off as a square of the same area is wide
constexpr double kSightCost = 2;      ///< of a cut in full sight, in times its cost for being long

// The cheapest cuts that any tree of folds has, overlaps or not: a dearest spanning tree keeps the rest.
double least_cut_cost(const SearchModel& model, const std::vector<double>& cost) {
  std::vector<int> hinges;
  for (int h = 0; h < model.n_halfedges; ++h)
    if (model.twin[static_cast<std::size_t>(h)] > h) hinges.push_back(h);
  const auto cost_of = [&](int h) { return cost[static_cast<std::size_t>(h)]; };
  std::ranges::stable_sort(hinges, std::ranges::greater(), cost_of);
  DisjointSets sets(static_cast<std::size_t>(model.n_faces));
  double least = 0;
  for (const int h : hinges)
    if (!sets.join(model.face_of[static_cast<std::size_t>(h)], model.beyond(h))) least += cost_of(h);
  return least;
}

}  // namespace

PolishTask polish_task(const DualGraph& dual, const SearchModel& model, const PolishAim& aim, double scale,
                       FaceId root) {
  const Mesh& mesh = dual.mesh();
  const double mm = scale * mesh.mean_edge();  // per unit of the search
  PolishTask task{aim.settings, kNeckWidth / mm, {}, -1, {}};
  if (aim.rooms_mm.empty()) task.settings.fits_paper = 0;
  for (const glm::dvec2 room : aim.rooms_mm) task.rooms.push_back(room / mm);
  for (int f = 0; f < model.n_faces; ++f)
    if (model.mesh_face[static_cast<std::size_t>(f)] == root) task.root = f;
  if (task.root < 0) task.settings.root_in_middle = 0;
  if (aim.in_sight.size() == mesh.n_edges())
    for (const HalfedgeId h : model.mesh_halfedge) task.in_sight.push_back(aim.in_sight[mesh.edge(h)]);
  return task;
}

NetCost::NetCost(const DualGraph& dual, const SearchModel& model, const SearchState& state, PolishTask task)
    : model_(&model), state_(&state), task_(std::move(task)), shape_(dual, model, state, task_.neck_width) {
  price_cuts();
}

void NetCost::price_cuts() {
  const PolishSettings& s = task_.settings;
  for (int h = 0; h < model_->n_halfedges; ++h) {
    const double sight = task_.in_sight.empty() ? 0 : s.hidden_cuts * task_.in_sight[at(h)];
    cut_cost_.push_back(model_->edge_length[at(h)] * (s.short_cuts + kSightCost * sight));
  }
  const double least = least_cut_cost(*model_, cut_cost_);
  const double share = least > 0 ? kCutCost * std::max(s.short_cuts, s.hidden_cuts) / least : 0;
  for (double& cost : cut_cost_) cost *= share;
  least_ = share * least + s.compact * (kSpreadCost + kHullCost);
}

void NetCost::add_up(NetCosts& costs) const {
  const PolishSettings& s = task_.settings;
  costs.sum = costs.cuts - least_;
  costs.sum +=
      s.compact * (kSpreadCost * std::sqrt(costs.spread) + kHullCost * costs.area / shape_.total_area());
  costs.sum += s.few_necks * kNeckCost * costs.necks / model_->n_faces;
  if (costs.size > 1) costs.sum += s.fits_paper * kSizeCost * std::log(costs.size);
  costs.sum = std::max(0.0, costs.sum + s.root_in_middle * kRootCost * costs.root);
}

void NetCost::update(NetCosts& costs) {
  shape_.refresh();
  costs.spread = shape_.spread();
  const Supports supports(*state_);
  costs.area = supports.area();
  if (task_.settings.fits_paper > 0) {
    costs.size = std::numeric_limits<double>::infinity();
    for (const glm::dvec2 room : task_.rooms) costs.size = std::min(costs.size, supports.size_in(room));
  }
  if (task_.settings.root_in_middle > 0)
    costs.root =
        glm::distance(supports.middle(), shape_.middle_of(task_.root)) / std::sqrt(shape_.total_area());
  add_up(costs);
}

NetCosts NetCost::measure() {
  NetCosts costs;
  for (int h = 0; h < model_->n_halfedges; ++h)
    if (model_->twin[at(h)] > h && !state_->is_fold(h)) costs.cuts += cut_cost_[at(h)];
  costs.necks = shape_.necks();
  update(costs);
  return costs;
}

NetCost::Change NetCost::change(const NetCosts& now, const Exchange& exchange, double hopeless) const {
  const PolishSettings& s = task_.settings;
  const double neck_cost = s.few_necks * kNeckCost / model_->n_faces;
  Change change{cut_cost(exchange.removed) - cut_cost(exchange.inserted), 0};
  change.cost += s.compact * kSpreadCost * (std::sqrt(shape_.spread_after(exchange)) - std::sqrt(now.spread));
  if (change.cost >= hopeless + 5 * neck_cost) return change;  // four faces and a fold can stop being necks
  change.necks = shape_.neck_change(exchange.removed, exchange.inserted);
  change.cost += neck_cost * change.necks;
  return change;
}

}  // namespace netwright
