// The command line's words and their help, by CLI11.
#include "app/cli_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <sstream>

#include "app/cli_aims.h"
#include "core/base/error.h"
#include "core/base/paper.h"
#include "core/mesh/read.h"
#include "core/project/open_model.h"
#include "core/project/project_file.h"
#include "core/project/proof_file.h"
#include "core/sheet/write.h"

namespace netwright {
namespace {

constexpr const char* kFooter =
    "Exit status of unfold and replace: 0 one proved net per component, 1 usage, input or output error,\n"
    "2 not within the limits, 3 proved impossible, 130 cancelled; files are written only with 0. Of verify: "
    "0 a net, 2 not one,\n"
    "1 unreadable. Of info: 0 fit to unfold, 2 needs repair, 1 unreadable. Of bench: 0 when it ran through,\n"
    "1 usage or output error, 130 cancelled.";

constexpr const char* kReplaceFooter =
    "Pins and folds go to the same faces and edges of the new version, else to the nearest ones; the search\n"
    "starts from the folds that are left and changes only what it must. What could not be kept is told.\n"
    "Exit status as of unfold.";

constexpr const char* kBenchFooter =
    "A folder stands for its model files; a folder without any, for the folders in it that have some. Each\n"
    "folder gets one row in the table: runs, share of them with a proved net, runs refused because the "
    "model\n"
    "cannot be read or unfolded as it is, and CPU time of all searches, solved or not: minimum, mean, mean\n"
    "without times above mean + 3 standard deviations (filtered), median, percentiles by nearest rank, "
    "maximum.\n"
    "With several streams a second table tells the wall-clock time.\n"
    "OUT gets a tab-separated row per run as soon as it is over, and the table as comments at its end. "
    "Stopped\n"
    "and started again with the same options, bench goes on behind the last whole row in OUT. FOLDER gets a "
    "page,\n"
    "index.html, and its plots: times, success and iterations by number of faces, of folders whose models "
    "have\n"
    "all nearly as many, with fitted growth, beside the figures of the paper's section 5.1.";

/// How many characters it shows; all of them are one column wide.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

/// What is read, and what is kept of it.
std::string formats_help() {
  const auto rows = model_format_table();
  std::array<std::size_t, 7> widths{};
  for (const auto& row : rows) {
    for (std::size_t c = 0; c < widths.size(); ++c) widths[c] = std::max(widths[c], width_of(row[c]));
  }
  std::string text = "Model files and what is kept of them:\n";
  for (const auto& row : rows) {
    std::string line = " ";
    for (std::size_t c = 0; c < widths.size(); ++c)
      line += " " + row[c] + std::string(widths[c] - width_of(row[c]) + 1, ' ');
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

std::string model_help(const std::string& words) {
  std::string text = words + ":";
  for (const ModelFormat& format : model_formats()) {
    for (const std::string_view extension : format.extensions) text += " ." + std::string(extension);
  }
  return text + " ." + std::string(kProjectExtension);
}

std::string output_help() {
  std::string text = "File to write, its extension chooses:";
  for (const ExportFormat& format : export_formats()) text += " " + std::string(format.extension);
  return text + " ." + std::string(kProjectExtension) + "; repeatable";
}

/// A number within limits, refused in plain words.
template <class Number>
CLI::Validator within(Number least, Number most, const std::string& words) {
  return CLI::Validator(
      [=](std::string& text) {
        Number value{};
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool is_number = error == std::errc() && end == text.data() + text.size();
        return is_number && value >= least && value <= most ? std::string() : "it must be " + words;
      },
      "");
}

/// Face numbers with this between them, two at least ("12:13", "4,5,6"); nothing when it isn't that.
std::optional<std::vector<int>> numbers_in(const std::string& word, char between) {
  std::vector<int> numbers;
  std::istringstream rest(word);
  for (std::string part; std::getline(rest, part, between);) {
    const bool is_number = !part.empty() && part.size() < 10 &&
                           std::all_of(part.begin(), part.end(), [](char c) { return c >= '0' && c <= '9'; });
    if (!is_number || std::stoi(part) < 1) return std::nullopt;
    numbers.push_back(std::stoi(part));
  }
  if (word.back() == between || numbers.size() < 2 || (between == ':' && numbers.size() > 2))
    return std::nullopt;
  return numbers;
}

CLI::Validator faces_apart_by(char between) {
  return CLI::Validator(
      [between](std::string& word) {
        if (!word.empty() && numbers_in(word, between)) return std::string();
        return between == ':' ? std::string("it must be two face numbers counted from 1, as in 12:13")
                              : std::string("it must be face numbers counted from 1, as in 4,5,6");
      },
      "");
}

CLI::Validator word_that(std::string (*why_not)(const std::string&)) {
  return CLI::Validator([why_not](std::string& word) { return why_not(word); }, "");
}

class Reader {
 public:
  Reader() {
    app_.name("netwright-cli");
    app_.set_version_flag("--version", std::string("netwright-cli ") + NETWRIGHT_VERSION,
                          "Print the version and exit");
    app_.set_help_flag("-h,--help", "Print this help and exit");
    app_.require_subcommand(1);
    app_.footer(formats_help() + "\n" + kFooter);
    add_unfold();
    add_replace();
    add_verify();
    add_info();
    add_bench();
  }

  Command read(int argc, const char* const* argv) {
    try {
      app_.parse(argc, argv);
    } catch (const CLI::ParseError& stop) {
      if (stop.get_exit_code() == 0) return PrintCommand{text_of(stop)};
      if (app_.get_subcommands().empty()) {
        throw Error(ErrorKind::Usage,
                    "Say what to do: unfold, replace, verify, info or bench; see netwright-cli --help.");
      }
      throw Error(ErrorKind::Usage, sentence(stop.what()));
    }
    if (replace_app_->parsed()) return replace();
    if (verify_app_->parsed()) return verify_;
    if (info_app_->parsed()) return info_;
    if (bench_app_->parsed()) return bench();
    unfold_.search = style();
    if (!up_.empty()) unfold_.recipe.up = up_ == "y" ? UpAxis::Y : UpAxis::Z;
    if (is_repair_) unfold_.recipe.repairs = usual_repair().repairs;
    if (is_repair_) unfold_.recipe.uneven = usual_repair().uneven;
    unfold_.recipe.repairs.max_hole_edges = hole_edges_;
    unfold_.recipe.repairs.welds |= unfold_.weld_mm.has_value();
    for (const std::string& word : leave_out_) add_leave_out(word);
    if (is_flatten_) unfold_.recipe.uneven = UnevenFaces::Flatten;
    if (is_split_) unfold_.recipe.uneven = UnevenFaces::Split;
    take_size();
    note_given();
    take_pins();
    take_exports();
    apply_aims(aims_, unfold_.polish);
    for (const std::string& output : outputs_) unfold_.outputs.emplace_back(output);
    // "a4" is understood; what is printed calls it by its own name.
    if (const auto paper = find_paper(unfold_.paper.format)) {
      const bool is_custom = paper->name == kCustomPaper;
      unfold_.paper.format =
          is_custom ? custom_paper(paper->width_mm, paper->height_mm) : std::string(paper->name);
    }
    return unfold_;
  }

 private:
  void add_unfold() {
    CLI::App& app =
        *app_.add_subcommand("unfold", "Unfold a 3-D model into one piece of paper without overlaps");
    unfold_app_ = &app;
    app.add_option("MODEL", unfold_.model, model_help("Model file or project"))->required()->type_name("");
    app.add_option("-o,--output", outputs_, output_help())
        ->type_name("OUT")
        ->allow_extra_args(false)
        ->take_all();
    app.add_option("--seed", unfold_.seed, "Where the search starts: the same seed gives the same net")
        ->type_name("N")
        ->check(
            within(std::int64_t{0}, std::numeric_limits<std::int64_t>::max(), "a whole number, 0 or more"))
        ->capture_default_str();
    add_search(app, unfold_, "Longest search in seconds, 0 = none");
    add_polish(app);
    app.add_option("--up", up_,
                   "Which axis is up, where the format's custom is wrong; the height is along it")
        ->type_name("y|z")
        ->check(CLI::Validator(
            [](std::string& word) {
              return word == "y" || word == "z" ? std::string() : "it must be y or z";
            },
            ""));
    app.add_flag(
        "--repair", is_repair_,
        "Repair the model first: weld, drop doubled and empty faces, turn, part what no paper can be");
    app.add_option("--weld", unfold_.weld_mm, "Join open edges that lie within so many mm of each other")
        ->type_name("MM")
        ->check(within(0.0, 1e6, "a number of millimetres, 0 or more"));
    app.add_option("--close-holes", hole_edges_, "Close holes with at most so many edges around")
        ->type_name("EDGES")
        ->check(within(3, 2000000000, "a number of edges, 3 or more"));
    app.add_option("--leave-out", leave_out_,
                   "Parts that get no piece: those inside others, small ones, or numbers as info lists them, "
                   "whatever --weld or --repair join")
        ->type_name("inner|small|N,…")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->take_all()
        ->check(CLI::Validator(
            [](std::string& word) {
              int number = 0;
              const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
              const bool is_number = error == std::errc() && end == word.data() + word.size() && number >= 1;
              return is_number || word == "inner" || word == "small"
                         ? std::string()
                         : "it must be inner, small or the numbers of parts, counted from 1";
            },
            ""));
    CLI::Option* flatten =
        app.add_flag("--planarize", is_flatten_, "Move corners until faces that are not flat are");
    app.add_flag("--split", is_split_, "Split faces that are not flat into triangles")->excludes(flatten);
    app.add_option("--simplify", unfold_.recipe.faces, "Simplify the model to at most so many faces")
        ->type_name("FACES")
        ->check(within(4, 2000000000, "a number of faces, 4 or more"));
    app.add_option("--soften", unfold_.soften_mm,
                   "Where there is no net, move corners by at most so many mm until there is one")
        ->type_name("MM")
        ->check(within(0.0, 1e6, "a number of millimetres, 0 or more"));
    app.add_flag("--merge", unfold_.recipe.merges, "Make one face of neighbours that lie in one plane");
    app.add_option("--root", unfold_.root,
                   "Face that the net starts from, by its number in the file counted from 1")
        ->type_name("FACE")
        ->check(within(1, 2000000000, "the number of a face, counted from 1"));
    CLI::Option* pieces =
        app.add_option(
               "--pieces", unfold_.most_pieces,
               "Where no net in one piece is found, allow so many pieces in all; the fewest are taken")
            ->type_name("N")
            ->check(within(1, 2000000000, "a number of pieces, 1 or more"));
    app.add_flag("--fewest-pieces", unfold_.fewest_pieces,
                 "Where no net in one piece is found, allow as many pieces as it takes")
        ->excludes(pieces);
    app.add_option("--proof", unfold_.proof,
                   "File for the proof, where there is one that no net in one piece exists; verify checks it")
        ->type_name("OUT.proof")
        ->check(CLI::Validator(
            [](std::string& word) {
              return has_proof_name(word) ? std::string() : "its name must end in .proof";
            },
            ""));
    add_pins(app);
    add_paper(app);
    add_sheet(app);
    add_exports(app);
    app.add_flag(
        "--report", unfold_.has_report,
        "Tell how well the net can be built: smallest edge, sharpest corner, thinnest neck, tabs, sheets");
    app.add_flag("--json", unfold_.is_json, "Print the result as one JSON object");
  }

  void add_polish(CLI::App& app) {
    app.add_option("--polish", unfold_.polish.effort,
                   "How long to improve the first net, in seconds of a usual machine (counted work, so that "
                   "the net is the same everywhere); 0 = not at all")
        ->type_name("S")
        ->check(within(0.0, 3600.0, "a number of seconds from 0 to 3600"))
        ->capture_default_str();
    app.add_option(
           "--aim", aims_,
           "What for, each with a weight: short cuts, a compact net, few necks under 3 mm (these three "
           "weigh 1), a net that fits one page, its root in the middle, cuts that are hidden")
        ->type_name("cuts|compact|necks|paper|root|hidden[=W],…")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->take_all()
        ->check(word_that(why_not_aim));
  }

  void add_paper(CLI::App& app) {
    PrintOptions& print = unfold_.print;
    app.add_option("--paper", unfold_.paper.format,
                   "Paper format: A4, A3, Letter …, or its sides in mm, as in 200x300")
        ->type_name("NAME|WxH")
        ->capture_default_str();
    app.add_option("--orientation", print.orientation, "How the paper lies; auto = as it serves best")
        ->type_name("auto|portrait|landscape")
        ->check(word_that(why_not_orientation));
    app.add_option("--margin", print.margin_mm, "Margin of the paper in mm (10)")
        ->type_name("MM")
        ->check(within(0.0, 100.0, "a number of millimetres from 0 to 100"));
    height_ = app.add_option("--height", unfold_.size.height_mm,
                             "Height of the finished model in mm, over as many pages as it takes")
                  ->type_name("MM")
                  ->check(within(1e-3, 1e6, "a number of millimetres above 0"));
    scale_ = app.add_option("--scale", unfold_.size.scale, "Size by its scale: mm per unit of the model")
                 ->type_name("F")
                 ->check(within(1e-9, 1e9, "a number above 0"))
                 ->excludes(height_);
    edge_ = app.add_option("--edge", print.edge, "Size by the length of the edge that two faces share")
                ->type_name("A:B=MM")
                ->check(word_that(why_not_edge))
                ->excludes(height_)
                ->excludes(scale_);
    sheets_ = app.add_option("--sheets", unfold_.size.sheets, "Print as large as so many sheets allow")
                  ->type_name("N")
                  ->check(within(1, kMostFittedSheets, "a whole number from 1 to 100"))
                  ->excludes(height_)
                  ->excludes(scale_)
                  ->excludes(edge_);
    app.add_flag("--fit-page", is_fit_page_, "Print as large as one page allows (this is the default)")
        ->excludes(height_)
        ->excludes(scale_)
        ->excludes(edge_)
        ->excludes(sheets_);
    app.add_flag("--split-to-fit", print.splits_to_fit,
                 "Cut a net that is larger than the paper into the fewest pieces that fit it");
  }

  void add_sheet(CLI::App& app) {
    PrintOptions& print = unfold_.print;
    app.add_option("--tabs", print.tabs,
                   "Glue tabs: their width in mm (5), 0 or none for none, 10 mm for a child, on one side of "
                   "each cut or both, taking turns; everywhere: a net with room for a tab at every cut is "
                   "searched for")
        ->type_name("MM|none|child|one|both|alternating|everywhere,…")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->take_all()
        ->check(word_that(why_not_tabs));
    app.add_option("--tab-angle", print.tab_angle_deg, "Angle of their ends in degrees (45)")
        ->type_name("DEG")
        ->check(within(10.0, 90.0, "a number of degrees from 10 to 90"));
    app.add_option(
           "--labels", print.labels,
           "Numbers of all cuts, the obvious ones too, or on the reverse; angles of folds, numbers of "
           "faces and names of pieces besides")
        ->type_name("all|reverse|angles|faces|pieces,…")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->take_all()
        ->check(word_that(why_not_label));
    app.add_flag("--no-numbers", print.has_no_numbers, "No numbers at the cuts");
    app.add_option("--lines", print.lines, "Style of the lines (origami)")
        ->type_name("origami|kit|solid|cutter")
        ->check(word_that(why_not_lines));
    app.add_option("--fold-ends", print.fold_ends_mm,
                   "Mark folds at their ends only, for clean faces: how long the marks are in mm; 0 draws "
                   "whole folds")
        ->type_name("MM")
        ->check(within(0.0, 100.0, "a number of millimetres from 0 to 100"));
    app.add_option("--loose-strips", print.loose_strips,
                   "A strip of paper, folded along its middle, for each cut without a glue tab (on)")
        ->type_name("on|off")
        ->check(word_that(why_not_strips));
    app.add_option("--side,--printed-side", print.printed_side,
                   "Which side of the model is printed (outside)")
        ->type_name("outside|inside|both")
        ->check(word_that(why_not_side));
    app.add_flag("--no-pictures", print.has_no_pictures, "Leave textures and colours of the model out");
    app.add_option("--picture-dpi", print.picture_dpi, "Pixels per inch of printed textures (300)")
        ->type_name("N")
        ->check(within(kLeastDpi, kMostDpi, "a whole number from 72 to 600"));
    app.add_flag("--grey", print.is_grey, "Print everything in shades of grey");
    app.add_option("--title", print.title, "Title on the sheets, instead of the model's name")
        ->type_name("TEXT");
    app.add_option("--author", print.author, "Who made the model, on the sheets")->type_name("TEXT");
    app.add_option("--note", print.note, "A line of your own on the sheets")->type_name("TEXT");
  }

  void take_size() {
    if (height_->count() > 0) unfold_.size.kind = PrintSize::Kind::Height;
    if (scale_->count() > 0) unfold_.size.kind = PrintSize::Kind::Scale;
    if (sheets_->count() > 0) unfold_.size.kind = PrintSize::Kind::FitSheets;
    if (unfold_.print.margin_mm) unfold_.paper.margin_mm = *unfold_.print.margin_mm;
  }

  void add_exports(CLI::App& app) {
    app.add_flag("--one-file", unfold_.exports.is_one_file,
                 "SVG, DXF: all sheets side by side in one file instead of one file per sheet");
    app.add_flag("--real-dashes", unfold_.exports.real_dashes,
                 "SVG, DXF: every dash a line of its own, for machines that ignore dash patterns");
    app.add_flag("--live-text", unfold_.exports.live_text,
                 "SVG, DXF: words stay text that can be edited, instead of outlines");
    app.add_option("--dpi", unfold_.exports.png_dpi, "PNG: pixels per inch")
        ->type_name("N")
        ->check(within(kLeastDpi, kMostDpi, "a whole number from 72 to 600"))
        ->capture_default_str();
    app.add_option("--instructions", instructions_,
                   "PDF, PNG, SVG: a page with pictures of the folding, time and difficulty")
        ->type_name("first|last")
        ->check(CLI::Validator(
            [](std::string& word) {
              return word == "first" || word == "last" ? std::string() : "it must be first or last";
            },
            ""));
    app.add_option(
           "--cutter", cutter_,
           "Write all that a cutting machine needs into OUT, then a folder: a PDF to print, SVG and DXF "
           "to cut, with the same registration marks")
        ->type_name("silhouette|cricut|laser")
        ->check(CLI::Validator(
            [](std::string& word) {
              return cutter_named(word) ? std::string() : "it must be silhouette, cricut or laser";
            },
            ""));
  }

  void take_exports() {
    if (instructions_ == "first") unfold_.exports.instructions = InstructionPage::First;
    if (instructions_ == "last") unfold_.exports.instructions = InstructionPage::Last;
    unfold_.cutter = cutter_named(cutter_);
  }

  void add_replace() {
    CLI::App& app = *app_.add_subcommand(
        "replace",
        "Put a changed version of the model in a project's place and keep its pins, net and settings");
    replace_app_ = &app;
    app.footer(kReplaceFooter);
    app.add_option("PROJECT", replace_.project, "Project of the old version: .netwright")
        ->required()
        ->type_name("");
    app.add_option("MODEL", replace_.unfold.model, "Model file of the new version")
        ->required()
        ->type_name("");
    app.add_option("-o,--output", outputs_, output_help())
        ->required()
        ->type_name("OUT")
        ->allow_extra_args(false)
        ->take_all();
    add_search(app, replace_.unfold, "Longest search in seconds, 0 = none");
    app.add_flag("--repair", replace_.is_repair, "Repair the new version first, as unfold --repair does");
    app.add_flag("--json", replace_.unfold.is_json, "Print the result as one JSON object");
  }

  ReplaceCommand replace() {
    replace_.unfold.search = style();
    for (const std::string& output : outputs_) replace_.unfold.outputs.emplace_back(output);
    return replace_;
  }

  void add_pins(CLI::App& app) {
    app.add_option("--must-fold", must_fold_,
                   "Edge that is to be a fold, told by the two faces that share it")
        ->type_name("A:B")
        ->allow_extra_args(false)
        ->take_all()
        ->check(faces_apart_by(':'));
    app.add_option("--must-cut", must_cut_, "Edge that is to be a cut, likewise")
        ->type_name("A:B")
        ->allow_extra_args(false)
        ->take_all()
        ->check(faces_apart_by(':'));
    app.add_option("--keep-together", together_, "Faces that are to stay joined by folds among themselves")
        ->type_name("A,B,…")
        ->allow_extra_args(false)
        ->take_all()
        ->check(faces_apart_by(','));
  }

  void take_pins() {
    for (const std::string& word : must_fold_) {
      const std::vector<int> faces = *numbers_in(word, ':');
      unfold_.must_fold.emplace_back(faces[0], faces[1]);
    }
    for (const std::string& word : must_cut_) {
      const std::vector<int> faces = *numbers_in(word, ':');
      unfold_.must_cut.emplace_back(faces[0], faces[1]);
    }
    for (const std::string& word : together_) unfold_.together.push_back(*numbers_in(word, ','));
  }

  void add_verify() {
    verify_app_ = app_.add_subcommand(
        "verify", "Prove that a .fold file or a project holds a net, or check a proof that there is none");
    verify_app_->footer(kFooter);
    verify_app_
        ->add_option("FILE", verify_.file,
                     "Net as written by unfold: .fold .netwright; or the .proof that there is none")
        ->required()
        ->type_name("");
    verify_app_
        ->add_option("--pieces", verify_.most_pieces,
                     "Allow so many pieces in all; without, one for each part of the model")
        ->type_name("N")
        ->check(within(1, 2000000000, "a number of pieces, 1 or more"));
    verify_app_->add_flag("--json", verify_.is_json, "Print the result as one JSON object");
  }

  void add_info() {
    info_app_ =
        app_.add_subcommand("info", "Tell what a model file or project holds and whether it can be unfolded");
    info_app_->add_option("MODEL", info_.model, model_help("Model file or project"))
        ->required()
        ->type_name("");
    info_app_->add_flag("--json", info_.is_json, "Print the result as one JSON object");
  }

  void add_bench() {
    bench_app_ = app_.add_subcommand("bench", "Measure the search on many models");
    bench_app_->footer(kBenchFooter);
    bench_app_->add_option("PATH", bench_paths_, "Model files and folders of them")->type_name("");
    bench_app_->add_option("--seeds", bench_.seeds, "Unfold each model N times, with the seeds 0 to N-1")
        ->type_name("N")
        ->check(within(std::int64_t{1}, std::int64_t{1000000}, "a whole number from 1 to 1000000"))
        ->capture_default_str();
    add_search(*bench_app_, bench_, "Longest search of one run in seconds, 0 = none");
    CLI::Option* polish = bench_app_
                              ->add_option("--polish", bench_.polish,
                                           "Polish each net for so long, too, and tell what that brings")
                              ->type_name("S")
                              ->check(within(0.0, 3600.0, "a number of seconds from 0 to 3600"));
    bench_app_->add_option("--tsv", bench_.tsv, "Table of all runs; there already, it is gone on with")
        ->type_name("OUT")
        ->excludes(polish);
    bench_app_
        ->add_option("--report", bench_.report,
                     "Page with tables and plots beside the paper's; without PATH, of the table in OUT")
        ->type_name("FOLDER");
  }

  /// What unfold and bench have in common; they differ in what is usual.
  template <class SearchCommand>
  void add_search(CLI::App& app, SearchCommand& command, const std::string& time_limit_help) {
    app.add_option("--time-limit", command.time_limit_s, time_limit_help)
        ->type_name("S")
        ->check(within(0.0, 1e9, "a number of seconds, 0 or more"))
        ->capture_default_str();
    app.add_option("--streams", command.streams, "Independent searches; part of what decides the net")
        ->type_name("N")
        ->check(within(1, 1024, "a whole number from 1 to 1024"))
        ->capture_default_str();
    app.add_option("--threads", command.threads,
                   "Threads that run them, 0 = by the machine; never decides the net")
        ->type_name("N")
        ->check(within(0, 1024, "a whole number from 0 to 1024"))
        ->capture_default_str();
    app.add_option("--search", search_, "How to search: fast, or as the paper has it")
        ->type_name("fast|paper")
        ->check(CLI::Validator(
            [](std::string& word) {
              return word == "fast" || word == "paper" ? std::string() : "it must be fast or paper";
            },
            ""))
        ->capture_default_str();
  }

  void note_given() {
    const auto is_named = [this](const char* option) { return unfold_app_->count(option) > 0; };
    unfold_.given.seed = is_named("--seed");
    unfold_.given.search = is_named("--search") || is_named("--streams");
    unfold_.given.recipe =
        !(unfold_.recipe == Recipe{}) || unfold_.weld_mm.has_value() || unfold_.leave_out.is_any();
    unfold_.given.pins = is_named("--root") || is_named("--must-fold") || is_named("--must-cut") ||
                         is_named("--keep-together");
    unfold_.given.paper = is_named("--paper");
    unfold_.given.size =
        is_named("--height") || is_named("--fit-page") || is_named("--scale") || is_named("--sheets");
  }

  void add_leave_out(const std::string& word) {
    if (word == "inner") {
      unfold_.leave_out.inner = true;
    } else if (word == "small") {
      unfold_.leave_out.small = true;
    } else {
      unfold_.leave_out.numbers.push_back(std::stoi(word));
    }
  }

  [[nodiscard]] SearchStyle style() const {
    return search_ == "paper" ? SearchStyle::Paper : SearchStyle::Fast;
  }

  BenchCommand bench() {
    for (const std::string& path : bench_paths_) bench_.paths.emplace_back(path);
    bench_.search = style();
    if (bench_.paths.empty() && (bench_.tsv.empty() || bench_.report.empty())) {
      throw Error(
          ErrorKind::Usage,
          "Name a PATH with models to measure, or a table with --tsv and a folder with --report to make a "
          "report of it.");
    }
    return bench_;
  }

  std::string text_of(const CLI::ParseError& stop) {
    std::ostringstream text;
    app_.exit(stop, text, text);
    return text.str();
  }

  /// The library's own message as one sentence that ends with the way to the help.
  static std::string sentence(std::string message) {
    while (!message.empty() && (message.back() == '.' || message.back() == '\n')) message.pop_back();
    std::replace(message.begin(), message.end(), '\n', ' ');
    const std::string::size_type twice = message.find(" At Most 1 required but received ");
    if (twice != std::string::npos) message = message.substr(0, twice) + " it is given more than once";
    return message + "; see netwright-cli --help.";
  }

  CLI::App app_{"Netwright unfolds a 3-D model into one overlap-free piece of paper."};
  CLI::App* unfold_app_ = nullptr;
  CLI::App* replace_app_ = nullptr;
  CLI::App* verify_app_ = nullptr;
  CLI::App* info_app_ = nullptr;
  CLI::App* bench_app_ = nullptr;
  CLI::Option* height_ = nullptr;
  CLI::Option* scale_ = nullptr;
  CLI::Option* edge_ = nullptr;
  CLI::Option* sheets_ = nullptr;
  bool is_fit_page_ = false;
  std::string up_;
  std::string instructions_, cutter_;
  bool is_repair_ = false;
  int hole_edges_ = 0;
  std::vector<std::string> leave_out_;
  bool is_flatten_ = false;
  bool is_split_ = false;
  UnfoldCommand unfold_;
  ReplaceCommand replace_;
  VerifyCommand verify_;
  InfoCommand info_;
  BenchCommand bench_;
  std::vector<std::string> outputs_;
  std::vector<std::string> aims_;
  std::vector<std::string> must_fold_, must_cut_, together_;
  std::vector<std::string> bench_paths_;
  std::string search_ = "fast";
};

}  // namespace

Command parse_command(int argc, const char* const* argv) { return Reader().read(argc, argv); }

}  // namespace netwright
