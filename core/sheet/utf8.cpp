// UTF-8 in titles may come from anywhere (file names); here it is decoded and cleaned.
#include <cstdint>

#include "core/sheet/font.h"

namespace netwright {

namespace {

constexpr char32_t kReplacement = 0xfffd;

struct Decoded {
  char32_t code = kReplacement;
  std::size_t length = 1;
};

Decoded decode(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint8_t lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4 || text.size() < length) return {};
  char32_t code = lead & (0x7fU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0U) != 0x80U) return {};
    code = (code << 6U) | (byte(i) & 0x3fU);
  }
  const bool is_overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  const bool is_outside = (code >= 0xd800 && code < 0xe000) || code > 0x10ffff;
  return is_overlong || is_outside ? Decoded{} : Decoded{code, length};
}

}  // namespace

std::vector<char32_t> code_points(std::string_view utf8) {
  std::vector<char32_t> codes;
  while (!utf8.empty()) {
    const Decoded next = decode(utf8);
    codes.push_back(next.code);
    utf8.remove_prefix(next.length);
  }
  return codes;
}

std::string clean_utf8(std::string_view text) {
  std::string clean;
  while (!text.empty()) {
    const Decoded next = decode(text);
    if (next.code == kReplacement || next.code < 0x20 || next.code == 0x7f)
      clean += "\xef\xbf\xbd";
    else
      clean += text.substr(0, next.length);
    text.remove_prefix(next.length);
  }
  return clean;
}

}  // namespace netwright
