// What a project's paper, size and model ask of polish.
#pragma once

#include <optional>

#include "core/project/project.h"
#include "core/solve/aims.h"

namespace netwright {

/// Nothing when no effort is to be made. The scale is the one at which the first net would be printed; the
/// rooms are those of the paper's pages, less the glue tabs. A net that is printed as large as the paper
/// allows is asked for the room of a full page, which no net can fill: so it grows for as long as it is
/// polished.
std::optional<PolishAim> polish_aim(const Project& project, const PolishSettings& settings);

/// How much a cut along each edge is seen, 0…1: not at all where the texture has a seam, less at the bottom
/// and in a valley.
IdVector<EdgeId, double> edges_in_sight(const DualGraph& dual);

}  // namespace netwright
