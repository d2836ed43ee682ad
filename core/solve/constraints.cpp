// Setting and asking for pins. What contradicts what is worked out in contradiction.cpp.
#include "core/solve/constraints.h"

#include <algorithm>

#include "core/solve/disjoint_sets.h"

namespace netwright {

namespace {

bool holds(const std::vector<EdgeId>& edges, EdgeId edge) {
  return std::binary_search(edges.begin(), edges.end(), edge);
}

void insert(std::vector<EdgeId>& edges, EdgeId edge) {
  edges.insert(std::lower_bound(edges.begin(), edges.end(), edge), edge);
}

}  // namespace

EdgePin pin_of(const Constraints& pins, EdgeId edge) {
  if (holds(pins.must_fold, edge)) return EdgePin::MustFold;
  return holds(pins.must_cut, edge) ? EdgePin::MustCut : EdgePin::None;
}

void set_pin(Constraints& pins, EdgeId edge, EdgePin pin) {
  std::erase(pins.must_fold, edge);
  std::erase(pins.must_cut, edge);
  if (pin == EdgePin::MustFold) insert(pins.must_fold, edge);
  if (pin == EdgePin::MustCut) insert(pins.must_cut, edge);
}

int patch_of(const Constraints& pins, FaceId face) {
  for (std::size_t k = 0; k < pins.together.size(); ++k)
    if (std::binary_search(pins.together[k].begin(), pins.together[k].end(), face))
      return static_cast<int>(k);
  return -1;
}

void let_go(Constraints& pins, const std::vector<FaceId>& faces) {
  for (auto& patch : pins.together)
    std::erase_if(patch, [&](FaceId f) { return std::find(faces.begin(), faces.end(), f) != faces.end(); });
  std::erase_if(pins.together, [](const auto& patch) { return patch.size() < 2; });
}

void keep_together(Constraints& pins, std::vector<FaceId> faces) {
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  let_go(pins, faces);
  if (faces.size() > 1) pins.together.push_back(std::move(faces));
}

bool keeps_pins(const Mesh& mesh, const UnfoldTree& tree, const Constraints& pins) {
  const auto is_fold = [&](EdgeId e) { return tree.is_fold(mesh, e); };
  if (!std::all_of(pins.must_fold.begin(), pins.must_fold.end(), is_fold)) return false;
  if (std::any_of(pins.must_cut.begin(), pins.must_cut.end(), is_fold)) return false;
  return std::all_of(pins.together.begin(), pins.together.end(), [&](const std::vector<FaceId>& patch) {
    DisjointSets sets(mesh.n_faces());
    std::size_t n_joined = 1;
    for (const FaceId f : patch) {
      const FaceId parent = tree.parent(mesh, f);
      if (std::binary_search(patch.begin(), patch.end(), parent) && sets.join(f.value, parent.value))
        ++n_joined;
    }
    return n_joined == patch.size();
  });
}

}  // namespace netwright
