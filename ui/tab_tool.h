// The tool for glue tabs: click a cut and its tab goes to the other side, to both, to none, in turn; drag a
// tab's rim and it gets wider or narrower. What would come is shown before the button is released.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/unfold/glue_tabs.h"
#include "render/edge_picker.h"
#include "render/overlay_renderer.h"
#include "ui/scene.h"
#include "ui/view_parts.h"

namespace netwright {

/// What the pointer does while the tool is in hand. `scene` may be null: in the model's view there are edges
/// only.
void take_tab(UiContext& context, const Scene* scene, const Pointed& pointed, const Gesture& gesture,
              const PanZoomCamera* camera);
/// The pointer is over a tab, or drags one.
[[nodiscard]] bool is_at_tab(const UiContext& context);
/// What a click or the drag in hand would bring.
void add_tab_tool(const UiContext& context, const Net& drawn, OverlayLines& lines);
void end_tab_tool(UiState& ui);

/// Selected edges that can have tabs.
[[nodiscard]] std::vector<EdgeId> tab_edges(const UiContext& context);
/// What was said of the edge; nothing but its name where nothing was.
[[nodiscard]] TabEdit tab_wish(const TabSettings& tabs, EdgeId edge);
/// Changes what is said of these edges; one undo step, `label` as in "Undo <label>".
void edit_tabs(UiContext& context, const std::vector<EdgeId>& edges, const std::string& label,
               const std::function<void(TabEdit&)>& change);
/// Nothing is said of them any more.
void reset_tabs(UiContext& context, const std::vector<EdgeId>& edges);

/// "212 tabs, 3 cuts without".
[[nodiscard]] std::string tabs_text(const GlueTabs& tabs);
/// Selects an edge and lets both views fly there.
void show_edge(UiContext& context, EdgeId edge);

// Actions.
void toggle_tab_tool(UiContext& context);
/// Searches on from the net as it is until every cut has room for a tab, and so from then on.
void make_room_for_tabs(UiContext& context);
[[nodiscard]] std::string why_no_room_for_tabs(const UiContext& context);
/// The lines of the chosen folds are not printed, or are again.
void toggle_fold_lines(UiContext& context);
[[nodiscard]] std::string fold_lines_label(const UiContext& context);
[[nodiscard]] std::string why_no_tab_tool(const UiContext& context);
[[nodiscard]] std::string why_no_fold_lines(const UiContext& context);

}  // namespace netwright
