// Builds the connectivity from a soup and refuses, with one sentence, whatever is not an oriented manifold.
#include "core/mesh/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/error.h"
#include "core/base/predicates.h"

namespace netwright {

namespace {

std::string face_name(int source) { return "face " + std::to_string(source + 1); }

[[noreturn]] void refuse(const std::string& name, const std::string& what) {
  throw Error(ErrorKind::Unfit, (name.empty() ? std::string("The model") : name) + ": " + what);
}

}  // namespace

Mesh::Mesh(const PolygonSoup& soup, const std::vector<bool>& is_flipped, const std::vector<int>& face_source)
    : name_(soup.name), up_axis_(soup.up_axis) {
  if (soup.n_faces() == 0) refuse(name_, "there is no face in it; export the model with its faces.");
  copy_faces(soup, is_flipped, face_source);
  std::vector<int> point_of;  // file's point number of each vertex
  IdVector<VertexId, glm::dvec3> positions;
  std::vector<int> vertex_of(soup.points.size(), -1);
  for (VertexId& v : from_) {
    int& mine = vertex_of[v.index()];
    if (mine < 0) {
      mine = static_cast<int>(point_of.size());
      point_of.push_back(v.value);
      positions.push_back(soup.points[v.index()]);
    }
    v = VertexId(mine);
  }
  positions_ = std::move(positions);
  for (const glm::dvec3& p : positions_) box_.add(p);
  measure_faces();
  pair_halfedges(point_of);
  check_fans(point_of);
  find_components();
  find_border_loops();
  copy_looks(soup);
}

void Mesh::copy_faces(const PolygonSoup& soup, const std::vector<bool>& is_flipped,
                      const std::vector<int>& face_source) {
  for (int f = 0; f < soup.n_faces(); ++f) {
    const auto corners = soup.face(f);
    const int source = face_source.empty() ? f : face_source[static_cast<std::size_t>(f)];
    if (corners.size() < 3)
      refuse(name_, face_name(source) + " has fewer than three corners; delete it in a modelling program.");
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (std::count(corners.begin(), corners.end(), corners[i]) > 1)
        refuse(name_, face_name(source) + " uses point " + std::to_string(corners[i] + 1) +
                          " twice; delete the face or the doubled corner in a modelling program.");
      from_.push_back(VertexId(corners[i]));
      face_.push_back(FaceId(f));
    }
    face_begin_.push_back(static_cast<int>(from_.size()));
    face_source_.push_back(source);
    is_flipped_.push_back(!is_flipped.empty() && is_flipped[static_cast<std::size_t>(f)] ? 1 : 0);
  }
}

void Mesh::copy_looks(const PolygonSoup& soup) {
  materials_ = soup.materials;
  if (soup.corner_uv.size() == from_.size()) uv_ = IdVector<HalfedgeId, glm::dvec2>(soup.corner_uv);
  if (soup.face_material.size() == n_faces()) face_material_ = IdVector<FaceId, int>(soup.face_material);
}

void Mesh::measure_faces() {
  for (const FaceId f : faces()) {
    glm::dvec3 centre(0);
    for (const HalfedgeId h : halfedges(f)) centre += position(h) / static_cast<double>(degree(f));
    glm::dvec3 vector_area(0);
    double size = 0;
    double longest_side = 0;
    for (const HalfedgeId h : halfedges(f)) {
      vector_area += glm::cross(position(h) - centre, position(next(h)) - centre) * 0.5;
      longest_side = std::max(longest_side, glm::length(position(next(h)) - position(h)));
      for (const HalfedgeId k : halfedges(f)) size = std::max(size, glm::length(position(h) - position(k)));
    }
    const double area = glm::length(vector_area);
    if (!(area > kDegenerateHeight * size * size))
      refuse(name_, face_name(face_source_[f]) +
                        " has no area (its corners lie on one line); dissolve it in a modelling program.");
    const glm::dvec3 normal = vector_area / area;
    double off = 0;
    for (const HalfedgeId h : halfedges(f))
      off = std::max(off, std::abs(glm::dot(position(h) - centre, normal)));
    centres_.push_back(centre);
    normals_.push_back(normal);
    areas_.push_back(area);
    sizes_.push_back(size);
    unevenness_.push_back(degree(f) == 3 ? 0 : off / size);
    side_unevenness_.push_back(degree(f) == 3 ? 0 : off / longest_side);
  }
}

