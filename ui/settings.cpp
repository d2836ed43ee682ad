// Reads and writes the settings. Every value is checked on the way in, because people edit such files by
// hand.
#include "ui/settings.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <fstream>
#include <string>
#include <string_view>

#include "core/base/paper.h"

namespace netwright {
namespace {

constexpr std::array<std::string_view, 3> kThemeNames{"system", "light", "dark"};
constexpr std::array<std::string_view, 2> kUnitNames{"mm", "in"};
constexpr std::array<std::string_view, kSections> kSectionNames{"model", "solve",    "why",     "runs",
                                                                "tabs",  "paper",    "print",   "export",
                                                                "check", "assembly", "history", "overlaps"};
constexpr std::array<std::string_view, kFirstHints> kHintNames{"views", "runs"};

struct Flag {
  std::string_view key;
  bool Settings::*value;
};
constexpr std::array<Flag, 13> kFlags{Flag{"show_aims", &Settings::shows_aims},
                                      Flag{"side_panel", &Settings::is_side_open},
                                      Flag{"show_tree", &Settings::show_tree},
                                      Flag{"show_overlaps", &Settings::show_overlaps},
                                      Flag{"show_root", &Settings::show_root},
                                      Flag{"show_heat", &Settings::show_heat},
                                      Flag{"show_pages", &Settings::show_pages},
                                      Flag{"show_tabs", &Settings::show_tabs},
                                      Flag{"show_numbers", &Settings::show_numbers},
                                      Flag{"xray", &Settings::is_xray},
                                      Flag{"show_textures", &Settings::show_textures},
                                      Flag{"desktop_dialogs", &Settings::uses_desktop_dialogs},
                                      Flag{"window_maximized", &Settings::is_maximized}};

struct Number {
  std::string_view key;
  int Settings::*value;
  int low;
  int high;
};
constexpr int kFarthest = 32767;  ///< window systems count in 16 bits
constexpr int kMostWeight = 300;  ///< percent
constexpr std::array<Number, 15> kNumbers{Number{"autosave_minutes", &Settings::autosave_minutes, 0, 60},
                                          Number{"threads", &Settings::threads, 0, 64},
                                          Number{"streams", &Settings::streams, 1, 16},
                                          Number{"time_limit_s", &Settings::time_limit_s, 0, 86400},
                                          Number{"polish_s", &Settings::polish_s, 0, 600},
                                          Number{"aim_cuts", &Settings::aim_cuts, 0, kMostWeight},
                                          Number{"aim_compact", &Settings::aim_compact, 0, kMostWeight},
                                          Number{"aim_necks", &Settings::aim_necks, 0, kMostWeight},
                                          Number{"aim_paper", &Settings::aim_paper, 0, kMostWeight},
                                          Number{"aim_root", &Settings::aim_root, 0, kMostWeight},
                                          Number{"aim_hidden", &Settings::aim_hidden, 0, kMostWeight},
                                          Number{"window_width", &Settings::window_width, 0, kFarthest},
                                          Number{"window_height", &Settings::window_height, 0, kFarthest},
                                          Number{"window_x", &Settings::window_x, -kFarthest, kFarthest},
                                          Number{"window_y", &Settings::window_y, -kFarthest, kFarthest}};

template <class T>
void read_number(std::string_view text, T low, T high, T& value) {
  T number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc() && end == text.data() + text.size() && number >= low && number <= high)
    value = number;
}

template <std::size_t n, class Choice>
void read_choice(std::string_view text, const std::array<std::string_view, n>& names, Choice& choice) {
  for (std::size_t i = 0; i < n; ++i)
    if (names[i] == text) choice = static_cast<Choice>(i);
}

/// "solve paper": those that are named are on, all others off.
template <std::size_t n>
void read_set(std::string_view text, const std::array<std::string_view, n>& names, std::array<bool, n>& set) {
  const std::string spaced = " " + std::string(text) + " ";
  for (std::size_t i = 0; i < n; ++i)
    set[i] = spaced.find(" " + std::string(names[i]) + " ") != std::string::npos;
}

template <std::size_t n>
std::string set_text(const std::array<std::string_view, n>& names, const std::array<bool, n>& set) {
  std::string text;
  for (std::size_t i = 0; i < n; ++i)
    if (set[i]) text.append(text.empty() ? "" : " ").append(names[i]);
  return text;
}

void read_value(std::string_view key, std::string_view text, Settings& settings) {
  if (key == "theme") {
    read_choice(text, kThemeNames, settings.theme);
  } else if (key == "unit") {
    read_choice(text, kUnitNames, settings.unit);
  } else if (key == "paper" && (text.empty() || find_paper(text))) {
    settings.paper = text;
  } else if (key == "open_panels") {
    read_set(text, kSectionNames, settings.open_sections);
  } else if (key == "hints_done") {
    read_set(text, kHintNames, settings.hints_done);
  } else if (key == "scale_percent") {
    int percent = 0;
    read_number(text, 0, 200, percent);
    settings.scale_percent = percent >= 100 ? percent : 0;
  } else if (key == "splitter") {
    read_number(text, 0.15F, 0.85F, settings.splitter);
  } else if (key == "recent" && !text.empty() && settings.recent.size() < Settings::kMaxRecent) {
    settings.recent.emplace_back(text);
  } else if (key == "export_folder") {
    settings.export_folder = text;
  }
  for (const Flag& flag : kFlags) {
    if (flag.key == key && (text == "yes" || text == "no")) settings.*flag.value = text == "yes";
  }
  for (const Number& number : kNumbers)
    if (number.key == key) read_number(text, number.low, number.high, settings.*number.value);
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// A line of its own; a path that would take two is not worth remembering.
void write_path(std::ostream& out, std::string_view key, const std::filesystem::path& path) {
  const std::string text = path.string();
  if (text.find_first_of("\r\n") == std::string::npos) out << key << " = " << text << '\n';
}

}  // namespace

void remember(Settings& settings, const std::filesystem::path& file) {
  std::error_code error;
  const auto absolute = std::filesystem::absolute(file, error);
  const auto& path = error ? file : absolute;
  std::erase(settings.recent, path);
  settings.recent.insert(settings.recent.begin(), path);
  if (settings.recent.size() > Settings::kMaxRecent) settings.recent.resize(Settings::kMaxRecent);
}

std::string paper_of_locale(std::string_view locale) {
  // Where ANSI sizes are sold, by ISO 3166 country code.
  constexpr std::array<std::string_view, 11> kLetter{"US", "CA", "MX", "CL", "CO", "CR",
                                                     "GT", "PA", "PH", "PR", "VE"};
  const auto mark = locale.find('_');
  const std::string_view country = mark == std::string_view::npos ? "" : locale.substr(mark + 1, 2);
  return std::find(kLetter.begin(), kLetter.end(), country) == kLetter.end() ? "A4" : "Letter";
}

std::string paper_locale() {
  for (const char* name : {"LC_ALL", "LC_PAPER", "LANG"}) {
    const char* value = std::getenv(name);
    if (value != nullptr && *value != 0) return value;
  }
  return {};
}

std::string paper_of(const Settings& settings) {
  return settings.paper.empty() ? paper_of_locale(paper_locale()) : settings.paper;
}

std::filesystem::path settings_path() {
  const char* config = std::getenv("XDG_CONFIG_HOME");
  if (config != nullptr && *config != 0) return std::filesystem::path(config) / "netwright" / "settings.conf";
  const char* home = std::getenv("HOME");
  if (home != nullptr && *home != 0) return std::filesystem::path(home) / ".config/netwright/settings.conf";
  return {};
}

Settings load_settings(const std::filesystem::path& file) {
  Settings settings;
  std::ifstream in(file);
  std::string line;
  while (std::getline(in, line)) {
    const auto equals = line.find('=');
    if (equals == std::string::npos) continue;
    const std::string_view whole = line;
    read_value(trimmed(whole.substr(0, equals)), trimmed(whole.substr(equals + 1)), settings);
  }
  return settings;
}

bool save_settings(const Settings& settings, const std::filesystem::path& file) {
  if (file.empty()) return false;
  std::error_code error;
  std::filesystem::create_directories(file.parent_path(), error);
  const auto draft = std::filesystem::path(file).concat(".new");
  {
    std::ofstream out(draft);
    out << "theme = " << kThemeNames[static_cast<std::size_t>(settings.theme)] << '\n';
    out << "scale_percent = " << settings.scale_percent << '\n';
    out << "unit = " << kUnitNames[static_cast<std::size_t>(settings.unit)] << '\n';
    out << "paper = " << settings.paper << '\n';
    out << "open_panels = " << set_text(kSectionNames, settings.open_sections) << '\n';
    out << "hints_done = " << set_text(kHintNames, settings.hints_done) << '\n';
    out << "splitter = " << settings.splitter << '\n';
    for (const Flag& flag : kFlags) out << flag.key << " = " << (settings.*flag.value ? "yes" : "no") << '\n';
    for (const Number& number : kNumbers) out << number.key << " = " << settings.*number.value << '\n';
    for (const auto& path : settings.recent) write_path(out, "recent", path);
    write_path(out, "export_folder", settings.export_folder);
    if (!out.flush()) return false;
  }
  std::filesystem::rename(draft, file, error);
  return !error;
}

}  // namespace netwright
