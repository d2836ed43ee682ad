// Puts lengths into words. Digits are kept as far as scissors and printers can follow.
#include "ui/lengths.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "ui/status.h"

namespace netwright {
namespace {

std::string number_text(const char* format, double value) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), format, value);
  return buffer.data();
}

std::string inch_text(double inches) {
  if (inches < 0.0005) return "under 0.001 in";
  if (inches < 0.0995) return number_text("%.3f in", inches);
  if (inches < 9.995) return number_text("%.2f in", inches);
  return number_text("%.1f in", inches);
}

std::string millimetre_text(double millimetres) {
  if (millimetres < 0.005) return "under 0.01 mm";
  if (millimetres < 0.095) return number_text("%.2f mm", millimetres);
  if (millimetres < 9.95) return number_text("%.1f mm", millimetres);
  return grouped(std::llround(millimetres)) + " mm";
}

/// At most two digits after the point, and no zeros that say nothing.
std::string short_inches(double inches) {
  std::string text = number_text("%.2f", inches);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text;
}

}  // namespace

const char* sign_of(LengthUnit unit) { return unit == LengthUnit::Inch ? "in" : "mm"; }

std::string length_text(double millimetres, LengthUnit unit) {
  return unit == LengthUnit::Inch ? inch_text(millimetres / kMillimetresPerInch)
                                  : millimetre_text(millimetres);
}

std::string exact_length_text(double millimetres, LengthUnit unit) {
  if (unit == LengthUnit::Inch) return number_text("%.3f in", millimetres / kMillimetresPerInch);
  const auto tenths = std::llround(millimetres * 10);
  return grouped(tenths / 10) + "." + std::to_string(std::abs(tenths % 10)) + " mm";
}

std::string area_text(double width_mm, double height_mm, LengthUnit unit) {
  if (unit == LengthUnit::Inch)
    return short_inches(width_mm / kMillimetresPerInch) + " × " +
           short_inches(height_mm / kMillimetresPerInch) + " in";
  return std::to_string(std::lround(width_mm)) + " × " + std::to_string(std::lround(height_mm)) + " mm";
}

const char* field_format(LengthUnit unit) { return unit == LengthUnit::Inch ? "%.2f in" : "%.0f mm"; }

}  // namespace netwright
