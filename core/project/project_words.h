// The words of project files, in the order of the values they stand for.
#pragma once

#include <array>
#include <string_view>

namespace netwright::project_words {

inline constexpr std::array<std::string_view, 2> kUp{"y", "z"};
inline constexpr std::array<std::string_view, 3> kUneven{"refuse", "split", "flatten"};
inline constexpr std::array<std::string_view, 3> kOrientation{"auto", "portrait", "landscape"};
inline constexpr std::array<std::string_view, 5> kTabSides{"auto", "first", "second", "both", "none"};
inline constexpr std::array<std::string_view, 3> kTabPatterns{"best_side", "alternating", "both_sides"};
inline constexpr std::array<std::string_view, 3> kOnTabs{"full", "faded", "white"};
inline constexpr std::array<std::string_view, 3> kPrintedSides{"outside", "inside", "both"};
inline constexpr std::array<std::string_view, 3> kInstructions{"none", "first", "last"};
inline constexpr std::array<std::string_view, 5> kSizes{"fit_page", "height", "edge", "scale", "fit_sheets"};

}  // namespace netwright::project_words
