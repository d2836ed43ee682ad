// The size a file claims, by the unit that its format prescribes or that is likely.
#include "core/project/real_size.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "core/mesh/mesh_report.h"

namespace netwright {
namespace {

constexpr double kSmallest_mm = 10;
constexpr double kLargest_mm = 2000;

/// Two digits that matter, none of them behind a dot from ten on.
std::string two_digits(double value) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), value >= 9.95 && value < 1e6 ? "%.0f" : "%.2g", value);
  return text.data();
}

}  // namespace

bool RealSize::is_odd() const { return longest_mm < kSmallest_mm || longest_mm > kLargest_mm; }

bool RealSize::is_worth_asking() const {
  constexpr double kLeastHeight = 0.01;  // of the longest side
  return is_odd() && height_mm > kLeastHeight * longest_mm;
}

RealSize real_size(const PolygonSoup& source, const Mesh& mesh) {
  const double in_mm = guess_unit(source).in_mm;
  const glm::dvec3 size = mesh.box().size();
  return {mesh.height() * in_mm, std::max({size.x, size.y, size.z}) * in_mm};
}

std::string real_length_text(double millimetres) {
  constexpr double kMetre = 1000;
  constexpr double kKilometre = 1e6;
  if (millimetres >= kKilometre) return two_digits(millimetres / kKilometre) + " km";
  if (millimetres >= kMetre) return two_digits(millimetres / kMetre) + " m";
  return two_digits(millimetres) + " mm";
}

}  // namespace netwright
