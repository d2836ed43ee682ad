// The pictures on the sheets: each piece's texture or colours as one image per page, going on a little past
// the outline and over the glue tabs. Used by draw_sheets only.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/sheet/draw.h"
#include "core/sheet/face_paint.h"

namespace netwright {

/// Paints the pieces of one layout; has its own copy of all it needs.
class PictureArtist : public std::enable_shared_from_this<PictureArtist> {
 public:
  PictureArtist(const Net& net, const PageLayout& layout, const SheetSettings& settings);

  /// One picture for each piece that this page shows something of, which can also be made anew later. None
  /// when pictures are off or the model is plain white.
  void draw(Sheet& sheet, const PageView& view) const;

 private:
  /// A window of a piece's canvas in whole pixels.
  struct Window {
    int piece = 0;
    glm::dvec2 corner{0, 0};  ///< mm
    int width = 0;
    int height = 0;
    bool is_mirrored = false;
  };
  /// What the picture of a piece takes up within this part of its canvas.
  [[nodiscard]] Box2 reach(int piece, const Box2& part) const;
  [[nodiscard]] std::shared_ptr<const Image> paint(const Window& window) const;

  Net net_;
  PageLayout layout_;
  PictureSettings settings_;
  bool is_grey_ = false;
  FacePaint paint_;
  bool has_pictures_ = false;
  double pixels_per_mm_ = 1;
  std::vector<std::vector<FaceId>> faces_;                       ///< of each piece
  std::vector<std::vector<const GlueTab*>> tabs_;                ///< of each piece
  IdVector<FaceId, std::vector<std::array<int, 3>>> triangles_;  ///< corners of each face
};

}  // namespace netwright
