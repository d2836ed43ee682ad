// netwright-cli unfold: refuse early what cannot work, read, search under watch, and write only a proved net.
#include <unistd.h>

#include <algorithm>
#include <memory>
#include <system_error>

#include "app/cli_aims.h"
#include "app/cli_commands.h"
#include "app/cli_model.h"
#include "app/cli_pieces.h"
#include "app/cli_report.h"
#include "app/cli_search.h"
#include "app/cli_watch.h"
#include "app/cli_why.h"
#include "core/base/counted.h"
#include "core/base/error.h"
#include "core/project/carry_pins.h"
#include "core/project/commands.h"
#include "core/project/polish_aim.h"
#include "core/project/project_file.h"
#include "core/project/proof_file.h"
#include "core/project/soften.h"
#include "core/project/tab_aim.h"
#include "core/sheet/number_text.h"
#include "core/sheet/page_frame.h"
#include "core/sheet/split_to_fit.h"
#include "core/sheet/write.h"
#include "core/solve/prove_impossible.h"
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
  Project printed = project;
  printed.paper = command.paper;
  printed.size = command.size;
  options.polish = polish_aim(printed, command.polish);
  options.tabs = tab_aim(command.paper, command.size, project.tabs);
  return options;
}

void take_exports(ExportSettings& exports, const ExportSettings& named) {
  exports.is_one_file |= named.is_one_file;
  exports.real_dashes |= named.real_dashes;
  exports.live_text |= named.live_text;
  if (named.png_dpi != ExportSettings{}.png_dpi) exports.png_dpi = named.png_dpi;
  if (named.instructions != InstructionPage::None) exports.instructions = named.instructions;
}

/// What was found, and where it goes on paper.
struct Drawing {
  Net net;         ///< the one that was found, or cut into pieces that fit
  HandEdit split;  ///< how it was cut
  PageLayout layout;
  WrittenDrawing written;  ///< all files, and the pages of the one that has most
};

WrittenDrawing write_one(const fs::path& output, const UnfoldCommand& command, const CliModel& model,
                         const UnfoldOutcome& outcome, const Drawing& drawing) {
  if (has_project_name(output)) {
    write_project(output, model, outcome.result, drawing.split, outcome.search_seconds, command);
    return {{output}};
  }
  const Project& project = model.project;
  const SheetInfo info{project.sheet.words.title, true, static_cast<std::uint64_t>(command.seed)};
  if (is_package(output, command)) {
    const PageLayout clear =
        arrange(drawing.net, cutter_paper(command.paper, *command.cutter), command.size, project.tabs);
    const CutterPackage package = write_cutter_package(output, drawing.net, clear, info, project.sheet,
                                                       project.exports, *command.cutter);
    for (const std::string& note : package.notes) complain("note: " + note);
    return {package.files, clear.pages.size()};
  }
  return write_drawing(output, drawing.net, drawing.layout, info, project.sheet, project.exports);
}

/// Cut into pieces where that was asked for; must-folds stay.
HandEdit split_of(const UnfoldCommand& command, const CliModel& model, const Net& net) {
  if (!command.print.splits_to_fit) return {net.tree, {}, {}, {}};
  const Constraints pins = pins_with_edits(model.project);
  return split_to_fit(net, command.paper, command.size, model.project.tabs,
                      [&](EdgeId e) { return pin_of(pins, e) != EdgePin::MustFold; });
}

void add(const WrittenDrawing& one, WrittenDrawing& all) {
  std::vector<fs::path> files = std::move(all.files);
  files.insert(files.end(), one.files.begin(), one.files.end());
  if (one.n_pages > all.n_pages) all = one;
  all.files = std::move(files);
}

