// Cuts a polygon that is not convex along diagonals from its inward corners, which opens the notches where
// other parts of a net must find room.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace netwright {

/// Corners that turn inward by no more than this (radians, a tenth of a degree) count as straight: nothing
/// hangs into so flat a notch.
inline constexpr double kStraightTurn = 0.0017453292519943296;

/// True when no corner of the counter-clockwise polygon turns inward by more than kStraightTurn.
bool is_open(std::span<const glm::dvec2> polygon);

/// Parts of a simple counter-clockwise polygon as corner indices, each counter-clockwise, every corner in
/// one part at least; open ones wherever a diagonal can be found that leaves no sliver.
std::vector<std::vector<int>> convex_cuts(std::span<const glm::dvec2> polygon);

}  // namespace netwright
