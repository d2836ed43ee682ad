// Pins are switches: pressing the key again takes the pin away.
#include "ui/pinning.h"

#include <algorithm>

#include "ui/selection.h"
#include "ui/status.h"

namespace netwright {
namespace {

template <class Key>
std::vector<Key> chosen(Key hovered, const std::vector<Key>& selected) {
  const bool is_in = std::find(selected.begin(), selected.end(), hovered) != selected.end();
  return hovered.is_valid() && !is_in ? std::vector<Key>{hovered} : selected;
}

const Mesh& mesh_of(const UiContext& c) { return c.session.project().dual->mesh(); }

/// Edges on a border have nothing beyond them to be joined to.
std::vector<EdgeId> inner_edges(const UiContext& c) {
  std::vector<EdgeId> edges = chosen_edges(c);
  std::erase_if(edges, [&](EdgeId e) { return mesh_of(c).is_border(e); });
  return edges;
}

bool are_pinned(const UiContext& c, const std::vector<EdgeId>& edges, EdgePin pin) {
  const Constraints& pins = c.session.project().pins;
  return std::all_of(edges.begin(), edges.end(), [&](EdgeId e) { return pin_of(pins, e) == pin; });
}

bool are_one_patch(const UiContext& c, const std::vector<FaceId>& faces) {
  const Constraints& pins = c.session.project().pins;
  const int patch = faces.empty() ? -1 : patch_of(pins, faces.front());
  return patch >= 0 && pins.together[static_cast<std::size_t>(patch)].size() == faces.size() &&
         std::all_of(faces.begin(), faces.end(), [&](FaceId f) { return patch_of(pins, f) == patch; });
}

/// These pins without those of the chosen edges and faces.
Constraints without_chosen(const UiContext& c) {
  Constraints pins = c.session.project().pins;
  const std::vector<FaceId> faces = chosen_faces(c);
  for (const EdgeId e : chosen_edges(c)) set_pin(pins, e, EdgePin::None);
  if (std::find(faces.begin(), faces.end(), pins.root) != faces.end()) pins.root = FaceId();
  let_go(pins, faces);
  return pins;
}

std::string count_text(std::size_t n, const char* one, const char* many) {
  return counted(static_cast<std::int64_t>(n), one, many);
}

}  // namespace

std::vector<EdgeId> chosen_edges(const UiContext& c) {
  if (!c.session.has_model()) return {};
  return chosen(hovered_edge(c.ui, mesh_of(c)), c.ui.selected_edges);
}

std::vector<FaceId> chosen_faces(const UiContext& c) {
  const bool is_at_edge = c.ui.hovered_side.is_valid();
  return chosen(is_at_edge ? FaceId() : c.ui.hovered, c.ui.selected_faces);
}

void pin_edges(UiContext& c, EdgePin pin) {
  const std::vector<EdgeId> edges = inner_edges(c);
  const bool is_back = are_pinned(c, edges, pin);
  Constraints pins = c.session.project().pins;
  for (const EdgeId e : edges) set_pin(pins, e, is_back ? EdgePin::None : pin);
  const bool is_fold = pin == EdgePin::MustFold;
  c.session.set_pins(pins, is_back ? "unpin " + count_text(edges.size(), "edge", "edges")
                                   : "pin " + (is_fold ? count_text(edges.size(), "fold", "folds")
                                                       : count_text(edges.size(), "cut", "cuts")));
}

void keep_faces_together(UiContext& c) {
  const std::vector<FaceId> faces = chosen_faces(c);
  Constraints pins = c.session.project().pins;
  const bool is_back = are_one_patch(c, faces);
  if (is_back) {
    let_go(pins, faces);
  } else {
    keep_together(pins, faces);
  }
  c.session.set_pins(pins, is_back ? "let faces go" : "keep faces together");
}

void clear_pins(UiContext& c) { c.session.set_pins(without_chosen(c), "clear pins"); }
void clear_all_pins(UiContext& c) { c.session.set_pins({}, "clear all pins"); }

std::string why_no_edge_pin(const UiContext& c) {
  if (!c.session.has_model()) return "Open a model first.";
  if (chosen_edges(c).empty()) return "Point at an edge and press the key, or select some edges first.";
  return inner_edges(c).empty() ? "This edge lies on the border: there is nothing beyond it to be joined."
                                : "";
}

std::string why_no_patch(const UiContext& c) {
  if (!c.session.has_model()) return "Open a model first.";
  return chosen_faces(c).size() < 2
             ? "Select two or more faces first: Shift+click, or Shift+drag around them."
             : "";
}

std::string why_no_clearing(const UiContext& c) {
  if (!c.session.has_model()) return "Open a model first.";
  return without_chosen(c) == c.session.project().pins ? "Nothing is pinned here." : "";
}

std::string why_nothing_pinned(const UiContext& c) {
  return c.session.project().pins == Constraints() ? "Nothing is pinned." : "";
}

std::string must_fold_label(const UiContext& c) {
  const auto edges = chosen_edges(c);
  return !edges.empty() && are_pinned(c, edges, EdgePin::MustFold) ? "Unpin the fold" : "Must fold";
}

std::string must_cut_label(const UiContext& c) {
  const auto edges = chosen_edges(c);
  return !edges.empty() && are_pinned(c, edges, EdgePin::MustCut) ? "Unpin the cut" : "Must cut";
}

std::string patch_label(const UiContext& c) {
  return are_one_patch(c, chosen_faces(c)) ? "Let the patch go" : "Keep together";
}

std::string pins_text(const Constraints& pins) {
  std::string text = pins.root.is_valid() ? "root" : "";
  const auto add = [&](std::size_t n, const char* one, const char* many) {
    if (n > 0) text += (text.empty() ? "" : " · ") + count_text(n, one, many);
  };
  add(pins.must_fold.size(), "fold", "folds");
  add(pins.must_cut.size(), "cut", "cuts");
  add(pins.together.size(), "patch", "patches");
  return text;
}

}  // namespace netwright
