// Polish: from a first overlap-free net to one that a person would rather cut out. Simulated annealing over
// overlap-free nets (the paper's section 4.6 adds further aims to the overlaps; here an overlap is never
// traded for anything, so that every net on the way is one).
#pragma once

#include <memory>
#include <vector>

#include "core/base/progress.h"
#include "core/base/random.h"
#include "core/solve/net_cost.h"

namespace netwright {

class Polisher {
 public:
  /// `folds` are those of a net without overlaps. The dual graph, the model and `progress` must outlive this.
  Polisher(const DualGraph& dual, const SearchModel& model, const std::vector<char>& folds, PolishTask task,
           Random random, const Progress& progress);
  ~Polisher();

  /// Works for a sixteenth of a second or so, or until cancelled; false once all work is done or nothing is
  /// left to wish for.
  bool advance();
  [[nodiscard]] double fraction() const;  ///< of the work that is done

  /// The best net so far: no overlaps, after placing and detecting everything anew,
  [[nodiscard]] const std::vector<char>& best_folds() const;
  [[nodiscard]] const NetCosts& best() const;  ///< and what it costs

 private:
  class Search;
  std::unique_ptr<Search> search_;
};

}  // namespace netwright
