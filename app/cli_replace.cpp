// netwright-cli replace: a changed version of the model takes the place of the one a project holds, and the
// search goes on from what is left of the net.
#include <memory>
#include <optional>

#include "app/cli_commands.h"
#include "app/cli_report.h"
#include "app/cli_search.h"
#include "core/base/error.h"
#include "core/mesh/read.h"
#include "core/project/open_model.h"
#include "core/project/project_file.h"
#include "core/project/replace_model.h"

namespace netwright {
namespace {

namespace fs = std::filesystem;

constexpr int kCancelled = 130;

Project old_version(const fs::path& file, Progress& progress) {
  progress.set_phase("Reading " + file.filename().string());
  if (!is_project_file(file))
    throw Error(ErrorKind::Usage,
                file.string() + " is no project; name the .netwright file of the old version.");
  Project project = load_project(file).project;
  MadeModel made = *project.made;
  add_survey(made, progress);  // knows the parts that were left out
  project.made = std::make_shared<const MadeModel>(std::move(made));
  return project;
}

/// Where repairing would help and was not asked for, the refusal ends with how to ask.
[[noreturn]] void refuse(const Project& old, const Replacement& refused, const ReplaceCommand& command,
                         Progress& progress) {
  const bool helps = !command.is_repair && replace_model(old, command.unfold.model, refused.project.source,
                                                         usual_repair(), progress)
                                               .refusal.empty();
  throw Error(ErrorKind::Unfit, refused.refusal + (helps ? " Or add --repair." : ""));
}

CliModel read_versions(UnfoldCommand& command, const ReplaceCommand& asked, Progress& progress) {
  const Project old = old_version(asked.project, progress);
  if (is_project_file(command.model))
    throw Error(ErrorKind::Usage,
                command.model.string() + " is a project; name the model file of the new version.");
  progress.set_phase("Reading " + command.model.filename().string());
  std::error_code ignored;
  const auto repairs = asked.is_repair ? std::optional(usual_repair()) : std::nullopt;
  Replacement replacement =
      replace_model(old, fs::absolute(command.model, ignored),
                    std::make_shared<const PolygonSoup>(read_soup(command.model)), repairs, progress);
  if (!replacement.refusal.empty()) refuse(old, replacement, asked, progress);
  CliModel model;
  model.project = std::move(replacement.project);
  model.start = std::move(replacement.start);
  model.replaced = std::move(replacement.report);
  model.notices = model.project.made->done;
  command.recipe = model.project.recipe;
  take_settings(command, model.project);
  return model;
}

}  // namespace

int run_replace(const ReplaceCommand& asked) {
  UnfoldCommand command = asked.unfold;
  const double start = now_seconds();
  check_outputs(command);
  const Interrupts interrupts;
  CliModel model;
  const Watched watched =
      run_watched(interrupts, [&](Progress& progress) { model = read_versions(command, asked, progress); });
  if (watched.was_interrupted) return kCancelled;
  if (!command.is_json) print_replaced(*model.replaced);
  return search_and_write(command, model, interrupts, start);
}

}  // namespace netwright
