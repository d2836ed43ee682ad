// The files that travel inside the programs: fonts, shaders and sample models, as they lie in the tree.
// Nothing is unpacked or copied: the bytes are part of the binary.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace netwright {

struct Asset {
  std::string_view name;  // the path from the project's root, such as "assets/fonts/Inter-Regular.otf"
  std::span<const std::byte> bytes;
};

/// Everything that is embedded, in the order of assets/CMakeLists.txt.
std::span<const Asset> assets();

/// The bytes of one embedded file by its path from the project's root; they live as long as the program and a
/// zero byte follows them. Throws std::out_of_range when no such file is embedded.
std::span<const std::byte> asset(std::string_view name);

/// The same bytes as text, for shaders and models.
std::string_view asset_text(std::string_view name);

}  // namespace netwright
