// Trees are grown face by face from the first one. A hinge to a face not laid down yet is either used, where
// the face overlaps nothing, or given up for good; so every tree is met once.
#include "core/solve/crowded_patch.h"

#include <algorithm>

#include "core/base/predicates.h"
#include "core/unfold/overlap.h"

namespace netwright {

namespace {

class Layer {
 public:
  Layer(const DualGraph& dual, const std::vector<FaceId>& faces, const IdVector<EdgeId, char>& may_fold,
        const IdVector<EdgeId, char>& must_fold, int max_steps)
      : dual_(dual),
        mesh_(dual.mesh()),
        faces_(faces),
        may_fold_(may_fold),
        must_fold_(must_fold),
        steps_left_(max_steps),
        depth_(2 * kProofDepth * mesh_.mean_edge()) {}

  std::optional<bool> run() {
    laid_.push_back({faces_.front(), Rigid2()});
    const bool is_found = grow();
    if (is_found) return false;
    return steps_left_ > 0 ? std::optional<bool>(true) : std::nullopt;
  }

 private:
  struct Laid {
    FaceId face;
    Rigid2 placement;
  };

  // Can the rest be laid down without overlaps?
  bool grow() {
    if (laid_.size() == faces_.size()) return true;
    const HalfedgeId h = next_hinge();
    if (!h.is_valid()) return false;
    const FaceId f = mesh_.neighbour(h);
    const Rigid2 placement = placement_of(mesh_.face(h)) * dual_.unroll(h);
    if (--steps_left_ <= 0) return false;
    const bool is_clear = std::none_of(laid_.begin(), laid_.end(), [&](const Laid& other) {
      return faces_overlap(dual_, f, placement, other.face, other.placement, depth_);
    });
    if (is_clear) {
      laid_.push_back({f, placement});
      if (grow()) return true;
      laid_.pop_back();
    }
    if (must_fold_[mesh_.edge(h)] != 0) return false;
    given_up_.push_back(mesh_.edge(h));
    const bool is_found = grow();
    given_up_.pop_back();
    return is_found;
  }

  // From a face laid down to one that isn't; must-folds first, since they leave no choice.
  [[nodiscard]] HalfedgeId next_hinge() const {
    HalfedgeId found;
    for (const Laid& laid : laid_)
      for (const HalfedgeId h : mesh_.halfedges(laid.face)) {
        const EdgeId e = mesh_.edge(h);
        const FaceId beyond = mesh_.neighbour(h);
        if (!beyond.is_valid() || !is_member(beyond) || is_laid(beyond)) continue;
        if (must_fold_[e] != 0) return h;
        const bool is_open =
            may_fold_[e] != 0 && std::find(given_up_.begin(), given_up_.end(), e) == given_up_.end();
        if (!found.is_valid() && is_open) found = h;
      }
    return found;
  }

  [[nodiscard]] bool is_member(FaceId f) const {
    return std::find(faces_.begin(), faces_.end(), f) != faces_.end();
  }
  [[nodiscard]] bool is_laid(FaceId f) const {
    return std::any_of(laid_.begin(), laid_.end(), [&](const Laid& laid) { return laid.face == f; });
  }
  [[nodiscard]] const Rigid2& placement_of(FaceId f) const {
    return std::find_if(laid_.begin(), laid_.end(), [&](const Laid& laid) { return laid.face == f; })
        ->placement;
  }

  const DualGraph& dual_;
  const Mesh& mesh_;
  const std::vector<FaceId>& faces_;
  const IdVector<EdgeId, char>& may_fold_;
  const IdVector<EdgeId, char>& must_fold_;
  int steps_left_;
  double depth_;
  std::vector<Laid> laid_;
  std::vector<EdgeId> given_up_;
};

}  // namespace

std::optional<bool> is_crowded(const DualGraph& dual, const std::vector<FaceId>& faces,
                               const IdVector<EdgeId, char>& may_fold,
                               const IdVector<EdgeId, char>& must_fold, int max_steps) {
  return Layer(dual, faces, may_fold, must_fold, max_steps).run();
}

}  // namespace netwright
