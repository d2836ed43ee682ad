// Packs rectangles onto pages.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

namespace netwright {

struct Packed {
  int page = 0;
  glm::dvec2 at{0, 0};     ///< corner nearest to the page's origin
  bool is_turned = false;  ///< by a quarter turn: it covers (y, x) instead of (x, y)
};

/// Places every rectangle, `gap` apart, on as few pages as a good first fit finds. Each must fit a page by
/// itself, one way or the other. One entry per rectangle, in their order.
std::vector<Packed> pack(const std::vector<glm::dvec2>& sizes, glm::dvec2 page, double gap);

}  // namespace netwright
