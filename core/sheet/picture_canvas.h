// Pixels to paint triangles on, which then grow outwards over what lies around them. Coordinates are pixels,
// y down; pixel (0, 0) reaches from 0 to 1. Used by the pictures on the sheets.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "core/sheet/face_paint.h"

namespace netwright {

class PictureCanvas {
 public:
  PictureCanvas(int width, int height);

  /// Covers every pixel whose middle lies in the triangle or on its sides. `uv` belongs to the corners.
  void paint_triangle(const std::array<glm::dvec2, 3>& at, const std::array<glm::dvec2, 3>& uv,
                      const FacePaint::Coat& coat);
  /// Lets what is painted grow over this convex polygon, however far that is.
  void open(const std::vector<glm::dvec2>& polygon);
  /// Gives the pixels up to `distance` from painted ones, and those opened, the colour of the nearest
  /// painted one. Opened ones further off are faded on request.
  void grow(double distance, bool fades);

  /// The finished picture, transparent where nothing is.
  [[nodiscard]] Image image(bool is_grey) &&;

 private:
  /// The pixels of a row, from the first to the one after the last, whose middles lie in a convex polygon.
  [[nodiscard]] std::pair<int, int> span(const glm::dvec2* polygon, std::size_t n, int row) const;
  void spread(std::vector<std::uint32_t>& front, int most);
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width) + static_cast<std::size_t>(x);
  }

  Image image_;
  std::vector<std::uint8_t> is_open_;
  /// Per pixel, how far right and down its nearest painted one is; kNowhere where none is known.
  std::vector<std::array<std::int16_t, 2>> nearest_;
};

/// Left becomes right.
void mirror(Image& image);

/// The same in shades of grey.
Image greyed(Image image);

}  // namespace netwright
