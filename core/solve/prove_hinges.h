// An exact search over the unfold trees of a small component: fold or cut, hinge by hinge, with everything
// that follows from a choice drawn first.
#pragma once

#include <optional>

#include "core/base/progress.h"
#include "core/mesh/dual_graph.h"
#include "core/unfold/impossibility.h"

namespace netwright {

struct HingeSearch {
  std::optional<ImpossibilityProof> proof;  ///< no tree of the component is without overlap
  std::vector<EdgeId> folds;                ///< of a tree without overlap deep enough for a proof; or empty
  std::int64_t steps = 0;
};

/// Neither proof nor folds after `max_steps` or when cancelled. The same answer every time.
HingeSearch search_hinges(const DualGraph& dual, const std::vector<FaceId>& component, std::int64_t max_steps,
                          const Progress& progress);

}  // namespace netwright
