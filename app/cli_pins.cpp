// Looks faces up by the file's numbers. After simplifying, merging or splitting a number means the face that
// came of the file's face, the first one where there are several.
#include "app/cli_pins.h"

#include <algorithm>
#include <string>

#include "core/base/error.h"

namespace netwright {

namespace {

FaceId face_of(const Mesh& mesh, int number, const std::string& purpose) {
  for (const FaceId f : mesh.faces())
    if (mesh.face_source(f) == number - 1) return f;
  const auto last = std::max_element(mesh.faces().begin(), mesh.faces().end(), [&](FaceId a, FaceId b) {
    return mesh.face_source(a) < mesh.face_source(b);
  });
  throw Error(ErrorKind::Usage, "There is no face " + std::to_string(number) + " " + purpose + ": " +
                                    mesh.name() + " has the faces 1 to " +
                                    std::to_string(mesh.face_source(*last) + 1) + ".");
}

}  // namespace

EdgeId edge_between(const Mesh& mesh, std::pair<int, int> faces, const std::string& purpose) {
  const FaceId one = face_of(mesh, faces.first, purpose);
  const FaceId other = face_of(mesh, faces.second, purpose);
  for (const HalfedgeId h : mesh.halfedges(one))
    if (mesh.neighbour(h) == other) return mesh.edge(h);
  throw Error(ErrorKind::Usage, "Faces " + std::to_string(faces.first) + " and " +
                                    std::to_string(faces.second) + " of " + mesh.name() +
                                    " share no edge, so there is nothing " + purpose + ".");
}

Constraints pins_of(const UnfoldCommand& command, const Mesh& mesh) {
  Constraints pins;
  if (command.root > 0) pins.root = face_of(mesh, command.root, "to start from");
  for (const auto& faces : command.must_fold)
    set_pin(pins, edge_between(mesh, faces, "to fold"), EdgePin::MustFold);
  for (const auto& faces : command.must_cut) {
    const EdgeId edge = edge_between(mesh, faces, "to cut");
    if (pin_of(pins, edge) == EdgePin::MustFold)
      throw Error(ErrorKind::Usage, "The edge between faces " + std::to_string(faces.first) + " and " +
                                        std::to_string(faces.second) +
                                        " cannot be both folded and cut; leave one of the two pins out.");
    set_pin(pins, edge, EdgePin::MustCut);
  }
  for (const auto& numbers : command.together) {
    std::vector<FaceId> patch;
    for (const int number : numbers) patch.push_back(face_of(mesh, number, "to keep together"));
    keep_together(pins, std::move(patch));
  }
  return pins;
}

}  // namespace netwright
