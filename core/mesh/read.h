// Reads model files: picks a reader by content, then by extension, and hands back what the file holds as a
// PolygonSoup.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "core/mesh/formats.h"
#include "core/mesh/soup.h"

namespace netwright {

/// Finds a file that a model refers to (material library, picture, buffer) by the name written in the model;
/// empty when there is none.
using CompanionLookup = std::function<std::optional<std::string>(const std::string& name)>;

/// Reads a model file. Its companions are looked for beside it. The soup keeps the file's order of faces, has
/// valid indices, finite coordinates and at least one face.
/// Throws Error(Read) with one sentence that names the file, the place in it and the cure.
PolygonSoup read_soup(const std::filesystem::path& path);

/// The same for a model in memory; `name` stands for the file name, in messages and for its extension.
PolygonSoup read_soup_bytes(const std::string& name, std::string_view bytes,
                            const CompanionLookup& companions = {});

}  // namespace netwright
