// Which models a bench measures, found from the paths on the command line.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace netwright {

/// Models that share one row of the summary.
struct BenchGroup {
  std::string name;  ///< the folder as it was named on the command line
  std::vector<std::filesystem::path> models;
};

/// A file is one model of its folder's group. A folder stands for its model files, sorted by name; a folder
/// without any stands for those of its sub-folders that have some, each a group of its own. Hidden files are
/// left out and nothing is listed twice. Throws Error(Usage) when a path is missing or holds no model.
std::vector<BenchGroup> bench_plan(const std::vector<std::filesystem::path>& paths);

}  // namespace netwright
