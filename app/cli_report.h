// How results are told: as a few calm lines for people, or as one JSON object for programs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/cli_model.h"
#include "app/cli_options.h"
#include "core/base/json.h"
#include "core/mesh/mesh_report.h"
#include "core/project/replace_model.h"
#include "core/sheet/write.h"
#include "core/solve/solve.h"
#include "core/unfold/verify.h"

namespace netwright {

struct UnfoldOutcome {
  const Mesh& mesh;
  const SolveResult& result;
  double search_seconds = 0;  ///< wall clock
  double wall_seconds = 0;    ///< of everything, reading and writing included
};

/// "bunny.obj: 370 faces, closed, genus 0"
std::string model_line(const Mesh& mesh);
/// "One piece, proved: no overlaps · 61 moves · 12 ms · seed 7"
std::string result_line(const UnfoldOutcome& outcome, const UnfoldCommand& command);
/// How well the net can be built, a line for each thing; what to look at begins with "warning:" or
/// "trouble:".
std::string build_report(const Net& net, const PageLayout& layout);
/// The same as a list of objects with grade (fact, warning, trouble) and text.
Json build_report_json(const Net& net, const PageLayout& layout);
/// "87 glue tabs, 3 cuts without room for one."
std::string tabs_line(const GlueTabs& tabs);
/// "Written: bunny.pdf (2 pages with the instructions, A4, the model 83 mm high)"
std::string files_line(const WrittenDrawing& written, const PageLayout& layout, const UnfoldCommand& command);
/// Why there is no net, and what to try.
std::string unsolved_sentence(const Mesh& mesh, const SolveResult& result, const UnfoldCommand& command);

/// What became of the old version's work, sentence by sentence.
void print_replaced(const ReplaceReport& report);
Json replaced_json(const ReplaceReport& report);

/// What softening changed.
std::string softened_sentence(const CliModel::Softened& softened);
Json softened_json(const CliModel::Softened& softened);

Json unfold_json(const UnfoldOutcome& outcome, const UnfoldCommand& command);
Json verify_json(const FlatNet& net, const VerifyReport& report, const VerifyCommand& command);
Json info_json(const MeshReport& report, const std::string& refusal, const InfoCommand& command);

/// Text with a line end, to standard output.
void print(const std::string& text);
/// "netwright-cli: TEXT" to standard error.
void complain(const std::string& sentence);

}  // namespace netwright
