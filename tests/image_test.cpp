// Decoding pictures, whole, damaged and lying ones.
#include "core/base/image.h"

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <iterator>
#include <string>

namespace netwright {
namespace {

/// An uncompressed 32-bit TGA of one row.
std::string tga(const std::string& bgra) {
  std::string bytes(18, '\0');
  bytes[2] = 2;
  bytes[12] = static_cast<char>(bgra.size() / 4);
  bytes[14] = 1;
  bytes[16] = 32;
  bytes[17] = 0x28;
  return bytes + bgra;
}

TEST(Image, DecodesPixelsAsRedGreenBlueAlpha) {
  const Image image = decode_image(tga("\x01\x02\x03\x04\x0A\x0B\x0C\x0D"));
  EXPECT_EQ(image.width, 2);
  EXPECT_EQ(image.height, 1);
  EXPECT_EQ(image.rgba, (std::vector<std::uint8_t>{3, 2, 1, 4, 12, 11, 10, 13}));
}

TEST(Image, DecodesTheGlobesMap) {
  std::ifstream file(NETWRIGHT_SOURCE "/assets/samples/globe.png", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const Image image = decode_image(bytes);
  EXPECT_EQ(image.width, 1024);
  EXPECT_EQ(image.height, 512);
  EXPECT_EQ(image.rgba.size(), 4U * 1024 * 512);
  EXPECT_TRUE(decode_image(bytes.substr(0, bytes.size() / 20)).is_empty());
}

TEST(Image, IsEmptyForWhatIsNoPicture) {
  EXPECT_TRUE(decode_image("").is_empty());
  EXPECT_TRUE(decode_image("not a picture").is_empty());
}

TEST(Image, RefusesSizesNobodyPrints) {
  std::string bytes = tga(std::string(4, '\0'));
  bytes[12] = bytes[13] = bytes[14] = bytes[15] = '\x7F';
  EXPECT_TRUE(decode_image(bytes).is_empty());
}

}  // namespace
}  // namespace netwright
