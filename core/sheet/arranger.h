// Lays the pieces of a net out on pages of one orientation, at one size.
#pragma once

#include <optional>

#include "core/sheet/pages.h"
#include "core/sheet/piece_shapes.h"
#include "core/sheet/tiles.h"

namespace netwright {

inline constexpr std::size_t kMostPages = 1000;

/// How much of the room a box takes: over 1 it does not fit.
double fill_factor(glm::dvec2 size, glm::dvec2 room);

/// The canvas after the last one, with room for so many columns and rows, and a page for every tile.
void add_tiled_canvas(PageLayout& layout, const Tiling& tiling, int columns, int rows, int first_row_letter);

/// How tiled pieces are cut: Quick tells how many sheets it may take, Best never takes more.
enum class Seams { Quick, Best };

/// Everything but the layout's tabs. Nothing when more than kMostPages would be needed.
std::optional<PageLayout> arrange_on(const PieceShapes& shapes, const PageFrame& frame, Seams seams);

}  // namespace netwright
