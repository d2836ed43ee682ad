// Packs pieces by their true outlines, so that one may lie in another one's bay.
#pragma once

#include <optional>
#include <vector>

#include "core/base/geometry.h"

namespace netwright {

/// Closed lines, in mm, y up; what winds around a point covers it.
using Outlines = std::vector<std::vector<glm::dvec2>>;

struct PackedOutline {
  int page = 0;
  Rigid2 turn;  ///< onto the page: 0 … page.x and 0 … page.y, y up
};

struct PieceToPack {
  Outlines outlines;
  double angle_rad = 0;  ///< at which it fits the page; others are tried, too
};

/// Every piece on one of at most `most_pages` pages, the first ones filled first, no two nearer than `gap`:
/// found on a raster of half a millimetre or coarser (a few hundred cells along the page), then checked
/// exactly. Nothing when this way of packing needs more pages. The same input gives the same places.
std::optional<std::vector<PackedOutline>> pack_outlines(const std::vector<PieceToPack>& pieces,
                                                        glm::dvec2 page, double gap, int most_pages);

/// The least distance between two sets of closed lines that do not cross; 0 where they do.
double distance_between(const Outlines& a, const Outlines& b);

}  // namespace netwright
