// The nearest point by a tree of boxes, and the Hausdorff distance by branch and bound: a triangle around a
// point at distance d holds nothing further away than d plus its radius, and nothing further than its
// furthest corner is from any one triangle (distance from a convex set is a convex function).
#include "core/mesh/deviation.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

namespace netwright {
namespace {

using Triangle = SurfaceTree::Triangle;

constexpr int kLeaf = 4;
// Bisections after which a measurement ends in any case; ordinary ones need some ten thousand.
constexpr int kMostSplits = 2000000;

double squared(const glm::dvec3& v) { return glm::dot(v, v); }

double squared_distance(const Box3& box, const glm::dvec3& p) {
  return squared(p - glm::clamp(p, box.min, box.max));
}

double distance_to(const Triangle& t, const glm::dvec3& p) {
  return glm::distance(nearest_in_triangle(t, p), p);
}

glm::dvec3 middle(const Triangle& t) { return (t[0] + t[1] + t[2]) / 3.0; }

template <class Face>
std::vector<Triangle> fans(std::size_t n_faces, const Face& corners_of) {
  std::vector<Triangle> triangles;
  for (std::size_t f = 0; f < n_faces; ++f) {
    const std::vector<glm::dvec3> p = corners_of(f);
    for (std::size_t i = 2; i < p.size(); ++i) triangles.push_back({p[0], p[i - 1], p[i]});
  }
  return triangles;
}

std::vector<Triangle> triangles_of(const Mesh& mesh) {
  return fans(mesh.n_faces(), [&](std::size_t f) {
    std::vector<glm::dvec3> p;
    for (const HalfedgeId h : mesh.halfedges(FaceId(f))) p.push_back(mesh.position(h));
    return p;
  });
}

std::vector<Triangle> triangles_of(const PolygonSoup& soup) {
  return fans(static_cast<std::size_t>(soup.n_faces()), [&](std::size_t f) {
    std::vector<glm::dvec3> p;
    for (const int i : soup.face(static_cast<int>(f))) p.push_back(soup.points[static_cast<std::size_t>(i)]);
    return p;
  });
}

/// One direction of the Hausdorff distance.
class Measurement {
 public:
  Measurement(const SurfaceTree& b, double slack, const Progress* progress)
      : b_(b), slack_(slack), progress_(progress) {}

  double run(std::span<const Triangle> triangles) {
    for (const Triangle& t : triangles) {
      for (const glm::dvec3& p : t) look_at(p);
      look_at(middle(t));
    }
    for (const Triangle& t : triangles) {
      parts_.push_back({t, guess_});
      while (!parts_.empty()) examine();
      if (progress_ != nullptr && progress_->is_cancelled()) break;
    }
    return worst_;
  }

 private:
  struct Part {
    Triangle triangle;
    int guess;
  };

  void look_at(const glm::dvec3& p) {
    const SurfaceTree::Hit hit = b_.nearest(p, guess_, worst_);
    guess_ = hit.triangle;
    worst_ = std::max(worst_, hit.distance);
  }

  void examine() {
    const Part part = parts_.back();
    parts_.pop_back();
    const Triangle& t = part.triangle;
    const glm::dvec3 m = middle(t);
    const double radius = std::sqrt(std::max({squared(t[0] - m), squared(t[1] - m), squared(t[2] - m)}));
    const double limit = std::max(1.02 * worst_, worst_ + slack_);
    const SurfaceTree::Hit hit = b_.nearest(m, part.guess, limit - radius);
    guess_ = hit.triangle;
    if (hit.distance + radius <= limit) return;
    worst_ = std::max(worst_, hit.distance);
    const Triangle& near = b_.triangles()[static_cast<std::size_t>(hit.triangle)];
    if (std::max({distance_to(near, t[0]), distance_to(near, t[1]), distance_to(near, t[2])}) <= limit)
      return;
    if (n_splits_ < kMostSplits) split(t, hit.triangle);
  }

  void split(const Triangle& t, int guess) {
    ++n_splits_;
    std::size_t k = 0;  // the longest side runs from k to k + 1
    for (std::size_t i = 1; i < 3; ++i)
      if (squared(t[(i + 1) % 3] - t[i]) > squared(t[(k + 1) % 3] - t[k])) k = i;
    const glm::dvec3 half = (t[k] + t[(k + 1) % 3]) / 2.0;
    const glm::dvec3 tip = t[(k + 2) % 3];
    look_at(half);
    parts_.push_back({{t[k], half, tip}, guess});
    parts_.push_back({{half, t[(k + 1) % 3], tip}, guess});
  }

