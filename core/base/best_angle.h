// Which way to turn a piece: boxes of a convex hull under rotation, and the angles that suit a purpose best.
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <vector>

#include "core/base/geometry.h"

namespace netwright {

/// Counter-clockwise, without collinear corners (two points or one where the input has no more).
std::vector<glm::dvec2> convex_hull(std::vector<glm::dvec2> points);

/// The box of the hull turned by the angle.
Box2 turned_box(const std::vector<glm::dvec2>& hull, double angle_rad);

/// The angle in [0, pi) with the least `cost` of the turned box's size; the smallest such angle. Looks at
/// every direction of a hull side (where the box's area is least), at every second degree, and refines the
/// best ones: a box that has to fit a page is best where it touches both limits, between those directions.
double best_angle(const std::vector<glm::dvec2>& hull, const std::function<double(glm::dvec2 size)>& cost);

}  // namespace netwright
