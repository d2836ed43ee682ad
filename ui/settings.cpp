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

namespace netwright {
namespace {

constexpr std::array<std::string_view, 3> kThemeNames{"system", "light", "dark"};

struct Flag {
  std::string_view key;
  bool Settings::*value;
};
constexpr std::array<Flag, 5> kFlags{
    Flag{"side_panel", &Settings::is_side_open}, Flag{"show_tree", &Settings::show_tree},
    Flag{"show_overlaps", &Settings::show_overlaps}, Flag{"show_root", &Settings::show_root},
    Flag{"show_pages", &Settings::show_pages}};

template <class T>
void read_number(std::string_view text, T low, T high, T& value) {
  T number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc() && end == text.data() + text.size() && number >= low && number <= high)
    value = number;
}

void read_value(std::string_view key, std::string_view text, Settings& settings) {
  if (key == "theme") {
    for (std::size_t i = 0; i < kThemeNames.size(); ++i) {
      if (kThemeNames[i] == text) settings.theme = static_cast<ThemeChoice>(i);
    }
  } else if (key == "scale_percent") {
    int percent = 0;
    read_number(text, 0, 200, percent);
    settings.scale_percent = percent >= 100 ? percent : 0;
  } else if (key == "splitter") {
    read_number(text, 0.15F, 0.85F, settings.splitter);
  } else if (key == "recent" && !text.empty() && settings.recent.size() < Settings::kMaxRecent) {
    settings.recent.emplace_back(text);
  }
  for (const Flag& flag : kFlags) {
    if (flag.key == key && (text == "yes" || text == "no")) settings.*flag.value = text == "yes";
  }
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
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
    out << "splitter = " << settings.splitter << '\n';
    for (const Flag& flag : kFlags) out << flag.key << " = " << (settings.*flag.value ? "yes" : "no") << '\n';
    for (const auto& path : settings.recent) out << "recent = " << path.string() << '\n';
    if (!out.flush()) return false;
  }
  std::filesystem::rename(draft, file, error);
  return !error;
}

}  // namespace netwright
