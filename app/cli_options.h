// What was asked for on the command line, as plain values. Only cli_options.cpp knows the library that reads
// it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "app/cli_print.h"
#include "core/base/paper.h"
#include "core/project/recipe.h"
#include "core/sheet/cutter_package.h"
#include "core/sheet/pages.h"
#include "core/solve/solve.h"

namespace netwright {

/// Parts of the model that get no piece.
struct LeaveOut {
  bool inner = false;
  bool small = false;
  std::vector<int> numbers{};  ///< as info lists them, counted from 1
  [[nodiscard]] bool is_any() const { return inner || small || !numbers.empty(); }
};

struct UnfoldCommand {
  std::filesystem::path model;
  std::vector<std::filesystem::path> outputs;
  std::int64_t seed = 0;     ///< 0 or more
  double time_limit_s = 60;  ///< 0 = none
  int streams = 2;
  int threads = 0;  ///< 0 = as many as there are streams and cores
  SearchStyle search = SearchStyle::Fast;
  PolishSettings polish;
  /// Where there is no net: corners may be moved so far, in mm of the file, until there is one.
  std::optional<double> soften_mm;
  Recipe recipe;                  ///< what is done to the model first,
  std::optional<double> weld_mm;  ///< and what can only be said in the file's terms once it is read:
  LeaveOut leave_out;
  int root = 0;                                ///< face number counted from 1, 0 = none
  std::vector<std::pair<int, int>> must_fold;  ///< edges as the numbers of their two faces, counted from 1
  std::vector<std::pair<int, int>> must_cut;   ///< likewise
  std::vector<std::vector<int>> together;      ///< patches as numbers of faces, counted from 1
  PaperSetup paper;
  PrintSize size;
  PrintOptions print;                  ///< what is not named is a project's to decide
  ExportSettings exports;              ///< what differs from the usual takes a project's place
  std::optional<CutterPreset> cutter;  ///< outputs without an extension are folders for its package
  int most_pieces = 1;                 ///< of a net where none of one piece is found
  bool fewest_pieces = false;          ///< as many as it takes
  std::filesystem::path proof;         ///< written where it is proved that there is no net; empty = nowhere
  bool is_json = false;
  bool has_report = false;  ///< how well the net can be built, beside the result

  /// Which of these were named; the others are a project's to decide where one is unfolded.
  struct Given {
    bool seed = false;
    bool search = false;
    bool recipe = false;
    bool pins = false;
    bool paper = false;
    bool size = false;
  } given;
};

/// Another version of the model in a project's place, unfolded as the project has it.
struct ReplaceCommand {
  std::filesystem::path project;
  UnfoldCommand unfold;  ///< the new model, the outputs and how to search; all else is the project's
  bool is_repair = false;
};

struct VerifyCommand {
  std::filesystem::path file;
  int most_pieces = 0;  ///< in all; 0 = one for each part of the model
  bool is_json = false;
};

struct InfoCommand {
  std::filesystem::path model;
  bool is_json = false;
};

struct BenchCommand {
  std::vector<std::filesystem::path> paths;  ///< model files and folders; none: only report what tsv holds
  std::int64_t seeds = 1;                    ///< each model is unfolded with the seeds 0 … seeds - 1
  double time_limit_s = 60;                  ///< of one run, 0 = none
  int streams = 1;
  int threads = 1;  ///< 0 = as many as there are streams and cores
  SearchStyle search = SearchStyle::Fast;
  double polish = 0;             ///< effort for each net; 0 = none is polished
  std::filesystem::path tsv;     ///< empty = keep no rows
  std::filesystem::path report;  ///< folder for a page with plots, empty = none
};

/// --help and --version: nothing is left to do but to print.
struct PrintCommand {
  std::string text;
};

using Command =
    std::variant<PrintCommand, UnfoldCommand, ReplaceCommand, VerifyCommand, InfoCommand, BenchCommand>;

/// Throws Error(Usage) with one sentence.
Command parse_command(int argc, const char* const* argv);

}  // namespace netwright
