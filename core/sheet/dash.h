// Dashes that fit their edge: whole periods, and ink at both ends, where a fold must be easy to find.
#pragma once

#include <span>
#include <vector>

namespace netwright {

/// The pattern (ink, gap, …), scaled a little so that an edge of this length carries whole periods and one
/// more first dash. Empty (a solid line) for edges too short to show the pattern, and
/// for patterns of no length or with negative parts.
std::vector<double> fit_dash(std::span<const double> pattern_mm, double length_mm);

}  // namespace netwright
