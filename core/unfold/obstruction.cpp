// Tries every hinge of every face by itself.
#include "core/unfold/obstruction.h"

#include "core/base/predicates.h"
#include "core/unfold/overlap.h"

namespace netwright {

namespace {

// Deeper than the proof would ever let pass, so that a doubtful contact is no obstruction.
bool overlaps_when_joined(const DualGraph& dual, HalfedgeId h) {
  const double depth = 2 * kProofDepth * dual.mesh().mean_edge();
  return faces_overlap(dual, dual.mesh().face(h), Rigid2(), dual.mesh().neighbour(h), dual.unroll(h), depth);
}

}  // namespace

FaceId find_isolated_face(const DualGraph& dual) {
  const Mesh& mesh = dual.mesh();
  for (const FaceId f : mesh.faces()) {
    // Two convex faces lie on different sides of the edge that joins them; only a concave one can be in the
    // way.
    bool has_hinge = false;
    bool is_blocked = true;
    for (const HalfedgeId h : mesh.halfedges(f)) {
      const FaceId g = mesh.neighbour(h);
      if (!g.is_valid()) continue;
      has_hinge = true;
      const bool may_overlap = dual.n_parts(f) > 1 || dual.n_parts(g) > 1;
      if (!may_overlap || !overlaps_when_joined(dual, h)) {
        is_blocked = false;
        break;
      }
    }
    if (has_hinge && is_blocked) return f;
  }
  return {};
}

ImpossibilityProof isolated_face_proof(const Mesh& mesh, FaceId face) {
  ImpossibilityProof proof;
  for (const HalfedgeId h : mesh.halfedges(face)) {
    if (!mesh.neighbour(h).is_valid()) continue;
    proof.nodes.push_back({ImpossibilityProof::Step::Hinge, mesh.edge(h).value, 0});
    proof.nodes.push_back({ImpossibilityProof::Step::Overlap, face.value, mesh.neighbour(h).value});
  }
  proof.nodes.push_back({ImpossibilityProof::Step::Topology, 0, 0});
  return proof;
}

std::string isolated_face_sentence(const Mesh& mesh, FaceId face) {
  return mesh.name() + " has no net in one piece: face " + std::to_string(mesh.face_source(face) + 1) +
         " overlaps every neighbour that could be joined to it; split that face or widen its notches in a "
         "modelling "
         "program.";
}

}  // namespace netwright
