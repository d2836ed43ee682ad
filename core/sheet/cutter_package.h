// All that a cutting machine needs, in one folder: what is printed first (pictures and numbers, as PDF) and
// what is cut then (SVG and DXF), with the same registration marks at the same places. The files are read
// back before anybody relies on them.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/sheet/export_settings.h"
#include "core/sheet/sheet.h"

namespace netwright {

/// Silhouette: the marks its cameras look for, 10 mm from the paper's edges (on A4 190 x 277 mm apart), folds
/// as perforation. Cricut: outlines and folds to score only; Design Space adds marks of its own around what
/// is printed, at most kCricutArea. Laser: hairlines in pure colours, numbers to engrave, and everything in
/// the PDF too, which many lasers take directly.
enum class CutterPreset { Silhouette, Cricut, Laser };
inline constexpr std::array<std::string_view, 3> kCutterNames = {"Silhouette", "Cricut", "Laser"};
/// By name, in any case; nothing for other words.
std::optional<CutterPreset> cutter_named(std::string_view name);
inline constexpr glm::dvec2 kCricutArea{234.95, 171.45};  ///< 9.25 x 6.75 inches, either way up

/// The same paper with margins that keep the net away from the marks: arrange() with this first.
PaperSetup cutter_paper(PaperSetup paper, CutterPreset preset);

/// What is printed and what is cut of one sheet. Both carry the marks in Layer::Regmarks; of what stands
/// around the net (title, legend, ruler) neither has anything, so that a camera sees nothing but the marks.
struct CutterSheets {
  Sheet print;
  Sheet cut;
};
CutterSheets cutter_sheets(const Sheet& sheet, const PageLayout& layout, CutterPreset preset);

/// Throws Error(Write) with the reason unless every outline is there in the SVG and in the DXF of a cut
/// sheet, closed and with its corners in order, and both have the sheet's marks.
void check_cut_files(const Sheet& cut, std::string_view svg, std::string_view dxf);

struct CutterPackage {
  std::vector<std::filesystem::path> files;
  std::vector<std::string> notes;  ///< sentences about what to mind, if anything
};

/// Writes STEM-print.pdf, STEM-cut.svg and STEM-cut.dxf (numbered where there are several sheets) into a
/// folder, which is made if it isn't there; STEM is the model's name. Throws Error(Usage) when a piece is
/// larger than a sheet or the net lies on a mark, and Error(Write).
CutterPackage write_cutter_package(const std::filesystem::path& folder, const Net& net,
                                   const PageLayout& layout, const SheetInfo& info,
                                   const SheetSettings& settings, const ExportSettings& exports,
                                   CutterPreset preset);

}  // namespace netwright
