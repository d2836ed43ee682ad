// Writing a file so that it is there whole or not at all: never half, never a damaged old one.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace netwright {

/// Writes to a temporary file beside the target, flushes it to the disk and renames it over the target.
/// Throws Error(Write) with one sentence; the old file, if any, is then unharmed and nothing is left behind.
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// The whole file. Throws Error(Read) when it cannot be read or is larger than `max_bytes`.
std::string read_file(const std::filesystem::path& path, std::size_t max_bytes);

}  // namespace netwright
