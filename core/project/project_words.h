// The words of project files, in the order of the values they stand for.
#pragma once

#include <array>
#include <string_view>

namespace netwright::project_words {

inline constexpr std::array<std::string_view, 2> kUp{"y", "z"};
inline constexpr std::array<std::string_view, 3> kUneven{"refuse", "split", "flatten"};
inline constexpr std::array<std::string_view, 3> kOrientation{"auto", "portrait", "landscape"};
inline constexpr std::array<std::string_view, 2> kSizes{"fit_page", "height"};

}  // namespace netwright::project_words
