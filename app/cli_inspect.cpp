// netwright-cli verify and info: they only look.
#include <algorithm>
#include <span>
#include <string_view>

#include "app/cli_commands.h"
#include "app/cli_report.h"
#include "core/mesh/read.h"
#include "core/mesh/repair.h"
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

}  // namespace

int run_verify(const VerifyCommand& command) {
  const FlatNet net = read_fold(command.file);
  const VerifyReport report = verify(net, 0);
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
  const PolygonSoup soup = read_soup(command.model);
  const PreparedModel model = prepare(soup);
  const MeshReport report = report_on(soup);
  if (command.is_json) {
    print(to_text(full_json(soup, report, model, command), {.is_indented = true}));
    return model.is_fit() ? kGood : kNotGood;
  }
  print(soup.name);
  for (const MeshReport::Line& line : report.lines) print("  " + prefix(line.kind) + line.text);
  if (model.is_fit()) {
    print("Fit to unfold.");
    return kGood;
  }
  print("Not fit to unfold as it is. " + model.refusal);
  if (const Prospect prospect = try_repair(soup, model); prospect.is_repairable) {
    print("With --repair it is fit to unfold:");
    for (const std::string& step : prospect.steps) print("  " + step);
  }
  return kNotGood;
}

}  // namespace netwright
