// What stands in free spots beside the net on the first page: the user's own picture and words, and a square
// to check the scale by. Used by draw_sheets only.
#pragma once

#include <vector>

#include "core/sheet/draw.h"
#include "core/sheet/outline.h"

namespace netwright {

/// The room a page leaves beside the net.
class FreeSpots {
 public:
  FreeSpots(const NetLines& lines, const PageView& view);

  /// A box of this size that keeps clear of the net and of what was placed before, in a corner or along a
  /// side if it can be; it is taken then. Nothing when there is none.
  std::optional<Box2> take(glm::dvec2 size);

 private:
  [[nodiscard]] bool is_free(const Box2& box) const;

  Box2 frame_;
  std::vector<Segment> outline_;
  std::vector<Box2> taken_;
};

/// A 50 mm square, if the page has room for it.
void draw_test_square(Sheet& sheet, FreeSpots& spots);

/// The user's picture (as large as there is room, 40 mm at most) and note. False when the note has no room; a
/// picture without room is left out.
bool draw_own_words(Sheet& sheet, FreeSpots& spots, const SheetWords& words, const Font& font);

}  // namespace netwright
