// Pixels: 8-bit RGBA, rows from top to bottom.
#pragma once

#include <cstdint>
#include <vector>

namespace netwright {

struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;  ///< 4 * width * height bytes
  [[nodiscard]] bool is_empty() const { return width <= 0 || height <= 0; }
};

}  // namespace netwright
