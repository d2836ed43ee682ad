// Words and JSON for the results of the three commands.
#include "app/cli_report.h"

#include <array>
#include <cstdio>

#include "core/base/counted.h"
#include "core/sheet/buildability.h"
#include "core/sheet/number_text.h"

namespace netwright {
namespace {

template <class... Values>
std::string format(const char* pattern, Values... values) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), pattern, values...);
  return text.data();
}

std::string duration(double seconds) {
  if (seconds < 0.001) return "under 1 ms";
  if (seconds < 1) return format("%.0f ms", seconds * 1000);
  return format("%.1f s", seconds);
}

std::string pieces_in_words(int n) { return n == 1 ? "One piece" : std::to_string(n) + " pieces"; }

constexpr std::array<const char*, 3> kGrades = {"fact", "warning", "trouble"};

const char* grade_word(const BuildLine& line) { return kGrades[static_cast<std::size_t>(line.grade)]; }

}  // namespace

std::string model_line(const Mesh& mesh) {
  std::string line = mesh.name() + ": " + counted(static_cast<std::int64_t>(mesh.n_faces()), "face", "faces");
  if (mesh.n_components() > 1) line += ", " + std::to_string(mesh.n_components()) + " components";
  line += mesh.is_closed() ? ", closed" : ", open";
  return line + ", genus " + std::to_string(mesh.genus());
}

std::string result_line(const UnfoldOutcome& outcome, const UnfoldCommand& command) {
  return pieces_in_words(outcome.result.proof.pieces) + ", proved: no overlaps · " +
         counted(outcome.result.moves, "move", "moves") + " · " + duration(outcome.search_seconds) +
         " · seed " + std::to_string(command.seed);
}

std::string build_report(const Net& net, const PageLayout& layout) {
  std::string text;
  for (const BuildLine& line : lines_of(judge(net, layout), net)) {
    const bool is_fact = line.grade == BuildLine::Grade::Fact;
    text += (text.empty() ? "" : "\n") + std::string(is_fact ? "" : grade_word(line)) +
            (is_fact ? "" : ": ") + line.text;
  }
  return text;
}

Json build_report_json(const Net& net, const PageLayout& layout) {
  Json list{Json::Array{}};
  for (const BuildLine& line : lines_of(judge(net, layout), net)) {
    Json one;
    one.set("grade", grade_word(line));
    one.set("text", line.text);
    list.add(std::move(one));
  }
  return list;
}

std::string tabs_line(const GlueTabs& tabs) {
  const auto count = [](const auto& list, const char* one, const char* many) {
    return counted(static_cast<std::int64_t>(list.size()), one, many);
  };
  return count(tabs.tabs, "glue tab", "glue tabs") +
         (tabs.missing.empty() ? "." : ", " + count(tabs.missing, "cut", "cuts") + " without room for one.");
}

std::string files_line(const WrittenDrawing& written, const PageLayout& layout,
                       const UnfoldCommand& command) {
  std::string line;
  for (const std::filesystem::path& file : written.files)
    line += (line.empty() ? "Written: " : ", ") + file.string();
  line += " (";
  if (written.n_pages > 0) line += pages_text(written) + ", ";
  return line + command.paper.format + ", the model " + short_number(layout.model_height_mm) + " mm high)";
}

std::string unsolved_sentence(const Mesh& mesh, const SolveResult& result, const UnfoldCommand& command) {
  if (result.overlaps.empty() && !result.proof.faults.empty()) {
    return mesh.name() + " was unfolded but the net did not pass the proof (" + result.proof.faults.front() +
           "); nothing was written.";
  }
  return mesh.name() + " could not be unfolded without overlaps within " +
         format("%g s", command.time_limit_s) + " (" +
         counted(static_cast<std::int64_t>(result.overlaps.size()), "overlap", "overlaps") +
         " left), so nothing was written; try another --seed or a longer --time-limit.";
}

