// Going on after the first net: exchanges of folds among nets without overlaps, so long as they serve a
// further aim (the optional objectives of the paper's section 4.6, one after the other instead of summed: an
// overlap is never traded for anything).
#pragma once

#include <functional>
#include <vector>

#include "core/base/progress.h"
#include "core/base/random.h"
#include "core/solve/search_state.h"

namespace netwright {

/// What an aim says of a net.
struct Judgement {
  double cost = 0;           ///< 0 = nothing left to wish for
  std::vector<int> trouble;  ///< halfedges of cuts that cost something: where to try exchanges
};
using NetJudge = std::function<Judgement(const SearchState&)>;

struct RefineResult {
  double cost_before = 0;
  double cost_after = 0;
  std::vector<std::pair<int, int>> moves;  ///< removed and inserted halfedges, in order
};

/// Lowers the cost of a state without overlaps; it has none afterwards either, and keeps its pins. Takes a
/// troubled cut at random and makes it a fold, in place of that fold on the loop it closes which serves best;
/// what was just made may not be undone at once. Ends at cost 0, after `most_looks` judgements or a sixth of
/// them without anything better, or when cancelled; the state is the best one seen.
RefineResult refine(SearchState& state, const NetJudge& judge, int most_looks, Random& random,
                    const Progress* progress);

}  // namespace netwright
