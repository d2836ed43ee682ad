// What comes after the first net: polish, then room for glue tabs. Every net on the way is proved before it
// takes the place of the one before.
#pragma once

#include <memory>
#include <vector>

#include "core/base/progress.h"
#include "core/solve/polish.h"
#include "core/solve/search_model.h"
#include "core/solve/showing.h"
#include "core/solve/solve.h"

namespace netwright {

class Finish {
 public:
  /// `whole` holds the folds of a proved net, and `result` that net; both keep step with the best one proved.
  /// All arguments must outlive this.
  Finish(std::shared_ptr<const DualGraph> dual, const std::vector<SearchModel>& models,
         const SolveOptions& options, Progress& progress, WholeTree& whole, Showing& showing,
         SolveResult& result);

  /// Does what the options ask for. Cancelled, it ends with the best so far.
  void run();

 private:
  void polish();
  void polish_component(std::size_t c);
  [[nodiscard]] PolishTask task_of(std::size_t c) const;
  void tell_what_is_left();
  void make_room_for_tabs();
  void find_room(std::size_t c, double scale);
  [[nodiscard]] bool take(std::size_t c, const std::vector<char>& folds);
  void log(double cost);
  void add_station();
  [[nodiscard]] std::vector<char> folds_of(std::size_t c) const;

  std::shared_ptr<const DualGraph> dual_;
  const std::vector<SearchModel>* models_;
  const SolveOptions* options_;
  Progress* progress_;
  WholeTree* whole_;
  Showing* showing_;
  SolveResult* result_;
  PolishView view_;
  double logged_cost_ = 0;
};

}  // namespace netwright
