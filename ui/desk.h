// The desk that sheets lie on side by side, in mm: where each of them begins, and which one a place belongs
// to.
#pragma once

#include "core/sheet/pages.h"

namespace netwright {

/// Where canvas `index` begins from the left; its top is at 0. One beyond the last is where a new one would.
double canvas_left(const PageLayout& layout, int index);

/// The canvas whose sheet lies at or nearest to this place; one beyond the last to the right of them all.
int canvas_at(const PageLayout& layout, double x_mm);

/// Sheet and room for the net, in the units of the net's view (y up), for any of these canvases.
Box2 sheet_on_desk(const PageLayout& layout, int index);
Box2 room_on_desk(const PageLayout& layout, int index);

}  // namespace netwright
