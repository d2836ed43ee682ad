// Lengths in words: millimetres inside the program, millimetres or inches before the eyes. Everything that
// shows a length goes through here; what takes one in is length_field() of the widgets.
#pragma once

#include <string>

namespace netwright {

enum class LengthUnit { Millimetre, Inch };

constexpr double kMillimetresPerInch = 25.4;

/// How many millimetres one of the unit has.
constexpr double in_millimetres(LengthUnit unit) {
  return unit == LengthUnit::Inch ? kMillimetresPerInch : 1;
}

/// "mm" or "in".
const char* sign_of(LengthUnit unit);

/// "under 0.01 mm", "0.8 mm", "12 mm"; "0.031 in", "1.25 in", "12.5 in".
std::string length_text(double millimetres, LengthUnit unit);

/// As measured, with the same digits however long it is: "18.2 mm", "1 204.5 mm"; "0.717 in".
std::string exact_length_text(double millimetres, LengthUnit unit);

/// "210 × 297 mm", "8.5 × 11 in": as precise as sheets of paper are.
std::string area_text(double width_mm, double height_mm, LengthUnit unit);

/// For a field that takes a length: whole millimetres, hundredths of an inch.
const char* field_format(LengthUnit unit);

}  // namespace netwright
