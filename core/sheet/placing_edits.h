// What a hand does with pieces on the page: moving, turning, aligning. Nothing here changes a layout; each
// function says how the pieces would lie afterwards.
#pragma once

#include <vector>

#include "core/sheet/placing.h"

namespace netwright {

/// Where a piece goes: a motion of its present canvas (mm, y up), then the canvas it lies on from now on.
struct PieceMotion {
  int piece = 0;
  int canvas = 0;  ///< one beyond the last is a new sheet
  Rigid2 motion;
};

/// The layout with these pieces moved; sheets that nothing lies on any more are gone.
HandLayout move_pieces(const Net& net, const PageLayout& layout, const std::vector<PieceMotion>& motions);

/// The layout at another scale: every piece keeps its angle and the middle of its box. Automatic when pieces
/// would be misplaced then, or lie on tiles, whose number depends on the size.
HandLayout resize_pieces(const Net& net, const PaperSetup& paper, const PageLayout& layout, double scale,
                         const TabSettings& tabs = no_tabs());

enum class Align { Left, Right, Top, Bottom, CentreAcross, CentreUpright };

/// Several pieces are aligned with each other, each on its own sheet: the outermost one stays, or the common
/// middle. One piece alone is aligned with its sheet.
HandLayout align_pieces(const Net& net, const PageLayout& layout, const std::vector<int>& pieces,
                        Align where);

/// Box of a piece with its tabs on its canvas, in mm, y down.
Box2 box_on_canvas(const Net& net, const PageLayout& layout, int piece);

/// By how much these pieces are turned so that one of their longest outer edges comes to lie level or
/// upright: angles in radians, in [0, pi/2), sorted. More quarter turns do so, too.
std::vector<double> level_turns(const Net& net, const PageLayout& layout, const std::vector<int>& pieces);

/// The nearest of these turns (with any quarter turns) and of the multiples of 15 degrees.
double snapped_turn(double angle_rad, const std::vector<double>& level_turns);

}  // namespace netwright
