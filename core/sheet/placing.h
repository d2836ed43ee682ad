// Pieces that lie where the user put them: turning such a choice into pages, keeping it while the net is
// edited, and telling what lies badly.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/sheet/pages.h"

namespace netwright {

/// Where the user put the pieces. Each place belongs to a face, so that it outlives other roots and edits of
/// the rest. Empty: the pieces are arranged by themselves.
struct HandLayout {
  /// One sheet, or a grid of tiles for a piece larger than the paper.
  struct Canvas {
    int columns = 1;
    int rows = 1;
    bool operator==(const Canvas&) const = default;
  };
  struct Place {
    FaceId face;
    int canvas = 0;
    Rigid2 turn;  ///< from the face's own frame, in mm, to its canvas with y up
    bool operator==(const Place&) const = default;
  };
  bool is_landscape = false;
  double scale = 1;  ///< mm per model unit
  std::vector<Canvas> canvases;
  std::vector<Place> places;  ///< one for each piece, in any order

  [[nodiscard]] bool is_automatic() const { return places.empty(); }
  bool operator==(const HandLayout&) const = default;
};

inline constexpr int kMostTilesAlong = 200;  ///< columns or rows of a canvas

/// The layout as it is, as if by hand.
HandLayout as_placed(const Net& net, const PageLayout& layout);

/// Pages of this paper with the pieces where they were put. A canvas without pieces gives no page. Nothing
/// when that cannot be: the paper has no such pages, or the places are not those of the net's pieces. Throws
/// Error(Usage) as arrange() does: unknown paper, margins that leave no room.
std::optional<PageLayout> lay_out(const Net& net, const PaperSetup& paper, const HandLayout& placed,
                                  const TabSettings& tabs = no_tabs());
/// With tabs that were placed for this net at this scale: where the pieces lie does not change them.
std::optional<PageLayout> lay_out(const Net& net, const PaperSetup& paper, const HandLayout& placed,
                                  GlueTabs tabs);

/// The same places for a net that was edited: what was not `moved` stays where it lies, and what came off
/// stays there, too. `before` and `after` are nets of one model. Automatic when `placed` does not fit
/// `before`.
HandLayout carry_places(const HandLayout& placed, const Net& before, const Net& after,
                        const std::vector<FaceId>& moved);

/// What cannot be printed as it lies.
struct Misplaced {
  std::vector<int> over_edge;                    ///< pieces that reach over the edge of their canvas
  std::vector<std::pair<int, int>> overlapping;  ///< pieces that cover each other, first < second
  std::vector<FaceId> faces;                     ///< that do so, sorted
  [[nodiscard]] bool is_nothing() const { return over_edge.empty() && overlapping.empty(); }
};
Misplaced find_misplaced(const Net& net, const PageLayout& layout);

/// One sentence with the cure; empty when nothing is misplaced.
std::string misplaced_sentence(const Misplaced& misplaced);

}  // namespace netwright
