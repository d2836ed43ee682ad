// Finds out what kind of file this is, calls its reader, and checks what comes back, so that whoever gets a
// soup may trust its indices and numbers.
#include "core/mesh/read.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>

#include "core/base/error.h"
#include "core/mesh/readers.h"

namespace netwright {

namespace readers {
namespace {

/// How many bytes the UTF-8 character at the start of the text takes; 0 when there is none.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const unsigned lead = byte(0);
  if (lead < 0x80) return lead >= 0x20 && lead != 0x7F ? 1 : 0;
  const std::size_t length = lead >= 0xF0 ? 4 : (lead >= 0xE0 ? 3 : 2);
  unsigned code = lead & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return 0;
    code = code << 6 | (byte(i) & 0x3FU);
  }
  constexpr std::array<unsigned, 5> kLeast{0, 0, 0x80, 0x800, 0x10000};
  const bool is_character = lead >= 0xC2 && lead < 0xF5 && code >= kLeast[length] && code < 0x110000 &&
                            (code < 0xD800 || code > 0xDFFF);
  return is_character ? length : 0;
}

}  // namespace

std::string readable(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    if (length == 0) {
      shown += '?';
    } else {
      shown += text.substr(0, length);
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return shown;
}

void refuse(const std::string& name, const std::string& what) {
  throw Error(ErrorKind::Read, readable(name + ": " + what));
}

}  // namespace readers

namespace {

using readers::refuse;

using Kind = ModelKind;

// Far above any model made for paper; reading more would take the machine's memory before anyone could say
// so.
constexpr std::uintmax_t kMaxFileBytes = std::uintmax_t{256} << 20;

// Squares and volumes of coordinates must stay within a double's range (1e308), so must their reciprocals.
constexpr double kMaxCoordinate = 1e75;

std::string known_extensions() {
  std::string list;
  for (const ModelFormat& format : model_formats()) {
    for (const std::string_view extension : format.extensions) {
      list += (list.empty() ? "." : ", .") + std::string(extension);
    }
  }
  return list;
}

/// "a JPEG picture" for the well-known files that people rename or drop by mistake.
std::string_view something_else(std::string_view bytes) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 9> kStrangers{{
      {"\xFF\xD8\xFF", "a JPEG picture"},
      {"\x89PNG", "a PNG picture"},
      {"GIF8", "a GIF picture"},
      {"RIFF", "a WebP, sound or video file"},
      {"%PDF", "a PDF document"},
      {"BLENDER", "a Blender project"},
      {"\x1F\x8B", "a gzip archive"},
      {"7z\xBC\xAF", "a 7z archive"},
      {"Kaydara FBX", "an FBX model"},
  }};
  for (const auto& [start, what] : kStrangers) {
    if (bytes.starts_with(start)) return what;
  }
  return {};
}

bool is_binary_stl(std::string_view bytes) {
  if (bytes.size() < 84) return false;
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, sizeof count);
  return count > 0 && bytes.size() == 84 + std::uint64_t{50} * count;
}

std::string_view without_blank_start(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  return text;
}

/// True when one of the first lines is an OBJ point.
bool has_obj_point(std::string_view text) {
  text = text.substr(0, 1 << 16);
  return text.starts_with("v ") || text.find("\nv ") != std::string_view::npos ||
         text.find("\rv ") != std::string_view::npos || text.find("\nv\t") != std::string_view::npos;
}

/// A 3DS file is one chunk of type 4D4D that says how long it is.
bool is_3ds(std::string_view bytes) {
  if (bytes.size() < 6 || !bytes.starts_with("MM")) return false;
  std::uint32_t length = 0;
  std::memcpy(&length, bytes.data() + 2, sizeof length);
  return length == bytes.size();
}

