// An exact search over the unfold trees of a small component: fold or cut, hinge by hinge, with everything
// that follows from a choice drawn first.
#pragma once

#include <optional>

#include "core/base/progress.h"
#include "core/mesh/dual_graph.h"
#include "core/unfold/impossibility.h"

namespace netwright {

struct HingeSearch {
  bool is_refuted = false;  ///< no forest of so few trees is without overlap
  bool is_found = false;    ///< one is, but for overlaps too shallow for a proof; its folds:
  std::vector<EdgeId> folds;
  std::optional<ImpossibilityProof> proof;  ///< when refuted for a single tree
  std::int64_t steps = 0;
};

/// Looks for a forest of at most `most_trees` trees on a component. Neither refuted nor found after
/// `max_steps` or when cancelled. The same answer every time.
HingeSearch search_hinges(const DualGraph& dual, const std::vector<FaceId>& component, int most_trees,
                          std::int64_t max_steps, const Progress& progress);

}  // namespace netwright
