// netwright-cli unfold: refuse early what cannot work, read, search under watch, and write only a proved net.
#include <unistd.h>

#include <algorithm>
#include <memory>
#include <system_error>

#include "app/cli_commands.h"
#include "app/cli_report.h"
#include "app/cli_watch.h"
#include "core/base/error.h"
#include "core/mesh/read.h"
#include "core/project/make_model.h"
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
  return text;
}

/// What can be known to fail is refused before any time is spent on the search.
void check_output(const fs::path& path) {
  if (!is_export_format(path)) {
    throw Error(ErrorKind::Usage, "Cannot tell how to write " + path.string() +
                                      ": give it one of the extensions " + known_formats() + ".");
  }
  std::error_code ignored;
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, ignored)) {
    throw Error(ErrorKind::Write, "Cannot write " + path.string() + ": the folder " + folder.string() +
                                      " does not exist, so make it first.");
  }
  if (fs::is_directory(path, ignored)) {
    throw Error(ErrorKind::Write,
                "Cannot write " + path.string() + ": it is a folder, so choose another name.");
  }
  if (access(folder.c_str(), W_OK) != 0) {
    throw Error(ErrorKind::Write, "Cannot write " + path.string() + ": the folder " + folder.string() +
                                      " may not be written to, so choose another one.");
  }
}

struct Model {
  std::shared_ptr<const DualGraph> dual;
  std::vector<std::string> notices;
};

/// Where repairing would help and was not asked for, the refusal ends with how to ask.
std::string repair_hint(const std::shared_ptr<const PolygonSoup>& soup, Recipe recipe, Progress& progress) {
  if (recipe.repairs) return "";
  recipe = {.repairs = true, .uneven = recipe.uneven};
  return make_model(soup, recipe, nullptr, progress).dual ? " Or add --repair." : "";
}

Model read_model(const UnfoldCommand& command, Progress& progress) {
  const auto soup = std::make_shared<const PolygonSoup>(read_soup(command.model));
  MadeModel made = make_model(soup, command.recipe, nullptr, progress);
  if (!made.dual) throw Error(ErrorKind::Unfit, made.refusal + repair_hint(soup, command.recipe, progress));
  Model model;
  model.notices = std::move(made.done);
  for (const MeshReport::Line& line : made.report.lines) {
    if (line.kind == MeshReport::Line::Kind::Notice) model.notices.push_back(line.text);
  }
  model.dual = std::move(made.dual);
  return model;
}

SolveOptions solve_options(const UnfoldCommand& command, const Mesh& mesh) {
  SolveOptions options;
  options.seed = static_cast<std::uint64_t>(command.seed);
  options.streams = command.streams;
  options.threads = command.threads;
  options.search = command.search;
  if (command.root > static_cast<int>(mesh.n_faces())) {
    throw Error(ErrorKind::Usage, "There is no face " + std::to_string(command.root) +
                                      " to start from: " + mesh.name() + " has the faces 1 to " +
                                      std::to_string(mesh.n_faces()) + ".");
  }
  for (const FaceId face : mesh.faces()) {
    if (command.root > 0 && mesh.face_source(face) == command.root - 1) options.root = face;
  }
  return options;
}

/// All files or none: when one cannot be written, those that this run added before it go again.
std::vector<fs::path> write_all(const UnfoldCommand& command, const Net& net, const PageLayout& layout) {
  const SheetInfo info{"", true, static_cast<std::uint64_t>(command.seed)};
  std::vector<fs::path> written;
  std::vector<fs::path> added;
  try {
    for (const fs::path& output : command.outputs) {
      std::error_code ignored;
      const bool was_there = fs::exists(output, ignored);
      for (const fs::path& file : write_drawing(output, net, layout, info)) {
        written.push_back(file);
        if (!was_there) added.push_back(file);
      }
    }
  } catch (...) {
    std::error_code ignored;
    for (const fs::path& file : added) fs::remove(file, ignored);
    throw;
  }
  return written;
}

/// Pieces, and where they go on paper.
struct Drawing {
  PageLayout layout;
  std::vector<fs::path> files;
};

Drawing draw(const UnfoldCommand& command, const Net& net) {
  Drawing drawing;
  drawing.layout = arrange(net, command.paper, command.size);
  drawing.files = write_all(command, net, drawing.layout);
  return drawing;
}

void tell_success(const UnfoldCommand& command, const UnfoldOutcome& outcome, const Drawing& drawing) {
  print(model_line(outcome.mesh));
  print(result_line(outcome, command));
  if (!drawing.files.empty()) print(files_line(drawing.files, drawing.layout, command));
}

}  // namespace

int run_unfold(const UnfoldCommand& command) {
  const double start = now_seconds();
  for (const fs::path& output : command.outputs) check_output(output);
  static_cast<void>(page_frame(command.paper));  // refuses unknown paper
  const Interrupts interrupts;
  Model model;
  Watched watched =
      run_watched(interrupts, [&](Progress& progress) { model = read_model(command, progress); });
  if (watched.was_interrupted) return kCancelled;
  for (const std::string& notice : model.notices) complain("note: " + notice);

  const Mesh& mesh = model.dual->mesh();
  const SolveOptions options = solve_options(command, mesh);
  SolveResult result;
  const double search_start = now_seconds();
  {
    ProgressLine line;
    const auto limit = command.time_limit_s > 0 ? std::optional(command.time_limit_s) : std::nullopt;
    watched = run_watched(
        interrupts,
        [&](Progress& progress) {
          result = solve(model.dual, options, progress, {line.snapshots(), {}});
        },
        limit, &line);
  }
  if (watched.was_interrupted) return kCancelled;
  UnfoldOutcome outcome{mesh, result, now_seconds() - search_start, 0};
  Drawing drawing;
  if (result.is_proved && !command.outputs.empty()) drawing = draw(command, result.net);
  outcome.wall_seconds = now_seconds() - start;
  if (command.is_json) {
    print(to_text(unfold_json(outcome, command), {.is_indented = true}));
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

}  // namespace netwright
