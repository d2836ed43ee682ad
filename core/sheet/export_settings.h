// What the user decides about the exported files: how many there are, what machines find in them and how fine
// pictures are. Kept in the project; the drawing itself is the same in all of them.
#pragma once

namespace netwright {

inline constexpr int kLeastDpi = 72;
inline constexpr int kMostDpi = 600;

/// Where the page with the instructions goes (PDF, PNG and SVG).
enum class InstructionPage { None, First, Last };

struct ExportSettings {
  bool is_one_file = false;  ///< SVG, DXF: all sheets side by side in one file instead of one file per sheet
  bool real_dashes = false;  ///< SVG, DXF: every dash a line of its own, since machines ignore dash patterns
  bool live_text = false;    ///< SVG, DXF: words stay text that can be edited, instead of outlines
  int png_dpi = 300;         ///< kLeastDpi … kMostDpi; held to these limits
  InstructionPage instructions = InstructionPage::None;
  bool operator==(const ExportSettings&) const = default;
};

}  // namespace netwright
