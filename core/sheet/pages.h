// Where the pieces lie on paper: the scale, the turn and place of each piece, and the pages that show them. A
// piece larger than the paper is tiled. All in millimetres, y down, as on the printed page.
#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/sheet/outline.h"
#include "core/sheet/page_frame.h"
#include "core/sheet/print_size.h"
#include "core/unfold/glue_tabs.h"
#include "core/unfold/net.h"

namespace netwright {

struct PageLayout {
  /// A flat area that pieces lie on, large enough for columns x rows of overlapping tiles (1 x 1: it is one
  /// page).
  struct Canvas {
    double width_mm = 0;
    double height_mm = 0;
    int columns = 1;
    int rows = 1;
    int first_row_letter = 0;  ///< rows are lettered on over the canvases: 0 = A
    /// The lines along which neighbouring sheets are joined; both show what lies within half of overlap_mm.
    std::vector<Segment> seams = {};
    int n_cut_marks = 0;  ///< how often they run through a fold, a tab or a number
    [[nodiscard]] bool is_tiled() const { return columns * rows > 1; }
  };
  /// One printed page: it shows the canvas from `origin` on, in frame.net.
  struct Page {
    int canvas = 0;
    int column = 0;  ///< counted in its row; columns need not lie below each other
    int row = 0;
    glm::dvec2 origin{0, 0};  ///< canvas point at the top left corner of frame.net
    std::string tag;          ///< "A1", "B3" …: row and column; empty on a canvas of one page
    /// Of a tile: what only it answers for, bounded by its seams and by where there is no paper.
    Box2 share = {};
    /// What of the canvas is drawn: a tile ends half of overlap_mm beyond its share; empty for all of
    /// frame.net.
    Box2 shown = {};
  };
  struct Placement {
    int canvas = 0;
    Rigid2 turn;  ///< after scaling, before y is turned down
  };

  double scale = 1;            ///< mm per model unit
  double model_height_mm = 0;  ///< what the finished model measures along its up axis
  PageFrame frame;             ///< of every page
  double overlap_mm = 10;      ///< of neighbouring tiles, at least
  std::vector<Placement> pieces;
  std::vector<Canvas> canvases;
  std::vector<Page> pages;  ///< in print order; tiles that no face touches are left out
  GlueTabs tabs;            ///< of the net at this scale; on_canvas_mm() says where their points lie

  /// Where a point of the net (model units, y up) lies on the piece's canvas.
  [[nodiscard]] glm::dvec2 on_canvas(int piece, glm::dvec2 point) const {
    return on_canvas_mm(piece, point * scale);
  }
  /// The same for a point in mm, as those of glue tabs are.
  [[nodiscard]] glm::dvec2 on_canvas_mm(int piece, glm::dvec2 point_mm) const {
    const glm::dvec2 turned = pieces[static_cast<std::size_t>(piece)].turn(point_mm);
    return {turned.x, -turned.y};
  }
  /// From canvas to page.
  [[nodiscard]] glm::dvec2 on_page(const Page& page, glm::dvec2 on_canvas) const {
    return on_canvas - page.origin + frame.net.min;
  }
};

/// FitPage: everything on one page, turned to the angle that prints largest. FitSheets: as large as a search
/// finds that takes no more than so many pages. Else true to the size that was given: several pages where one
/// is too small, pieces larger than a page tiled. Pieces keep 3 mm of distance and one scale. Throws
/// Error(Usage): unknown paper, margins that leave no room, what scale_of() refuses, over 1000 pages.
PageLayout arrange(const Net& net, const PaperSetup& paper, const PrintSize& size,
                   const TabSettings& tabs = no_tabs());

/// The same net with its pieces side by side instead of on top of each other; one piece is left as it is.
Net spread_pieces(Net net);

}  // namespace netwright
