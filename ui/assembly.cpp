// What is glued belongs to the project; which seam is in hand is only what is selected.
#include "ui/assembly.h"

#include <algorithm>

#include "core/base/counted.h"
#include "core/sheet/labels.h"
#include "core/unfold/gluing_order.h"
#include "ui/selection.h"
#include "ui/tab_tool.h"

namespace netwright {
namespace {

bool is_glued(const UiContext& c, EdgeId e) {
  return std::ranges::binary_search(c.session.project().glued, e);
}

std::size_t position(const std::vector<EdgeId>& order, EdgeId e) {
  return static_cast<std::size_t>(std::ranges::find(order, e) - order.begin());
}

}  // namespace

const std::vector<EdgeId>& assembly_order(UiContext& c) {
  Assembly& assembly = c.ui.assembly;
  const auto shown = c.session.shown();
  const std::uint64_t version = shown == nullptr || !shown->is_proved ? 0 : shown->version;
  if (assembly.version == version && assembly.is_known) return assembly.order;
  assembly.is_known = true;
  assembly.version = version;
  assembly.order.clear();
  if (version == 0) return assembly.order;
  assembly.order = gluing_order(shown->net);
  return assembly.order;
}

int assembly_number(UiContext& c, EdgeId cut) {
  const SheetSettings& sheet = c.session.project().sheet;
  const auto shown = c.session.shown();
  const auto pages = c.session.pages();
  if (shown == nullptr || pages == nullptr || !sheet.labels.edge_numbers) return 0;
  Assembly& assembly = c.ui.assembly;
  std::vector<EdgeId> tabless = strip_cuts(*pages, sheet);
  const bool is_same = assembly.numbers_version == shown->version && !assembly.numbers.empty() &&
                       assembly.skips_obvious == sheet.labels.skips_obvious && assembly.tabless == tabless;
  if (!is_same) {
    assembly.numbers_version = shown->version;
    assembly.skips_obvious = sheet.labels.skips_obvious;
    assembly.tabless = std::move(tabless);
    assembly.numbers = cut_numbers(shown->net, assembly.skips_obvious, assembly.tabless);
  }
  return assembly.numbers[cut];
}

EdgeId assembly_seam(UiContext& c) {
  const std::vector<EdgeId>& order = assembly_order(c);
  if (c.ui.selected_edges.size() == 1 && std::ranges::find(order, c.ui.selected_edges.front()) != order.end())
    return c.ui.selected_edges.front();
  const auto open = std::ranges::find_if(order, [&](EdgeId e) { return !is_glued(c, e); });
  return open == order.end() ? EdgeId() : *open;
}

void go_in_assembly(UiContext& c, int step) {
  const std::vector<EdgeId>& order = assembly_order(c);
  if (order.empty()) return;
  const EdgeId seam = assembly_seam(c);
  const bool is_shown = c.ui.selected_edges.size() == 1 && c.ui.selected_edges.front() == seam;
  const auto at = static_cast<int>(seam.is_valid() ? position(order, seam) : order.size() - 1);
  // The first press shows the seam in hand.
  const int to = std::clamp(is_shown ? at + step : at, 0, static_cast<int>(order.size()) - 1);
  show_edge(c, order[static_cast<std::size_t>(to)]);
}

void tick_seam(UiContext& c) {
  const EdgeId seam = assembly_seam(c);
  if (!seam.is_valid()) return;
  std::vector<EdgeId> glued = c.session.project().glued;
  const bool was_glued = is_glued(c, seam);
  if (was_glued)
    std::erase(glued, seam);
  else
    glued.push_back(seam);
  c.session.set_glued(std::move(glued), was_glued ? "open seam" : "glue seam");
  if (was_glued) return show_edge(c, seam);
  clear_selection(c.ui);
  if (const EdgeId next = assembly_seam(c); next.is_valid()) show_edge(c, next);
}

std::string why_no_assembly(const UiContext& c) {
  if (!c.session.has_model()) return "Open a model first.";
  const auto shown = c.session.shown();
  return shown == nullptr || !shown->is_proved || c.session.pages() == nullptr
             ? "Unfold the model into one piece first (Space)."
             : "";
}

std::string assembly_text(const UiContext& c, std::size_t n_seams) {
  return grouped(static_cast<std::int64_t>(c.session.project().glued.size())) + " of " +
         grouped(static_cast<std::int64_t>(n_seams)) + " glued";
}

}  // namespace netwright
