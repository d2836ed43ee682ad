// Each face turns around a pivot, which itself goes straight to where it will be. Faces with the same motion
// and the same pivot stay together on their way: all faces of a swing have one, an end of the joined edge;
// of a glide each part that stays in one piece has its middle, and all turn together besides.
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

/// Turn and way that bring the middles of all faces closest to where they shall be, by the least squares
/// weighted with the faces' paper.
struct Fit {
  double angle_rad = 0;
  glm::dvec2 from{0};  ///< the middle of all paper
  glm::dvec2 to{0};
};

glm::dvec2 middle(const Net& net, FaceId f) {
  glm::dvec2 sum(0);
  double n = 0;
  for (const HalfedgeId h : net.mesh().halfedges(f)) {
    sum += net.corner(h);
    n += 1;
  }
  return sum / n;
}

Fit fit(const Net& from, const Net& to) {
  const Mesh& mesh = from.mesh();
  Fit best;
  double paper = 0;
  for (const FaceId f : mesh.faces()) {
    best.from += mesh.area(f) * middle(from, f);
    best.to += mesh.area(f) * middle(to, f);
    paper += mesh.area(f);
  }
  best.from /= paper;
  best.to /= paper;
  double along = 0;
  double across = 0;
  for (const FaceId f : mesh.faces()) {
    const glm::dvec2 a = middle(from, f) - best.from;
    const glm::dvec2 b = middle(to, f) - best.to;
    along += mesh.area(f) * glm::dot(a, b);
    across += mesh.area(f) * cross(a, b);
  }
  best.angle_rad = std::atan2(across, along);
  return best;
}

}  // namespace

Net laid_over(Net net, const Net& drawn) {
  const Fit best = fit(net, drawn);
  const Rigid2 motion = shift(best.to) * Rigid2::rotation(best.angle_rad) * shift(-best.from);
  for (const FaceId f : net.mesh().faces()) net.placement[f] = motion * net.placement[f];
  return net;
}

Rigid2 Swing::part_of(const Way& way, double share) {
  return shift(way.pivot + way.shift * share) * Rigid2::rotation(way.angle_rad * share) * shift(-way.pivot);
}

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
  const Fit best = fit(before, after);
  whole_ = {best.angle_rad, best.from, best.to - best.from};
  const Rigid2 back = part_of(whole_, 1).inverse();
  for (const FaceId f : after.mesh().faces())
    ways_[f] = way_of(back * after.placement[f] * before.placement[f].inverse(), pivots[part[f]]);
  advance(now);
}

bool Swing::advance(double now) {
  const double t = std::clamp((now - since_) / kSeconds, 0.0, 1.0);
  const double share = starts_fast_ ? eased_out(t) : eased(t);
  const Rigid2 whole = part_of(whole_, share);
  for (const FaceId f : net_.mesh().faces()) net_.placement[f] = whole * part_of(ways_[f], share) * from_[f];
  return t < 1;
}

}  // namespace netwright
