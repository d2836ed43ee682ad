// What the command line says about polish, and how it is told what came of it.
#pragma once

#include <string>
#include <vector>

#include "core/base/json.h"
#include "core/solve/solve.h"

namespace netwright {

/// One word of --aim, "necks" or "necks=2", that was not understood, told as CLI11 tells it; empty when good.
std::string why_not_aim(const std::string& word);

/// The settings with what was named; words must be good. A word without a weight counts as 1.
void apply_aims(const std::vector<std::string>& words, PolishSettings& settings);

/// The measures of a net that polish is about.
struct PolishFigures {
  double cut_length = 0;  ///< model units, each cut counted once
  double outline = 0;     ///< model units, all the way round
  double hull_fill = 0;   ///< paper over the convex hull of each piece, 0…1
  double box_fill = 0;    ///< over the smallest rectangle
};
PolishFigures polish_figures(const Net& net);

/// "Polished: cuts 16 % shorter, hull 61 % filled (38 %), 0 necks under 3 mm (4)". Empty when nothing was
/// polished. A second line names what was asked for and not reached, see unmet_wishes().
std::string polish_line(const SolveResult& result, const PolishSettings& settings);
Json polish_json(const SolveResult& result);

}  // namespace netwright
