// Feeds bytes to the reader of project files. What starts like a zip archive is read as one; anything else is
// cut into the parts of an archive, so that no check sum stands between the fuzzer and the checks behind it.
// A project that was read must be one that can be saved and read again.
#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string_view>

#include "core/base/error.h"
#include "core/project/project_file.h"

namespace {

using namespace netwright;

/// Four lengths, then so many bytes each; the rest is a picture.
ProjectParts cut(std::string_view bytes) {
  ProjectParts parts;
  for (std::string* part : {&parts.json, &parts.source, &parts.base, &parts.mesh}) {
    std::uint32_t length = 0;
    if (bytes.size() < sizeof length) break;
    std::memcpy(&length, bytes.data(), sizeof length);
    bytes.remove_prefix(sizeof length);
    *part = bytes.substr(0, length);
    bytes.remove_prefix(part->size());
  }
  if (!bytes.empty()) parts.pictures.emplace_back(bytes);
  return parts;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  StoredProject stored;
  try {
    stored = bytes.starts_with("PK") ? parse_project(bytes, "fuzz.netwright")
                                     : from_parts(cut(bytes), "fuzz.netwright");
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::Read || error.what()[0] == '\0') std::abort();
    return 0;
  }
  const std::string saved = project_bytes(stored.project, stored.belongs_to);
  const StoredProject again = parse_project(saved, "again.netwright");
  const bool has_tree = stored.project.tree != nullptr;
  if (has_tree != (again.project.tree != nullptr) || again.belongs_to != stored.belongs_to) std::abort();
  if (has_tree && *again.project.tree != *stored.project.tree) std::abort();
  return 0;
}