std::string softened_sentence(const CliModel::Softened& softened) {
  return "Softened: moved " + counted(softened.n_corners, "corner", "corners") + ", the surface by at most " +
         short_number(softened.deviation_mm) + " mm.";
}

Json softened_json(const CliModel::Softened& softened) {
  Json json;
  json.set("corners", softened.n_corners);
  json.set("deviation_mm", softened.deviation_mm);
  return json;
}

Json unfold_json(const UnfoldOutcome& outcome, const UnfoldCommand& command) {
  const Mesh& mesh = outcome.mesh;
  const SolveResult& result = outcome.result;
  Json json;
  json.set("model", command.model.string());
  json.set("faces", static_cast<std::int64_t>(mesh.n_faces()));
  json.set("vertices", static_cast<std::int64_t>(mesh.n_vertices()));
  json.set("genus", mesh.genus());
  json.set("closed", mesh.is_closed());
  json.set("pieces", result.net.n_pieces);
  json.set("overlaps", static_cast<std::int64_t>(result.overlaps.size()));
  json.set("verified", result.is_proved);
  json.set("seed", command.seed);
  json.set("iterations", result.iterations);
  json.set("restarts", result.restarts);
  json.set("cpu_seconds", result.cpu_seconds);
  json.set("verify_seconds", result.verify_seconds);
  json.set("wall_seconds", outcome.wall_seconds);
  return json;
}

Json verify_json(const FlatNet& net, const VerifyReport& report, const VerifyCommand& command) {
  Json faults{Json::Array{}};
  for (const std::string& fault : report.faults) faults.add(fault);
  Json json;
  json.set("file", command.file.string());
  json.set("faces", static_cast<std::int64_t>(net.faces.size()));
  json.set("pieces", report.pieces);
  json.set("overlaps", report.overlaps);
  json.set("verified", report.is_net);
  json.set("deepest_overlap", report.deepest_overlap);
  json.set("worst_distortion", report.worst_distortion);
  json.set("faults", faults);
  return json;
}

Json info_json(const MeshReport& report, const std::string& refusal, const InfoCommand& command) {
  Json notices{Json::Array{}};
  for (const MeshReport::Line& line : report.lines) {
    if (line.kind == MeshReport::Line::Kind::Notice) notices.add(line.text);
  }
  Json json;
  json.set("model", command.model.string());
  json.set("faces", report.n_faces);
  json.set("vertices", report.n_vertices);
  json.set("components", report.n_components);
  json.set("genus", report.genus);
  json.set("closed", report.is_closed);
  json.set("manifold", report.is_manifold);
  json.set("border_edges", report.n_border_edges);
  json.set("uneven_faces", report.n_uneven_faces);
  json.set("self_intersections", report.n_self_intersections);
  json.set("fit", refusal.empty());
  json.set("notices", notices);
  json.set("problem", refusal.empty() ? Json() : Json(refusal));
  return json;
}

void print_replaced(const ReplaceReport& report) {
  print(report.summary);
  for (const MeshReport::Line& line : report.lines)
    print((line.kind == MeshReport::Line::Kind::Problem ? "  Not kept: " : "  ") + line.text);
}

Json replaced_json(const ReplaceReport& report) {
  Json notes{Json::Array{}};
  for (const MeshReport::Line& line : report.lines) notes.add(line.text);
  Json json;
  json.set("pins", report.n_pins);
  json.set("pins_kept", report.n_kept);
  json.set("pins_moved", report.n_moved);
  json.set("pins_lost", report.n_lost);
  json.set("folds", report.n_folds);
  json.set("folds_kept", report.n_folds_kept);
  json.set("notes", notes);
  return json;
}

void print(const std::string& text) { std::fputs((text + "\n").c_str(), stdout); }

void complain(const std::string& sentence) {
  std::fputs(("netwright-cli: " + sentence + "\n").c_str(), stderr);
}

}  // namespace netwright
