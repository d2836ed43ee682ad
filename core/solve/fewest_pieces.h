// Nets of several pieces, for a model that has none of one piece or whose maker would rather have more: for
// each number of pieces the net with the best cuts that was found, each of them proved.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/progress.h"
#include "core/solve/constraints.h"
#include "core/unfold/net.h"
#include "core/unfold/verify.h"

namespace netwright {

struct PiecesOptions {
  std::uint64_t seed = 0;
  Constraints pins{};  ///< kept by every net
  /// A tree to begin with, overlaps and all: what a search for one piece came to. It must keep the pins.
  std::shared_ptr<const UnfoldTree> from{};
  int n_choices = 3;        ///< numbers of pieces to look for: the fewest and so many less one after it
  int tries_per_face = 60;  ///< how long to look, for each choice
  std::int64_t exact_steps = 150'000;  ///< of an exact search for fewer pieces, where the model is small
};

struct PiecesChoice {
  Net net;                ///< proved
  double cut_length = 0;  ///< of all cuts, once each, model units; borders are no cuts
};

struct PiecesResult {
  std::vector<PiecesChoice> choices;  ///< by number of pieces, each number once
  int at_least = 1;                   ///< no net has fewer pieces than this
  bool was_cancelled = false;
};

/// The same answer every time. Empty choices when the pins cannot be kept without an overlap, or when
/// cancelled before there is any net.
PiecesResult fewest_pieces(const std::shared_ptr<const DualGraph>& dual, const PiecesOptions& options,
                           const Progress& progress);

/// What a cut along this edge costs: its length, less where it will hardly be seen, which is where the model
/// is sharp, in its hollows and on its underside.
double cut_cost(const DualGraph& dual, EdgeId edge);

}  // namespace netwright
