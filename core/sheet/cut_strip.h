// How to cover a strip of paper with few sheets, and where to join them: where seams run through few marks.
#pragma once

#include <vector>

namespace netwright {

/// A stretch along one axis, in mm.
struct Span {
  double low = 0;
  double high = 0;
};

/// Spans in any order, as those that they cover together: ascending, and further apart than `gap`.
std::vector<Span> merge_spans(std::vector<Span> spans, double gap);

/// A sheet more is worth it when so many marks fewer are cut. (Measured with tiles_bench: were paper all that
/// counts, it would take 2 % fewer sheets that cut 10 % more marks.)
inline constexpr double kMarksPerSheet = 10;

struct StripToCut {
  std::vector<Span> paper;  ///< what has to be covered, as merge_spans() leaves it with a gap of the overlap
  std::vector<Span> marks;  ///< what a seam should not run through
};

struct CutStrip {
  /// What each sheet answers for, ascending. Where two of them touch is a seam; where they do not, there is
  /// no paper in between.
  std::vector<Span> shares;
  int n_cut_marks = 0;
};

/// A sheet reaches over each of its seams by half the overlap at least, and shows no more than the window
/// (wider than two overlaps). Of all ways with seams at steps of half a millimetre the one with the fewest
/// sheets and cut marks, as kMarksPerSheet weighs them, that keeps away from the other marks.
CutStrip cut_strip(const StripToCut& strip, double window, double overlap);

}  // namespace netwright
