// What the editor remembers between two starts: looks, layout, recent files. Kept as a small text file of
// "key = value" lines under XDG_CONFIG_HOME; a missing or damaged file means the defaults.
#pragma once

#include <filesystem>
#include <vector>

#include "ui/theme.h"

namespace netwright {

struct Settings {
  ThemeChoice theme = ThemeChoice::System;
  int scale_percent = 0;  ///< 100 … 200; 0 follows the screen
  float splitter = 0.5F;  ///< the model view's share of the width, 0.15 … 0.85
  bool is_side_open = true;
  bool show_tree = true;
  bool show_overlaps = true;
  bool show_root = true;
  bool show_pages = true;
  std::vector<std::filesystem::path> recent;  ///< newest first, at most kMaxRecent

  static constexpr std::size_t kMaxRecent = 8;
  bool operator==(const Settings&) const = default;
};

/// Puts a file at the head of the recent ones.
void remember(Settings& settings, const std::filesystem::path& file);

/// $XDG_CONFIG_HOME/netwright/settings.conf, or below ~/.config; empty when neither is known.
std::filesystem::path settings_path();

Settings load_settings(const std::filesystem::path& file);

/// False when the file cannot be written (a read-only home is no reason to stop).
bool save_settings(const Settings& settings, const std::filesystem::path& file);

}  // namespace netwright
