// Edits of a tree are changes of parent links: a piece is turned so that the face that moves is its root,
// then hung below another face.
#include "core/unfold/hand_edits.h"

#include <algorithm>

namespace netwright {

namespace {

// The first fold from `f` towards `g`, both of one piece, that may be cut; invalid when none may.
EdgeId first_free_fold(const Mesh& mesh, const UnfoldTree& tree, FaceId f, FaceId g, const MayCut& may_cut) {
  UnfoldTree towards = tree;
  towards.reroot(mesh, g);
  for (; f != g; f = towards.parent(mesh, f)) {
    const EdgeId e = mesh.edge(towards.to_parent(f));
    if (may_cut(e)) return e;
  }
  return {};
}

// Makes the face below this fold a root.
void part(const Mesh& mesh, UnfoldTree& tree, EdgeId fold) {
  const HalfedgeId h = mesh.halfedge(fold);
  const FaceId child = tree.to_parent(mesh.face(h)) == h ? mesh.face(h) : mesh.neighbour(h);
  tree.set_parent(child, HalfedgeId());
}

void hang(const Mesh& mesh, UnfoldTree& tree, HalfedgeId side) {
  tree.reroot(mesh, mesh.face(side));
  tree.set_parent(mesh.face(side), side);
}

std::optional<HalfedgeId> across_triangle_pair(const Mesh& mesh, HalfedgeId entry,
                                               const std::function<bool(EdgeId)>& is_flat) {
  for (HalfedgeId h = mesh.next(entry); h != entry; h = mesh.next(h)) {
    const HalfedgeId twin = mesh.twin(h);
    if (!twin.is_valid() || mesh.degree(mesh.face(twin)) != 3 || !is_flat(mesh.edge(h))) continue;
    // The side of the far triangle that shares no corner with the side we came from.
    for (HalfedgeId g = mesh.next(twin); g != twin; g = mesh.next(g)) {
      const auto touches = [&](VertexId v) { return v == mesh.from(entry) || v == mesh.to(entry); };
      if (!touches(mesh.from(g)) && !touches(mesh.to(g))) return g;
    }
  }
  return std::nullopt;
}

// The side opposite to where the strip enters a face; nothing where it ends.
std::optional<HalfedgeId> opposite(const Mesh& mesh, HalfedgeId entry,
                                   const std::function<bool(EdgeId)>& is_flat) {
  const int degree = mesh.degree(mesh.face(entry));
  if (degree == 4) return mesh.next(mesh.next(entry));
  return degree == 3 ? across_triangle_pair(mesh, entry, is_flat) : std::nullopt;
}

}  // namespace

std::vector<FaceId> branch_of(const Mesh& mesh, const UnfoldTree& tree, FaceId top) {
  std::vector<FaceId> faces{top};
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (const HalfedgeId h : mesh.halfedges(faces[i])) {
      const FaceId g = mesh.neighbour(h);
      if (g.is_valid() && tree.to_parent(g) == mesh.twin(h)) faces.push_back(g);
    }
  return faces;
}

std::optional<HandEdit> join_at(const Mesh& mesh, const UnfoldTree& tree, HalfedgeId side,
                                const MayCut& may_cut, FaceId fixed) {
  const FaceId f = mesh.face(side);
  const FaceId g = mesh.neighbour(side);
  if (!g.is_valid() || tree.is_fold(mesh, mesh.edge(side))) return std::nullopt;
  HandEdit edit{tree, {mesh.edge(side)}, {}, {}};
  if (tree.root_of(mesh, f) == tree.root_of(mesh, g)) {
    const EdgeId fold = first_free_fold(mesh, tree, f, g, may_cut);
    if (!fold.is_valid()) return std::nullopt;
    edit.cut = {fold};
    part(mesh, edit.tree, fold);
  }
  const bool holds_fixed = fixed.is_valid() && edit.tree.root_of(mesh, fixed) == edit.tree.root_of(mesh, f);
  const HalfedgeId moving = holds_fixed ? mesh.twin(side) : side;
  edit.moved = branch_of(mesh, edit.tree, edit.tree.root_of(mesh, mesh.face(moving)));
  hang(mesh, edit.tree, moving);
  const bool has_fixed = fixed.is_valid() && edit.tree.root_of(mesh, fixed) == edit.tree.root_of(mesh, f);
  edit.tree.reroot(mesh, has_fixed ? fixed : tree.root_of(mesh, mesh.neighbour(moving)));
  return edit;
}

std::optional<HandEdit> cut_at(const Mesh& mesh, const UnfoldTree& tree, EdgeId edge) {
  if (mesh.is_border(edge) || !tree.is_fold(mesh, edge)) return std::nullopt;
  HandEdit edit{tree, {}, {edge}, {}};
  part(mesh, edit.tree, edge);
  const HalfedgeId h = mesh.halfedge(edge);
  const FaceId child =
      edit.tree.is_root(mesh.face(h)) && !tree.is_root(mesh.face(h)) ? mesh.face(h) : mesh.neighbour(h);
  edit.moved = branch_of(mesh, edit.tree, child);
  return edit;
}

std::vector<HalfedgeId> places_for(const Mesh& mesh, const UnfoldTree& tree, FaceId branch) {
  const std::vector<FaceId> faces = branch_of(mesh, tree, branch);
  IdVector<FaceId, char> is_inside(mesh.n_faces(), 0);
  for (const FaceId f : faces) is_inside[f] = 1;
  std::vector<HalfedgeId> places;
  for (const FaceId f : faces)
    for (const HalfedgeId h : mesh.halfedges(f)) {
      const FaceId g = mesh.neighbour(h);
      if (g.is_valid() && is_inside[g] == 0 && !tree.is_fold(mesh, mesh.edge(h))) places.push_back(h);
    }
  return places;
}

std::optional<HandEdit> hang_at(const Mesh& mesh, const UnfoldTree& tree, FaceId branch, HalfedgeId side) {
  const std::vector<HalfedgeId> places = places_for(mesh, tree, branch);
  if (std::find(places.begin(), places.end(), side) == places.end()) return std::nullopt;
  HandEdit edit{tree, {mesh.edge(side)}, {}, branch_of(mesh, tree, branch)};
  if (!tree.is_root(branch)) edit.cut = {mesh.edge(tree.to_parent(branch))};
  edit.tree.set_parent(branch, HalfedgeId());
  hang(mesh, edit.tree, side);
  return edit;
}

std::vector<EdgeId> strip_across(const Mesh& mesh, EdgeId edge, const std::function<bool(EdgeId)>& is_flat) {
  std::vector<EdgeId> strip{edge};
  const auto is_new = [&](EdgeId e) { return std::find(strip.begin(), strip.end(), e) == strip.end(); };
  const HalfedgeId first = mesh.halfedge(edge);
  for (HalfedgeId h : {first, mesh.twin(first)}) {
    while (h.is_valid()) {
      const std::optional<HalfedgeId> out = opposite(mesh, h, is_flat);
      if (!out || !is_new(mesh.edge(*out))) break;
      strip.push_back(mesh.edge(*out));
      h = mesh.twin(*out);
    }
  }
  return strip;
}

}  // namespace netwright
