// The models a benchmark is asked to measure.
#pragma once

#include <algorithm>
#include <filesystem>
#include <vector>

namespace netwright::testing {

/// A file stands for itself, a folder for the OBJ and OFF files in it, by name.
inline std::vector<std::filesystem::path> models_in(const std::filesystem::path& path) {
  if (!std::filesystem::is_directory(path)) return {path};
  std::vector<std::filesystem::path> models;
  for (const auto& entry : std::filesystem::directory_iterator(path))
    if (entry.path().extension() == ".obj" || entry.path().extension() == ".off")
      models.push_back(entry.path());
  std::ranges::sort(models);
  return models;
}

}  // namespace netwright::testing