void Mesh::pair_halfedges(const std::vector<int>& point_of) {
  struct Side {
    int low, high, halfedge;
    auto operator<=>(const Side&) const = default;
  };
  std::vector<Side> sides;
  sides.reserve(n_halfedges());
  double total = 0;
  for (const HalfedgeId h : halfedges()) {
    const int a = from(h).value;
    const int b = to(h).value;
    sides.push_back({std::min(a, b), std::max(a, b), h.value});
    total += glm::length(position(to(h)) - position(from(h)));
  }
  mean_edge_ = total / static_cast<double>(n_halfedges());
  std::sort(sides.begin(), sides.end());
  twin_.assign(n_halfedges(), HalfedgeId());
  edge_.assign(n_halfedges(), EdgeId());

  const auto edge_name = [&](const Side& s) {
    return "the edge between points " + std::to_string(point_of[static_cast<std::size_t>(s.low)] + 1) +
           " and " + std::to_string(point_of[static_cast<std::size_t>(s.high)] + 1);
  };
  const auto source_name = [&](const Side& s) {
    return std::to_string(face_source_[face_[HalfedgeId(s.halfedge)]] + 1);
  };
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t j = i + 1;
    while (j < sides.size() && sides[j].low == sides[i].low && sides[j].high == sides[i].high) ++j;
    const HalfedgeId h(sides[i].halfedge);
    if (j - i > 2)
      refuse(name_,
             edge_name(sides[i]) + " has " + std::to_string(j - i) + " faces (" + source_name(sides[i]) +
                 ", " + source_name(sides[i + 1]) + ", " + source_name(sides[i + 2]) +
                 (j - i > 3 ? ", …" : "") +
                 "), but paper has two sides of an edge at most; delete the inner or doubled faces in a "
                 "modelling program.");
    if (j - i == 2) {
      const HalfedgeId t(sides[i + 1].halfedge);
      if (from(h) == from(t))
        refuse(name_, "faces " + source_name(sides[i]) + " and " + source_name(sides[i + 1]) +
                          " run the same way along " + edge_name(sides[i]) +
                          "; recalculate the normals in a modelling program.");
      twin_[h] = t;
      twin_[t] = h;
      edge_[t] = EdgeId(edge_halfedge_.size());
    } else {
      ++n_border_edges_;
    }
    edge_[h] = edge_halfedge_.push_back(h);
    i = j;
  }
}

void Mesh::check_fans(const std::vector<int>& point_of) const {
  IdVector<VertexId, int> incident(n_vertices(), 0);
  IdVector<VertexId, HalfedgeId> start(n_vertices());
  for (const HalfedgeId h : halfedges()) {
    ++incident[from(h)];
    if (!start[from(h)].is_valid() || !twin(h).is_valid()) start[from(h)] = h;
  }
  for (const VertexId v : vertices()) {
    int seen = 0;
    HalfedgeId h = start[v];
    do {
      ++seen;
      h = twin(prev(h));
    } while (h.is_valid() && h != start[v]);
    if (seen != incident[v])
      refuse(name_,
             "at point " + std::to_string(point_of[v.index()] + 1) + " (a corner of face " +
                 std::to_string(face_source_[face_[start[v]]] + 1) +
                 ") parts of the model touch in a single point; split the point in a modelling program.");
  }
}

void Mesh::find_components() {
  component_.assign(n_faces(), -1);
  std::vector<FaceId> stack;
  for (const FaceId seed : faces()) {
    if (component_[seed] >= 0) continue;
    component_[seed] = static_cast<int>(n_components_);
    stack.push_back(seed);
    while (!stack.empty()) {
      const FaceId f = stack.back();
      stack.pop_back();
      for (const HalfedgeId h : halfedges(f)) {
        const FaceId g = neighbour(h);
        if (g.is_valid() && component_[g] < 0) {
          component_[g] = component_[f];
          stack.push_back(g);
        }
      }
    }
    ++n_components_;
  }
}

void Mesh::find_border_loops() {
  IdVector<HalfedgeId, char> seen(n_halfedges(), 0);
  for (const HalfedgeId h : halfedges()) {
    if (twin(h).is_valid() || seen[h]) continue;
    ++n_border_loops_;
    HalfedgeId walk = h;
    do {
      seen[walk] = 1;
      walk = next(walk);
      while (twin(walk).is_valid()) walk = next(twin(walk));
    } while (walk != h);
  }
}

int Mesh::genus() const {
  const int euler =
      static_cast<int>(n_vertices()) - static_cast<int>(n_edges()) + static_cast<int>(n_faces());
  return (2 * static_cast<int>(n_components()) - static_cast<int>(n_border_loops()) - euler) / 2;
}

}  // namespace netwright
