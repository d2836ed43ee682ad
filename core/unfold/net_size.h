// What a net takes to make: how much is cut, and how much paper it is cut from. Model units.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "core/unfold/net.h"

namespace netwright {

/// Of all edges that the net cuts, counted once; borders are none.
double cut_length(const Net& net);

/// Convex hull of every piece.
std::vector<std::vector<glm::dvec2>> piece_hulls(const Net& net);

/// Of the smallest rectangles around these hulls.
double paper_area(const std::vector<std::vector<glm::dvec2>>& hulls);

}  // namespace netwright
