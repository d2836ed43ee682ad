// Pixels: 8-bit RGBA, rows from top to bottom.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace netwright {

struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;  ///< 4 * width * height bytes
  [[nodiscard]] bool is_empty() const { return width <= 0 || height <= 0; }
};

struct ImageSize {
  int width = 0;
  int height = 0;
};

/// What a picture file's header says, without decoding anything; 0 x 0 when it is none.
ImageSize image_size(std::string_view bytes);

/// Decodes a PNG, JPEG, BMP, TGA or GIF file's bytes; an empty image when they are none of these, are
/// damaged, or hold more than 64 million pixels.
Image decode_image(std::string_view bytes);

/// The picture as the bytes of a PNG file; empty when the picture is.
std::string encode_png(const Image& image);

}  // namespace netwright
