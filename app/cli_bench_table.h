// The summary of a bench: one row per folder, as tables for people and as comments for the file of rows, and
// how the figures grow with the number of faces.
#pragma once

#include <optional>
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
  BenchStats faces;   ///< likewise
  BenchStats iterations;
};

/// One per folder, in the order of first appearance. `times` says which times, as in &BenchRow::cpu_seconds.
std::vector<BenchFigures> bench_figures(const std::vector<BenchRow>& rows, double BenchRow::*times);

/// The same with one group for each size of model, by size: of the folders whose models have all nearly the
/// same number of faces (within 10 %), those with nearly the same mean (5 %) together; other folders are left
/// out. The folder's name is the mean number of faces.
std::vector<BenchFigures> bench_sizes(const std::vector<BenchRow>& rows, double BenchRow::*times);

/// How the figures grow with the mean number of faces; what cannot be fitted is empty.
struct BenchGrowth {
  double least_faces = 0;
  double most_faces = 0;
  int n_sizes = 0;
  std::optional<PowerLaw> median_time;
  std::optional<PowerLaw> mean_time;
  std::optional<PowerLaw> mean_iterations;
};
BenchGrowth bench_growth(const std::vector<BenchFigures>& sizes);

/// "Growth with the number of faces |F|, 100 to 800 (5 sizes): median time |F|^1.5, …"; empty when nothing
/// could be fitted.
std::string growth_sentence(const BenchGrowth& growth);

/// The folders as they are shown: by their last names where these differ.
std::vector<std::string> folder_names(const std::vector<BenchFigures>& figures);

/// Aligned columns, a heading first; times as "0.15 ms" or "2.3 s".
std::string bench_table(const std::vector<BenchFigures>& figures);
/// The same for faces and iterations.
std::string iterations_table(const std::vector<BenchFigures>& figures);

/// Three digits that count: "0.150 ms", "2.30 s", "412 s".
std::string duration_words(double seconds);
/// Three digits, or all in front of the point: "0.53", "41.2", "10234".
std::string count_words(double count);
/// The share with a proved net, rounded down, so that "100 %" means every single one.
std::string success_words(const BenchFigures& figures);

/// The same as tab-separated lines with a heading: times in seconds, success in percent.
std::vector<std::string> bench_summary(const std::vector<BenchFigures>& figures);

}  // namespace netwright
