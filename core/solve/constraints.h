// What the user pinned: the face the net starts at, edges that must be folds or cuts, and patches of faces
// that stay together. Every net the search finds keeps them; pins that contradict each other are found before
// it starts.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/mesh/dual_graph.h"
#include "core/unfold/unfold_tree.h"

namespace netwright {

struct Constraints {
  FaceId root;                                ///< layout and tree start here; may be invalid
  std::vector<EdgeId> must_fold;              ///< ascending, each once; none of them on a border
  std::vector<EdgeId> must_cut;               ///< ascending, each once
  std::vector<std::vector<FaceId>> together;  ///< patches: joined by folds among themselves; ascending,
                                              ///< no face in two of them, at least two faces each

  /// Nothing pinned but perhaps the root, which rules no net out.
  [[nodiscard]] bool are_free() const { return must_fold.empty() && must_cut.empty() && together.empty(); }
  bool operator==(const Constraints&) const = default;
};

/// How an edge may be pinned.
enum class EdgePin { None, MustFold, MustCut };

[[nodiscard]] EdgePin pin_of(const Constraints& pins, EdgeId edge);
/// Takes the place of what the edge was pinned to before.
void set_pin(Constraints& pins, EdgeId edge, EdgePin pin);
/// Index of the patch a face belongs to, -1 for none.
[[nodiscard]] int patch_of(const Constraints& pins, FaceId face);
/// Makes these faces one patch; what they were patched with before is let go of, and a patch that is left
/// with a single face goes.
void keep_together(Constraints& pins, std::vector<FaceId> faces);
/// Takes these faces out of their patches.
void let_go(Constraints& pins, const std::vector<FaceId>& faces);

/// Why no net can keep all pins, and which pins are to blame.
struct Contradiction {
  std::string sentence;       ///< what contradicts what, and what to release
  std::vector<EdgeId> edges;  ///< pinned edges to blame
  std::vector<FaceId> faces;  ///< and faces that show the trouble
};

/// Loops of must-folds, must-cuts that separate faces, patches that do not hang together, must-folds that
/// cannot lie flat side by side. Nothing found does not promise a net, only that a tree keeps all pins and
/// that what is pinned lies flat by itself. O(faces), below a few milliseconds at 12 000.
[[nodiscard]] std::optional<Contradiction> find_contradiction(const DualGraph& dual, const Constraints& pins);

/// Does this tree keep every pin (the root apart, which a tree has to be turned to, see
/// UnfoldTree::reroot)?
[[nodiscard]] bool keeps_pins(const Mesh& mesh, const UnfoldTree& tree, const Constraints& pins);

}  // namespace netwright
