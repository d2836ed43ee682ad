// What the paper's authors measured, for comparison: Table 2 of "Unfolding Polyhedra via Tabu Search" (see
// its section 5.1), 2800 models of Thingi10K at five sizes, on the authors' own machine.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace netwright {

inline constexpr std::array<int, 5> kPaperFaces{100, 200, 400, 600, 800};

/// One program at one number of faces; times in seconds, success in percent.
struct PaperFigures {
  double min = 0;
  double mean = 0;
  double filtered_mean = 0;
  double max = 0;
  double success_percent = 0;
};

struct PaperProgram {
  std::string_view name;                                                ///< for tables
  std::string_view label;                                               ///< for plots
  std::array<std::optional<PaperFigures>, kPaperFaces.size()> figures;  ///< empty: not measured
};

/// The tabu search of the authors, Optimized Topological Surgery, Simulated Annealing.
extern const std::array<PaperProgram, 3> kPaperPrograms;

}  // namespace netwright
