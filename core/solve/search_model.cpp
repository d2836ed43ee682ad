// Copies a component out of the mesh and scales it to mean edge 1.
#include "core/solve/search_model.h"

namespace netwright {

namespace {

// Pins of edges and patches as the search asks for them, by halfedge of the model.
void take_pins(const Mesh& mesh, const Constraints& pins, SearchModel& model) {
  for (std::size_t h = 0; h < model.mesh_halfedge.size(); ++h)
    if (pin_of(pins, mesh.edge(model.mesh_halfedge[h])) == EdgePin::MustCut) model.twin[h] = -1;
  model.is_pinned = !pins.must_fold.empty() || !pins.together.empty();
  if (!model.is_pinned) return;
  IdVector<FaceId, int> patch(mesh.n_faces(), -1);
  for (std::size_t k = 0; k < pins.together.size(); ++k)
    for (const FaceId f : pins.together[k]) patch[f] = static_cast<int>(k);
  for (std::size_t h = 0; h < model.mesh_halfedge.size(); ++h) {
    const HalfedgeId own = model.mesh_halfedge[h];
    const FaceId beyond = mesh.neighbour(own);
    const bool is_inner = beyond.is_valid() && patch[beyond] == patch[mesh.face(own)];
    model.is_kept.push_back(pin_of(pins, mesh.edge(own)) == EdgePin::MustFold ? 1 : 0);
    model.patch.push_back(is_inner ? patch[beyond] : -1);
  }
}

SearchModel component_model(const DualGraph& dual, const Constraints& pins, int component) {
  const Mesh& mesh = dual.mesh();
  const double scale = 1 / mesh.mean_edge();
  SearchModel model;
  IdVector<HalfedgeId, int> local(mesh.n_halfedges(), -1);
  for (const FaceId f : mesh.faces()) {
    if (mesh.component(f) != component) continue;
    for (const HalfedgeId h : mesh.halfedges(f)) {
      local[h] = model.n_halfedges++;
      model.mesh_halfedge.push_back(h);
      model.face_of.push_back(model.n_faces);
      model.edge_length.push_back(mesh.length(mesh.edge(h)) * scale);
      Rigid2 unroll = dual.unroll(h);
      unroll.x *= scale;
      unroll.y *= scale;
      model.unroll.push_back(unroll);
    }
    for (int k = 0; k < dual.n_parts(f); ++k) {
      for (const int corner : dual.part(f, k))
        model.verts.push_back(dual.flat(HalfedgeId(mesh.first(f).value + corner)) * scale);
      model.vert_begin.push_back(static_cast<int>(model.verts.size()));
    }
    model.part_begin.push_back(static_cast<int>(model.vert_begin.size()) - 1);
    model.face_begin.push_back(model.n_halfedges);
    model.mesh_face.push_back(f);
    model.total_area += mesh.area(f) * scale * scale;
    ++model.n_faces;
  }
  int hinged = 0;
  for (const HalfedgeId h : model.mesh_halfedge) {
    const HalfedgeId t = mesh.twin(h);
    model.twin.push_back(t.is_valid() ? local[t] : -1);
    hinged += t.is_valid() ? 1 : 0;
  }
  model.mean_valence = static_cast<double>(hinged) / model.n_faces;
  if (!pins.are_free()) take_pins(mesh, pins, model);
  return model;
}

}  // namespace

std::vector<SearchModel> search_models(const DualGraph& dual, const Constraints& pins) {
  std::vector<SearchModel> models;
  for (std::size_t c = 0; c < dual.mesh().n_components(); ++c)
    models.push_back(component_model(dual, pins, static_cast<int>(c)));
  return models;
}

}  // namespace netwright
