// What the user decides about the printed sheets beside paper and size: lines, numbers, colours, sides and
// words. Kept in the project; the writers and the screen only repeat what is drawn by them.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/ids.h"
#include "core/base/image.h"

namespace netwright {

/// One kind of line. Lengths in mm.
struct PrintedLine {
  glm::dvec3 colour{0, 0, 0};  ///< sRGB 0…1
  double width_mm = 0.18;
  std::vector<double> dash_mm;  ///< ink, gap, ink, gap …; empty = solid
  bool operator==(const PrintedLine&) const = default;
};

struct LineStyles {
  PrintedLine cut;
  PrintedLine mountain;
  PrintedLine valley;
  PrintedLine tab_fold;                          ///< between a face and its glue tab
  double flat_below_rad = 0.017453292519943295;  ///< folds bent less are left out
  bool only_ends = false;  ///< marks at both ends of a fold instead of a line, for clean faces
  double end_mark_mm = 4;  ///< length of such a mark
  bool operator==(const LineStyles&) const = default;
};

/// Origami: mountain dash-dot, valley dash. Kit: the reverse. SolidDash: mountain solid, valley dashed.
/// Cutter: solid hairlines in the pure colours that cutting programs tell apart.
enum class LinePreset { Origami, Kit, SolidDash, Cutter };
LineStyles line_styles(LinePreset preset);
inline constexpr std::array<std::string_view, 4> kLinePresetNames = {"Origami (paper)", "Kit (reversed)",
                                                                     "Solid and dashed", "Cutter"};

/// Numbers and words on the net.
struct LabelSettings {
  bool edge_numbers = true;   ///< the same on both sides of a cut: on the tab and where it lands
  bool skips_obvious = true;  ///< none where two neighbouring sides meet at a point and can only be glued so
  bool on_reverse = false;    ///< printed on the back page instead, mirrored
  bool piece_names = false;   ///< A, B, C … where there are several pieces
  bool fold_angles = false;   ///< in degrees, at the folds
  bool face_numbers = false;
  double size_mm = 2.47;  ///< em size (7 pt); shrinks with short edges
  bool operator==(const LabelSettings&) const = default;
};

/// Texture and colours of the model on the paper.
struct PictureSettings {
  enum class OnTabs { Full, Faded, White };
  bool is_on = true;    ///< textures, or material colours where there are none
  int dpi = 300;        ///< 72 … 600
  double bleed_mm = 1;  ///< past the outline
  OnTabs on_tabs = OnTabs::Faded;
  bool operator==(const PictureSettings&) const = default;
};

enum class PrintedSide {
  Outside,  ///< the printed side becomes the outside of the model
  Inside,   ///< mirrored, so that the marks are hidden inside; no picture, which nobody would see there
  Both,     ///< picture and cuts outside, all marks inside, as front and back pages that register
};

/// The user's own words and picture on the sheet.
struct SheetWords {
  std::string title;  ///< empty: the model's name
  std::string author;
  std::string note;
  std::shared_ptr<const Image> picture;
  bool operator==(const SheetWords&) const = default;
};

struct SheetSettings {
  LineStyles lines = line_styles(LinePreset::Origami);
  LabelSettings labels;
  PictureSettings pictures;
  PrintedSide printed_side = PrintedSide::Outside;
  bool loose_strips = true;  ///< a strip of paper for each cut without a glue tab, where a sheet has room
  bool is_grey = false;      ///< everything in shades of grey
  SheetWords words;
  std::vector<EdgeId> hidden_folds;  ///< left out by hand, sorted
  std::vector<EdgeId> shown_folds;   ///< drawn though they are flat, sorted
  bool operator==(const SheetSettings&) const = default;
};

}  // namespace netwright