/// The format that the bytes themselves speak of.
std::optional<Kind> kind_by_content(std::string_view bytes) {
  if (bytes.starts_with("glTF")) return Kind::Gltf;
  if (bytes.starts_with("ply\n") || bytes.starts_with("ply\r")) return Kind::Ply;
  if (is_binary_stl(bytes)) return Kind::Stl;
  if (is_3ds(bytes)) return Kind::ThreeDs;
  const std::string_view start = without_blank_start(bytes).substr(0, 1 << 16);
  if (start.find('\0') != std::string_view::npos) return std::nullopt;
  const std::string_view word = start.substr(0, start.find_first_of(" \t\r\n"));
  if (word.size() <= 5 && word.ends_with("OFF")) return Kind::Off;
  if (word == "solid" && start.find("facet") != std::string_view::npos) return Kind::Stl;
  if (word.starts_with('{') && start.find("\"asset\"") != std::string_view::npos) return Kind::Gltf;
  if (word.starts_with('<') && start.find("<COLLADA") != std::string_view::npos) return Kind::Dae;
  if (has_obj_point(start)) return Kind::Obj;
  return std::nullopt;
}

Kind kind_of(const std::string& name, std::string_view bytes) {
  if (bytes.empty()) refuse(name, "the file is empty; export the model again.");
  const std::string_view stranger = something_else(bytes);
  if (!stranger.empty()) {
    refuse(name, "this is " + std::string(stranger) +
                     ", not a model in a format that can be read; open one of " + known_extensions() + ".");
  }
  const ModelFormat* named = model_format(std::filesystem::path(name));
  if (bytes.starts_with("PK\x03\x04")) {
    if (named != nullptr && named->kind == Kind::ThreeMf) return Kind::ThreeMf;
    refuse(name, "this is a zip archive; unpack it and open the model inside.");
  }
  if (const auto kind = kind_by_content(bytes)) return *kind;
  if (named == nullptr) {
    refuse(name,
           "this is no model in a format that can be read; export it as one of " + known_extensions() + ".");
  }
  const bool has_nul = bytes.substr(0, 4096).find('\0') != std::string_view::npos;
  const bool has_a_mark =
      named->kind == Kind::ThreeMf || named->kind == Kind::Dae || named->kind == Kind::ThreeDs;
  if (has_a_mark || (named->kind == Kind::Obj && has_nul)) {
    const std::string label(named->label);
    refuse(name, "its content is not that of a " + label + " file; export the model again.");
  }
  return named->kind;
}

PolygonSoup read_kind(Kind kind, const std::string& name, std::string_view bytes,
                      const CompanionLookup& companions) {
  switch (kind) {
    case Kind::Obj:
      return readers::read_obj(name, bytes, companions);
    case Kind::Gltf:
      return readers::read_gltf(name, bytes, companions);
    case Kind::Off:
      return readers::read_off(name, bytes);
    case Kind::Stl:
    case Kind::Ply:
    case Kind::ThreeMf:
    case Kind::Dae:
    case Kind::ThreeDs:
      break;
  }
  const ModelFormat& format = model_format(kind);
  return readers::read_in_child(name, bytes, std::string(format.extensions.front()), companions);
}

void check_soup(const std::string& name, const PolygonSoup& soup) {
  if (soup.n_faces() == 0) {
    refuse(name, soup.points.empty() ? "there is no shape in it; export the model with its faces."
                                     : "it holds points but no faces; export the model with its faces.");
  }
  for (std::size_t i = 0; i < soup.points.size(); ++i) {
    const glm::dvec3& p = soup.points[i];
    const double largest = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    const bool is_number = std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
    if (is_number && largest <= kMaxCoordinate) continue;
    refuse(name, "point " + std::to_string(i + 1) +
                     (is_number ? " lies further out than 1e75; scale the model down."
                                : " has a coordinate that is not a finite number; repair the point or export "
                                  "the model again."));
  }
  const int n_points = static_cast<int>(soup.points.size());
  for (int f = 0; f < soup.n_faces(); ++f) {
    for (const int corner : soup.face(f)) {
      if (corner >= 0 && corner < n_points) continue;
      refuse(name, "face " + std::to_string(f + 1) + " names point " + std::to_string(corner + 1) +
                       ", but there are only " + std::to_string(n_points) + "; export the model again.");
    }
  }
}

