// The resolution put into a PNG, as a chunk of its own behind the header.
#include "core/sheet/patch_bytes.h"

#include <cmath>
#include <cstdint>
#include <string_view>

namespace netwright {

namespace {

constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n";

std::uint32_t crc32(std::string_view bytes) {
  std::uint32_t crc = 0xffffffffU;
  for (const char c : bytes) {
    crc ^= static_cast<std::uint8_t>(c);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? 0xedb88320U : 0U);
  }
  return ~crc;
}

std::string big_endian(std::uint32_t value) {
  std::string bytes;
  for (const unsigned shift : {24U, 16U, 8U, 0U}) bytes += static_cast<char>((value >> shift) & 0xffU);
  return bytes;
}

}  // namespace

std::string with_resolution(std::string png, double dpi) {
  constexpr std::size_t kHeaderEnd =
      8 + 4 + 4 + 13 + 4;  // signature, then length, name, data and sum of IHDR
  if (png.size() < kHeaderEnd || !png.starts_with(kPngSignature)) return png;
  const auto per_metre = static_cast<std::uint32_t>(std::lround(dpi / 0.0254));
  const std::string body = "pHYs" + big_endian(per_metre) + big_endian(per_metre) + '\x01';
  png.insert(kHeaderEnd, big_endian(9) + body + big_endian(crc32(body)));
  return png;
}

}  // namespace netwright
