// The paper's figures 6 to 8 with our own measurements in them, as SVG.
#pragma once

#include <string>
#include <vector>

#include "app/cli_bench_table.h"

namespace netwright {

/// Figures 6, 7 and 8; each needs at least one size with times.
struct BenchPlots {
  std::string time;     ///< by faces, both logarithmic: ours from least to most, the paper's three programs
  std::string success;  ///< by faces
  std::string iterations;  ///< by faces, with a proportional fit
};

/// `sizes` as bench_sizes() makes them; those without times are left out. Empty pictures when none is left.
BenchPlots bench_plots(std::vector<BenchFigures> sizes, const std::string& time_words);

}  // namespace netwright