void clean_colours(PolygonSoup& soup) {
  for (Material& material : soup.materials) {
    for (int i = 0; i < 3; ++i) {
      double& share = material.colour[i];
      share = std::isfinite(share) ? std::clamp(share, 0.0, 1.0) : Material().colour[i];
    }
  }
}

/// Texture coordinates that are no numbers would poison a drawing: they are left out, and told.
void clean_uv(PolygonSoup& soup) {
  bool was_bad = false;
  for (glm::dvec2& uv : soup.corner_uv) {
    if (std::isfinite(uv.x) && std::isfinite(uv.y)) continue;
    uv = glm::dvec2(0);
    was_bad = true;
  }
  if (was_bad) soup.notices.emplace_back("Some texture coordinates are not numbers; they were set to zero.");
}

/// The file of that name, large and small letters being the same (models from Windows); else the name itself.
std::filesystem::path in_any_case(const std::filesystem::path& wanted) {
  std::error_code error;
  const auto alike = [](char a, char b) {
    const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    return small(a) == small(b);
  };
  const std::string name = wanted.filename().string();
  for (std::filesystem::directory_iterator at(wanted.parent_path(), error), end; !error && at != end;
       at.increment(error)) {
    if (std::ranges::equal(at->path().filename().string(), name, alike)) return at->path();
  }
  return wanted;
}

/// A whole file; empty when it is no file, cannot be read or is too large.
std::optional<std::string> file_bytes(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return std::nullopt;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error || size > kMaxFileBytes) return std::nullopt;
  std::ifstream file(path, std::ios::binary);
  std::string bytes(static_cast<std::size_t>(size), '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(size));
  if (!file) return std::nullopt;
  return bytes;
}

std::string model_bytes(const std::string& name, const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) refuse(path.string(), "there is no such file; check the path.");
  if (std::filesystem::is_directory(path, error))
    refuse(name, "this is a folder; open the model file inside it.");
  if (!std::filesystem::is_regular_file(path, error)) refuse(name, "this is not a regular file.");
  if (std::filesystem::file_size(path, error) > kMaxFileBytes) {
    refuse(name,
           "it is larger than 256 MB, far too much for paper; simplify it in a modelling program first.");
  }
  std::optional<std::string> bytes = file_bytes(path);
  if (!bytes) refuse(name, "the file cannot be read; check its permissions.");
  return std::move(*bytes);
}

}  // namespace

PolygonSoup read_soup_bytes(const std::string& name, std::string_view bytes,
                            const CompanionLookup& companions) {
  const Kind kind = kind_of(name, bytes);
  const CompanionLookup none = [](const std::string&) { return std::nullopt; };
  PolygonSoup soup = read_kind(kind, name, bytes, companions ? companions : none);
  soup.name = readers::readable(name);
  for (std::string& notice : soup.notices) notice = readers::readable(notice);
  for (Material& material : soup.materials) material.name = readers::readable(material.name);
  soup.up_axis = model_format(kind).up_axis;
  check_soup(name, soup);
  clean_colours(soup);
  clean_uv(soup);
  return soup;
}

PolygonSoup read_soup(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  const std::string bytes = model_bytes(name, path);
  const CompanionLookup beside = [&path](const std::string& written) {
    std::string file = written;  // exporters on Windows write backslashes
    std::ranges::replace(file, '\\', '/');
    const std::filesystem::path wanted(file);
    std::optional<std::string> found;
    if (wanted.is_relative()) found = file_bytes(path.parent_path() / wanted);
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    if (!found) found = file_bytes(folder / wanted.filename());
    return found ? found : file_bytes(in_any_case(folder / wanted.filename()));
  };
  return read_soup_bytes(name, bytes, beside);
}

}  // namespace netwright
