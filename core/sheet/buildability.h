// How well a net can be cut out, folded and glued at the size it is printed: its smallest edge, its sharpest
// corner, its thinnest neck, and what there is to do.
#pragma once

#include <string>
#include <vector>

#include "core/sheet/pages.h"
#include "core/unfold/net.h"

namespace netwright {

inline constexpr double kSmallEdge = 5;  ///< mm; shorter edges and thinner necks are warned of,
inline constexpr double kTinyEdge = 3;   ///< mm; and these are trouble

/// The narrowest bridge of paper: the shortest way through the paper from one part of the outline to another
/// one that is no neighbour of it. There the net tears.
struct Neck {
  double width_mm = 0;
  std::vector<FaceId> faces;  ///< it leads through; empty when the net has no neck
};

struct Buildability {
  EdgeId smallest_edge;
  double smallest_edge_mm = 0;
  int n_small_edges = 0;       ///< under kSmallEdge, tiny ones included
  int n_tiny_edges = 0;        ///< under kTinyEdge
  HalfedgeId sharpest_corner;  ///< begins at it, in its face
  double sharpest_corner_rad = 0;
  Neck neck;
  int n_folds = 0;  ///< that are bent
  int n_cuts = 0;
  double folds_mm = 0;
  double cuts_mm = 0;  ///< of the outline: a cut counts on both sides, a border once
  int n_tabs = 0;
  std::vector<EdgeId> without_tab;
  int n_sheets = 0;
};

/// For a net without overlaps, laid out on its pages.
Buildability judge(const Net& net, const PageLayout& layout);

/// The same in words, one sentence a line, with what it is about.
struct BuildLine {
  enum class Grade { Fact, Warning, Trouble };
  Grade grade = Grade::Fact;
  std::string text;
  std::vector<EdgeId> edges;
  std::vector<FaceId> faces;
};
std::vector<BuildLine> lines_of(const Buildability& judged, const Net& net);

}  // namespace netwright
