// The command line's words and their help, by CLI11.
#include "app/cli_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>

#include "core/base/error.h"

namespace netwright {
namespace {

constexpr const char* kFooter =
    "Exit status of unfold: 0 one proved net per component, 1 usage, input or output error,\n"
    "2 not within the limits, 130 cancelled; files are written only with 0. Of verify: 0 a net, 2 not one,\n"
    "1 unreadable. Of info: 0 fit to unfold, 2 needs repair, 1 unreadable.";

class Reader {
 public:
  Reader() {
    app_.name("netwright-cli");
    app_.set_version_flag("--version", std::string("netwright-cli ") + NETWRIGHT_VERSION,
                          "Print the version and exit");
    app_.set_help_flag("-h,--help", "Print this help and exit");
    app_.set_help_all_flag("--help-all", "Print the help of all commands and exit");
    app_.require_subcommand(1);
    app_.footer(kFooter);
    add_unfold();
    add_verify();
    add_info();
  }

  Command read(int argc, const char* const* argv) {
    try {
      app_.parse(argc, argv);
    } catch (const CLI::ParseError& stop) {
      if (stop.get_exit_code() == 0) return PrintCommand{text_of(stop)};
      throw Error(ErrorKind::Usage, sentence(stop.what()));
    }
    if (verify_app_->parsed()) return verify_;
    if (info_app_->parsed()) return info_;
    if (height_->count() > 0) unfold_.size.kind = PrintSize::Kind::Height;
    for (const std::string& output : outputs_) unfold_.outputs.emplace_back(output);
    return unfold_;
  }

 private:
  void add_unfold() {
    CLI::App& app =
        *app_.add_subcommand("unfold", "Unfold a 3-D model into one piece of paper without overlaps");
    app.add_option("MODEL", unfold_.model, "Model file: .obj .gltf .glb .stl .ply .off .3mf")->required();
    app.add_option("-o,--output", outputs_,
                   "File to write, its extension chooses: .pdf .svg .png .fold; repeatable")
        ->type_name("OUT")
        ->allow_extra_args(false)
        ->take_all();
    app.add_option("--seed", unfold_.seed, "Where the search starts: the same seed gives the same net")
        ->type_name("N")
        ->capture_default_str();
    app.add_option("--time-limit", unfold_.time_limit_s, "Longest search in seconds, 0 = none")
        ->type_name("S")
        ->check(CLI::Range(0.0, 1e9).description(""))
        ->capture_default_str();
    app.add_option("--streams", unfold_.streams, "Independent searches; part of what decides the net")
        ->type_name("N")
        ->check(CLI::Range(1, 1024).description(""))
        ->capture_default_str();
    app.add_option("--threads", unfold_.threads,
                   "Threads that run them, 0 = by the machine; never decides the net")
        ->type_name("N")
        ->check(CLI::Range(0, 1024).description(""))
        ->capture_default_str();
    app.add_option("--root", unfold_.root,
                   "Face that the net starts from, by its number in the file counted from 1")
        ->type_name("FACE")
        ->check(CLI::Range(1, 2000000000).description(""));
    app.add_option("--paper", unfold_.paper.format, "Paper format: A4, A3, Letter …")
        ->type_name("NAME")
        ->capture_default_str();
    height_ = app.add_option("--height", unfold_.size.height_mm,
                             "Height of the finished model in mm, over as many pages as it takes")
                  ->type_name("MM")
                  ->check(CLI::Range(1e-3, 1e6).description(""));
    app.add_flag("--fit-page", is_fit_page_, "Print as large as one page allows (this is the default)")
        ->excludes(height_);
    app.add_flag("--json", unfold_.is_json, "Print the result as one JSON object");
  }

  void add_verify() {
    verify_app_ = app_.add_subcommand(
        "verify",
        "Prove that a .fold file is a net: one piece per component, true to the model, no overlaps");
    verify_app_->add_option("FILE", verify_.file, "Net as written by unfold: .fold")->required();
    verify_app_->add_flag("--json", verify_.is_json, "Print the result as one JSON object");
  }

  void add_info() {
    info_app_ = app_.add_subcommand("info", "Tell what a model file holds and whether it can be unfolded");
    info_app_->add_option("MODEL", info_.model, "Model file: .obj .gltf .glb .stl .ply .off .3mf")
        ->required();
    info_app_->add_flag("--json", info_.is_json, "Print the result as one JSON object");
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
    return message + "; see netwright-cli --help.";
  }

  CLI::App app_{"Netwright unfolds a 3-D model into one overlap-free piece of paper."};
  CLI::App* verify_app_ = nullptr;
  CLI::App* info_app_ = nullptr;
  CLI::Option* height_ = nullptr;
  bool is_fit_page_ = false;
  UnfoldCommand unfold_;
  VerifyCommand verify_;
  InfoCommand info_;
  std::vector<std::string> outputs_;
};

}  // namespace

Command parse_command(int argc, const char* const* argv) { return Reader().read(argc, argv); }

}  // namespace netwright
