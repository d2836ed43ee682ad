// What the command line unfolds: a model file, or a project with what its user had decided before.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/cli_options.h"
#include "core/project/project.h"
#include "core/project/replace_model.h"
#include "core/solve/solve.h"
#include "core/unfold/hand_edits.h"

namespace netwright {

struct CliModel {
  Project project;                   ///< its dual is there
  std::vector<std::string> notices;  ///< whole sentences
  std::optional<SolveResult> net;    ///< a project's own proved net, where the options ask for no other one
  std::shared_ptr<const UnfoldTree> start;  ///< to search on from, changing as little as may be; or null
  /// Corners moved so that there is a net, and how far the surface went at most.
  struct Softened {
    int n_corners = 0;
    double deviation_mm = 0;
  };
  std::optional<Softened> softened;
  std::optional<ReplaceReport> replaced;  ///< what became of the old version's work
};

/// Reads the model or project and makes the mesh. What the options leave open, a project decides: recipe,
/// seed, root, paper and size of `command` are then those that count. Throws Error.
CliModel read_cli_model(UnfoldCommand& command, Progress& progress);

/// Paper, size and seed of the project are those that count from now on.
void take_settings(UnfoldCommand& command, const Project& project);

/// Writes a project with this net in it, and `split` as an edit by hand where it cuts anything. Throws
/// Error(Write).
void write_project(const std::filesystem::path& path, const CliModel& model, const SolveResult& result,
                   const HandEdit& split, double search_seconds, const UnfoldCommand& command);

}  // namespace netwright
