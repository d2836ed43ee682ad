// What the user said of single edges, their tabs and whether their folds are printed, for another mesh of the
// same model.
#pragma once

#include <functional>

#include "core/mesh/mesh.h"
#include "core/sheet/sheet_settings.h"
#include "core/unfold/glue_tabs.h"

namespace netwright {

/// The same wish, told by somebody for whom the edge's two sides are the other way round.
TabEdit seen_from_twin(TabEdit edit);

/// The edge of the new mesh in an edge's place; invalid when there is none.
using EdgeHeir = std::function<EdgeId(EdgeId)>;
/// A direction of the old mesh in the new one.
using TurnedAlong = std::function<glm::dvec3(const glm::dvec3&)>;

/// Edits of edges without an heir go; where two have the same one the first of them is kept.
void carry_settings(TabSettings& tabs, SheetSettings& sheet, const Mesh& from, const Mesh& to,
                    const EdgeHeir& heir, const TurnedAlong& turned);

}  // namespace netwright
