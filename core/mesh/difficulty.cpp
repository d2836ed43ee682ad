// Gathers what makes nets overlap: faces around a point that together have more than a full turn, folds that
// close in on each other, and long faces beside short ones. The weights come from a least-squares fit.
#include "core/mesh/difficulty.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace netwright {
namespace {

constexpr double kFullTurn = 6.283185307179586;
// A fold bent inward by less than this (radians, a good degree) is as good as flat.
constexpr double kValley = 0.02;

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// Sum over all inner points of how much more than a full turn the corners around them have.
double negative_curvature(const Mesh& mesh) {
  IdVector<VertexId, double> turn(mesh.n_vertices(), 0);
  for (const HalfedgeId h : mesh.halfedges())
    turn[mesh.from(h)] += angle_between(mesh.position(mesh.to(h)) - mesh.position(h),
                                        mesh.position(mesh.prev(h)) - mesh.position(h));
  for (const EdgeId e : mesh.edges()) {
    if (!mesh.is_border(e)) continue;
    turn[mesh.from(mesh.halfedge(e))] = 0;
    turn[mesh.to(mesh.halfedge(e))] = 0;
  }
  double sum = 0;
  for (const double t : turn) sum += std::max(0.0, t - kFullTurn);
  return sum;
}

struct Folds {
  double n_valleys = 0;
  double bend = 0;    ///< sum of all, radians
  double uneven = 0;  ///< standard deviation of the lengths over their mean
};

Folds measure_folds(const Mesh& mesh) {
  Folds folds;
  double lengths = 0;
  double squares = 0;
  for (const EdgeId e : mesh.edges()) {
    lengths += mesh.length(e);
    squares += mesh.length(e) * mesh.length(e);
    const HalfedgeId h = mesh.halfedge(e);
    if (mesh.is_border(e)) continue;
    const FaceId f = mesh.face(h);
    const FaceId g = mesh.neighbour(h);
    const double bend = angle_between(mesh.normal(f), mesh.normal(g));
    folds.bend += bend;
    const bool is_valley = glm::dot(mesh.centre(g) - mesh.centre(f), mesh.normal(f)) > 0;
    if (is_valley && bend > kValley) ++folds.n_valleys;
  }
  const auto n = static_cast<double>(mesh.n_edges());
  folds.uneven = std::sqrt(std::max(0.0, n * squares / (lengths * lengths) - 1));
  return folds;
}

}  // namespace

double predicted_difficulty(const Mesh& mesh) {
  const Folds folds = measure_folds(mesh);
  const double log_moves = -4.616 + 1.258 * std::log(static_cast<double>(mesh.n_faces())) +
                           0.239 * std::log1p(negative_curvature(mesh)) +
                           0.508 * std::log1p(folds.n_valleys) + 0.513 * folds.uneven -
                           0.604 * std::log1p(folds.bend);
  return std::max(0.0, std::expm1(log_moves));
}

}  // namespace netwright
