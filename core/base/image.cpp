// Decodes pictures with stb_image, after looking at their size so that a lying header cannot ask for
// gigabytes; encodes them with stb_image_write.
#include "core/base/image.h"

#include <stb_image.h>
#include <stb_image_write.h>

#include <cstddef>
#include <limits>
#include <memory>

namespace netwright {

ImageSize image_size(std::string_view bytes) {
  if (bytes.empty() || bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) return {};
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  ImageSize size;
  int channels = 0;
  if (stbi_info_from_memory(data, static_cast<int>(bytes.size()), &size.width, &size.height, &channels) == 0)
    return {};
  return size.width > 0 && size.height > 0 ? size : ImageSize{};
}

Image decode_image(std::string_view bytes) {
  constexpr std::int64_t kMaxPixels = 64'000'000;
  const ImageSize told = image_size(bytes);
  if (told.width == 0 || std::int64_t{told.width} * told.height > kMaxPixels) return {};
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const int size = static_cast<int>(bytes.size());
  int width = 0;
  int height = 0;
  int channels = 0;
  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load_from_memory(data, size, &width, &height, &channels, 4), stbi_image_free);
  if (!pixels) return {};
  Image image{.width = width, .height = height, .rgba = {}};
  image.rgba.assign(pixels.get(), pixels.get() + std::size_t{4} * static_cast<std::size_t>(width) *
                                                     static_cast<std::size_t>(height));
  return image;
}

std::string encode_png(const Image& image) {
  std::string bytes;
  if (image.is_empty()) return bytes;
  const auto append = [](void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(data),
                                               static_cast<std::size_t>(size));
  };
  stbi_write_png_to_func(append, &bytes, image.width, image.height, 4, image.rgba.data(), image.width * 4);
  return bytes;
}

}  // namespace netwright
