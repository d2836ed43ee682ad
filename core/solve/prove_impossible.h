// Tries to prove that a model has no net in one piece, for when searching for one has taken long. What it
// finds is checked before it is told.
#pragma once

#include <memory>
#include <optional>

#include "core/base/progress.h"
#include "core/unfold/impossibility.h"
#include "core/unfold/net.h"

namespace netwright {

struct ProveLimits {
  std::int64_t region_steps = 30'000;  ///< choices tried among regions; any model
  std::int64_t hinge_steps = 400'000;  ///< choices tried among hinges,
  std::size_t hinge_faces = 64;        ///< in components of at most so many faces
};

enum class ProveAnswer {
  Proved,    ///< there is no net
  NetFound,  ///< there is, and here it is
  Unknown,   ///< not within the limits
};

struct ProveResult {
  ProveAnswer answer = ProveAnswer::Unknown;
  ImpossibilityProof proof;  ///< when proved; `verify_impossible` has agreed
  std::optional<Net> net;    ///< when found; one piece per component, `verify` has agreed
  std::int64_t hinge_steps = 0;
};

/// Pins are not asked: what is proved holds for every choice of them. Ends early when `progress` is
/// cancelled. The same answer every time, on any machine.
ProveResult prove_impossible(const std::shared_ptr<const DualGraph>& dual, const ProveLimits& limits,
                             const Progress& progress);

/// One sentence for people.
std::string impossible_sentence(const Mesh& mesh);

}  // namespace netwright