  const SurfaceTree& b_;
  double slack_;
  const Progress* progress_;  ///< null: to the end
  double worst_ = 0;
  int guess_ = -1;
  int n_splits_ = 0;
  std::vector<Part> parts_;
};

}  // namespace

// By the regions of the plane that the point projects to (C. Ericson, Real-Time Collision Detection,
// 2005, 5.1.5).
glm::dvec3 nearest_in_triangle(const Triangle& t, const glm::dvec3& p) {
  const glm::dvec3 ab = t[1] - t[0];
  const glm::dvec3 ac = t[2] - t[0];
  const double d1 = glm::dot(ab, p - t[0]);
  const double d2 = glm::dot(ac, p - t[0]);
  if (d1 <= 0 && d2 <= 0) return t[0];
  const double d3 = glm::dot(ab, p - t[1]);
  const double d4 = glm::dot(ac, p - t[1]);
  if (d3 >= 0 && d4 <= d3) return t[1];
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return t[0] + ab * (d1 / (d1 - d3));
  const double d5 = glm::dot(ab, p - t[2]);
  const double d6 = glm::dot(ac, p - t[2]);
  if (d6 >= 0 && d5 <= d6) return t[2];
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return t[0] + ac * (d2 / (d2 - d6));
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
    return t[1] + (t[2] - t[1]) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
  const double whole = va + vb + vc;
  return t[0] + ab * (vb / whole) + ac * (vc / whole);
}

SurfaceTree::SurfaceTree(const Mesh& mesh) : SurfaceTree(triangles_of(mesh)) {}

SurfaceTree::SurfaceTree(const PolygonSoup& soup) : SurfaceTree(triangles_of(soup)) {}

SurfaceTree::SurfaceTree(std::vector<Triangle> triangles) : triangles_(std::move(triangles)) {
  std::vector<int> order(triangles_.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  nodes_.reserve(triangles_.size() + 1);
  nodes_.emplace_back();
  build(0, 0, static_cast<int>(order.size()), order);
  std::vector<Triangle> sorted;
  sorted.reserve(triangles_.size());
  for (const int i : order) sorted.push_back(triangles_[static_cast<std::size_t>(i)]);
  triangles_ = std::move(sorted);
}

void SurfaceTree::build(std::size_t node, int begin, int end, std::vector<int>& order) {
  Box3 middles;
  for (int i = begin; i < end; ++i) {
    const Triangle& t = triangles_[static_cast<std::size_t>(order[static_cast<std::size_t>(i)])];
    for (const glm::dvec3& p : t) nodes_[node].box.add(p);
    middles.add(middle(t));
  }
  if (end - begin <= kLeaf) {
    nodes_[node].begin = begin;
    nodes_[node].end = end;
    return;
  }
  const glm::dvec3 size = middles.size();
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
  const int half = begin + (end - begin) / 2;
  std::nth_element(order.begin() + begin, order.begin() + half, order.begin() + end, [&](int i, int j) {
    const double a = middle(triangles_[static_cast<std::size_t>(i)])[axis];
    const double b = middle(triangles_[static_cast<std::size_t>(j)])[axis];
    return a < b || (a == b && i < j);
  });
  const std::size_t child = nodes_.size();
  nodes_[node].begin = static_cast<int>(child);
  nodes_.emplace_back();
  nodes_.emplace_back();
  build(child, begin, half, order);
  build(child + 1, half, end, order);
}

SurfaceTree::Hit SurfaceTree::nearest(const glm::dvec3& p, int guess, double enough) const {
  Hit best{guess, std::numeric_limits<double>::infinity()};
  double least = std::numeric_limits<double>::infinity();  // squared, like `stop`
  const double stop = enough > 0 ? enough * enough : 0;
  if (guess >= 0) least = squared(nearest_in_triangle(triangles_[static_cast<std::size_t>(guess)], p) - p);
  std::array<std::pair<int, double>, 64> stack{};  // the tree is balanced: its depth is a logarithm
  std::size_t n = 0;
  stack[n++] = {0, 0.0};
  while (n > 0 && least > stop) {
    const auto [at, away] = stack[--n];
    if (away >= least) continue;
    const Node& node = nodes_[static_cast<std::size_t>(at)];
    for (int i = node.begin; i < node.end; ++i) {
      const double d = squared(nearest_in_triangle(triangles_[static_cast<std::size_t>(i)], p) - p);
      if (d >= least) continue;
      least = d;
      best.triangle = i;
    }
    if (node.end > 0) continue;
    const double left = squared_distance(nodes_[static_cast<std::size_t>(node.begin)].box, p);
    const double right = squared_distance(nodes_[static_cast<std::size_t>(node.begin + 1)].box, p);
    const bool left_first = left <= right;
    stack[n++] = {left_first ? node.begin + 1 : node.begin, std::max(left, right)};
    stack[n++] = {left_first ? node.begin : node.begin + 1, std::min(left, right)};
  }
  best.distance = std::sqrt(least);
  return best;
}

double distance_from(const SurfaceTree& a, const SurfaceTree& b, double tolerance) {
  return Measurement(b, tolerance * a.box().diagonal(), nullptr).run(a.triangles());
}

double hausdorff_distance(const SurfaceTree& a, const SurfaceTree& b, double tolerance) {
  return std::max(distance_from(a, b, tolerance), distance_from(b, a, tolerance));
}

double hausdorff_distance(const SurfaceTree& a, const SurfaceTree& b, const Progress& progress) {
  const auto one_way = [&](const SurfaceTree& from, const SurfaceTree& to) {
    const double slack = kDeviationTolerance * from.box().diagonal();
    return progress.is_cancelled() ? 0 : Measurement(to, slack, &progress).run(from.triangles());
  };
  const double there = one_way(a, b);
  return std::max(there, one_way(b, a));
}

}  // namespace netwright
