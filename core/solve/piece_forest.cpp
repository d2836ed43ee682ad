// Joining moves the smaller piece to the larger one after every face of both was compared; cutting lays both
// sides out anew.
#include "core/solve/piece_forest.h"

#include <algorithm>
#include <cmath>

#include "core/unfold/overlap.h"

namespace netwright {

PieceForest::PieceForest(const DualGraph& dual, double depth)
    : dual_(&dual),
      depth_(depth),
      radius_(dual.mesh().n_faces(), 0),
      is_fold_(dual.mesh().n_edges(), 0),
      piece_(dual.mesh().n_faces(), 0),
      placement_(dual.mesh().n_faces()),
      n_pieces_(static_cast<int>(dual.mesh().n_faces())) {
  const Mesh& mesh = dual.mesh();
  for (const FaceId f : mesh.faces()) {
    piece_[f] = f.value;
    faces_of_.push_back({f});
    for (const HalfedgeId h : mesh.halfedges(f)) radius_[f] = std::max(radius_[f], glm::length(dual.flat(h)));
  }
}

bool PieceForest::join(EdgeId edge) {
  const Mesh& mesh = dual_->mesh();
  if (mesh.is_border(edge)) return false;
  HalfedgeId h = mesh.halfedge(edge);
  const auto size = [&](HalfedgeId side) {
    return faces_of_[static_cast<std::size_t>(piece_[mesh.face(side)])].size();
  };
  if (size(h) < size(mesh.twin(h))) h = mesh.twin(h);
  const int kept = piece_[mesh.face(h)];
  const int moved = piece_[mesh.neighbour(h)];
  if (kept == moved) return false;
  const Rigid2 motion = placement_[mesh.face(h)] * dual_->unroll(h) * placement_[mesh.neighbour(h)].inverse();
  if (!fits(kept, moved, motion)) return false;
  std::vector<FaceId>& all = faces_of_[static_cast<std::size_t>(kept)];
  for (const FaceId f : faces_of_[static_cast<std::size_t>(moved)]) {
    placement_[f] = motion * placement_[f];
    piece_[f] = kept;
    all.push_back(f);
  }
  faces_of_[static_cast<std::size_t>(moved)].clear();
  is_fold_[edge] = 1;
  --n_pieces_;
  return true;
}

bool PieceForest::fits(int kept, int moved, const Rigid2& motion) const {
  for (const FaceId g : faces_of_[static_cast<std::size_t>(moved)]) {
    const Rigid2 there = motion * placement_[g];
    for (const FaceId f : faces_of_[static_cast<std::size_t>(kept)]) {
      const Rigid2& here = placement_[f];
      const double x = here.x - there.x;
      const double y = here.y - there.y;
      const double reach = radius_[f] + radius_[g];
      if (x * x + y * y < reach * reach && faces_overlap(*dual_, f, here, g, there, depth_)) return false;
    }
  }
  return true;
}

void PieceForest::exchange(const std::vector<EdgeId>& folds, const std::vector<EdgeId>& cuts) {
  const Mesh& mesh = dual_->mesh();
  std::vector<int> touched;
  for (const EdgeId e : folds) {
    is_fold_[e] = 0;
    touched.push_back(piece_[mesh.face(mesh.halfedge(e))]);
  }
  for (const EdgeId e : cuts) {
    is_fold_[e] = 1;
    touched.push_back(piece_[mesh.face(mesh.halfedge(e))]);
    touched.push_back(piece_[mesh.neighbour(mesh.halfedge(e))]);
  }
  std::sort(touched.begin(), touched.end());
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  std::vector<FaceId> faces;
  for (const int piece : touched) {
    std::vector<FaceId>& of_piece = faces_of_[static_cast<std::size_t>(piece)];
    faces.insert(faces.end(), of_piece.begin(), of_piece.end());
    of_piece.clear();
    --n_pieces_;
  }
  for (const FaceId f : faces) piece_[f] = -1;
  for (const FaceId f : faces)
    if (piece_[f] < 0) lay_out(f);
}

void PieceForest::lay_out(FaceId from) {
  const Mesh& mesh = dual_->mesh();
  std::vector<FaceId>& reached = faces_of_[from.index()];
  reached.assign(1, from);
  piece_[from] = from.value;
  placement_[from] = Rigid2();
  for (std::size_t i = 0; i < reached.size(); ++i) {
    const FaceId f = reached[i];
    for (const HalfedgeId h : mesh.halfedges(f)) {
      if (!is_fold(mesh.edge(h)) || piece_[mesh.neighbour(h)] >= 0) continue;
      const FaceId g = mesh.neighbour(h);
      piece_[g] = from.value;
      placement_[g] = placement_[f] * dual_->unroll(h);
      reached.push_back(g);
    }
  }
  ++n_pieces_;
}

}  // namespace netwright