/// All files or none: when one cannot be written, those that this run added before it go again.
Drawing draw(const UnfoldCommand& command, const CliModel& model, const UnfoldOutcome& outcome) {
  Drawing drawing;
  drawing.split = split_of(command, model, outcome.result.net);
  drawing.net =
      drawing.split.cut.empty() ? outcome.result.net : layout(outcome.result.net.dual, drawing.split.tree);
  drawing.layout = arrange(drawing.net, command.paper, command.size, model.project.tabs);
  std::vector<fs::path> added;
  try {
    for (const fs::path& output : command.outputs) {
      std::error_code ignored;
      const bool was_there = fs::exists(output, ignored);
      const WrittenDrawing one = write_one(output, command, model, outcome, drawing);
      add(one, drawing.written);
      if (!was_there) added.insert(added.end(), one.files.begin(), one.files.end());
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
  if (const std::string line = polish_line(outcome.result, command.polish); !line.empty()) print(line);
  if (!drawing.split.cut.empty())
    print("Cut into " + std::to_string(drawing.net.n_pieces) + " pieces that fit a page of " +
          command.paper.format + ".");
  if (!drawing.written.files.empty() && !drawing.layout.tabs.tabs.empty())
    print(tabs_line(drawing.layout.tabs));
  if (command.has_report) print(build_report(drawing.net, drawing.layout));
  if (!drawing.written.files.empty()) print(files_line(drawing.written, drawing.layout, command));
}

/// Pins are tried out for as long as the search was allowed to take. None where there is nothing to explain.
std::optional<WhyNot> ask_why(const UnfoldCommand& command, const SolveResult& result,
                              const SolveOptions& options, const Interrupts& interrupts) {
  if (result.is_proved || result.isolated_face.is_valid()) return std::nullopt;
  WhyNot why;
  const auto limit = command.time_limit_s > 0 ? std::optional(command.time_limit_s) : std::nullopt;
  run_watched(
      interrupts, [&](Progress& progress) { why = look_into(result, options, progress); }, limit);
  return why;
}

/// The model with as little of its shape changed as gives a net; none when nothing within the limit helps.
std::optional<CliModel> softened(const UnfoldCommand& command, const CliModel& model,
                                 const SolveResult& result, const SolveOptions& options,
                                 const Interrupts& interrupts) {
  const Project& project = model.project;
  const double in_mm = guess_unit(*project.source).in_mm;
  Softening found;
  const auto limit = command.time_limit_s > 0 ? std::optional(command.time_limit_s) : std::nullopt;
  run_watched(
      interrupts,
      [&](Progress& progress) {
        found = soften(project.source, project.recipe, *project.made, options, find_trouble(result),
                       *command.soften_mm / in_mm, progress);
      },
      limit);
  if (!found.is_found()) return std::nullopt;
  CliModel soft = model;
  soft.start = nullptr;
  soft.softened = {found.n_moved, found.deviation * in_mm};
  soft.project.pins = carry_pins(project.pins, project.dual->mesh(), found.made->dual->mesh()).pins;
  soft.project.edits = {};
  soft.project.recipe = found.recipe;
  soft.project.dual = found.made->dual;
  soft.project.made = found.made;
  soft.notices = {softened_sentence(*soft.softened)};
  return soft;
}

}  // namespace

void check_outputs(const UnfoldCommand& command) {
  for (const fs::path& output : command.outputs) check_output(output, command);
  if (!command.proof.empty()) check_folder(command.proof);
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
  if (result.impossible != nullptr && !command.proof.empty())
    write_proof(command.proof, mesh, *result.impossible);
  if (!result.is_proved && command.soften_mm && !model.softened) {
    if (const auto soft = softened(command, model, result, options, interrupts))
      return search_and_write(command, *soft, interrupts, start);
    complain("note: No change of shape within " + short_number(*command.soften_mm) + " mm gave a net.");
  }
  const std::optional<PiecesResult> pieces = look_for_pieces(command, result, options, interrupts);
  if (interrupts.has_come()) return kCancelled;
  const bool has_pieces = pieces && take_pieces(command, *pieces, result);
  UnfoldOutcome outcome{mesh, result, now_seconds() - search_start, 0};
  const std::optional<WhyNot> why = ask_why(command, result, options, interrupts);
  Drawing drawing;
  if (result.is_proved && (!command.outputs.empty() || command.has_report))
    drawing = draw(command, model, outcome);
  outcome.wall_seconds = now_seconds() - start;
  if (command.is_json) {
    Json json = unfold_json(outcome, command);
    if (!drawing.written.files.empty()) {
      json.set("glue_tabs", static_cast<std::int64_t>(drawing.layout.tabs.tabs.size()));
      json.set("cuts_without_tab", static_cast<std::int64_t>(drawing.layout.tabs.missing.size()));
    }
    if (command.print.splits_to_fit && !drawing.written.files.empty())
      json.set("printed_pieces", drawing.net.n_pieces);
    if (command.has_report && result.is_proved)
      json.set("report", build_report_json(drawing.net, drawing.layout));
    if (result.polished) json.set("polish", polish_json(result));
    if (model.replaced) json.set("replaced", replaced_json(*model.replaced));
    if (model.softened) json.set("softened", softened_json(*model.softened));
    if (why) json.set("why", why_json(*why, mesh));
    if (pieces) json.set("choices", pieces_json(*pieces));
    print(to_text(json, {.is_indented = true}));
  } else if (result.is_proved) {
    tell_success(command, outcome, drawing);
    if (has_pieces)
      for (const std::string& line : pieces_lines(command, *pieces)) print(line);
  }
  if (result.is_proved) return kDone;
  if (pieces && !pieces->choices.empty())
    complain("note: there are nets of " + counted(pieces->choices.front().net.n_pieces, "piece", "pieces") +
             ", more than --pieces allows.");
  if (result.isolated_face.is_valid()) {
    complain(isolated_face_sentence(mesh, result.isolated_face));
    return kImpossible;
  }
  if (result.impossible != nullptr) {
    complain(impossible_sentence(mesh));
  } else {
    complain(unsolved_sentence(mesh, result, command));
  }
  for (const std::string& line : why_lines(*why, mesh)) complain("note: " + line);
  return result.impossible != nullptr ? kImpossible : kUnsolved;
}

int run_unfold(const UnfoldCommand& asked) {
  UnfoldCommand command = asked;
  const double start = now_seconds();
  check_outputs(command);
  static_cast<void>(page_frame(command.paper));  // refuses unknown paper
  const Interrupts interrupts;
  CliModel model;
  const Watched watched =
      run_watched(interrupts, [&](Progress& progress) { model = read_cli_model(command, progress); });
  if (watched.was_interrupted) return kCancelled;
  take_exports(model.project.exports, command.exports);
  return search_and_write(command, model, interrupts, start);
}

}  // namespace netwright
