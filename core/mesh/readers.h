// What the readers of the single formats share; only read.cpp, read_*.cpp and the helper program include it.
#pragma once

#include <string>
#include <string_view>

#include "core/base/subprocess.h"
#include "core/mesh/read.h"
#include "core/mesh/soup.h"

namespace netwright::readers {

/// Text from a file, fit to be shown: control characters and what is no UTF-8 become '?'.
std::string readable(std::string_view text);

/// Throws Error(Read) with "name: what", made readable.
[[noreturn]] void refuse(const std::string& name, const std::string& what);

PolygonSoup read_obj(const std::string& name, std::string_view bytes, const CompanionLookup& companions);
PolygonSoup read_gltf(const std::string& name, std::string_view bytes, const CompanionLookup& companions);

PolygonSoup read_off(const std::string& name, std::string_view bytes);

/// Who reads for us, and how far we let it go.
struct ChildReader {
  std::filesystem::path program;
  ChildLimits limits;
};
/// netwright-read beside this program; some seconds, less than a gigabyte.
ChildReader usual_child_reader();

/// Reads STL, PLY, 3MF, Collada or 3DS in a child process, so that neither a crash nor a blow-up in the
/// library that parses them costs the user anything. `extension` is one of "stl", "ply", "3mf", "dae", "3ds".
PolygonSoup read_in_child(const std::string& name, std::string_view bytes, const std::string& extension,
                          const CompanionLookup& companions,
                          const ChildReader& reader = usual_child_reader());

/// Refuses a file whose header promises more than the file can hold, before anyone allocates that much.
void check_header(const std::string& name, std::string_view bytes, const std::string& extension);

/// What the helper makes of a file: a soup whose materials have no textures yet, and where these are.
struct ParsedModel {
  struct Picture {
    std::string name;   ///< as the model has it, a file beside it when there are no bytes
    std::string bytes;  ///< of a picture inside the model
  };
  PolygonSoup soup;
  std::vector<Picture> pictures;
  std::vector<int> picture_of;  ///< per material: index into pictures or -1
};

/// A parsed model as bytes and back, for the pipe between the two processes.
std::string pack(const ParsedModel& model);
ParsedModel unpack(const std::string& name, std::string_view packed);

/// The helper's own part: parses with Assimp. Throws Error(Read) with what Assimp said.
ParsedModel parse_with_assimp(std::string_view bytes, const std::string& extension);

}  // namespace netwright::readers
