// Simple polygons of the plane as lists of corners: area, convexity, crossings, triangles and convex parts.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace netwright {

/// Positive when the corners run counter-clockwise.
double signed_area(std::span<const glm::dvec2> polygon);

/// True when no corner turns right (collinear corners are allowed) and the boundary goes round once.
bool is_convex(std::span<const glm::dvec2> polygon);

/// True when no two sides that are not neighbours meet, and neighbours meet only at their corner. Exact.
bool is_simple(std::span<const glm::dvec2> polygon);

/// True when the segments a b and c d have a point in common, be it an end. Exact.
bool segments_meet(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 d);

bool contains(std::span<const glm::dvec2> polygon, glm::dvec2 point);

/// Triangles of a simple counter-clockwise polygon as corner indices, by ear clipping; n-2 of them, of which
/// some have no area where corners are collinear.
std::vector<std::array<int, 3>> triangulate(std::span<const glm::dvec2> polygon);

/// Convex counter-clockwise parts that cover a simple counter-clockwise polygon, as corner indices: one for a
/// convex polygon, else triangles merged where they stay convex (Hertel and Mehlhorn 1983: at most four times
/// the fewest possible).
std::vector<std::vector<int>> convex_parts(std::span<const glm::dvec2> polygon);

}  // namespace netwright
