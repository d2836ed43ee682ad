// netwright-cli verify and info: they only look.
#include <algorithm>
#include <span>
#include <string_view>

#include "app/cli_commands.h"
#include "app/cli_recipe.h"
#include "app/cli_report.h"
#include "core/base/counted.h"
#include "core/base/error.h"
#include "core/mesh/model_parts.h"
#include "core/mesh/read.h"
#include "core/mesh/repair.h"
#include "core/project/project_file.h"
#include "core/project/proof_file.h"
#include "core/sheet/fold_file.h"

namespace netwright {
namespace {

constexpr int kGood = 0;
constexpr int kNotGood = 2;

std::string_view kind_name(MeshReport::Line::Kind kind) {
  switch (kind) {
    case MeshReport::Line::Kind::Fact:
      return "fact";
    case MeshReport::Line::Kind::Notice:
      return "notice";
    case MeshReport::Line::Kind::Problem:
      return "problem";
  }
  return "";
}

/// Numbers as the sentences have them, counted from 1; of very many culprits the first thousand.
Json numbers_json(std::span<const int> numbers) {
  constexpr std::size_t kShown = 1000;
  Json json{Json::Array{}};
  for (const int number : numbers.first(std::min(numbers.size(), kShown))) json.add(number + 1);
  return json;
}

Json finding_json(const MeshReport::Line& line) {
  Json json;
  json.set("topic", topic_name(line.topic));
  json.set("kind", kind_name(line.kind));
  json.set("count", line.count);
  json.set("text", line.text);
  if (!line.faces.empty()) json.set("faces", numbers_json(line.faces));
  if (!line.points.empty()) json.set("points", numbers_json(line.points));
  if (!line.edges.empty()) {
    Json edges{Json::Array{}};
    constexpr std::size_t kShown = 1000;
    for (std::size_t i = 0; i < std::min(line.edges.size(), kShown); ++i)
      edges.add(numbers_json(line.edges[i]));
    json.set("edges", edges);
  }
  return json;
}

/// What repair would do to a model that is not fit; nothing for one that is.
struct Prospect {
  std::vector<std::string> steps;
  bool is_repairable = false;
};

Prospect try_repair(const PolygonSoup& soup, const PreparedModel& model) {
  if (model.is_fit()) return {};
  Progress progress;
  const RepairResult result = repair_all(soup, {}, progress);
  return {result.done, result.is_fit()};
}

/// None when there is only one.
std::vector<ModelPart> separate_parts(const PolygonSoup& soup, const PreparedModel& model) {
  Progress progress;
  std::vector<ModelPart> parts = listed_parts(soup, model, progress).parts;
  return parts.size() < 2 ? std::vector<ModelPart>() : parts;
}

Json part_json(const ModelPart& part) {
  Json json;
  json.set("faces", static_cast<std::int64_t>(part.faces.size()));
  json.set("size", Json::Array{part.size.x, part.size.y, part.size.z});
  json.set("inner", part.is_inner);
  json.set("small", part.is_small);
  return json;
}

void print_parts(const std::vector<ModelPart>& parts) {
  constexpr std::size_t kShown = 30;
  for (std::size_t p = 0; p < std::min(parts.size(), kShown); ++p) {
    const ModelPart& part = parts[p];
    print("  Part " + std::to_string(p + 1) + ": " +
          counted(static_cast<std::int64_t>(part.faces.size()), "face", "faces") + ", " +
          size_text(part.size) + (part.is_inner ? ", inside another one" : "") +
          (part.is_small ? ", small" : ""));
  }
  if (parts.size() > kShown)
    print("  and " + counted(static_cast<std::int64_t>(parts.size() - kShown), "part", "parts") + " more");
}

Json full_json(const PolygonSoup& soup, const MeshReport& report, const PreparedModel& model,
               const InfoCommand& command) {
  Json json = info_json(report, model.refusal, command);
  json.set("border_loops", report.n_border_loops);
  json.set("border_length", report.border_length);
  json.set("size", Json::Array{report.size.x, report.size.y, report.size.z});
  json.set("unit", guess_unit(soup).name);
  Json findings{Json::Array{}};
  for (const MeshReport::Line& line : report.lines) findings.add(finding_json(line));
  json.set("findings", findings);
  const Prospect prospect = try_repair(soup, model);
  Json steps{Json::Array{}};
  for (const std::string& step : prospect.steps) steps.add(step);
  json.set("repairable", prospect.is_repairable);
  json.set("repair", steps);
  Json parts{Json::Array{}};
  for (const ModelPart& part : separate_parts(soup, model)) parts.add(part_json(part));
  json.set("parts", parts);
  return json;
}

std::string prefix(MeshReport::Line::Kind kind) {
  switch (kind) {
    case MeshReport::Line::Kind::Fact:
      return "";
    case MeshReport::Line::Kind::Notice:
      return "Note: ";
    case MeshReport::Line::Kind::Problem:
      return "Problem: ";
  }
  return "";
}

/// The net in a .fold file, or the one that a project's tree is laid out to.
FlatNet read_net(const std::filesystem::path& file) {
  if (!is_project_file(file)) return read_fold(file);
  const Project project = load_project(file).project;
  if (!project.tree)
    throw Error(ErrorKind::Read, file.string() + " holds a model without a net; unfold it first.");
  return to_flat_net(layout(project.dual, *project.tree), 1);
}

Json project_json(const Project& project, const InfoCommand& command) {
  const MadeModel& made = *project.made;
  Json json = info_json(made.report, "", command);
  Json own;
  own.set("source", project.source->name);
  own.set("source_faces", project.source->n_faces());
  Json done{Json::Array{}};
  for (const std::string& sentence : made.done) done.add(sentence);
  own.set("done", done);
  own.set("has_net", project.tree != nullptr);
  own.set("verified", project.run && project.run->is_proved);
  if (project.run) own.set("seed", std::to_string(project.run->seed));
  own.set("paper", project.paper.format);
  json.set("project", own);
  return json;
}

std::string net_line(const Project& project) {
  if (!project.tree) return "No net yet.";
  const std::size_t n = project.tree->roots().size();
  std::string line = n == 1 ? "A net in one piece" : "A net in " + std::to_string(n) + " pieces";
  if (!project.run || !project.run->is_proved) return line + ", not proved.";
  return line + ", proved (seed " + std::to_string(project.run->seed) + ").";
}

void tell_of_project(const Project& project, const InfoCommand& command) {
  if (command.is_json) {
    print(to_text(project_json(project, command), {.is_indented = true}));
    return;
  }
  print("A project made of " + project.source->name);
  for (const std::string& sentence : project.made->done) print("  " + sentence);
  for (const MeshReport::Line& line : project.made->report.lines) print("  " + prefix(line.kind) + line.text);
  print(net_line(project));
}

/// 0 when the proof holds, which means that there is no net.
int verify_proof(const VerifyCommand& command) {
  const ProofFile file = read_proof(command.file);
  const ImpossibilityVerdict verdict = verify_impossible(file.mesh, file.proof);
  if (command.is_json) {
    Json json;
    json.set("file", command.file.string());
    json.set("faces", static_cast<std::int64_t>(file.mesh.n_faces()));
    json.set("regions", static_cast<std::int64_t>(file.proof.regions.size()));
    json.set("steps", static_cast<std::int64_t>(file.proof.nodes.size()));
    json.set("proved", verdict.is_proved);
    json.set("fault", verdict.fault);
    print(to_text(json, {.is_indented = true}));
  } else if (verdict.is_proved) {
    print("Proved: " + file.mesh.name() + ", " +
          counted(static_cast<std::int64_t>(file.mesh.n_faces()), "face", "faces") +
          ", has no net in one piece (" +
          counted(static_cast<std::int64_t>(file.proof.nodes.size()), "step", "steps") + " checked).");
  } else {
    print("Not a proof: " + verdict.fault);
  }
  return verdict.is_proved ? kGood : kNotGood;
}

}  // namespace

int run_verify(const VerifyCommand& command) {
  if (has_proof_name(command.file)) return verify_proof(command);
  const FlatNet net = read_net(command.file);
  VerifyReport report = verify(net, 0);
  if (report.pieces <= command.most_pieces) report = verify(net, report.pieces);
  if (command.is_json) {
    print(to_text(verify_json(net, report, command), {.is_indented = true}));
  } else if (report.is_net) {
    const std::string pieces = report.pieces == 1 ? "one piece" : std::to_string(report.pieces) + " pieces";
    print("A net: " + std::to_string(net.faces.size()) + " faces in " + pieces +
          ", true to the model, proved free of overlaps.");
  } else {
    print("Not a net:");
    for (const std::string& fault : report.faults) print("  " + fault);
  }
  return report.is_net ? kGood : kNotGood;
}

int run_info(const InfoCommand& command) {
  if (is_project_file(command.model)) {
    tell_of_project(load_project(command.model).project, command);
    return kGood;
  }
  const PolygonSoup soup = read_soup(command.model);
  const PreparedModel model = prepare(soup);
  const MeshReport report = report_on(soup);
  if (command.is_json) {
    print(to_text(full_json(soup, report, model, command), {.is_indented = true}));
    return model.is_fit() ? kGood : kNotGood;
  }
  print(soup.name);
  for (const MeshReport::Line& line : report.lines) print("  " + prefix(line.kind) + line.text);
  const Prospect prospect = try_repair(soup, model);
  print_parts(separate_parts(soup, model));
  if (model.is_fit()) {
    print("Fit to unfold.");
    return kGood;
  }
  print("Not fit to unfold as it is. " + model.refusal);
  if (prospect.is_repairable) {
    print("With --repair it is fit to unfold:");
    for (const std::string& step : prospect.steps) print("  " + step);
  }
  return kNotGood;
}

}  // namespace netwright
