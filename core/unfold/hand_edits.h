// Editing an unfold tree by hand: joining the two sides of a cut, cutting a fold, hanging a branch elsewhere.
// Every function leaves the tree it was given alone and says what would change, so that it can be shown
// before it is done.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/unfold/unfold_tree.h"

namespace netwright {

struct HandEdit {
  UnfoldTree tree;             ///< the result
  std::vector<EdgeId> joined;  ///< cuts that become folds
  std::vector<EdgeId> cut;     ///< folds that become cuts
  std::vector<FaceId> moved;   ///< faces that lie elsewhere against the rest
};

/// May this fold be cut to make way? (Pins say no.)
using MayCut = std::function<bool(EdgeId)>;

/// The face at this side of a cut swings over to the face beyond, with all that hangs on it. Where both
/// belong to one piece, the fold by which it hangs is cut: the first one towards the other side that may be.
/// Nothing at a border, at a fold, and where no fold may be cut. `fixed` (may be invalid) stays where it is,
/// so the other piece moves if its own would.
std::optional<HandEdit> join_at(const Mesh& mesh, const UnfoldTree& tree, HalfedgeId side,
                                const MayCut& may_cut, FaceId fixed);

/// The fold becomes a cut; what hangs below it is a piece of its own.
std::optional<HandEdit> cut_at(const Mesh& mesh, const UnfoldTree& tree, EdgeId edge);

/// The branch that begins at a face (it and all below it) hangs by this side, one of its own, from now on.
std::optional<HandEdit> hang_at(const Mesh& mesh, const UnfoldTree& tree, FaceId branch, HalfedgeId side);
/// The sides by which that branch could hang: its cuts to faces outside of it.
std::vector<HalfedgeId> places_for(const Mesh& mesh, const UnfoldTree& tree, FaceId branch);

/// All faces of the branch that begins at this one, itself first.
std::vector<FaceId> branch_of(const Mesh& mesh, const UnfoldTree& tree, FaceId top);

/// The strip of four-cornered faces across this edge: from every face on to the edge opposite, both ways, as
/// far as it goes; two triangles that lie in one plane (bend under kFlatFold, asked through `is_flat`) count
/// as one face with four corners. The edge itself comes first.
std::vector<EdgeId> strip_across(const Mesh& mesh, EdgeId edge, const std::function<bool(EdgeId)>& is_flat);

}  // namespace netwright
