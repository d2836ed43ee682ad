// What a net should be besides free of overlaps: the optional objectives of the paper's section 4.6. Every
// one has a least value that is known, 0, though not every model reaches it.
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "core/unfold/net.h"

namespace netwright {

inline constexpr double kNeckWidth = 3;  ///< mm; narrower bridges tear

/// How long a net is polished, and for what. Weights: 0 = not asked for, 1 = as usual.
struct PolishSettings {
  double effort = 1;          ///< 1 is about a second of one core. Counted work, never a clock
  double short_cuts = 1;      ///< little to cut out and to glue: the folds that are kept are the long ones
  double compact = 1;         ///< no long arms: paper near the middle, the convex hull filled
  double few_necks = 1;       ///< no bridges narrower than kNeckWidth
  double fits_paper = 0;      ///< one page is enough
  double root_in_middle = 0;  ///< the root in the middle of the net
  double hidden_cuts = 0;     ///< cuts where they are seen least

  bool operator==(const PolishSettings&) const = default;
};

struct PolishAim {
  PolishSettings settings;
  /// mm per model unit at which a net would be printed. Asked once, for the first net.
  std::function<double(const Net&)> scale;
  std::vector<glm::dvec2> rooms_mm;  ///< a net that fits the paper fits into one of these, turned as it likes
  IdVector<EdgeId, double> in_sight;  ///< how much a cut here is seen, 0…1; empty = all alike
};

/// What came of it. Lengths and counts are of all components together.
struct PolishReport {
  UnfoldTree first;  ///< the tree before
  double scale = 1;  ///< mm per model unit
  int necks_before = 0;
  int necks_after = 0;
  /// How much too large for the room, as a factor on lengths: 1 or less fits. 0 when that was not asked.
  double size_before = 0;
  double size_after = 0;
  /// How far the root is from the middle, in sides of a square as large as the net. 0 when that was not
  /// asked.
  double root_off = 0;
};

/// What was asked for and could be had in full, but is not there: "12 % too large for the page", "3 necks
/// under 3 mm", "the root is off the middle". Short cuts and a compact net are never done: there is always
/// less.
std::vector<std::string> unmet_wishes(const PolishReport& report, const PolishSettings& settings);

}  // namespace netwright
