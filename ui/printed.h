// The finished sheets on the desk of the net's view, exactly under the net that lies there; and glue tabs for
// the view's own faster drawing.
#pragma once

#include <vector>

#include "core/sheet/pages.h"
#include "render/palette.h"
#include "render/sheet_renderer.h"

namespace netwright {

/// Each sheet where its page lies. Backs lie below their fronts; of a canvas of tiles every tile shows its
/// own part, and its backs are left out. Sheets that show nothing of the net stand at the right.
std::vector<PlacedSheet> place_sheets(const std::vector<Sheet>& sheets, const PageLayout& layout,
                                      PrintedSide printed_side);

/// The sheets of tiled canvases whole, as the printer gives them: with titles and rulers, each where its tile
/// is but apart from the others, mirrored ones in mirrored order, backs below all fronts. They lie below
/// whatever else is on the desk; none where nothing is tiled.
std::vector<PlacedSheet> spread_tiles(const std::vector<Sheet>& sheets, const PageLayout& layout,
                                      PrintedSide printed_side, const std::vector<PlacedSheet>& above);

/// A page that goes with these sheets stands before or behind them.
PlacedSheet place_beside(const Sheet& page, bool is_before, const std::vector<PlacedSheet>& sheets,
                         const PageLayout& layout);

/// Where a placed sheet lies in the net's view.
Box2 box_of(const PlacedSheet& placed, double scale);

/// The tabs of the net `shown` as a drawing in mm, y down, where the faces lie in `net`.
Sheet draw_tabs(const GlueTabs& tabs, const Net& shown, const Net& net, double scale, const Palette& palette);

/// The outline of a tab where its face lies in `net`, in the net's own units.
std::vector<glm::dvec2> tab_outline(const GlueTab& tab, const Net& shown, const Net& net, double scale);

}  // namespace netwright
