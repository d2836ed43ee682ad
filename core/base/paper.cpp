// The table of paper sizes (ISO 216 and ANSI).
#include "core/base/paper.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace netwright {

namespace {

constexpr std::array<PaperFormat, 13> kFormats = {{{"A4", 210, 297},
                                                   {"A0", 841, 1189},
                                                   {"A1", 594, 841},
                                                   {"A2", 420, 594},
                                                   {"A3", 297, 420},
                                                   {"A5", 148, 210},
                                                   {"A6", 105, 148},
                                                   {"B3", 353, 500},
                                                   {"B4", 250, 353},
                                                   {"B5", 176, 250},
                                                   {"Letter", 215.9, 279.4},
                                                   {"Legal", 215.9, 355.6},
                                                   {"Tabloid", 279.4, 431.8}}};

bool equal_ignoring_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

}  // namespace

std::span<const PaperFormat> paper_formats() { return kFormats; }

std::optional<PaperFormat> find_paper(std::string_view name) {
  for (const PaperFormat& format : kFormats)
    if (equal_ignoring_case(format.name, name)) return format;
  return std::nullopt;
}

}  // namespace netwright
