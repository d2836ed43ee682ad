// Projects for tests, made the way editor and command line make them.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "core/project/commands.h"
#include "core/project/make_model.h"
#include "core/project/project.h"
#include "core/solve/solve.h"
#include "tests/support.h"

namespace netwright::testing {

/// A project of this model, made by this recipe, without a net.
inline Project project_of(PolygonSoup soup, const Recipe& recipe = {}) {
  Project project;
  project.source = std::make_shared<const PolygonSoup>(std::move(soup));
  Progress progress;
  auto made = std::make_shared<const MadeModel>(make_model(project.source, recipe, nullptr, progress));
  if (!made->dual) throw std::logic_error(made->refusal);
  project.recipe = recipe;
  project.dual = made->dual;
  project.made = std::move(made);
  return project;
}

/// With the net that a search finds; unproved where there is none.
inline Project solved(Project project, std::uint64_t seed = 0) {
  SolveOptions options;
  options.seed = seed;
  options.max_iterations = 20000;
  Progress progress;
  const SolveResult result = solve(project.dual, options, progress);
  RunSummary run;
  run.seed = seed;
  run.moves = result.moves;
  run.restarts = result.restarts;
  run.seconds = 0.25;
  run.overlaps = static_cast<int>(result.overlaps.size());
  run.is_proved = result.is_proved;
  return accept_tree(std::move(project), result.net.tree, run);
}

}  // namespace netwright::testing
