// Draws the net: paper on a desk, cuts solid, mountains dash-dotted, valleys dashed, overlapping faces red.
// Faces are painted in the order of their numbers, so of overlapping faces the one with the higher number is
// on top.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/unfold/fold.h"
#include "core/unfold/net.h"
#include "render/camera.h"
#include "render/face_states.h"
#include "render/line_renderer.h"

namespace netwright {

/// A sheet of paper under the net, in the net's units: its border, and the part that can be printed on.
struct SheetOutline {
  Box2 border;
  Box2 printable;
};

struct NetLook {
  bool shows_folds = true;
  bool shows_cuts = true;
  bool draws_sheets = true;  ///< else draw_sheets() did
  bool is_printed = false;   ///< the sheets show all that: only what is said of faces, over them, like glass
  float scale = 1;           ///< pixels per design pixel
};

class NetRenderer {
 public:
  explicit NetRenderer(const LineRenderer& lines);
  /// Takes a net over; does nothing when `version` (not 0) is what it holds already. Without its folds they
  /// are not drawn until it is given again with them.
  void set_net(const Net& net, const IdVector<EdgeId, EdgeKind>& kinds, std::uint64_t version,
               bool has_folds = true);
  void clear();
  /// Sheets to draw under the net; none by default.
  void set_sheets(std::span<const SheetOutline> sheets);
  /// Sheets and what is on them besides faces and lines: for what is drawn between them and draw().
  void draw_sheets(const PanZoomCamera& camera, const Palette& palette, const NetLook& look) const;
  /// Draws over the desk into the framebuffer in use. `states`: one per face, or none.
  void draw(const PanZoomCamera& camera, const Palette& palette, const FaceStates& states,
            const NetLook& look);

 private:
  void upload_faces(const Net& net, std::uint64_t version);
  void upload_cuts(const Net& net, const IdVector<EdgeId, EdgeKind>& kinds, std::uint64_t version);
  void upload_folds(const Net& net, const IdVector<EdgeId, EdgeKind>& kinds, std::uint64_t version);
  void upload_outlines();
  void upload_states(const FaceStates& states);
  void draw_faces(const PanZoomCamera& camera, const Palette& palette, const NetLook& look) const;
  void draw_lines(const PanZoomCamera& camera, const Palette& palette, const NetLook& look) const;

  const LineRenderer& lines_;
  Shader shader_;
  Buffer face_buffer_;
  VertexArray face_array_;
  int n_face_vertices_ = 0;
  std::vector<Box2> sheets_;
  double mean_edge_ = 0;  ///< of the model, in world units
  Texture state_table_;
  FaceStates states_;
  std::vector<glm::vec2> corners_;  ///< of all faces, for outlines of selected ones
  std::vector<int> face_begin_;
  std::vector<LineSegment> segments_;  ///< uploaded last, kept for their room
  bool are_outlines_stale_ = true;
  LineBatch cuts_;
  LineBatch folds_;
  LineBatch outlines_;
  LineBatch sheet_lines_;
};

}  // namespace netwright
