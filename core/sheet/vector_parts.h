// What the writers of vector files share: dashes as lines of their own, words as outlines, and sheets moved
// side by side.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/sheet/font.h"
#include "core/sheet/sheet.h"

namespace netwright {

using Line = std::vector<glm::dvec2>;

/// The inked parts of a stroke, as open lines in order; of a solid one the whole line, closed by its first
/// point where the stroke is closed.
std::vector<Line> inked_lines(const Stroke& stroke);

/// The outline of a text as it lies on the page, turned by its angle.
std::vector<Font::Step> text_outline(const Text& text, const Font& font);

/// The same as closed polygons; curves become lines that leave them by less than 0.01 mm.
std::vector<Line> text_polygons(const Text& text, const Font& font);

/// The same sheet with everything on it moved by so many mm.
Sheet moved(Sheet sheet, glm::dvec2 by_mm);

/// Sheets that are written into one file, with gaps between them. `left_mm` is where each one begins.
struct SheetRow {
  std::vector<Sheet> sheets;  ///< moved to their places
  std::vector<double> left_mm;
  double width_mm = 0;
  double height_mm = 0;
};
SheetRow side_by_side(std::span<const Sheet> sheets);

}  // namespace netwright
