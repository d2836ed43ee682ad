// The report of a bench: one page that needs nothing beside it, and its plots as pictures of their own.
#pragma once

#include <filesystem>
#include <string>

#include "app/cli_bench_log.h"

namespace netwright {

/// The page as HTML. `times` says which times it tells, `time_words` what they are called.
std::string bench_page(const BenchRecord& record, double BenchRow::*times, const std::string& time_words);

/// Makes the folder, so that a name that cannot be one is told before anything is measured. Throws
/// Error(Write).
void make_report_folder(const std::filesystem::path& folder);

/// Writes index.html and, where there is something to plot, time.svg, success.svg and iterations.svg into the
/// folder. Throws Error(Write).
void write_report(const std::filesystem::path& folder, const BenchRecord& record, double BenchRow::*times,
                  const std::string& time_words);

}  // namespace netwright
