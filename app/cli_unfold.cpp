// netwright-cli unfold: refuse early what cannot work, read, search under watch, and write only a proved net.
#include <unistd.h>

#include <algorithm>
#include <memory>
#include <system_error>

#include "app/cli_commands.h"
#include "app/cli_model.h"
#include "app/cli_report.h"
#include "app/cli_search.h"
#include "app/cli_watch.h"
#include "core/base/error.h"
#include "core/project/commands.h"
#include "core/project/project_file.h"
#include "core/sheet/page_frame.h"
#include "core/sheet/write.h"
#include "core/unfold/obstruction.h"

namespace netwright {
namespace {

namespace fs = std::filesystem;

constexpr int kDone = 0;
constexpr int kUnsolved = 2;
constexpr int kImpossible = 3;
constexpr int kCancelled = 130;

std::string known_formats() {
  std::string text;
  for (const ExportFormat& format : export_formats())
    text += (text.empty() ? "" : " ") + std::string(format.extension);
  return text + " ." + std::string(kProjectExtension);
}

/// A folder that gets all that a cutter needs.
bool is_package(const fs::path& path, const UnfoldCommand& command) {
  return command.cutter && !path.has_extension();
}

/// The folder that a path is to be made in must be there and ours to write to.
void check_folder(const fs::path& path) {
  std::error_code ignored;
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, ignored)) {
    throw Error(ErrorKind::Write, "Cannot write " + path.string() + ": the folder " + folder.string() +
                                      " does not exist, so make it first.");
  }
  if (access(folder.c_str(), W_OK) != 0) {
    throw Error(ErrorKind::Write, "Cannot write " + path.string() + ": the folder " + folder.string() +
                                      " may not be written to, so choose another one.");
  }
}

/// What can be known to fail is refused before any time is spent on the search.
void check_output(const fs::path& path, const UnfoldCommand& command) {
  if (is_package(path, command)) {
    check_folder(path.has_filename() ? path : path.parent_path());
    return;
  }
  if (!is_export_format(path) && !has_project_name(path)) {
    throw Error(ErrorKind::Usage, "Cannot tell how to write " + path.string() +
                                      ": give it one of the extensions " + known_formats() + ".");
  }
  check_folder(path);
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) {
    throw Error(ErrorKind::Write,
                "Cannot write " + path.string() + ": it is a folder, so choose another name.");
  }
}

SolveOptions solve_options(const UnfoldCommand& command, const CliModel& model) {
  const Project& project = model.project;
  SolveOptions options;
  options.seed = static_cast<std::uint64_t>(command.seed);
  options.streams = command.streams;
  options.threads = command.threads;
  options.search = command.search;
  options.pins = model.start ? pins_with_edits(project) : project.pins;
  options.from = model.start;
  options.stays_near = model.start != nullptr;
  return options;
}

void take_exports(ExportSettings& exports, const ExportSettings& named) {
  exports.is_one_file |= named.is_one_file;
  exports.real_dashes |= named.real_dashes;
  exports.live_text |= named.live_text;
  if (named.png_dpi != ExportSettings{}.png_dpi) exports.png_dpi = named.png_dpi;
  if (named.instructions != InstructionPage::None) exports.instructions = named.instructions;
}

/// The project's settings of print, with those named in the command in their place.
void take_printing(Project& project, UnfoldCommand& command) {
  const UnfoldCommand::Printing& printing = command.printing;
  if (printing.margin_mm) project.paper.margin_mm = command.paper.margin_mm = *printing.margin_mm;
  if (printing.tabs_mm) project.tabs.is_on = *printing.tabs_mm > 0;
  if (printing.tabs_mm && *printing.tabs_mm > 0) project.tabs.width_mm = *printing.tabs_mm;
  if (printing.lines) project.sheet.lines = line_styles(*printing.lines);
  if (printing.side) project.sheet.printed_side = *printing.side;
  if (printing.is_grey) project.sheet.is_grey = true;
  if (printing.no_numbers) project.sheet.labels.edge_numbers = false;
  if (printing.no_pictures) project.sheet.pictures.is_on = false;
  take_exports(project.exports, command.exports);
}

/// What was found, and where it goes on paper.
struct Drawing {
  PageLayout layout;
  std::vector<fs::path> files;
};

