// The table of paper sizes (ISO 216 and ANSI), and papers that are named by their sides.
#include "core/base/paper.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>

namespace netwright {

namespace {

constexpr std::array<PaperFormat, 17> kFormats = {{{"A4", 210, 297},
                                                   {"A0", 841, 1189},
                                                   {"A1", 594, 841},
                                                   {"A2", 420, 594},
                                                   {"A3", 297, 420},
                                                   {"A5", 148, 210},
                                                   {"A6", 105, 148},
                                                   {"B0", 1000, 1414},
                                                   {"B1", 707, 1000},
                                                   {"B2", 500, 707},
                                                   {"B3", 353, 500},
                                                   {"B4", 250, 353},
                                                   {"B5", 176, 250},
                                                   {"B6", 125, 176},
                                                   {"Letter", 215.9, 279.4},
                                                   {"Legal", 215.9, 355.6},
                                                   {"Tabloid", 279.4, 431.8}}};

bool equal_ignoring_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

std::optional<double> side_in(std::string_view text) {
  double side = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), side);
  const bool is_number = error == std::errc() && end == text.data() + text.size();
  if (!is_number || !(side >= kLeastPaperSide) || !(side <= kMostPaperSide)) return std::nullopt;
  return side;
}

std::optional<PaperFormat> paper_by_sides(std::string_view name) {
  const std::size_t between = name.find_first_of("xX");
  if (between == std::string_view::npos) return std::nullopt;
  const auto first = side_in(name.substr(0, between));
  const auto second = side_in(name.substr(between + 1));
  if (!first || !second) return std::nullopt;
  return PaperFormat{kCustomPaper, std::min(*first, *second), std::max(*first, *second)};
}

std::string in_tenths(double side_mm) {
  const auto tenths = std::lround(side_mm * 10);
  std::string text = std::to_string(tenths / 10);
  if (tenths % 10 != 0) text += "." + std::to_string(tenths % 10);
  return text;
}

}  // namespace

std::span<const PaperFormat> paper_formats() { return kFormats; }

std::optional<PaperFormat> find_paper(std::string_view name) {
  for (const PaperFormat& format : kFormats)
    if (equal_ignoring_case(format.name, name)) return format;
  return paper_by_sides(name);
}

std::string custom_paper(double width_mm, double height_mm) {
  return in_tenths(std::min(width_mm, height_mm)) + "x" + in_tenths(std::max(width_mm, height_mm));
}

}  // namespace netwright
