// Feeds bytes to the reader of one model format and, where a soup comes out, to everything that a file passes
// on its way to a mesh. NETWRIGHT_FUZZ_NAME stands for the file's name and so chooses the reader.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/base/error.h"
#include "core/mesh/merge_faces.h"
#include "core/mesh/read.h"
#include "core/mesh/repair.h"
#include "core/mesh/split_faces.h"

namespace {

using namespace netwright;

void demand(bool holds) {
  if (!holds) std::abort();
}

/// What read.h promises of every soup.
void check_promises(const PolygonSoup& soup) {
  demand(soup.n_faces() > 0);
  demand(soup.face_begin.front() == 0 && soup.face_begin.back() == static_cast<int>(soup.corners.size()));
  for (const int corner : soup.corners) demand(corner >= 0 && corner < static_cast<int>(soup.points.size()));
  for (const glm::dvec3& p : soup.points)
    demand(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
  demand(soup.corner_uv.empty() || soup.corner_uv.size() == soup.corners.size());
  demand(soup.face_material.empty() || soup.face_material.size() == static_cast<std::size_t>(soup.n_faces()));
  for (const int material : soup.face_material)
    demand(material >= -1 && material < static_cast<int>(soup.materials.size()));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  PolygonSoup soup;
  try {
    soup = read_soup_bytes(NETWRIGHT_FUZZ_NAME, bytes);
  } catch (const Error& error) {
    demand(error.kind() == ErrorKind::Read && error.what()[0] != '\0');
    return 0;
  }
  check_promises(soup);
  const PreparedModel model = prepare(soup);
  if (!model.mesh) {
    demand(!model.refusal.empty());
    return 0;
  }
  const MergedFaces merged = merge_coplanar_faces(*model.mesh);
  const SplitFaces split = split_uneven_faces(*model.mesh);
  demand(merged.n_after() <= static_cast<int>(model.mesh->n_faces()));
  demand(split.soup.n_faces() >= static_cast<int>(model.mesh->n_faces()));
  return 0;
}
