// netwright-cli verify and info: they only look.
#include "app/cli_commands.h"
#include "app/cli_report.h"
#include "core/mesh/read.h"
#include "core/mesh/repair.h"
#include "core/sheet/fold_file.h"

namespace netwright {
namespace {

constexpr int kGood = 0;
constexpr int kNotGood = 2;

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
  const std::string name = soup.name;
  const PreparedModel model = prepare(soup);
  if (command.is_json) {
    print(to_text(info_json(model.report, model.refusal, command), {.is_indented = true}));
    return model.is_fit() ? kGood : kNotGood;
  }
  print(name);
  bool is_refusal_told = false;
  for (const MeshReport::Line& line : model.report.lines) {
    print("  " + prefix(line.kind) + line.text);
    is_refusal_told = is_refusal_told || line.text == model.refusal;
  }
  if (model.is_fit()) {
    print("Fit to unfold.");
  } else if (!is_refusal_told) {
    print(model.refusal);
  }
  return model.is_fit() ? kGood : kNotGood;
}

}  // namespace netwright
