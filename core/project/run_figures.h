// The figures of a run, as the status bar and the chart show them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/solve/snapshot.h"

namespace netwright {

/// The figures in the status bar, true at the moment of the call.
struct RunFigures {
  int faces = 0;
  int overlaps = 0;
  int overlaps_at_start = 0;
  int best_overlaps = 0;
  std::int64_t moves = 0;
  double moves_per_second = 0;
  int restarts = 0;
  std::uint64_t seed = 0;
  double seconds = 0;
  std::vector<int> history;  ///< overlaps over moves, for the chart
  std::int64_t history_stride = 1;
  double polish_fraction = 0;        ///< of the work that polish may do
  std::vector<double> polish_costs;  ///< what was left to wish for, see PolishView; empty before polish
  std::vector<PolishStation> polish_stations;  ///< for the chart
  std::vector<std::string> unmet_wishes;       ///< see aims.h; known when the run has ended
  double at_polish = -1;  ///< the moment of polish that is looked at, as a fraction; -1 = none
  std::int64_t at_move =
      -1;  ///< the moment of the history that is looked at, in moves from its start; -1 = none
};

}  // namespace netwright
