// Numbers and words on a net: the same number on both sides of a cut, names of pieces, angles of folds,
// numbers of faces. Each lies wholly inside one face or tab and covers no other, so none covers a line
// either.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "core/sheet/pages.h"
#include "core/sheet/sheet.h"

namespace netwright {

/// Words in a box, on a canvas, in mm, y down.
struct Label {
  enum class Kind { EdgeNumber, PieceName, FoldAngle, FaceNumber };
  Kind kind = Kind::EdgeNumber;
  std::string words;
  int canvas = 0;
  glm::dvec2 centre{0, 0};
  double angle_rad = 0;     ///< clockwise, within -90 … 90 degrees, so that it is never upside down
  double size_mm = 2.47;    ///< em size
  glm::dvec2 box_mm{0, 0};  ///< width and height of the ink
  FaceId face;              ///< it lies in this face, or on a tab of it
  HalfedgeId side;          ///< of that face, for edge numbers and fold angles
  bool is_on_tab = false;

  [[nodiscard]] std::array<glm::dvec2, 4> corners() const;
};

struct PlacedLabels {
  std::vector<Label> labels;
  std::vector<EdgeId> left_out;  ///< cuts whose number finds no room on both sides, sorted; they have none
};

/// Names of pieces stand out.
inline FontWeight weight_of(Label::Kind kind) {
  return kind == Label::Kind::PieceName ? FontWeight::SemiBold : FontWeight::Regular;
}

/// Where everything goes that the settings ask for. Edge numbers run 1, 2, 3 … along the outline of the first
/// piece, then on along the next.
PlacedLabels place_labels(const Net& net, const PageLayout& layout, const SheetSettings& settings);

/// The number of each cut that gets one, in the order of the outline; 0 for all other edges. Those `tabless`
/// are not obvious: a loose strip belongs to them.
IdVector<EdgeId, int> cut_numbers(const Net& net, bool skips_obvious,
                                  const std::vector<EdgeId>& tabless = {});

/// Cuts for which loose strips are made.
inline std::vector<EdgeId> strip_cuts(const PageLayout& layout, const SheetSettings& settings) {
  return settings.loose_strips ? layout.tabs.missing : std::vector<EdgeId>();
}

/// Numbers that read as another one upside down end with a point: "6." and "9.", "86." and "98.".
std::string number_words(int number);

/// A, B … Z, AA …
std::string piece_name(int piece);

/// A label smaller than this is left out (3 pt).
inline constexpr double kLeastLabelSize = 1.058;
/// Two sides that meet at a point under less than this can only be glued to each other.
inline constexpr double kObviousGap = 1.6;

}  // namespace netwright
