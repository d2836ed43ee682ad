// A page that goes with the sheets: how the net becomes the model in six pictures, and what the work amounts
// to.
#pragma once

#include "core/sheet/export_settings.h"
#include "core/sheet/sheet.h"

namespace netwright {

/// What there is to do, measured on paper.
struct BuildFigures {
  int n_mountains = 0;
  int n_valleys = 0;
  double fold_mm = 0;     ///< all drawn folds together
  int n_cuts = 0;         ///< seams to glue
  double cut_mm = 0;      ///< all seams together
  double outline_mm = 0;  ///< what the knife follows, tabs included
  int n_corners = 0;      ///< of the outlines
  int n_tabs = 0;
  int n_sheets = 0;
  double shortest_cut_mm = 0;  ///< the shortest seam
  double tenth_cut_mm = 0;     ///< a tenth of the seams is shorter than this

  /// An unhurried hobbyist with knife, ruler and white glue: 4 s and another 1 s per 10 mm for each straight
  /// cut; 6 s and another 1 s per 20 mm to score and fold; 45 s and another 1 s per 4 mm to glue a seam and
  /// hold it.
  double cutting_h = 0;
  double folding_h = 0;
  double gluing_h = 0;
  [[nodiscard]] double hours() const { return cutting_h + folding_h + gluing_h; }
  /// 1 … 5: one, and one more for each of these: over 30 seams, over 120 seams, a tenth of the seams shorter
  /// than 6 mm, over 10 hours.
  int difficulty = 1;
};
BuildFigures build_figures(const Net& net, const PageLayout& layout, const SheetSettings& settings);

/// Grams per square metre that suit the model: "120 to 160" where a tenth of the seams is shorter than 8 mm,
/// "200 to 300" for models over 300 mm, else "160 to 200".
const char* paper_weight(const BuildFigures& figures, double model_height_mm);

/// One page of the layout's size, outside the count of sheets.
Sheet instruction_sheet(const Net& net, const PageLayout& layout, const SheetInfo& info,
                        const SheetSettings& settings);

/// Puts that page before or behind the others. In front of two-sided sheets its own back stays empty, so that
/// fronts stay on fronts.
void add_instructions(std::vector<Sheet>& sheets, Sheet page, InstructionPage where);

/// The net folded so far (0 … 1) as a shaded picture of fills only, fitted into a box: faces from the
/// farthest to the nearest, each with its edges. At 0 it is seen as printed, at 1 as it stands on the table.
std::vector<Fill> folding_picture(const Net& net, double amount, const Box2& box);

}  // namespace netwright
