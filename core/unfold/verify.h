// The independent proof. Judges the stored coordinates and nothing else, with rigorous error bounds, and
// shares no code with the search or the overlap detection: a mistake there cannot hide here.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/unfold/flat_net.h"

namespace netwright {

struct VerifyReport {
  bool is_net = false;              ///< all of the checks below hold
  int pieces = 0;                   ///< trees found
  int overlaps = 0;                 ///< pairs of faces of one piece deeper than kProofDepth mean edges
  double deepest_overlap = 0;       ///< upper estimate, in mean edges (0 when none)
  double worst_distortion = 0;      ///< largest deviation from congruence, share of the face's size
  std::vector<std::string> faults;  ///< one sentence each, for the user; empty exactly when is_net
};

/// Checks: indices and numbers are sound; every face is congruent to its place on the model times one common
/// scale, none mirrored against the others; joined faces form `expected_pieces` trees without a cycle, each
/// join an edge that both faces share on the model; every cut edge is paired with exactly one other or lies
/// on a border of the model; assignments match the bends; no two faces of a piece overlap deeper than
/// kProofDepth mean edges.
VerifyReport verify(const FlatNet& net, int expected_pieces = 1);

}  // namespace netwright
