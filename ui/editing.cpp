// Works the edit out when the pointer comes to another edge or place, and keeps it until it is made: the
// overlay draws it from there.
#include "ui/editing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/predicates.h"
#include "ui/selection.h"
#include "ui/status.h"

namespace netwright {
namespace {

const Mesh& mesh_of(const UiContext& c) { return c.session.project().dual->mesh(); }

MayCut may_cut(const UiContext& c) {
  return [&session = c.session](EdgeId e) { return session.may_cut(e); };
}

/// Edits of one tree after another as one.
void append(HandEdit& all, HandEdit&& next) {
  all.tree = std::move(next.tree);
  all.joined.insert(all.joined.end(), next.joined.begin(), next.joined.end());
  all.cut.insert(all.cut.end(), next.cut.begin(), next.cut.end());
  all.moved.insert(all.moved.end(), next.moved.begin(), next.moved.end());
}

std::optional<HandEdit> edit_edge(const UiContext& c, const UnfoldTree& tree, HalfedgeId side) {
  const Mesh& mesh = mesh_of(c);
  if (tree.is_fold(mesh, mesh.edge(side)))
    return c.session.may_cut(mesh.edge(side)) ? cut_at(mesh, tree, mesh.edge(side)) : std::nullopt;
  if (pin_of(c.session.project().pins, mesh.edge(side)) == EdgePin::MustCut) return std::nullopt;
  return join_at(mesh, tree, side, may_cut(c), c.session.project().pins.root);
}

/// All edges of the strip that are what this one is.
std::optional<HandEdit> edit_strip(const UiContext& c, const UnfoldTree& tree, HalfedgeId side) {
  const Mesh& mesh = mesh_of(c);
  const DualGraph& dual = *c.session.project().dual;
  const bool was_fold = tree.is_fold(mesh, mesh.edge(side));
  const auto is_flat = [&](EdgeId e) { return std::abs(dual.bend(e)) < kFlatFold; };
  std::optional<HandEdit> all;
  for (const EdgeId e : strip_across(mesh, mesh.edge(side), is_flat)) {
    const UnfoldTree& present = all ? all->tree : tree;
    if (mesh.is_border(e) || present.is_fold(mesh, e) != was_fold) continue;
    const HalfedgeId h = e == mesh.edge(side) ? side : mesh.halfedge(e);
    std::optional<HandEdit> next = edit_edge(c, present, h);
    if (!next) continue;
    if (!all)
      all = std::move(next);
    else
      append(*all, std::move(*next));
  }
  return all;
}

/// The place for a dragged branch whose edge in the plane is nearest to the pointer.
HalfedgeId nearest_place(const Mesh& mesh, const Net& net, const std::vector<HalfedgeId>& places,
                         const glm::dvec2& at) {
  HalfedgeId best;
  double least = std::numeric_limits<double>::infinity();
  for (const HalfedgeId h : places) {
    const HalfedgeId there = mesh.twin(h);
    const glm::dvec2 middle = 0.5 * (net.corner(there) + net.corner(mesh.next(there)));
    const double distance = glm::length(middle - at);
    if (distance >= least) continue;
    least = distance;
    best = h;
  }
  return best;
}

void work_out(UiContext& c, std::optional<HandEdit> edit) {
  Editing& editing = c.ui.editing;
  editing.edit = std::move(edit);
  editing.preview = editing.edit ? c.session.preview(*editing.edit) : nullptr;
}

std::string effect_text(const UiContext& c) {
  const Editing& editing = c.ui.editing;
  const ShownNet& after = *editing.preview;
  std::string text = counted(static_cast<std::int64_t>(editing.edit->moved.size()), "face", "faces") + " ";
  text += editing.edit->joined.empty() ? "come off" : "swing over";
  const int n_before = c.session.shown()->net.n_pieces;
  if (after.net.n_pieces != n_before) text += ", " + counted(after.net.n_pieces, "piece", "pieces");
  const auto n_overlaps = static_cast<std::int64_t>(after.overlaps.size());
  return text + ", " + (n_overlaps == 0 ? "no overlap" : counted(n_overlaps, "overlap", "overlaps"));
}

std::string label_of(const HandEdit& edit) {
  if (edit.joined.empty()) return edit.cut.size() > 1 ? "cut strip" : "cut fold";
  return edit.joined.size() > 1 ? "join strip" : "join edge";
}

/// What comes over to what, and by which edge; nothing for a cut.
std::optional<SwingWish> swing_of(const Mesh& mesh, const HandEdit& edit) {
  const auto moves = [&](FaceId f) {
    return std::find(edit.moved.begin(), edit.moved.end(), f) != edit.moved.end();
  };
  FaceId still;
  for (const FaceId f : mesh.faces())
    if (!still.is_valid() && !moves(f)) still = f;
  if (edit.joined.empty() || !still.is_valid()) return std::nullopt;
  const HalfedgeId side = mesh.halfedge(edit.joined.front());
  const FaceId near = mesh.face(side);
  const FaceId far = mesh.neighbour(side);
  if (moves(near) == moves(far)) return SwingWish{edit.joined.front(), still, near};
  return moves(near) ? SwingWish{edit.joined.front(), far, near} : SwingWish{edit.joined.front(), near, far};
}

void make(UiContext& c, const std::string& label) {
  Editing& editing = c.ui.editing;
  const HandEdit edit = *editing.edit;
  if (!c.ui.is_motion_reduced) c.ui.swing = swing_of(mesh_of(c), edit);
  editing.edit.reset();
  editing.preview = nullptr;
  editing.side = HalfedgeId();
  editing.version = 0;
  c.session.edit_by_hand(edit, label);
}

std::string refusal_text(const UiContext& c, HalfedgeId side) {
  const Mesh& mesh = mesh_of(c);
  if (mesh.is_border(mesh.edge(side))) return "the border has nothing to be joined to";
  const EdgePin pin = pin_of(c.session.project().pins, mesh.edge(side));
  return pin != EdgePin::None ? "the edge is pinned: press Del to free it first"
                              : "all folds in between are pinned: free one of them first";
}

void hover_edge(UiContext& c, HalfedgeId side, const Gesture& gesture) {
  Editing& editing = c.ui.editing;
  const auto shown = c.session.shown();
  const bool is_same = editing.side == side && editing.version == shown->version &&
                       editing.is_strip == gesture.is_adding && !editing.branch.is_valid();
  editing.branch = FaceId();
  editing.places.clear();
  if (!is_same) {
    editing.side = side;
    editing.version = shown->version;
    editing.is_strip = gesture.is_adding;
    const UnfoldTree& tree = shown->net.tree;
    work_out(c, gesture.is_adding ? edit_strip(c, tree, side) : edit_edge(c, tree, side));
  }
  const EdgeId edge = mesh_of(c).edge(side);
  c.ui.hint = edge_text(c.session, edge, c.ui.settings.unit) + " · ";
  if (!editing.edit) {
    c.ui.hint += refusal_text(c, side);
    return;
  }
  c.ui.hint +=
      std::string(editing.edit->joined.empty() ? "click cuts it: " : "click joins it: ") + effect_text(c);
  if (gesture.is_clicked) make(c, label_of(*editing.edit));
}

void begin_drag(UiContext& c, FaceId face) {
  Editing& editing = c.ui.editing;
  const auto shown = c.session.shown();
  editing.branch = face;
  editing.side = HalfedgeId();
  editing.version = shown->version;
  editing.places = places_for(mesh_of(c), shown->net.tree, face);
  work_out(c, std::nullopt);
}

void drag_branch(UiContext& c, const Net& net, const glm::dvec2& at) {
  Editing& editing = c.ui.editing;
  const Mesh& mesh = mesh_of(c);
  const HalfedgeId place = nearest_place(mesh, net, editing.places, at);
  if (place.is_valid() && place != editing.side) {
    editing.side = place;
    work_out(c, hang_at(mesh, c.session.shown()->net.tree, editing.branch, place));
  }
  c.ui.hint = editing.edit ? "Release: " + effect_text(c) : "This branch has no other place";
}

}  // namespace

void take_edit(UiContext& context, const Pointed& pointed, const Gesture& gesture, const Net* net,
               const glm::dvec2* at) {
  UiState& ui = context.ui;
  const auto shown = context.session.shown();
  if (shown == nullptr || shown->net.dual != context.session.project().dual) return;
  Editing& editing = ui.editing;
  if (editing.branch.is_valid() && editing.version == shown->version && net != nullptr && at != nullptr) {
    if (gesture.drag_button == 0) {
      drag_branch(context, *net, *at);
      return;
    }
    if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) return;  // pressed and not moved yet
    const bool is_wanted = editing.edit.has_value() && !gesture.is_clicked;
    if (is_wanted) make(context, "hang branch");
    editing = Editing{.is_on = true};
    return;
  }
  ui.hovered = pointed.face;
  ui.hovered_side = pointed.side;
  if (pointed.side.is_valid()) {
    hover_edge(context, pointed.side, gesture);
    return;
  }
  editing = Editing{.is_on = true};
  if (pointed.face.is_valid() && gesture.is_pressed && net != nullptr) begin_drag(context, pointed.face);
  ui.hint = pointed.face.is_valid() ? "Drag the face to hang its branch elsewhere"
                                    : "Join and cut: click edges, Shift for the whole strip · Esc ends";
}

void end_editing(UiState& ui) { ui.editing = Editing(); }

}  // namespace netwright
