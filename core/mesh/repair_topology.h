// What the steps of repair and the report share: the sides of a soup's faces sorted by edge, groups that
// grow together, measures of one face, and a soup being written face by face.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <numeric>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/counted.h"
#include "core/base/geometry.h"
#include "core/mesh/repair.h"
#include "core/mesh/soup.h"

namespace netwright::repair {

/// One side of a face: its two points in order of number, its face, the corner it starts at (an index into
/// soup.corners), and whether it runs from low to high.
struct Side {
  int low;
  int high;
  int face;
  int corner;
  bool is_upward;
};

/// All sides, those of one edge next to each other, by face within an edge.
std::vector<Side> sorted_sides(const PolygonSoup& soup);
void sort_sides(std::vector<Side>& sides);

/// Calls visit(std::span<const Side>) once for each edge.
template <class Visit>
void for_each_edge(std::span<const Side> sides, Visit visit) {
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t j = i + 1;
    while (j < sides.size() && sides[j].low == sides[i].low && sides[j].high == sides[i].high) ++j;
    visit(sides.subspan(i, j - i));
    i = j;
  }
}

/// Two different faces meet there and no third one.
inline bool is_manifold_edge(std::span<const Side> edge) {
  return edge.size() == 2 && edge[0].face != edge[1].face;
}

/// The corner that follows in the face.
inline int next_corner(const PolygonSoup& soup, int face, int corner) {
  const auto f = static_cast<std::size_t>(face);
  return corner + 1 == soup.face_begin[f + 1] ? soup.face_begin[f] : corner + 1;
}
inline const glm::dvec3& corner_point(const PolygonSoup& soup, int corner) {
  return soup.points[static_cast<std::size_t>(soup.corners[static_cast<std::size_t>(corner)])];
}

/// Things that grow together in groups (union by size, paths halved).
class Groups {
 public:
  explicit Groups(std::size_t n) : parent_(n), size_(n, 1) { std::iota(parent_.begin(), parent_.end(), 0); }
  int find(int i) {
    while (at(i) != i) i = at(i) = at(at(i));
    return i;
  }
  /// False when they were one group already.
  bool unite(int a, int b) {
    a = find(a);
    b = find(b);
    if (a == b) return false;
    if (size_[static_cast<std::size_t>(a)] < size_[static_cast<std::size_t>(b)]) std::swap(a, b);
    at(b) = a;
    size_[static_cast<std::size_t>(a)] += size_[static_cast<std::size_t>(b)];
    return true;
  }

 private:
  int& at(int i) { return parent_[static_cast<std::size_t>(i)]; }
  std::vector<int> parent_;
  std::vector<int> size_;
};

/// Groups that also know whether each member agrees with its group's first one or is turned against it.
class TurnedGroups {
 public:
  explicit TurnedGroups(std::size_t n) : parent_(n), size_(n, 1), is_turned_(n, 0) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  struct Place {
    int group;
    bool is_turned;
  };
  Place find(int i);
  /// Puts a and b into one group, b turned against a or not; false when they are in one and disagree.
  bool unite(int a, int b, bool is_turned);

 private:
  std::vector<int> parent_;
  std::vector<int> size_;
  std::vector<char> is_turned_;
};

/// How many points faces use.
int n_used_points(const PolygonSoup& soup);

/// The box around all corners of faces.
Box3 used_box(const PolygonSoup& soup);

/// As Mesh measures it (see there); a face without area has no normal.
struct FaceMeasure {
  glm::dvec3 centre{0};
  glm::dvec3 normal{0};
  double size = 0;
  double unevenness = 0;
  bool has_area = false;
  double side_unevenness = 0;  ///< both as Mesh has them
};
FaceMeasure measure_face(const PolygonSoup& soup, int f);

/// A corner on its own.
struct Corner {
  int point;
  glm::dvec2 uv{0};
};
std::vector<Corner> face_corners(const PolygonSoup& soup, int f);

/// A soup being written, face by face, with the points of another one.
class SoupWriter {
 public:
  explicit SoupWriter(const PolygonSoup& from);
  void copy_face(int f);
  void add_face(std::span<const Corner> corners, int source, int material);
  [[nodiscard]] PolygonSoup& soup() { return result_.soup; }
  /// The result, all of whose corners are joined where they should be.
  [[nodiscard]] Repaired finish(int count, std::string sentence);

 private:
  const PolygonSoup& from_;
  Repaired result_;
};

/// The input as it is: nothing was there to put right.
Repaired unchanged(const PolygonSoup& soup);

/// The soup with its points joined as on opening.
PolygonSoup joined(const PolygonSoup& soup);

/// Joins open edges within the distance, and the ends of sides that are no longer. Returns how many points
/// merged.
int join_points(PolygonSoup& soup, double distance);

/// prepare() of a soup whose faces came from others: the mesh's face_source and is_flipped tell.
PreparedModel prepare_from(const PolygonSoup& soup, const std::vector<int>& face_source,
                           const std::vector<bool>& is_turned);

/// The fans of corners around points: corners at one point that edges of exactly two faces connect.
Groups corner_fans(const PolygonSoup& soup, std::span<const Side> sides);

/// Models whose diagonal is below this lose their size when areas are squared.
inline constexpr double kLeastDiagonal = 1e-75;

/// What prepare() and the report both say.
std::string doubled_points_sentence(int n_merged);
std::string turned_faces_sentence(std::ptrdiff_t n_turned);
/// What repair says when it did it.
std::string turned_sentence(std::ptrdiff_t n_turned);

/// " (36 → 32 faces)"
std::string before_after(int before, int after, const std::string& many);

}  // namespace netwright::repair
