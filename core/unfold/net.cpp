// Lays a tree out by multiplying its hinges' motions from the roots outwards.
#include "core/unfold/net.h"

namespace netwright {

Box2 Net::box(FaceId f) const {
  Box2 result;
  for (const HalfedgeId h : mesh().halfedges(f)) result.add(corner(h));
  return result;
}

Box2 Net::box() const {
  Box2 result;
  for (const FaceId f : mesh().faces()) result.add(box(f));
  return result;
}

namespace {

// Puts the pieces in a row, so that a model of several parts can be looked at.
void separate_pieces(Net& net) {
  std::vector<Box2> boxes(static_cast<std::size_t>(net.n_pieces));
  for (const FaceId f : net.mesh().faces()) boxes[static_cast<std::size_t>(net.piece[f])].add(net.box(f));
  std::vector<glm::dvec2> shift(boxes.size(), glm::dvec2(0));
  double right = boxes[0].max.x;
  for (std::size_t k = 1; k < boxes.size(); ++k) {
    shift[k] = {right + net.mesh().mean_edge() - boxes[k].min.x, boxes[0].centre().y - boxes[k].centre().y};
    right = boxes[k].max.x + shift[k].x;
  }
  for (const FaceId f : net.mesh().faces()) {
    const glm::dvec2 s = shift[static_cast<std::size_t>(net.piece[f])];
    net.placement[f].x += s.x;
    net.placement[f].y += s.y;
  }
}

}  // namespace

Net layout(std::shared_ptr<const DualGraph> dual, UnfoldTree tree) {
  Net net;
  net.dual = std::move(dual);
  net.tree = std::move(tree);
  const Mesh& mesh = net.mesh();
  net.placement.assign(mesh.n_faces(), Rigid2());
  net.piece.assign(mesh.n_faces(), 0);
  for (const FaceId f : net.tree.preorder(mesh)) {
    const HalfedgeId up = net.tree.to_parent(f);
    if (!up.is_valid()) {
      net.piece[f] = net.n_pieces++;
      continue;
    }
    const HalfedgeId down = mesh.twin(up);
    const FaceId parent = mesh.face(down);
    net.placement[f] = net.placement[parent] * net.dual->unroll(down);
    net.piece[f] = net.piece[parent];
  }
  if (net.n_pieces > 1) separate_pieces(net);
  return net;
}

}  // namespace netwright
