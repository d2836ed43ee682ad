// What can be said about a net on paper before it is printed: how compact it is, how much has to be cut, and
// how large it gets on a page.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "core/base/image.h"
#include "core/sheet/pages.h"
#include "core/unfold/net.h"

namespace netwright {

struct NetMeasures {
  int n_pieces = 0;
  double fill = 0;        ///< paper of all pieces over their smallest rectangles, 0…1: more is more compact
  double cut_length = 0;  ///< of all edges that the net cuts, counted once, model units
  double model_height = 0;
  std::vector<std::vector<glm::dvec2>> hulls;  ///< convex hull of every piece, model units
};

NetMeasures measure(const Net& net);

/// What a net of one piece measures on paper, in mm, wider than high: its smallest rectangle at the scale it
/// is printed at. Nothing where only the pages themselves tell (several pieces fitted to one page, a net
/// fitted to several, a size by an edge, a paper without room, a flat model).
std::optional<glm::dvec2> size_on_paper(const NetMeasures& measures, const PaperSetup& paper,
                                        const PrintSize& size);

/// The net as a small picture: white, as opaque as it covers a pixel, turned to lie in its smallest
/// rectangle. Several pieces stand side by side.
Image net_picture(const Net& net, int width_px, int height_px);

}  // namespace netwright
