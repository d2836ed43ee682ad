// The pictures on the sheets: each piece's texture or colours as one image per page, going on a little past
// the outline and over the glue tabs. Used by draw_sheets only.
#pragma once

#include <array>
#include <vector>

#include "core/sheet/draw.h"
#include "core/sheet/face_paint.h"

namespace netwright {

/// Paints the pieces of one layout.
class PictureArtist {
 public:
  PictureArtist(const Net& net, const PageLayout& layout, const SheetSettings& settings);

  /// False when pictures are off or the model is plain white: there is nothing to draw then.
  [[nodiscard]] bool has_pictures() const { return has_pictures_; }
  /// One picture for each piece that this page shows something of.
  void draw(Sheet& sheet, const PageView& view) const;

 private:
  [[nodiscard]] Box2 reach(int piece) const;
  [[nodiscard]] Image paint(int piece, glm::dvec2 corner, int width, int height) const;

  const Net& net_;
  const PageLayout& layout_;
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
