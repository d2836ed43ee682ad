// Assembly mode: the seams of the finished net one after the other, what is glued ticked off.
#pragma once

#include <string>
#include <vector>

#include "ui/ui_state.h"

namespace netwright {

/// The order for the shown net, worked out once for each net; empty without a proved one.
const std::vector<EdgeId>& assembly_order(UiContext& context);
/// The number printed at both sides of a cut; 0 for those without one, and where numbers are not printed.
[[nodiscard]] int assembly_number(UiContext& context, EdgeId cut);
/// The seam in hand: the selected cut, else the first that is not glued; invalid when all are.
[[nodiscard]] EdgeId assembly_seam(UiContext& context);
/// So many steps on or back; both views fly there.
void go_in_assembly(UiContext& context, int step);
/// Ticks the seam in hand off and goes on to the next that is open, or takes the tick back.
void tick_seam(UiContext& context);

[[nodiscard]] std::string why_no_assembly(const UiContext& context);
/// "12 of 117 glued".
[[nodiscard]] std::string assembly_text(const UiContext& context, std::size_t n_seams);

}  // namespace netwright
