// Each face turns around a pivot, which itself goes straight to where it will be. Faces with the same motion
// and the same pivot stay together on their way: all faces of a swing have one, an end of the joined edge;
// of a glide each part that stays in one piece has its middle.
#include "ui/swing.h"

#include <algorithm>
#include <cmath>

namespace netwright {
namespace {

Rigid2 shift(glm::dvec2 way) { return {1, 0, way.x, way.y}; }

double eased(double t) { return t * t * (3 - 2 * t); }

/// Of what is on its way already when the next goal comes.
double eased_out(double t) { return 1 - (1 - t) * (1 - t); }

/// Numbers the parts between edges that are not folds in both trees; returns how many there are.
std::size_t find_parts(const Net& before, const Net& after, IdVector<FaceId, std::size_t>& part) {
  const Mesh& mesh = after.mesh();
  const std::size_t kNone = mesh.n_faces();
  part.assign(mesh.n_faces(), kNone);
  std::size_t n_parts = 0;
  std::vector<FaceId> open;
  for (const FaceId first : mesh.faces()) {
    if (part[first] != kNone) continue;
    part[first] = n_parts;
    open.push_back(first);
    while (!open.empty()) {
      const FaceId face = open.back();
      open.pop_back();
      for (const HalfedgeId h : mesh.halfedges(face)) {
        const EdgeId e = mesh.edge(h);
        if (!before.tree.is_fold(mesh, e) || !after.tree.is_fold(mesh, e)) continue;
        const FaceId next = mesh.neighbour(h);
        if (part[next] != kNone) continue;
        part[next] = n_parts;
        open.push_back(next);
      }
    }
    ++n_parts;
  }
  return n_parts;
}

/// The middle of all corners of each part.
std::vector<glm::dvec2> middles(const Net& net, const IdVector<FaceId, std::size_t>& part,
                                std::size_t n_parts) {
  std::vector<glm::dvec2> sums(n_parts, glm::dvec2(0));
  std::vector<double> counts(n_parts, 0);
  for (const HalfedgeId h : net.mesh().halfedges()) {
    const std::size_t p = part[net.mesh().face(h)];
    sums[p] += net.corner(h);
    counts[p] += 1;
  }
  for (std::size_t p = 0; p < n_parts; ++p) sums[p] /= counts[p];
  return sums;
}

}  // namespace

Swing::Way Swing::way_of(const Rigid2& whole, glm::dvec2 pivot) {
  return {std::atan2(whole.sin, whole.cos), pivot, whole(pivot) - pivot};
}

Swing::Swing(Net before, const Net& after, const SwingWish& wish, double now)
    : net_(after), from_(before.placement), ways_(before.placement.size()), since_(now) {
  const Mesh& mesh = after.mesh();
  const Rigid2 to_before = before.placement[wish.still] * after.placement[wish.still].inverse();
  const auto motion = [&](FaceId f) {
    return to_before * after.placement[f] * before.placement[f].inverse();
  };
  const Rigid2 of_moved = motion(wish.moved);
  const HalfedgeId near = mesh.halfedge(wish.edge);
  const HalfedgeId side = mesh.face(near) == wish.moved ? near : mesh.twin(near);
  const glm::dvec2 a = before.corner(side);
  const glm::dvec2 b = before.corner(mesh.next(side));
  const glm::dvec2 pivot = glm::distance(of_moved(a), a) <= glm::distance(of_moved(b), b) ? a : b;
  for (const FaceId f : mesh.faces()) ways_[f] = way_of(motion(f), pivot);
  advance(now);
}

Swing::Swing(const Net& before, const Net& after, double now)
    : net_(after), from_(before.placement), ways_(before.placement.size()), since_(now), starts_fast_(true) {
  IdVector<FaceId, std::size_t> part;
  const std::size_t n_parts = find_parts(before, after, part);
  const std::vector<glm::dvec2> pivots = middles(before, part, n_parts);
  for (const FaceId f : after.mesh().faces())
    ways_[f] = way_of(after.placement[f] * before.placement[f].inverse(), pivots[part[f]]);
  advance(now);
}

bool Swing::advance(double now) {
  const double t = std::clamp((now - since_) / kSeconds, 0.0, 1.0);
  const double share = starts_fast_ ? eased_out(t) : eased(t);
  for (const FaceId f : net_.mesh().faces()) {
    const Way& way = ways_[f];
    net_.placement[f] = shift(way.pivot + way.shift * share) * Rigid2::rotation(way.angle_rad * share) *
                        shift(-way.pivot) * from_[f];
  }
  return t < 1;
}

}  // namespace netwright
