// What the command line says about the printed sheets. A project's own settings count where nothing is said.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/project/project.h"

namespace netwright {

/// As it was typed; all words are known to be good.
struct PrintOptions {
  std::vector<std::string> tabs;  ///< a width in mm, or none, child, one, both, alternating, everywhere
  std::optional<double> tab_angle_deg;
  std::vector<std::string> labels;  ///< all, angles, faces, pieces, reverse
  bool has_no_numbers = false;
  std::string lines;                   ///< origami, kit, solid, cutter; each of these may be empty
  std::optional<double> fold_ends_mm;  ///< 0 = whole folds
  std::string loose_strips;            ///< on, off
  std::string printed_side;            ///< outside, inside, both
  bool has_no_pictures = false;
  std::optional<int> picture_dpi;
  bool is_grey = false;
  std::optional<std::string> title;
  std::optional<std::string> author;
  std::optional<std::string> note;
  std::optional<double> margin_mm;
  std::string orientation;  ///< auto, portrait, landscape
  std::string edge;         ///< A:B=MM
  bool splits_to_fit = false;
};

/// One of these words that was not understood, told as CLI11 tells it ("it must be …"); empty when it is one.
std::string why_not_tabs(const std::string& word);
std::string why_not_label(const std::string& word);
std::string why_not_lines(const std::string& word);
std::string why_not_strips(const std::string& word);
std::string why_not_side(const std::string& word);
std::string why_not_orientation(const std::string& word);
std::string why_not_edge(const std::string& word);

/// The project with what was named. Throws Error(Usage) when the edge is not there.
void apply(const PrintOptions& options, Project& project);

}  // namespace netwright
