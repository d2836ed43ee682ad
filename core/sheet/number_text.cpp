// Numbers for titles and for vector files, through std::to_chars.
#include "core/sheet/number_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace netwright {

std::string decimal_number(double value, int decimals) {
  std::array<char, 400> buffer{};  // the largest double has 309 digits
  const auto done = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                  std::chars_format::fixed, std::clamp(decimals, 0, 20));
  std::string text(buffer.data(), done.ptr);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::string short_number(double value) {
  if (value == 0 || !std::isfinite(value)) return std::isfinite(value) ? "0" : "?";
  const int magnitude = static_cast<int>(std::floor(std::log10(std::abs(value))));
  if (magnitude < -6 || magnitude > 9) {
    std::array<char, 40> buffer{};
    const auto done =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, 3);
    return {buffer.data(), done.ptr};
  }
  return decimal_number(value, 2 - magnitude);
}

}  // namespace netwright
