// Pins that do not contradict each other, drawn at random: what tests and the bench of pins have in common.
#pragma once

#include <algorithm>
#include <vector>

#include "core/base/random.h"
#include "core/solve/constraints.h"
#include "core/solve/disjoint_sets.h"

namespace netwright::testing {

/// Folds of a spanning forest of the dual graph, hinges taken in random order (Kruskal).
inline IdVector<EdgeId, char> random_forest(const Mesh& mesh, Random& random) {
  std::vector<EdgeId> hinges;
  for (const EdgeId e : mesh.edges())
    if (!mesh.is_border(e)) hinges.push_back(e);
  for (std::size_t i = hinges.size(); i > 1; --i)
    std::swap(hinges[i - 1], hinges[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
  DisjointSets sets(mesh.n_faces());
  IdVector<EdgeId, char> is_fold(mesh.n_edges(), 0);
  for (const EdgeId e : hinges) {
    const HalfedgeId h = mesh.halfedge(e);
    if (sets.join(mesh.face(h).value, mesh.neighbour(h).value)) is_fold[e] = 1;
  }
  return is_fold;
}

/// A walk over folds of the forest from a random face: up to `size` faces that hang together in it.
inline std::vector<FaceId> random_patch(const Mesh& mesh, const IdVector<EdgeId, char>& is_fold, int size,
                                        Random& random) {
  std::vector<FaceId> patch{FaceId(random.below(static_cast<int>(mesh.n_faces())))};
  for (std::size_t i = 0; i < patch.size(); ++i)
    for (const HalfedgeId h : mesh.halfedges(patch[i])) {
      const bool grows = is_fold[mesh.edge(h)] != 0 && static_cast<int>(patch.size()) < size;
      if (grows && std::find(patch.begin(), patch.end(), mesh.neighbour(h)) == patch.end())
        patch.push_back(mesh.neighbour(h));
    }
  return patch;
}

/// A root and up to `n` pins of each other kind that one random tree keeps, so that they cannot contradict
/// each other but in how faces lie; those that do are drawn again.
inline Constraints random_pins(const DualGraph& dual, int n, Random& random) {
  const Mesh& mesh = dual.mesh();
  for (int attempt = 0; attempt < 100; ++attempt) {
    const IdVector<EdgeId, char> is_fold = random_forest(mesh, random);
    Constraints pins;
    pins.root = FaceId(random.below(static_cast<int>(mesh.n_faces())));
    for (int k = 0; k < 20 * n; ++k) {
      const EdgeId e(random.below(static_cast<int>(mesh.n_edges())));
      const bool is_one = is_fold[e] != 0;
      const std::size_t n_there = is_one ? pins.must_fold.size() : pins.must_cut.size();
      if (static_cast<int>(n_there) < n && !mesh.is_border(e))
        set_pin(pins, e, is_one ? EdgePin::MustFold : EdgePin::MustCut);
    }
    for (int k = 0; k < n; ++k) {
      std::vector<FaceId> patch = random_patch(mesh, is_fold, 4, random);
      if (std::none_of(patch.begin(), patch.end(), [&](FaceId f) { return patch_of(pins, f) >= 0; }))
        keep_together(pins, std::move(patch));
    }
    if (!find_contradiction(dual, pins)) return pins;
  }
  return {};
}

}  // namespace netwright::testing
