// The presets of line styles.
#include "core/sheet/sheet_settings.h"

#include <utility>

#include "core/sheet/print_style.h"

namespace netwright {

namespace {

using namespace print_style;

LineStyles coloured_lines() {
  LineStyles styles;
  styles.cut = {kCutColour, kCutWidth, {}};
  styles.mountain = {kMountainColour, kFoldWidth, {kMountainDash.begin(), kMountainDash.end()}};
  styles.valley = {kValleyColour, kFoldWidth, {kValleyDash.begin(), kValleyDash.end()}};
  styles.tab_fold = {kQuietInk, kFoldWidth, {kTabFoldDash.begin(), kTabFoldDash.end()}};
  return styles;
}

/// Pure colours at the width that laser cutters take for a line to follow.
LineStyles cutter_lines() {
  LineStyles styles;
  styles.cut = {{1, 0, 0}, kCutterWidth, {}};
  styles.mountain = {{0, 0, 1}, kCutterWidth, {}};
  styles.valley = {{0, 1, 0}, kCutterWidth, {}};
  styles.tab_fold = {{1, 0, 1}, kCutterWidth, {}};
  return styles;
}

}  // namespace

LineStyles line_styles(LinePreset preset) {
  LineStyles styles = coloured_lines();
  switch (preset) {
    case LinePreset::Kit:
      std::swap(styles.mountain.dash_mm, styles.valley.dash_mm);
      return styles;
    case LinePreset::SolidDash:
      styles.mountain.dash_mm.clear();
      return styles;
    case LinePreset::Cutter:
      return cutter_lines();
    default:
      return styles;
  }
}

}  // namespace netwright
