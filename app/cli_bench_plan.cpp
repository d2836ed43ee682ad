// From paths to groups of models.
#include "app/cli_bench_plan.h"

#include <algorithm>
#include <system_error>

#include "core/base/error.h"
#include "core/mesh/read.h"

namespace netwright {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> entries(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code failure;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, failure)) {
    if (!entry.path().filename().string().starts_with('.')) found.push_back(entry.path());
  }
  if (failure) {
    throw Error(ErrorKind::Usage, "The folder " + folder.string() + " cannot be looked into (" +
                                      failure.message() + "); name one that may be read.");
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<fs::path> models_in(const std::vector<fs::path>& entries) {
  std::vector<fs::path> models;
  std::error_code ignored;
  for (const fs::path& path : entries)
    if (is_model_path(path) && fs::is_regular_file(path, ignored)) models.push_back(path);
  return models;
}

/// "a/b/" and "./a/b" are the same folder as "a/b".
fs::path tidied(const fs::path& path) {
  const fs::path normal = path.lexically_normal();
  return normal.has_filename() || !normal.has_relative_path() ? normal : normal.parent_path();
}

class Plan {
 public:
  void add(const fs::path& path) {
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) {
      add_folder(path);
    } else if (fs::exists(path, ignored)) {
      add_models(path.has_parent_path() ? path.parent_path() : fs::path("."), {path});
    } else {
      throw Error(ErrorKind::Usage, "There is no file or folder " + path.string() + "; check its name.");
    }
  }
  [[nodiscard]] std::vector<BenchGroup> groups() && { return std::move(groups_); }

 private:
  void add_folder(const fs::path& folder) {
    const std::vector<fs::path> inside = entries(folder);
    const std::vector<fs::path> models = models_in(inside);
    bool is_empty = models.empty();
    if (!is_empty) add_models(folder, models);
    if (is_empty) {
      std::error_code ignored;
      for (const fs::path& path : inside) {
        if (!fs::is_directory(path, ignored)) continue;
        const std::vector<fs::path> inner = models_in(entries(path));
        if (!inner.empty()) add_models(path, inner);
        is_empty = is_empty && inner.empty();
      }
    }
    if (is_empty) {
      throw Error(ErrorKind::Usage, "There is no model in the folder " + folder.string() +
                                        ", nor in the folders in it; name one with models.");
    }
  }

  void add_models(const fs::path& folder, const std::vector<fs::path>& models) {
    const std::string name = tidied(folder).string();
    auto group =
        std::find_if(groups_.begin(), groups_.end(), [&](const BenchGroup& g) { return g.name == name; });
    if (group == groups_.end()) group = groups_.insert(groups_.end(), BenchGroup{name, {}});
    for (const fs::path& model : models) {
      const fs::path path = tidied(model);
      if (std::find(group->models.begin(), group->models.end(), path) == group->models.end())
        group->models.push_back(path);
    }
  }

  std::vector<BenchGroup> groups_;
};

}  // namespace

std::vector<BenchGroup> bench_plan(const std::vector<fs::path>& paths) {
  Plan plan;
  for (const fs::path& path : paths) plan.add(path);
  return std::move(plan).groups();
}

}  // namespace netwright
