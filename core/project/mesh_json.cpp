// Edges to and from JSON. Which of its two faces an edge begins with is ours to change, so whoever cares
// about the side reads sides and not edges.
#include "core/project/mesh_json.h"

#include <algorithm>
#include <limits>

namespace netwright {

Json edges_json(const std::vector<EdgeId>& edges, const Mesh& mesh) {
  Json json{Json::Array{}};
  for (const EdgeId e : edges) {
    const HalfedgeId h = mesh.halfedge(e);
    json.add(mesh.face(h).value);
    json.add(h.value - mesh.first(mesh.face(h)).value);
  }
  return json;
}

std::vector<HalfedgeId> read_sides(JsonFields& fields, std::string_view key, const Mesh& mesh) {
  const std::vector<int> numbers = fields.integers(key, 0, std::numeric_limits<int>::max());
  std::vector<HalfedgeId> sides;
  for (std::size_t i = 0; i < numbers.size(); i += 2) {
    const FaceId f(numbers[i]);
    const bool is_there =
        i + 1 < numbers.size() && f.index() < mesh.n_faces() && numbers[i + 1] < mesh.degree(f);
    if (!is_there) fields.refuse(key, "names an edge that is not there");
    sides.emplace_back(mesh.first(f).value + numbers[i + 1]);
  }
  return sides;
}

std::vector<EdgeId> read_edges(JsonFields& fields, std::string_view key, const Mesh& mesh) {
  std::vector<EdgeId> edges;
  for (const HalfedgeId side : read_sides(fields, key, mesh)) edges.push_back(mesh.edge(side));
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

}  // namespace netwright
