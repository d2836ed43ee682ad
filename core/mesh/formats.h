// The one table of model formats: readers, dialogs, command line and README take from it what can be read and
// what is kept of it.
#pragma once

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/mesh/soup.h"

namespace netwright {

/// In the order of model_formats().
enum class ModelKind { Obj, Gltf, Stl, Ply, Off, ThreeMf, Dae, ThreeDs };

struct ModelFormat {
  ModelKind kind;
  std::string_view label;                        ///< "Wavefront OBJ"
  std::span<const std::string_view> extensions;  ///< lower case without the dot, the usual one first
  UpAxis up_axis;         ///< of the soup that comes out; reading turns Collada and 3DS models y up
  std::string_view up;    ///< in the file: "y", "z", "in the file"
  std::string_view unit;  ///< that the format means: "mm", "m"; empty when it must be guessed from the size
  bool keeps_polygons;    ///< faces may have more than three corners
  std::string_view
      colours;  ///< where they stand in the file: "materials", "points"; empty when none are kept
  std::string_view pictures;  ///< "files", "files, inside"; empty when none are kept
};

/// Every format that can be read, the most common one first.
std::span<const ModelFormat> model_formats();
const ModelFormat& model_format(ModelKind kind);

/// By the path's extension, in any case; null when no format has it.
const ModelFormat* model_format(const std::filesystem::path& path);
/// True when the path's extension (any case) is one of a format above.
bool is_model_path(const std::filesystem::path& path);

/// The table as people read it, headings first: format, files, faces, colours, pictures, unit, up. What a
/// format does not have is "–".
std::vector<std::array<std::string, 7>> model_format_table();

}  // namespace netwright
