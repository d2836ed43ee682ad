// Colours that a file gives to points or faces instead of materials, made into materials. Linked into the
// helper program, too, so nothing here reads files.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "core/mesh/soup.h"

namespace netwright::readers {

/// A colour as screens and most files have it (sRGB, 0…1) as a Material has it: linear, within 0…1, and
/// grey where it is no number.
glm::dvec3 linear_colour(const glm::dvec3& srgb);

/// One sRGB colour per face, or none where the face keeps the material it has. Alike ones share a material;
/// of more than a thousand different ones (a scan with a colour at every point) neighbouring shades become
/// one.
void colour_faces(PolygonSoup& soup, const std::vector<std::optional<glm::dvec3>>& srgb);

}  // namespace netwright::readers
