// Schlickenrieder's steepest edge unfolding, as the paper uses it for a start.
#include "core/unfold/steepest_edge.h"

#include <cmath>
#include <deque>

namespace netwright {

namespace {

// Uniform on the sphere: height and longitude (Archimedes).
glm::dvec3 random_direction(Random& random) {
  const double z = 2 * random.unit() - 1;
  const double longitude = 6.283185307179586 * random.unit();
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(longitude), r * std::sin(longitude), z};
}

IdVector<EdgeId, char> steepest_cuts(const Mesh& mesh, const glm::dvec3& direction) {
  IdVector<VertexId, EdgeId> steepest(mesh.n_vertices());
  IdVector<VertexId, double> climb(mesh.n_vertices(), 0);
  const auto offer = [&](VertexId from, VertexId to, EdgeId e) {
    const glm::dvec3 d = mesh.position(to) - mesh.position(from);
    const double slope = glm::dot(d, direction) / glm::length(d);
    if (slope > climb[from]) {
      climb[from] = slope;
      steepest[from] = e;
    }
  };
  for (const EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e);
    offer(mesh.from(h), mesh.to(h), e);
    offer(mesh.to(h), mesh.from(h), e);
  }
  IdVector<EdgeId, char> is_cut(mesh.n_edges(), 0);
  for (const EdgeId e : steepest)
    if (e.is_valid()) is_cut[e] = 1;
  return is_cut;
}

}  // namespace

UnfoldTree steepest_edge_tree(const DualGraph& dual, Random& random) {
  const Mesh& mesh = dual.mesh();
  const IdVector<EdgeId, char> is_cut = steepest_cuts(mesh, random_direction(random));
  UnfoldTree tree(mesh.n_faces());
  IdVector<FaceId, char> seen(mesh.n_faces(), 0);
  const FaceId first(random.below(static_cast<int>(mesh.n_faces())));
  std::deque<FaceId> uncut;             // reached, neighbours across folds still to visit
  std::vector<HalfedgeId> across_cuts;  // cuts met on the way: the way on where the cuts enclose a region
  const auto reach = [&](FaceId f) {
    seen[f] = 1;
    uncut.push_back(f);
  };
  const auto walk_from = [&](FaceId root) {
    if (seen[root]) return;
    reach(root);
    while (true) {
      while (!uncut.empty()) {
        const FaceId f = uncut.front();
        uncut.pop_front();
        for (const HalfedgeId h : mesh.halfedges(f)) {
          const FaceId g = mesh.neighbour(h);
          if (!g.is_valid() || seen[g]) continue;
          if (is_cut[mesh.edge(h)]) {
            across_cuts.push_back(h);
          } else {
            tree.set_parent(g, mesh.twin(h));
            reach(g);
          }
        }
      }
      while (!across_cuts.empty() && seen[mesh.neighbour(across_cuts.back())]) across_cuts.pop_back();
      if (across_cuts.empty()) return;
      const HalfedgeId h = across_cuts.back();
      tree.set_parent(mesh.neighbour(h), mesh.twin(h));
      reach(mesh.neighbour(h));
    }
  };
  walk_from(first);
  for (const FaceId f : mesh.faces()) walk_from(f);
  return tree;
}

}  // namespace netwright
