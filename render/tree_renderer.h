// Draws the unfold tree over the model and over the net: from face centre to face centre through the middle
// of the shared edge, the root marked, and what the last move did as in the paper's figures 3 and 4.
#pragma once

#include <cstdint>
#include <span>

#include "core/unfold/net.h"
#include "render/camera.h"
#include "render/line_renderer.h"

namespace netwright {

struct TreeLook {
  bool shows_tree = true;
  bool shows_roots = true;
  bool shows_search = true;      ///< climbed path and candidates, when there are any
  float scale = 1;               ///< pixels per design pixel
  bool is_seen_through = false;  ///< the model is: what it hides is drawn faintly
};

class TreeRenderer {
 public:
  explicit TreeRenderer(const LineRenderer& lines);
  /// Takes the net's tree over; does nothing when `version` (not 0) is what it holds already. Without its
  /// folds only roots and what the last move did are drawn, until it is given again with them.
  /// `climbed`: faces on the path climbed by the last move, in order; `candidates`: cuts it could have
  /// joined.
  void set_tree(const Net& net, std::span<const FaceId> climbed, std::span<const EdgeId> candidates,
                std::uint64_t version, bool has_folds = true);
  void clear();
  /// Over the model drawn before with the same camera: hidden where the surface hides it.
  void draw_on_model(const OrbitCamera& camera, const Palette& palette, const TreeLook& look) const;
  void draw_on_net(const PanZoomCamera& camera, const Palette& palette, const TreeLook& look) const;

 private:
  void upload_folds(const Net& net, std::uint64_t version);
  void upload_marks(const Net& net, std::span<const FaceId> climbed, std::span<const EdgeId> candidates,
                    std::uint64_t version);

  const LineRenderer& lines_;
  LineBatch folds_in_space_;
  LineBatch folds_in_plane_;
  LineBatch in_space_;
  LineBatch in_plane_;
  LineBatch roots_in_space_;  ///< apart, because discs stand out farther than lines
  LineBatch roots_in_plane_;
  double mean_edge_ = 0;
};

/// A point well inside a face, in space and in the plane: where the tree's lines meet. The corners' mean, or
/// for a concave face that of its largest convex part.
glm::dvec3 face_anchor(const DualGraph& dual, FaceId face);
glm::dvec2 face_anchor(const Net& net, FaceId face);

}  // namespace netwright
