// Flattens faces, rolls them over hinges and compares them, each step with a generous bound of its rounding.
// The bounds count units of 2^-52 and are rounded up to a power of two well beyond what the steps can add up
// to.
#include "core/unfold/certain_overlap.h"

#include <algorithm>
#include <limits>

#include "core/base/predicates.h"

namespace netwright::proof {
namespace {

constexpr double kStep =
    0x1p-52 * 32;  ///< more than the few roundings of one step lose, relative to its sizes

using Polygon = std::vector<glm::dvec2>;

bool is_in_triangle(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
  return orientation(a, b, p) >= 0 && orientation(b, c, p) >= 0 && orientation(c, a, p) >= 0;
}

bool is_convex(const Polygon& p) {
  double turned = 0;
  for (std::size_t i = 0, n = p.size(); i < n; ++i) {
    const glm::dvec2 a = p[(i + 1) % n] - p[i];
    const glm::dvec2 b = p[(i + 2) % n] - p[(i + 1) % n];
    if (orientation(p[i], p[(i + 1) % n], p[(i + 2) % n]) <= 0) return false;
    turned += std::atan2(cross(a, b), glm::dot(a, b));
  }
  return turned < 7;  // once round
}

/// Triangles inside the face. Where no ear is left (straight corners, an outline that touches itself) the
/// rest is left out: fewer parts can only mean fewer overlaps.
std::vector<Polygon> ears(Polygon left) {
  std::vector<Polygon> triangles;
  const auto corner = [&](std::size_t k) { return left[k % left.size()]; };
  const auto is_ear = [&](std::size_t k) {
    const glm::dvec2 a = corner(k);
    const glm::dvec2 b = corner(k + 1);
    const glm::dvec2 c = corner(k + 2);
    return orientation(a, b, c) > 0 && std::none_of(left.begin(), left.end(), [&](glm::dvec2 p) {
             return p != a && p != b && p != c && is_in_triangle(p, a, b, c);
           });
  };
  while (left.size() >= 3) {
    std::size_t k = 0;
    while (k < left.size() && !is_ear(k)) ++k;
    if (k == left.size()) break;
    triangles.push_back({corner(k), corner(k + 1), corner(k + 2)});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>((k + 1) % left.size()));
  }
  return triangles;
}

/// Does b reach more than `limit` to the inner side of every edge of a? The least such reach over the edges
/// of both is how far one must move to come free of the other.
bool reaches_into(const Polygon& a, const Polygon& b, double limit) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const glm::dvec2 p = a[i];
    const glm::dvec2 e = a[(i + 1) % a.size()] - p;
    const double length = glm::length(e);
    double reach = -std::numeric_limits<double>::infinity();
    for (const glm::dvec2 q : b) {
      const glm::dvec2 d = q - p;
      reach = std::max(reach, cross(e, d) / length - kStep * glm::length(d));
    }
    if (!(reach > limit)) return false;  // also where the edge has no length
  }
  return true;
}

}  // namespace

RolledFaces::RolledFaces(const Mesh& mesh)
    : mesh_(mesh),
      limit_(kImpossibleDepth * mesh.mean_edge()),
      flat_(mesh.n_halfedges()),
      size_(mesh.n_faces(), 0),
      parts_(mesh.n_faces()) {
  for (const FaceId f : mesh.faces()) flatten(f);
}

void RolledFaces::flatten(FaceId f) {
  const glm::dvec3 first = mesh_.position(mesh_.first(f));
  glm::dvec3 normal(0);
  glm::dvec3 longest(0);
  for (const HalfedgeId h : mesh_.halfedges(f)) {
    const glm::dvec3 from = mesh_.position(h) - first;
    const glm::dvec3 to = mesh_.position(mesh_.to(h)) - first;
    normal += glm::cross(from, to);
    if (glm::length(to - from) > glm::length(longest)) longest = to - from;
  }
  normal = glm::normalize(normal);
  const glm::dvec3 u = glm::normalize(longest - normal * glm::dot(longest, normal));
  const glm::dvec3 v = glm::cross(normal, u);
  Polygon corners;
  for (const HalfedgeId h : mesh_.halfedges(f)) {
    const glm::dvec3 d = mesh_.position(h) - first;
    flat_[h] = {glm::dot(d, u), glm::dot(d, v)};
    size_[f] = std::max(size_[f], glm::length(d));
    corners.push_back(flat_[h]);
  }
  parts_[f] = is_convex(corners) ? std::vector<Polygon>{corners} : ears(corners);
}

Laid RolledFaces::across(const Laid& here, HalfedgeId h) const {
  const HalfedgeId t = mesh_.twin(h);
  const glm::dvec2 here_from = flat_[h];
  const glm::dvec2 here_to = flat_[mesh_.next(h)];
  const glm::dvec2 there_from = flat_[mesh_.next(t)];
  const glm::dvec2 there_to = flat_[t];
  const glm::dvec2 d = here_to - here_from;
  const glm::dvec2 e = there_to - there_from;
  const glm::dvec2 turn = glm::normalize(glm::dvec2(glm::dot(e, d), cross(e, d)));
  Rigid2 roll{turn.x, turn.y, 0, 0};
  const glm::dvec2 shift = (here_from + here_to) * 0.5 - roll.rotate((there_from + there_to) * 0.5);
  roll.x = shift.x;
  roll.y = shift.y;

  const double sizes = size_[mesh_.face(h)] + size_[mesh_.face(t)];
  const double turn_error = kStep * (1 + sizes / std::min(glm::length(d), glm::length(e)));
  Laid there{here.at * roll, here.turn_error_rad + turn_error, here.shift_error};
  there.shift_error += here.turn_error_rad * glm::length(shift) + turn_error * sizes;
  there.shift_error += kStep * (std::abs(there.at.x) + std::abs(there.at.y) + sizes);
  return there;
}

double RolledFaces::error(FaceId f, const Laid& at) const {
  return at.shift_error + (at.turn_error_rad + kStep) * size_[f] +
         kStep * (std::abs(at.at.x) + std::abs(at.at.y));
}

bool RolledFaces::overlap(FaceId f, const Laid& f_at, FaceId g, const Laid& g_at) const {
  const glm::dvec2 apart(f_at.at.x - g_at.at.x, f_at.at.y - g_at.at.y);
  if (glm::length(apart) > (size_[f] + size_[g]) * 1.001) return false;
  const double limit = limit_ + error(f, f_at) + error(g, g_at);
  const auto placed = [](const Polygon& part, const Rigid2& at) {
    Polygon there;
    for (const glm::dvec2 p : part) there.push_back(at(p));
    return there;
  };
  for (const Polygon& a : parts_[f]) {
    const Polygon here = placed(a, f_at.at);
    for (const Polygon& b : parts_[g]) {
      const Polygon there = placed(b, g_at.at);
      if (reaches_into(here, there, limit) && reaches_into(there, here, limit)) return true;
    }
  }
  return false;
}

}  // namespace netwright::proof