std::vector<fs::path> write_one(const fs::path& output, const UnfoldCommand& command, const CliModel& model,
                                const UnfoldOutcome& outcome, const PageLayout& layout) {
  if (has_project_name(output)) {
    write_project(output, model, outcome.result, outcome.search_seconds, command);
    return {output};
  }
  const SheetInfo info{"", true, static_cast<std::uint64_t>(command.seed)};
  const Net& net = outcome.result.net;
  if (is_package(output, command)) {
    const PageLayout clear =
        arrange(net, cutter_paper(command.paper, *command.cutter), command.size, model.project.tabs);
    const CutterPackage package = write_cutter_package(output, net, clear, info, model.project.sheet,
                                                       model.project.exports, *command.cutter);
    for (const std::string& note : package.notes) complain("note: " + note);
    return package.files;
  }
  return write_drawing(output, net, layout, info, model.project.sheet, model.project.exports);
}

/// All files or none: when one cannot be written, those that this run added before it go again.
Drawing draw(const UnfoldCommand& command, const CliModel& model, const UnfoldOutcome& outcome) {
  Drawing drawing;
  drawing.layout = arrange(outcome.result.net, command.paper, command.size, model.project.tabs);
  std::vector<fs::path> added;
  try {
    for (const fs::path& output : command.outputs) {
      std::error_code ignored;
      const bool was_there = fs::exists(output, ignored);
      for (const fs::path& file : write_one(output, command, model, outcome, drawing.layout)) {
        drawing.files.push_back(file);
        if (!was_there) added.push_back(file);
      }
    }
  } catch (...) {
    std::error_code ignored;
    for (const fs::path& file : added) fs::remove(file, ignored);
    throw;
  }
  return drawing;
}

void tell_success(const UnfoldCommand& command, const UnfoldOutcome& outcome, const Drawing& drawing) {
  print(model_line(outcome.mesh));
  print(result_line(outcome, command));
  if (!drawing.files.empty()) print(files_line(drawing.files, drawing.layout, command));
}

}  // namespace

void check_outputs(const UnfoldCommand& command) {
  for (const fs::path& output : command.outputs) check_output(output, command);
}

int search_and_write(const UnfoldCommand& command, const CliModel& model, const Interrupts& interrupts,
                     double start) {
  for (const std::string& notice : model.notices) complain("note: " + notice);

  const Mesh& mesh = model.project.dual->mesh();
  const SolveOptions options = solve_options(command, model);
  SolveResult result;
  const double search_start = now_seconds();
  if (model.net) {
    result = *model.net;
  } else {
    ProgressLine line;
    const auto limit = command.time_limit_s > 0 ? std::optional(command.time_limit_s) : std::nullopt;
    const Watched watched = run_watched(
        interrupts,
        [&](Progress& progress) {
          result = solve(model.project.dual, options, progress, {line.snapshots(), {}});
        },
        limit, &line);
    if (watched.was_interrupted) return kCancelled;
  }
  UnfoldOutcome outcome{mesh, result, now_seconds() - search_start, 0};
  Drawing drawing;
  if (result.is_proved && !command.outputs.empty()) drawing = draw(command, model, outcome);
  outcome.wall_seconds = now_seconds() - start;
  if (command.is_json) {
    Json json = unfold_json(outcome, command);
    if (model.replaced) json.set("replaced", replaced_json(*model.replaced));
    print(to_text(json, {.is_indented = true}));
  } else if (result.is_proved) {
    tell_success(command, outcome, drawing);
  }
  if (result.is_proved) return kDone;
  if (result.isolated_face.is_valid()) {
    complain(isolated_face_sentence(mesh, result.isolated_face));
    return kImpossible;
  }
  complain(unsolved_sentence(mesh, result, command));
  return kUnsolved;
}

int run_unfold(const UnfoldCommand& asked) {
  UnfoldCommand command = asked;
  const double start = now_seconds();
  check_outputs(command);
  command.paper.margin_mm = command.printing.margin_mm.value_or(command.paper.margin_mm);
  static_cast<void>(page_frame(command.paper));  // refuses unknown paper
  const Interrupts interrupts;
  CliModel model;
  const Watched watched =
      run_watched(interrupts, [&](Progress& progress) { model = read_cli_model(command, progress); });
  if (watched.was_interrupted) return kCancelled;
  take_printing(model.project, command);
  return search_and_write(command, model, interrupts, start);
}

}  // namespace netwright
