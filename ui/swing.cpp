// Each face turns around one pivot, an end of the joined edge, which itself goes straight to where it will
// be. Faces with the same motion stay together on their way.
#include "ui/swing.h"

#include <algorithm>
#include <cmath>

namespace netwright {
namespace {

Rigid2 shift(glm::dvec2 way) { return {1, 0, way.x, way.y}; }

double eased(double t) { return t * t * (3 - 2 * t); }

}  // namespace

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
  pivot_ = glm::distance(of_moved(a), a) <= glm::distance(of_moved(b), b) ? a : b;
  for (const FaceId f : mesh.faces()) {
    const Rigid2 whole = motion(f);
    ways_[f] = {std::atan2(whole.sin, whole.cos), whole(pivot_) - pivot_};
  }
  advance(now);
}

bool Swing::advance(double now) {
  const double t = std::clamp((now - since_) / kSeconds, 0.0, 1.0);
  const double share = eased(t);
  for (const FaceId f : net_.mesh().faces()) {
    const Way& way = ways_[f];
    net_.placement[f] = shift(pivot_ + way.shift * share) * Rigid2::rotation(way.angle_rad * share) *
                        shift(-pivot_) * from_[f];
  }
  return t < 1;
}

}  // namespace netwright
