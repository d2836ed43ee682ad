// Flattens every face into a frame of its own and works out how each neighbour unrolls across a hinge.
#include "core/mesh/dual_graph.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/base/error.h"
#include "core/base/polygon2.h"
#include "core/base/predicates.h"

namespace netwright {

namespace {

// Faces folded over onto each other (179.9 degrees and more) turn up as mountain or valley by rounding alone.
constexpr double kDoubledOver = 3.1398472;

// Is the neighbour's centre strictly below the face's plane? Newell's sum on the raw coordinates keeps exact
// zeros zero.
bool lies_below(const Mesh& m, HalfedgeId h) {
  glm::dvec3 normal(0);
  for (const HalfedgeId k : m.halfedges(m.face(h))) {
    const glm::dvec3 a = m.position(m.prev(k));
    const glm::dvec3 b = m.position(k);
    normal += glm::dvec3((a.y - b.y) * (a.z + b.z), (a.z - b.z) * (a.x + b.x), (a.x - b.x) * (a.y + b.y));
  }
  return glm::dot(m.centre(m.neighbour(h)) - m.position(m.to(h)), normal) < 0;
}

}  // namespace

DualGraph::DualGraph(std::shared_ptr<const Mesh> mesh, const std::vector<EdgeId>& hidden)
    : mesh_(std::move(mesh)), is_hidden_(mesh_->n_edges(), 0) {
  for (const EdgeId e : hidden) is_hidden_[e] = 1;
  flatten_faces();
  split_faces();
  place_hinges();
}

void DualGraph::flatten_faces() {
  const Mesh& m = *mesh_;
  flat_.assign(m.n_halfedges(), glm::dvec2(0));
  for (const FaceId f : m.faces()) {
    if (m.side_unevenness(f) > kFlatness) {
      char text[160];
      std::snprintf(text, sizeof text,
                    "face %d is not flat (a corner is off its plane by %.2g %% of its size)",
                    m.face_source(f) + 1, 100 * m.unevenness(f));
      throw Error(ErrorKind::Unfit, (m.name().empty() ? std::string("The model") : m.name()) + ": " + text +
                                        "; triangulate the face in a modelling program.");
    }
    // The longest side is the best known direction in the face's plane.
    glm::dvec3 side(0);
    for (const HalfedgeId h : m.halfedges(f)) {
      const glm::dvec3 candidate = m.position(m.to(h)) - m.position(h);
      if (glm::length(candidate) > glm::length(side)) side = candidate;
    }
    const glm::dvec3 n = m.normal(f);
    const glm::dvec3 u = glm::normalize(side - n * glm::dot(side, n));
    const glm::dvec3 v = glm::cross(n, u);
    for (const HalfedgeId h : m.halfedges(f)) {
      const glm::dvec3 d = m.position(h) - m.centre(f);
      flat_[h] = {glm::dot(d, u), glm::dot(d, v)};
    }
  }
}

void DualGraph::split_faces() {
  const Mesh& m = *mesh_;
  std::vector<glm::dvec2> corners;
  for (const FaceId f : m.faces()) {
    corners.clear();
    for (const HalfedgeId h : m.halfedges(f)) corners.push_back(flat_[h]);
    if (corners.size() > 3 && !is_convex(corners) && !is_simple(corners))
      throw Error(ErrorKind::Unfit, (m.name().empty() ? std::string("The model") : m.name()) +
                                        ": the outline of face " + std::to_string(m.face_source(f) + 1) +
                                        " crosses or touches itself; split the face in a modelling program.");
    for (const auto& part : convex_parts(corners)) {
      part_corners_.insert(part_corners_.end(), part.begin(), part.end());
      part_corner_begin_.push_back(static_cast<int>(part_corners_.size()));
    }
    part_begin_.push_back(static_cast<int>(part_corner_begin_.size()) - 1);
  }
}

void DualGraph::place_hinges() {
  const Mesh& m = *mesh_;
  unroll_.assign(m.n_halfedges(), Rigid2());
  bend_.assign(m.n_edges(), 0);
  std::size_t interior = 0;
  for (const HalfedgeId h : m.halfedges()) {
    const HalfedgeId t = m.twin(h);
    if (!t.is_valid()) continue;
    ++interior;
    const glm::dvec2 from_here = flat_[h];
    const glm::dvec2 to_here = flat_[m.next(h)];
    const glm::dvec2 from_there = flat_[m.next(t)];
    const glm::dvec2 to_there = flat_[t];
    const glm::dvec2 d = to_here - from_here;
    const glm::dvec2 e = to_there - from_there;
    const double size = glm::length(d) * glm::length(e);
    const Rigid2 turn{glm::dot(e, d) / size, cross(e, d) / size, 0, 0};
    const glm::dvec2 shift = (from_here + to_here) * 0.5 - turn.rotate((from_there + to_there) * 0.5);
    unroll_[h] = {turn.cos, turn.sin, shift.x, shift.y};

    const glm::dvec3 n = m.normal(m.face(h));
    const glm::dvec3 k = m.normal(m.face(t));
    const glm::dvec3 along = glm::normalize(m.position(m.to(h)) - m.position(h));
    double& bend = bend_[m.edge(h)];
    bend = std::atan2(glm::dot(glm::cross(n, k), along), glm::dot(n, k));
    if (std::abs(bend) > kDoubledOver)
      bend = lies_below(m, m.halfedge(m.edge(h))) ? std::abs(bend) : -std::abs(bend);
  }
  mean_valence_ = static_cast<double>(interior) / static_cast<double>(m.n_faces());
}

}  // namespace netwright
