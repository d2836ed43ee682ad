// The editor's main: reads the command line, opens the real window and runs the loop, or draws one picture of
// the window without a display.
#include <charconv>
#include <chrono>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>

#include "app/application.h"
#include "app/window_headless.h"
#include "core/base/error.h"
#include "ui/recovery.h"

namespace {

using namespace netwright;

constexpr std::string_view kHelp =
    "netwright [MODEL | PROJECT]\n"
    "    opens the editor, with a model or project when one is named\n"
    "netwright --screenshot OUT.png [--size WxH] [--solve] [MODEL | PROJECT]\n"
    "    draws the window without a display and quits\n"
    "\n"
    "  --solve          searches for a net to the end before the picture is taken\n"
    "  --size WxH       of the window, 1440x900 unless told otherwise\n"
    "  --theme NAME     light or dark\n"
    "  --scale PERCENT  size of the interface, 100 to 200\n"
    "  --tell-widgets FILE\n"
    "                   for scripts that test the window: FILE says where everything is on screen\n"
    "  --help, --version\n";

struct Options {
  std::filesystem::path model;
  std::filesystem::path screenshot;
  std::filesystem::path told_widgets;
  glm::ivec2 size{1440, 900};
  bool has_size = false;
  std::optional<ThemeChoice> theme;
  int scale_percent = 0;
  bool wants_solve = false;
  bool wants_help = false;
  bool wants_version = false;
};

Error usage(const std::string& sentence) { return {ErrorKind::Usage, sentence + " See netwright --help."}; }

int number(std::string_view text, int low, int high, const std::string& option) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc() && end == text.data() + text.size() && value >= low && value <= high) return value;
  throw usage(option + " takes whole numbers from " + std::to_string(low) + " to " + std::to_string(high) +
              ", not “" + std::string(text) + "”.");
}

glm::ivec2 size_of(std::string_view text) {
  const auto cross = text.find('x');
  if (cross == std::string_view::npos) throw usage("--size takes a width and a height, such as 1440x900.");
  return {number(text.substr(0, cross), 320, 8192, "--size"),
          number(text.substr(cross + 1), 240, 8192, "--size")};
}

ThemeChoice theme_of(std::string_view text) {
  if (text == "light") return ThemeChoice::Light;
  if (text == "dark") return ThemeChoice::Dark;
  throw usage("--theme is light or dark, not “" + std::string(text) + "”.");
}

void read_option(Options& options, const std::string& name, const std::function<std::string()>& value) {
  if (name == "--help" || name == "-h") {
    options.wants_help = true;
  } else if (name == "--version") {
    options.wants_version = true;
  } else if (name == "--solve") {
    options.wants_solve = true;
  } else if (name == "--screenshot") {
    options.screenshot = value();
  } else if (name == "--size") {
    options.size = size_of(value());
    options.has_size = true;
  } else if (name == "--tell-widgets") {
    options.told_widgets = value();
  } else if (name == "--theme") {
    options.theme = theme_of(value());
  } else if (name == "--scale") {
    options.scale_percent = number(value(), 100, 200, name);
  } else {
    throw usage("There is no option " + name + ".");
  }
}

Options read_options(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument.size() > 1 && argument.front() == '-') {
      read_option(options, argument, [&] {
        if (++i == argc) throw usage(argument + " needs a value.");
        return std::string(argv[i]);
      });
    } else if (options.model.empty()) {
      options.model = argument;
    } else {
      throw usage("Only one model can be opened at a time.");
    }
  }
  if (options.wants_solve && options.screenshot.empty()) throw usage("--solve belongs to --screenshot.");
  if (options.wants_solve && options.model.empty()) throw usage("--solve needs a model.");
  return options;
}

Session::Clock steady_clock() {
  return [] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  };
}

void apply_options(Application& application, const Options& options) {
  if (options.theme) application.ui().settings.theme = *options.theme;
  if (options.scale_percent > 0) application.ui().settings.scale_percent = options.scale_percent;
  if (!options.model.empty()) application.session().open(options.model);
}

/// Turns the loop until nothing is going on any more.
void settle(Application& application) {
  const auto is_busy = [&] {
    const RunState state = application.session().state();
    return state != RunState::Idle && state != RunState::Empty;
  };
  while (is_busy()) {
    if (application.session().state() == RunState::Replaying) application.session().skip_replay();
    application.turn(0.02);
  }
  const auto lacks_sheets = [&] {
    const Session& session = application.session();
    const auto shown = session.shown();
    const bool is_coming = session.project().tree != nullptr && (shown == nullptr || shown->is_proved);
    return is_coming && session.sheets() == nullptr && application.ui().error.empty();
  };
  while (lacks_sheets()) application.turn(0.02);
}

int take_screenshot(const Options& options) {
  HeadlessWindow window({"Netwright", options.size});
  Application application(window, steady_clock(), {});
  if (!options.theme) application.ui().settings.theme = ThemeChoice::Light;
  apply_options(application, options);
  settle(application);
  if (options.wants_solve && application.session().has_model()) {
    application.session().unfold();
    settle(application);
  }
  constexpr int kFramesToSettle = 12;
  for (int i = 0; i < kFramesToSettle; ++i) application.draw();
  while (application.workspace().scene().is_rough()) application.turn(0.02);
  application.ui().toasts.clear();
  application.draw();
  std::ofstream out(options.screenshot, std::ios::binary);
  out << encode_png(window.read_pixels());
  if (!out.flush()) {
    throw Error(ErrorKind::Write, "The picture " + options.screenshot.string() +
                                      " cannot be written; name a file in a folder you may write to.");
  }
  if (!application.ui().error.empty()) throw Error(ErrorKind::Read, application.ui().error);
  return 0;
}

int run_editor(const Options& options) {
  WindowOptions wanted{"Netwright", options.size, {}};
  if (!options.has_size) wanted.placement = placement_of(load_settings(settings_path()));
  const auto window = open_window(wanted);
  Application application(*window, steady_clock(), settings_path());
  if (const auto folder = state_folder(); !folder.empty()) application.session().keep_changes_in(folder);
  if (!options.told_widgets.empty()) application.tell_widgets(options.told_widgets);
  apply_options(application, options);
  application.run();
  return 0;
}

int run(int argc, char** argv) {
  const Options options = read_options(argc, argv);
  if (options.wants_help) {
    std::cout << kHelp;
    return 0;
  }
  if (options.wants_version) {
    std::cout << "netwright " NETWRIGHT_VERSION "\n";
    return 0;
  }
  return options.screenshot.empty() ? run_editor(options) : take_screenshot(options);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "netwright: " << error.what() << '\n';
    return 1;
  }
}
