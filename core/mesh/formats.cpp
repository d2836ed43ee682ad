// The formats and how the table words them.
#include "core/mesh/formats.h"

#include <algorithm>
#include <utility>

namespace netwright {
namespace {

using std::string_view;

constexpr std::array<string_view, 1> kObj{"obj"};
constexpr std::array<string_view, 2> kGltf{"glb", "gltf"};
constexpr std::array<string_view, 1> kStl{"stl"};
constexpr std::array<string_view, 1> kPly{"ply"};
constexpr std::array<string_view, 1> kOff{"off"};
constexpr std::array<string_view, 1> kThreeMf{"3mf"};
constexpr std::array<string_view, 1> kDae{"dae"};
constexpr std::array<string_view, 1> kThreeDs{"3ds"};

constexpr std::array<ModelFormat, 8> kFormats{{
    {ModelKind::Obj, "Wavefront OBJ", kObj, UpAxis::Y, "y", "", true, "materials", "files"},
    {ModelKind::Gltf, "glTF 2.0", kGltf, UpAxis::Y, "y", "m", false, "materials", "files, inside"},
    {ModelKind::Stl, "STL, binary and text", kStl, UpAxis::Z, "z", "mm", false, "", ""},
    {ModelKind::Ply, "PLY", kPly, UpAxis::Z, "z", "", true, "points", "files"},
    {ModelKind::Off, "OFF", kOff, UpAxis::Z, "z", "", true, "faces, points", ""},
    {ModelKind::ThreeMf, "3MF", kThreeMf, UpAxis::Z, "z", "mm", false, "", ""},
    {ModelKind::Dae, "Collada", kDae, UpAxis::Y, "in the file", "", true, "materials", "files"},
    {ModelKind::ThreeDs, "3DS", kThreeDs, UpAxis::Y, "z", "", false, "materials", "files"},
}};

std::string small(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

}  // namespace

std::span<const ModelFormat> model_formats() { return kFormats; }

const ModelFormat& model_format(ModelKind kind) { return kFormats.at(static_cast<std::size_t>(kind)); }

const ModelFormat* model_format(const std::filesystem::path& path) {
  const std::string extension = small(path.extension().string());
  const auto found = std::ranges::find_if(kFormats, [&](const ModelFormat& format) {
    return !extension.empty() &&
           std::ranges::find(format.extensions, string_view(extension).substr(1)) != format.extensions.end();
  });
  return found == kFormats.end() ? nullptr : &*found;
}

bool is_model_path(const std::filesystem::path& path) { return model_format(path) != nullptr; }

std::vector<std::array<std::string, 7>> model_format_table() {
  std::vector<std::array<std::string, 7>> rows{
      {"Format", "Files", "Faces", "Colours", "Pictures", "Unit", "Up"}};
  const auto or_dash = [](string_view text) { return std::string(text.empty() ? "–" : text); };
  for (const ModelFormat& format : kFormats) {
    std::string files;
    for (const string_view extension : format.extensions)
      files += (files.empty() ? "." : " .") + std::string(extension);
    rows.push_back({std::string(format.label), files, format.keeps_polygons ? "polygons" : "triangles",
                    or_dash(format.colours), or_dash(format.pictures),
                    std::string(format.unit.empty() ? "by size" : format.unit), std::string(format.up)});
  }
  return rows;
}

}  // namespace netwright
