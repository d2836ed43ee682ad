// Each uneven face is cut along diagonals that no other face uses, so that the result stays a manifold; where
// there are none, its triangles meet in a new point at its centre.
#include "core/mesh/split_faces.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <set>
#include <utility>

#include "core/base/polygon2.h"
#include "core/base/predicates.h"
#include "core/mesh/polygon_laplacian.h"

namespace netwright {
namespace {

/// Faces are split from this unevenness on. What is only just flat is laid out by projection, which shortens
/// its sides by the square of that; a tenth keeps short sides within what a proof accepts.
constexpr double kSplitFrom = 0.1 * kFlatness;

using Triangles = std::vector<std::array<int, 3>>;  // corner indices within the face

/// How well two triangles of a quad lie in one plane: the cosine between their normals.
double agreement(const std::vector<glm::dvec3>& p, const Triangles& two) {
  std::array<glm::dvec3, 2> normal{};
  for (std::size_t t = 0; t < 2; ++t) {
    const auto at = [&](std::size_t k) { return p[static_cast<std::size_t>(two[t][k])]; };
    normal[t] = glm::cross(at(1) - at(0), at(2) - at(0));
  }
  const double lengths = glm::length(normal[0]) * glm::length(normal[1]);
  return lengths > 0 ? glm::dot(normal[0], normal[1]) / lengths : -1;
}

class FaceSplitter {
 public:
  explicit FaceSplitter(const Mesh& mesh) : mesh_(mesh) {
    for (const HalfedgeId h : mesh.halfedges()) {
      sides_.insert(std::minmax(mesh.from(h).value, mesh.to(h).value));
    }
    copy_what_stays();
    for (const FaceId f : mesh.faces()) {
      if (mesh.side_unevenness(f) > kSplitFrom) {
        split(f);
        ++result_.n_split;
      } else {
        keep(f);
      }
    }
  }
  SplitFaces take() { return std::move(result_); }

 private:
  void copy_what_stays() {
    result_.soup.name = mesh_.name();
    result_.soup.up_axis = mesh_.up_axis();
    result_.soup.materials = mesh_.materials();
    for (const VertexId v : mesh_.vertices()) result_.soup.points.push_back(mesh_.position(v));
  }

  void add(FaceId f, const std::vector<int>& points, const std::vector<glm::dvec2>& uv) {
    result_.soup.add_face(points);
    if (mesh_.has_uv()) {
      result_.soup.corner_uv.insert(result_.soup.corner_uv.end(), uv.begin(), uv.end());
    }
    if (!mesh_.materials().empty()) result_.soup.face_material.push_back(mesh_.material(f));
    result_.split_from.push_back(f);
    result_.is_flipped.push_back(mesh_.is_flipped(f));
    result_.face_source.push_back(result_.soup.n_faces() - 1);
  }

  void read_corners(FaceId f) {
    points_.clear();
    places_.clear();
    uv_.clear();
    for (const HalfedgeId h : mesh_.halfedges(f)) {
      points_.push_back(mesh_.from(h).value);
      places_.push_back(mesh_.position(h));
      uv_.push_back(mesh_.has_uv() ? mesh_.uv(h) : glm::dvec2(0));
    }
  }

  void keep(FaceId f) {
    read_corners(f);
    add(f, points_, uv_);
  }

  void split(FaceId f) {
    read_corners(f);
    for (const Triangles& triangles : ways_to_split()) {
      const auto diagonals = diagonals_of(triangles);
      const bool is_new = std::none_of(diagonals.begin(), diagonals.end(),
                                       [&](const auto& diagonal) { return sides_.contains(diagonal); });
      if (!is_new || !has_area(triangles)) continue;
      sides_.insert(diagonals.begin(), diagonals.end());
      for (const auto& [a, b, c] : triangles) add_triangle(f, a, b, c);
      return;
    }
    split_at_centre(f);
  }

  /// The triangulations to try, the best one first.
  [[nodiscard]] std::vector<Triangles> ways_to_split() const {
    const std::vector<glm::dvec2> flat = frame_of(places_).flat;
    if (!is_simple(flat)) return {};
    const Triangles by_ears = triangulate(flat);
    if (points_.size() != 4 || !is_convex(flat)) return {by_ears};
    const Triangles first{{0, 1, 2}, {0, 2, 3}};
    const Triangles second{{1, 2, 3}, {1, 3, 0}};
    if (agreement(places_, first) >= agreement(places_, second)) return {first, second};
    return {second, first};
  }

  [[nodiscard]] std::vector<std::pair<int, int>> diagonals_of(const Triangles& triangles) const {
    const int n = static_cast<int>(points_.size());
    std::vector<std::pair<int, int>> diagonals;
    for (const auto& triangle : triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        const int a = triangle[i];
        const int b = triangle[(i + 1) % 3];
        if ((a + 1) % n == b || (b + 1) % n == a || a > b) continue;  // a side, or counted from its other end
        diagonals.push_back(
            std::minmax(points_[static_cast<std::size_t>(a)], points_[static_cast<std::size_t>(b)]));
      }
    }
    return diagonals;
  }

  /// False when a triangle is a mere line, as between three corners of a straight run.
  [[nodiscard]] bool has_area(const Triangles& triangles) const {
    return std::all_of(triangles.begin(), triangles.end(), [&](const std::array<int, 3>& t) {
      const auto at = [&](std::size_t k) { return places_[static_cast<std::size_t>(t[k])]; };
      const double twice_area = glm::length(glm::cross(at(1) - at(0), at(2) - at(0)));
      const double longest =
          std::max({glm::distance(at(0), at(1)), glm::distance(at(1), at(2)), glm::distance(at(2), at(0))});
      return twice_area > 4 * kDegenerateHeight * longest * longest;
    });
  }

  void add_triangle(FaceId f, int a, int b, int c) {
    std::vector<int> points;
    std::vector<glm::dvec2> uv;
    for (const int corner : {a, b, c}) {
      points.push_back(points_[static_cast<std::size_t>(corner)]);
      uv.push_back(uv_[static_cast<std::size_t>(corner)]);
    }
    add(f, points, uv);
  }

  void split_at_centre(FaceId f) {
    const double share = 1.0 / static_cast<double>(points_.size());
    glm::dvec2 centre_uv(0);
    for (const glm::dvec2& uv : uv_) centre_uv += uv * share;
    const int centre = static_cast<int>(result_.soup.points.size());
    result_.soup.points.push_back(mesh_.centre(f));
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const std::size_t j = (i + 1) % points_.size();
      add(f, {points_[i], points_[j], centre}, {uv_[i], uv_[j], centre_uv});
    }
  }

  const Mesh& mesh_;
  SplitFaces result_;
  std::set<std::pair<int, int>> sides_;  // pairs of points that a side or a diagonal joins
  std::vector<int> points_;              // the corners of the face at hand
  std::vector<glm::dvec3> places_;
  std::vector<glm::dvec2> uv_;
};

}  // namespace

SplitFaces split_uneven_faces(const Mesh& mesh) { return FaceSplitter(mesh).take(); }

}  // namespace netwright
