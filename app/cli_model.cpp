// Reading for unfold. A project file and a model file lead to the same Project, the one with its tree, the
// other without.
#include "app/cli_model.h"

#include <utility>

#include "app/cli_pins.h"
#include "app/cli_recipe.h"
#include "core/base/error.h"
#include "core/mesh/read.h"
#include "core/project/carry_pins.h"
#include "core/project/commands.h"
#include "core/project/project_file.h"
#include "core/unfold/flat_net.h"

namespace netwright {
namespace {

void make(CliModel& model, const UnfoldCommand& command, Progress& progress) {
  Project& project = model.project;
  ToldModel told = make_as_told(project.source, command, progress);
  model.notices = told.made->done;
  for (const MeshReport::Line& line : told.made->report.lines)
    if (line.kind == MeshReport::Line::Kind::Notice) model.notices.push_back(line.text);
  project.recipe = std::move(told.recipe);
  project.dual = told.made->dual;
  project.made = std::move(told.made);
}

/// The project's own net as if it had just been found; nothing where it is not proved.
std::optional<SolveResult> stored_net(const Project& project) {
  if (!project.tree || !project.run || !project.run->is_proved) return std::nullopt;
  SolveResult result;
  result.net = layout(project.dual, *project.tree);
  result.proof = verify(to_flat_net(result.net, 1), static_cast<int>(project.dual->mesh().n_components()));
  result.is_proved = result.proof.is_net;
  result.moves = project.run->moves;
  result.restarts = project.run->restarts;
  if (!result.is_proved) return std::nullopt;
  return result;
}

CliModel read_stored(UnfoldCommand& command, Progress& progress) {
  CliModel model;
  progress.set_phase("Reading " + command.model.filename().string());
  model.project = load_project(command.model).project;
  Project& project = model.project;
  const UnfoldCommand::Given& given = command.given;
  if (given.recipe) {
    Progress making;
    const auto before = project.dual;
    make(model, command, making);
    project.tree = nullptr;
    project.run.reset();
    const CarriedPins carried = carry_pins(project.pins, before->mesh(), project.dual->mesh());
    project.pins = carried.pins;
    if (carried.n_lost > 0) model.notices.push_back(carried.sentence());
  }
  command.recipe = project.recipe;
  if (given.pins) project.pins = pins_of(command, project.dual->mesh());
  if (given.seed) project.seed = static_cast<std::uint64_t>(command.seed);
  if (given.paper) project.paper.format = command.paper.format;
  if (given.size) project.size = command.size;
  apply(command.print, project);
  take_settings(command, project);
  if (given.recipe || given.pins || given.seed || given.search) return model;
  model.net = stored_net(project);
  if (model.net) {
    command.seed = static_cast<std::int64_t>(project.run->seed);
    model.notices.push_back(command.model.filename().string() +
                            " holds a proved net, which is taken as it is; name a --seed to search anew.");
  }
  return model;
}

}  // namespace

CliModel read_cli_model(UnfoldCommand& command, Progress& progress) {
  if (is_project_file(command.model)) return read_stored(command, progress);
  CliModel model;
  Project& project = model.project;
  std::error_code ignored;
  project.path = std::filesystem::absolute(command.model, ignored);
  project.source = std::make_shared<const PolygonSoup>(read_soup(command.model));
  make(model, command, progress);
  if (std::string notice = size_notice(command, *project.source, project.dual->mesh()); !notice.empty())
    model.notices.push_back(std::move(notice));
  project.pins = pins_of(command, project.dual->mesh());
  project.seed = static_cast<std::uint64_t>(command.seed);
  project.paper = command.paper;
  project.size = command.size;
  apply(command.print, project);
  take_settings(command, project);
  return model;
}

void take_settings(UnfoldCommand& command, const Project& project) {
  command.seed = static_cast<std::int64_t>(project.seed);
  command.paper = project.paper;
  command.size = project.size;
}

void write_project(const std::filesystem::path& path, const CliModel& model, const SolveResult& result,
                   const HandEdit& split, double search_seconds, const UnfoldCommand& command) {
  const auto save = [&](Project project) {
    if (!split.cut.empty()) project = edit_by_hand(std::move(project), split);
    save_project(project, path);
  };
  if (model.net) return save(model.project);
  RunSummary run;
  run.seed = static_cast<std::uint64_t>(command.seed);
  run.moves = result.moves;
  run.restarts = result.restarts;
  run.seconds = search_seconds;
  run.overlaps = static_cast<int>(result.overlaps.size());
  run.is_proved = result.is_proved;
  save(accept_tree(model.project, result.net.tree, run));
}

}  // namespace netwright
