// How a printed sheet looks: line widths, dashes and colours of the net, and the measures of what stands
// around it. Lengths in mm.
#pragma once

#include <array>
#include <glm/vec3.hpp>

namespace netwright::print_style {

constexpr glm::dvec3 rgb(unsigned hex) {
  return {((hex >> 16U) & 0xffU) / 255.0, ((hex >> 8U) & 0xffU) / 255.0, (hex & 0xffU) / 255.0};
}

// The net. Colour is a second cue only: the dashes tell the folds apart in black and white too.
inline constexpr double kCutWidth = 0.25;
inline constexpr double kFoldWidth = 0.18;
inline constexpr glm::dvec3 kCutColour = rgb(0x1a1a1a);
inline constexpr glm::dvec3 kMountainColour = rgb(0xa8381f);
inline constexpr glm::dvec3 kValleyColour = rgb(0x2456c8);
inline constexpr std::array<double, 4> kMountainDash = {3.0, 0.9, 0.3, 0.9};
inline constexpr std::array<double, 2> kValleyDash = {2.0, 1.2};
inline constexpr std::array<double, 2> kTabFoldDash = {1.0, 0.8};
inline constexpr double kCutterWidth = 0.1;
/// A pattern is shrunk to this share at most to fit an edge; on shorter edges the fold is one solid line.
inline constexpr double kLeastDashScale = 0.35;

// Ink of what stands around the net.
inline constexpr glm::dvec3 kInk = rgb(0x1f2328);
inline constexpr glm::dvec3 kQuietInk = rgb(0x5b636d);
inline constexpr glm::dvec3 kPaperInk = rgb(0xffffff);  ///< of words on dark pictures
inline constexpr glm::dvec3 kHairline = rgb(0xb4bac2);
inline constexpr glm::dvec3 kMapPaper = rgb(0xdfe3e8);
inline constexpr glm::dvec3 kGlueBand = rgb(0xe9ebee);
inline constexpr glm::dvec3 kMapHere = rgb(0x1f2328);
inline constexpr glm::dvec3 kGood = rgb(0x1a7f37);
inline constexpr double kHairlineWidth = 0.12;
inline constexpr double kRulerWidth = 0.15;

// Strips around the net.
inline constexpr double kHeaderHeight = 11;
inline constexpr double kWideHeader = 120;     ///< from this width on figures and proof share a line
inline constexpr double kStripGap = 3;         ///< between a strip and the net
inline constexpr double kFooterHeight = 11;    ///< legend and ruler side by side
inline constexpr double kLegendHeight = 6.5;   ///< the legend alone, when the ruler goes elsewhere
inline constexpr double kNoteHeight = 4;       ///< one line of small print
inline constexpr double kSideWidth = 12;       ///< upright ruler
inline constexpr double kLegendColumn = 27.5;  ///< one entry of the legend
inline constexpr double kRulerLength = 100;
inline constexpr double kSquare = 50;  ///< test square, where there is room

// Layout.
inline constexpr double kPieceGap = 3;
inline constexpr double kTileOverlap = 10;
inline constexpr double kNetInset = 0.5;     ///< keeps line widths and rounding inside the frame
inline constexpr double kLeastNetSide = 30;  ///< a page with less room than this for the net is no use

}  // namespace netwright::print_style
