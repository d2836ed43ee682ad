// A proof that a model has no net in one piece, as data, and the checker of such proofs. The checker works on
// the mesh alone with arithmetic of its own: it shares nothing with the search that finds proofs, nor with
// the overlap detection.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/mesh/mesh.h"

namespace netwright {

/// A tree of cases. Every net of a component is a choice, for each hinge, of fold or cut; the cases cover all
/// choices, and each ends where something a net cannot have is forced: two faces, joined by folds, that
/// overlap deeper than kImpossibleDepth mean edges, folds that close a loop, or faces cut off from the rest.
struct ImpossibilityProof {
  /// Some faces, fewer than the component, and what a net can join inside them. Its *doors* are those of its
  /// faces that have a hinge to a face outside, in ascending order. The folds between faces of the region
  /// join its doors into groups: in every net these groups are one of `joins`, or finer. (Each entry has one
  /// group number per door.) The checker tries all forests of the region to see that. No entry: no net at
  /// all.
  struct Region {
    std::vector<FaceId> faces;            ///< ascending; no face is in two regions
    std::vector<std::vector<int>> joins;  ///< may be empty
    bool operator==(const Region&) const = default;
  };

  enum class Step : std::uint8_t {
    Hinge,     ///< first: edge `a` is a fold, then: it is a cut. Not between two faces of one region
    Region,    ///< one case for each entry in `joins` of region `a`, in order
    Overlap,   ///< ends a case: faces `a` and `b` are joined by folds and overlap
    Topology,  ///< ends a case: the folds close a loop, or cuts separate faces of one component
  };
  struct Node {
    Step step = Step::Topology;
    std::int32_t a = 0;
    std::int32_t b = 0;
    bool operator==(const Node&) const = default;
  };

  std::vector<Region> regions;
  std::vector<Node> nodes;  ///< preorder: each case with all that follows from it, then the next one
  bool operator==(const ImpossibilityProof&) const = default;
};

struct ImpossibilityVerdict {
  bool is_proved = false;
  std::string fault;  ///< what the proof fails to show, one sentence; empty when is_proved
};

/// Does the proof show that the mesh has no net of one piece per component? Faces are laid flat by projection
/// to their best plane, neighbours joined at the middle and along the direction of their common edge, as
/// everywhere; an overlap counts when it is deeper than kImpossibleDepth mean edges after all rounding.
ImpossibilityVerdict verify_impossible(const Mesh& mesh, const ImpossibilityProof& proof);

}  // namespace netwright
