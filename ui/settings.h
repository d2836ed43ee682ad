// What the editor remembers between two starts: looks, layout, preferences, recent files. Kept as a small
// text file of "key = value" lines under XDG_CONFIG_HOME; a missing or damaged file means the defaults.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "ui/lengths.h"
#include "ui/theme.h"

namespace netwright {

/// The sections of the side panel.
enum class Section {
  Model,
  Solve,
  Why,
  Runs,
  Tabs,
  Paper,
  Print,
  Export,
  Check,
  Assembly,
  History,
  Overlaps
};
inline constexpr std::size_t kSections = 12;

/// Hints for people who are new here; each goes away for good once it was closed or has done its work.
enum class FirstHint { Views, Runs };
inline constexpr std::size_t kFirstHints = 2;

struct Settings {
  ThemeChoice theme = ThemeChoice::System;
  int scale_percent = 0;  ///< 100 … 200; 0 follows the screen
  LengthUnit unit = LengthUnit::Millimetre;
  std::string paper;         ///< the format of new models; empty follows the locale
  int autosave_minutes = 1;  ///< 1 … 60; 0 = never
  int threads = 0;           ///< that search, 1 … 64; 0 = all the machine has
  int streams = 2;           ///< independent searches, 1 … 16
  int time_limit_s = 60;     ///< of a search; 0 = none
  int polish_s = 1;          ///< how long nets are improved, 0 … 600; 0 = not at all
  int aim_cuts = 100;        ///< what for: percent of the usual weight, 0 … 300
  int aim_compact = 100;
  int aim_necks = 100;
  int aim_paper = 0;
  int aim_root = 0;
  int aim_hidden = 0;
  bool shows_aims = false;            ///< the weights of these in the panel
  bool uses_desktop_dialogs = false;  ///< for files, where the desktop has some
  float splitter = 0.5F;              ///< the model view's share of the width, 0.15 … 0.85
  bool is_side_open = true;
  bool show_tree = true;
  bool show_overlaps = true;
  bool show_root = true;
  bool show_heat = false;  ///< how often faces were in collision, after a search without a net
  bool show_pages = true;
  bool show_tabs = true;
  bool is_xray = false;       ///< the model is seen through
  bool show_numbers = false;  ///< of faces and edges, in the net
  bool show_textures = true;
  std::array<bool, kSections> open_sections{false, true,  true,  true,  false, true,
                                            false, false, false, false, false, false};
  std::array<bool, kFirstHints> hints_done{};
  int window_width = 0;  ///< of the real window, in screen units; 0 = never seen
  int window_height = 0;
  int window_x = 0;
  int window_y = 0;
  bool is_maximized = false;
  std::vector<std::filesystem::path> recent;  ///< newest first, at most kMaxRecent
  std::filesystem::path export_folder;        ///< where the last net was written; empty before the first

  [[nodiscard]] bool& is_open(Section section) { return open_sections[static_cast<std::size_t>(section)]; }
  [[nodiscard]] bool& is_done(FirstHint hint) { return hints_done[static_cast<std::size_t>(hint)]; }

  static constexpr std::size_t kMaxRecent = 8;
  bool operator==(const Settings&) const = default;
};

/// Puts a file at the head of the recent ones.
void remember(Settings& settings, const std::filesystem::path& file);

/// The paper that printers hold in the country of a locale ("de_DE.UTF-8"): "Letter" in North America and
/// some of its neighbours, else "A4".
std::string paper_of_locale(std::string_view locale);
/// The locale's name as the environment has it for paper: LC_ALL, else LC_PAPER, else LANG.
std::string paper_locale();
/// What new models are printed on: the user's choice, else the locale's.
std::string paper_of(const Settings& settings);

/// $XDG_CONFIG_HOME/netwright/settings.conf, or below ~/.config; empty when neither is known.
std::filesystem::path settings_path();

Settings load_settings(const std::filesystem::path& file);

/// False when the file cannot be written (a read-only home is no reason to stop).
bool save_settings(const Settings& settings, const std::filesystem::path& file);

}  // namespace netwright
