// The summary of a bench: one row per folder, as a table for people and as comments for the file of rows.
#pragma once

#include <string>
#include <vector>

#include "app/cli_bench_log.h"
#include "app/cli_bench_stats.h"

namespace netwright {

struct BenchFigures {
  std::string folder;
  int n = 0;          ///< rows
  int n_proved = 0;   ///< of them, with a proved net
  int n_refused = 0;  ///< of them, without a search; they have no times
  BenchStats times;   ///< of all searches, solved or not
};

/// One per folder, in the order of first appearance. `times` says which times, as in &BenchRow::cpu_seconds.
std::vector<BenchFigures> bench_figures(const std::vector<BenchRow>& rows, double BenchRow::*times);

/// Aligned columns, a heading first; times as "0.15 ms" or "2.3 s". Folders go by their last names where
/// these differ.
std::string bench_table(const std::vector<BenchFigures>& figures);

/// The same as tab-separated lines with a heading: times in seconds, success in percent.
std::vector<std::string> bench_summary(const std::vector<BenchFigures>& figures);

}  // namespace netwright
