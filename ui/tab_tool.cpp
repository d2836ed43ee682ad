// Where a tab really has room is found by the chore that places them all; what is shown before is the shape
// that was asked for.
#include "ui/tab_tool.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/polygon2.h"
#include "ui/arranging.h"
#include "ui/editing.h"
#include "ui/measure.h"
#include "ui/pinning.h"
#include "ui/printed.h"
#include "ui/selection.h"
#include "ui/status.h"

namespace netwright {
namespace {

constexpr double kRimReach = 6;  ///< design pixels

const Mesh& mesh_of(const UiContext& c) { return c.session.project().dual->mesh(); }

bool can_have_tab(const UiContext& c, EdgeId e) {
  const auto shown = c.session.shown();
  if (shown == nullptr || shown->kinds.size() <= e.index()) return false;
  const EdgeKind kind = shown->kinds[e];
  return kind == EdgeKind::Cut || (kind == EdgeKind::Border && c.session.project().tabs.on_borders);
}

bool has_tab(const GlueTabs& tabs, HalfedgeId side) {
  const auto at = std::ranges::lower_bound(tabs.tabs, side, {}, &GlueTab::side);
  return at != tabs.tabs.end() && at->side == side;
}

/// What the edge has now: what was said of it, else what was found for it.
TabSide present_side(const UiContext& c, EdgeId e) {
  const TabSide wished = tab_wish(c.session.project().tabs, e).side;
  const auto pages = c.session.pages();
  if (wished != TabSide::Auto || pages == nullptr) return wished;
  const HalfedgeId h = mesh_of(c).halfedge(e);
  const HalfedgeId twin = mesh_of(c).twin(h);
  const bool is_first = has_tab(pages->tabs, h);
  const bool is_second = twin.is_valid() && has_tab(pages->tabs, twin);
  if (is_first && is_second) return TabSide::Both;
  return is_first ? TabSide::First : is_second ? TabSide::Second : TabSide::None;
}

TabSide next_side(const UiContext& c, EdgeId e) {
  const TabSide present = present_side(c, e);
  const bool is_free = tab_wish(c.session.project().tabs, e).side == TabSide::Auto;
  if (mesh_of(c).is_border(e)) return present == TabSide::None ? TabSide::First : TabSide::None;
  switch (present) {
    case TabSide::First:
      return TabSide::Second;
    case TabSide::Second:
      return is_free ? TabSide::First : TabSide::Both;
    case TabSide::Both:
      return TabSide::None;
    default:
      return TabSide::First;
  }
}

/// The tab as it is asked for, where the side lies in the net, in the net's units.
std::vector<glm::dvec2> asked_outline(const UiContext& c, const Net& net, HalfedgeId side, double width_mm,
                                      double scale) {
  const Mesh& mesh = mesh_of(c);
  const EdgeId e = mesh.edge(side);
  const TabSettings& tabs = c.session.project().tabs;
  const TabEdit wish = tab_wish(tabs, e);
  const glm::dvec2 begin = net.corner(side);
  const glm::dvec2 end = net.corner(mesh.next(side));
  const double length = glm::distance(begin, end);
  const glm::dvec2 along = (end - begin) / length;
  const glm::dvec2 out(along.y, -along.x);
  const double width = std::min(width_mm / scale, length / 2);
  const bool is_first = side == mesh.halfedge(e);
  const double at_begin = (is_first ? wish.first_angle_rad : wish.second_angle_rad).value_or(tabs.angle_rad);
  const double at_end = (is_first ? wish.second_angle_rad : wish.first_angle_rad).value_or(tabs.angle_rad);
  const double from = width / std::tan(at_begin);
  const double to = length - width / std::tan(at_end);
  if (from >= to) return {end, begin, begin + along * (length / 2) + out * width};
  return {end, begin, begin + along * from + out * width, begin + along * to + out * width};
}

double wished_width(const UiContext& c, EdgeId e) {
  const TabSettings& tabs = c.session.project().tabs;
  return tab_wish(tabs, e).width_mm.value_or(tabs.width_mm);
}

void add_outline(const std::vector<glm::dvec2>& outline, OverlayStyle style, OverlayLines& lines) {
  for (std::size_t i = 0; i < outline.size(); ++i)
    lines.add_in_plane(outline[i], outline[(i + 1) % outline.size()], style);
}

const GlueTab* tab_at(const UiContext& c, const Scene& scene, glm::dvec2 at, double reach) {
  const auto pages = c.session.pages();
  if (pages == nullptr || scene.shown() == nullptr || !c.ui.settings.show_tabs) return nullptr;
  for (const GlueTab& tab : pages->tabs.tabs) {
    const auto outline = tab_outline(tab, scene.shown()->net, *scene.net(), pages->scale);
    Box2 box;
    for (const glm::dvec2 p : outline) box.add(p);
    const bool is_near = at.x > box.min.x - reach && at.x < box.max.x + reach && at.y > box.min.y - reach &&
                         at.y < box.max.y + reach;
    if (is_near && contains(outline, at)) return &tab;
  }
  return nullptr;
}

/// How far the pointer is from the side's line, in mm on paper.
double width_at(const UiContext& c, const Net& net, HalfedgeId side, glm::dvec2 at) {
  const glm::dvec2 begin = net.corner(side);
  const glm::dvec2 along = glm::normalize(net.corner(mesh_of(c).next(side)) - begin);
  const double away = glm::dot(at - begin, glm::dvec2(along.y, -along.x));
  return std::clamp(away * c.session.pages()->scale, kLeastTabWidth, kMostTabWidth);
}

/// True while a tab is being dragged.
bool follow_drag(UiContext& c, const Scene& scene, const Gesture& gesture, glm::dvec2 at) {
  Tabbing& tool = c.ui.tabbing;
  if (gesture.is_pressed) tool.held = tool.tab;
  if (!tool.held.is_valid()) return false;
  if (gesture.drag_button == 0) {
    tool.is_dragging = true;
    tool.width_mm = width_at(c, *scene.net(), tool.held, at);
    c.ui.hint = "Width " + exact_length_text(tool.width_mm, c.ui.settings.unit);
    return true;
  }
  if (!tool.is_dragging) return false;
  const EdgeId e = mesh_of(c).edge(tool.held);
  const double width_mm = tool.width_mm;
  tool.is_dragging = false;
  tool.held = tool.tab = HalfedgeId();
  edit_tabs(c, {e}, "tab width", [&](TabEdit& edit) { edit.width_mm = width_mm; });
  return true;
}

const char* side_words(TabSide side) {
  switch (side) {
    case TabSide::Both:
      return "puts a tab on both sides";
    case TabSide::None:
      return "takes the tab away";
    default:
      return "puts the tab on the other side";
  }
}

std::vector<EdgeId> chosen_folds(const UiContext& c) {
  std::vector<EdgeId> edges = chosen_edges(c);
  const auto shown = c.session.shown();
  std::erase_if(edges, [&](EdgeId e) {
    if (shown == nullptr || shown->kinds.size() <= e.index()) return true;
    const EdgeKind kind = shown->kinds[e];
    return kind == EdgeKind::Cut || kind == EdgeKind::Border || kind == EdgeKind::Hidden;
  });
  return edges;
}

bool is_drawn(const UiContext& c, EdgeId e) {
  const SheetSettings& sheet = c.session.project().sheet;
  if (std::ranges::binary_search(sheet.hidden_folds, e)) return false;
  return std::ranges::binary_search(sheet.shown_folds, e) ||
         std::abs(c.session.project().dual->bend(e)) >= sheet.lines.flat_below_rad;
}

void put_in(std::vector<EdgeId>& sorted, EdgeId e) {
  const auto at = std::ranges::lower_bound(sorted, e);
  if (at == sorted.end() || *at != e) sorted.insert(at, e);
}

}  // namespace

TabEdit tab_wish(const TabSettings& tabs, EdgeId edge) {
  const auto at = std::ranges::lower_bound(tabs.edits, edge, {}, &TabEdit::edge);
  if (at != tabs.edits.end() && at->edge == edge) return *at;
  TabEdit none;
  none.edge = edge;
  return none;
}

std::vector<EdgeId> tab_edges(const UiContext& c) {
  std::vector<EdgeId> edges = c.ui.selected_edges;
  std::erase_if(edges, [&](EdgeId e) { return !can_have_tab(c, e); });
  return edges;
}

void edit_tabs(UiContext& c, const std::vector<EdgeId>& edges, const std::string& label,
               const std::function<void(TabEdit&)>& change) {
  TabSettings tabs = c.session.project().tabs;
  for (const EdgeId e : edges) {
    TabEdit edit = tab_wish(tabs, e);
    change(edit);
    TabEdit nothing;
    nothing.edge = e;
    std::erase_if(tabs.edits, [&](const TabEdit& old) { return old.edge == e; });
    const auto at = std::ranges::lower_bound(tabs.edits, e, {}, &TabEdit::edge);
    if (edit != nothing) tabs.edits.insert(at, edit);
  }
  c.session.set_tabs(tabs, label);
}

void reset_tabs(UiContext& c, const std::vector<EdgeId>& edges) {
  edit_tabs(c, edges, "reset tabs", [](TabEdit& edit) {
    const EdgeId e = edit.edge;
    edit = TabEdit();
    edit.edge = e;
  });
}

void make_room_for_tabs(UiContext& c) {
  TabSettings tabs = c.session.project().tabs;
  tabs.in_search = true;
  c.session.set_tabs(tabs, "room for tabs");
  c.session.unfold_from_here();
}

std::string why_no_room_for_tabs(const UiContext& c) {
  if (!c.session.has_model()) return "Open a model first.";
  if (!c.session.project().tabs.is_on) return "Switch glue tabs on first (section Tabs).";
  const auto pages = c.session.pages();
  if (pages == nullptr) return "Unfold the model first (Space).";
  return pages->tabs.missing.empty() ? "Every cut has its tab." : "";
}

std::string tabs_text(const GlueTabs& tabs) {
  const auto n_missing = static_cast<std::int64_t>(tabs.missing.size());
  const std::string text = counted(static_cast<std::int64_t>(tabs.tabs.size()), "tab", "tabs");
  return n_missing == 0 ? text : text + ", " + counted(n_missing, "cut", "cuts") + " without";
}

void show_edge(UiContext& c, EdgeId edge) {
  const Mesh& mesh = mesh_of(c);
  const HalfedgeId h = mesh.halfedge(edge);
  select_side(c.ui, mesh, h, false);
  c.ui.wants_flight = {mesh.face(h)};
  if (!mesh.is_border(edge)) c.ui.wants_flight.push_back(mesh.neighbour(h));
}

bool is_at_tab(const UiContext& c) {
  return c.ui.tabbing.is_on && (c.ui.tabbing.is_dragging || c.ui.tabbing.tab.is_valid());
}

void take_tab(UiContext& c, const Scene* scene, const Pointed& pointed, const Gesture& gesture,
              const PanZoomCamera* camera) {
  UiState& ui = c.ui;
  Tabbing& tool = ui.tabbing;
  const glm::dvec2 at =
      camera == nullptr ? glm::dvec2(0) : camera->to_world({gesture.pointer.x, gesture.pointer.y});
  if (scene != nullptr && follow_drag(c, *scene, gesture, at)) return;
  tool.held = gesture.is_pressed ? tool.held : HalfedgeId();
  tool.side = tool.tab = HalfedgeId();
  ui.hovered = pointed.face;
  ui.hovered_side = pointed.side;
  const double reach =
      camera == nullptr ? 0 : kRimReach * static_cast<double>(ui.look.scale) / camera->pixels_per_unit();
  const GlueTab* const tab =
      scene == nullptr || pointed.face.is_valid() ? nullptr : tab_at(c, *scene, at, reach);
  if (tab != nullptr) tool.tab = ui.hovered_side = tab->side;
  if (gesture.is_pressed) tool.held = tool.tab;
  const HalfedgeId side = ui.hovered_side;
  if (side.is_valid() && can_have_tab(c, mesh_of(c).edge(side))) tool.side = side;
  if (!tool.side.is_valid()) {
    ui.hint = side.is_valid() ? "A fold needs no tab · H hides or shows its line"
                              : "Click a cut: its tab changes sides · drag a tab to change its width";
    return;
  }
  const EdgeId e = mesh_of(c).edge(tool.side);
  ui.hint = std::string("Click ") + side_words(next_side(c, e)) + " · Shift+click selects" +
            (tool.tab.is_valid() ? " · drag changes the width" : "");
  if (!gesture.is_clicked) return;
  select_side(ui, mesh_of(c), tool.side, gesture.is_adding);
  if (gesture.is_adding) return;
  const TabSide next = next_side(c, e);
  edit_tabs(c, {e}, next == TabSide::None ? "take tab away" : "tab side",
            [&](TabEdit& edit) { edit.side = next; });
}

void add_tab_tool(const UiContext& c, const Net& drawn, OverlayLines& lines) {
  const Tabbing& tool = c.ui.tabbing;
  const auto pages = c.session.pages();
  if (!tool.is_on || pages == nullptr) return;
  if (tool.is_dragging)
    return add_outline(asked_outline(c, drawn, tool.held, tool.width_mm, pages->scale),
                       OverlayStyle::Selected, lines);
  if (!tool.side.is_valid()) return;
  const EdgeId e = mesh_of(c).edge(tool.side);
  const HalfedgeId h = mesh_of(c).halfedge(e);
  const HalfedgeId twin = mesh_of(c).twin(h);
  const TabSide next = next_side(c, e);
  const double width = wished_width(c, e);
  const auto add = [&](HalfedgeId side, OverlayStyle style) {
    if (side.is_valid()) add_outline(asked_outline(c, drawn, side, width, pages->scale), style, lines);
  };
  if (next == TabSide::First || next == TabSide::Both) add(h, OverlayStyle::Hovered);
  if (next == TabSide::Second || next == TabSide::Both) add(twin, OverlayStyle::Hovered);
  if (next != TabSide::None) return;
  for (const HalfedgeId side : {h, twin})
    if (side.is_valid() && has_tab(pages->tabs, side)) add(side, OverlayStyle::Culprit);
}

void end_tab_tool(UiState& ui) { ui.tabbing = Tabbing(); }

void toggle_tab_tool(UiContext& c) {
  const bool was_on = c.ui.tabbing.is_on;
  end_measure(c.ui);
  end_editing(c.ui);
  end_arranging(c.ui);
  end_tab_tool(c.ui);
  c.ui.tabbing.is_on = !was_on;
  if (was_on) return;
  c.ui.settings.show_tabs = true;
  c.ui.settings.is_open(Section::Tabs) = true;
}

void toggle_fold_lines(UiContext& c) {
  const std::vector<EdgeId> folds = chosen_folds(c);
  const bool hides = std::ranges::all_of(folds, [&](EdgeId e) { return is_drawn(c, e); });
  SheetSettings sheet = c.session.project().sheet;
  for (const EdgeId e : folds) {
    std::erase(sheet.hidden_folds, e);
    std::erase(sheet.shown_folds, e);
    const bool is_flat = std::abs(c.session.project().dual->bend(e)) < sheet.lines.flat_below_rad;
    if (hides && !is_flat) put_in(sheet.hidden_folds, e);
    if (!hides && is_flat) put_in(sheet.shown_folds, e);
  }
  const std::string what = folds.size() == 1 ? "fold line" : "fold lines";
  c.session.set_sheet(sheet, (hides ? "hide " : "show ") + what);
}

std::string fold_lines_label(const UiContext& c) {
  const std::vector<EdgeId> folds = c.session.has_model() ? chosen_folds(c) : std::vector<EdgeId>();
  const bool hides = std::ranges::all_of(folds, [&](EdgeId e) { return is_drawn(c, e); });
  return hides ? "Hide fold line" : "Show fold line";
}

std::string why_no_tab_tool(const UiContext& c) {
  if (!c.session.has_model()) return "Open a model first.";
  if (c.session.pages() == nullptr) return "Unfold the model first (Space).";
  return c.session.project().tabs.is_on ? "" : "Glue tabs are switched off (section Tabs).";
}

std::string why_no_fold_lines(const UiContext& c) {
  if (!c.session.has_model()) return "Open a model first.";
  return chosen_folds(c).empty() ? "Point at a fold, or select some." : "";
}

}  // namespace netwright
