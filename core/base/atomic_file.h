// Writing a file so that it is there whole or not at all: never half, never a damaged old one.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace netwright {

/// Looks at what was written, read back from the disk; throws to refuse it.
using WrittenCheck = std::function<void(std::string_view)>;

/// Writes to a temporary file beside the target, flushes it to the disk, has it checked (where there is a
/// check) and renames it over the target. Throws Error(Write) with one sentence, or what the check threw; the
/// old file, if any, is then unharmed and nothing is left behind.
void write_file(const std::filesystem::path& path, std::string_view bytes, const WrittenCheck& check = {});

/// The whole file. Throws Error(Read) when it cannot be read or is larger than `max_bytes`.
std::string read_file(const std::filesystem::path& path, std::size_t max_bytes);

}  // namespace netwright
