// What is left to wish for in a net of one component, as one number made of the aims and their weights. The
// least is 0, though not every model can reach it.
#pragma once

#include <vector>

#include "core/solve/aims.h"
#include "core/solve/net_shape.h"
#include "core/solve/search_state.h"

namespace netwright {

/// One component's aims in the search's own units.
struct PolishTask {
  PolishSettings settings;
  double neck_width = 0;          ///< mean edges
  std::vector<glm::dvec2> rooms;  ///< mean edges; only with fits_paper
  int root = -1;                  ///< face; only with root_in_middle
  std::vector<double> in_sight;   ///< per halfedge, 0…1; only with hidden_cuts
};

PolishTask polish_task(const DualGraph& dual, const SearchModel& model, const PolishAim& aim, double scale,
                       FaceId root);

/// The parts of a cost.
struct NetCosts {
  double cuts = 0;    ///< weighted already
  double spread = 1;  ///< see NetShape
  int necks = 0;
  double area = 0;  ///< of the hull
  double size = 0;  ///< see PolishReport; 0 without fits_paper
  double root = 0;  ///< how far it is off, in sides of a square of the paper's area
  double sum = 0;   ///< of all, weighted
};

class NetCost {
 public:
  /// All arguments but the task must outlive this.
  NetCost(const DualGraph& dual, const SearchModel& model, const SearchState& state, PolishTask task);

  [[nodiscard]] const PolishTask& task() const { return task_; }

  /// To be called after each change of the state: all measures anew.
  NetCosts measure();
  /// The same when cuts and necks of the state are known; the others are taken anew.
  void update(NetCosts& costs);

  /// A lower bound of what an exchange will change, before it is made, and what it changes of the necks.
  /// Nothing is asked of necks when the rest is `hopeless` or more.
  struct Change {
    double cost = 0;
    int necks = 0;
  };
  [[nodiscard]] Change change(const NetCosts& now, const Exchange& exchange, double hopeless) const;
  [[nodiscard]] double cut_cost(int h) const { return cut_cost_[at(h)]; }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  void price_cuts();
  void add_up(NetCosts& costs) const;

  const SearchModel* model_;
  const SearchState* state_;
  PolishTask task_;
  NetShape shape_;
  std::vector<double> cut_cost_;  ///< per halfedge
  double least_ = 0;              ///< what no net can do without
};

}  // namespace netwright
