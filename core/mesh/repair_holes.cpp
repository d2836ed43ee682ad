// Fills borders: a flat one with a single face, others with the triangles that bend least (the dynamic
// programme of P. Liepa, "Filling Holes in Meshes", 2003: smallest largest bend, then smallest area), never
// with an edge that the model has already.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>
#include <unordered_set>

#include "core/base/polygon2.h"
#include "core/base/predicates.h"
#include "core/mesh/repair.h"
#include "core/mesh/repair_topology.h"

namespace netwright {
namespace {

using repair::Corner;
using repair::Side;

/// A border seen from the hole: its corners in the order of the face that would fill it, and the face beyond
/// each side, which leads from its corner to the next.
struct Hole {
  std::vector<Corner> corners;
  std::vector<int> neighbours;
};

std::uint64_t edge_key(int a, int b) {
  return static_cast<std::uint64_t>(static_cast<std::uint32_t>(std::min(a, b))) << 32 |
         static_cast<std::uint32_t>(std::max(a, b));
}

/// The borders that can be walked around: at each of their points one border side ends and one begins.
std::vector<Hole> find_holes(const PolygonSoup& soup, const std::vector<Side>& sides) {
  constexpr int kNone = -1;
  constexpr int kSeveral = -2;
  std::vector<int> leaving(soup.points.size(), kNone);
  std::vector<Side> border;
  repair::for_each_edge(sides, [&](std::span<const Side> edge) {
    if (edge.size() != 1) return;
    int& mine = leaving[static_cast<std::size_t>(edge[0].is_upward ? edge[0].low : edge[0].high)];
    mine = mine == kNone ? static_cast<int>(border.size()) : kSeveral;
    border.push_back(edge[0]);
  });
  std::vector<Hole> holes;
  std::vector<char> is_seen(border.size(), 0);
  for (std::size_t start = 0; start < border.size(); ++start) {
    Hole hole;
    auto at = start;
    while (is_seen[at] == 0) {
      is_seen[at] = 1;
      const Side& side = border[at];
      const int end_corner = repair::next_corner(soup, side.face, side.corner);
      const int end = soup.corners[static_cast<std::size_t>(end_corner)];
      hole.corners.push_back({end, soup.corner_uv.empty()
                                       ? glm::dvec2(0)
                                       : soup.corner_uv[static_cast<std::size_t>(end_corner)]});
      hole.neighbours.push_back(side.face);
      const int next = leaving[static_cast<std::size_t>(end)];
      if (next < 0) break;
      at = static_cast<std::size_t>(next);
    }
    if (at != start || hole.corners.size() < 3) continue;
    // The filling face runs the other way: from the end of each border side to its start.
    std::ranges::reverse(hole.corners);
    std::ranges::reverse(hole.neighbours);
    holes.push_back(std::move(hole));
  }
  return holes;
}

class Filler {
 public:
  explicit Filler(const PolygonSoup& soup) : soup_(soup), writer_(soup) {
    const std::vector<Side> sides = repair::sorted_sides(soup);
    for (const Side& side : sides) edges_.insert(edge_key(side.low, side.high));
    for (int f = 0; f < soup.n_faces(); ++f) writer_.copy_face(f);
    measure_parts(sides);
  }

  bool fill(const Hole& hole) {
    if (is_whole_outline(hole)) return false;
    if (fill_flat(hole) || fill_bending_least(hole)) return true;
    return fill_with_fan(hole);
  }

  [[nodiscard]] repair::SoupWriter& writer() { return writer_; }

 private:
  // The work grows with the cube of the corners; larger borders get a point in the middle.
  static constexpr std::size_t kMostCorners = 200;

  [[nodiscard]] glm::dvec3 at(const Corner& c) const {
    return soup_.points[static_cast<std::size_t>(c.point)];
  }
  [[nodiscard]] glm::dvec3 normal_beyond(const Hole& hole, std::size_t side) const {
    return repair::measure_face(soup_, hole.neighbours[side]).normal;
  }

  void measure_parts(const std::vector<Side>& sides) {
    repair::Groups parts(static_cast<std::size_t>(soup_.n_faces()));
    repair::for_each_edge(std::span<const Side>(sides), [&](std::span<const Side> edge) {
      for (const Side& side : edge) parts.unite(edge[0].face, side.face);
    });
    std::vector<double> area(static_cast<std::size_t>(soup_.n_faces()), 0);
    for (int f = 0; f < soup_.n_faces(); ++f) {
      area[static_cast<std::size_t>(parts.find(f))] +=
          glm::length(vector_area(repair::face_corners(soup_, f)));
    }
    for (int f = 0; f < soup_.n_faces(); ++f)
      part_area_.push_back(area[static_cast<std::size_t>(parts.find(f))]);
  }

  [[nodiscard]] glm::dvec3 vector_area(const std::vector<Corner>& corners) const {
    glm::dvec3 sum(0);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
      sum += 0.5 * glm::cross(at(corners[i]) - at(corners[0]), at(corners[i + 1]) - at(corners[0]));
    return sum;
  }

  /// The outer border of a flat part is no hole: its filling would lie on the part itself.
  [[nodiscard]] bool is_whole_outline(const Hole& hole) const {
    constexpr double kSlack = 1e-6;
    return part_area_[static_cast<std::size_t>(hole.neighbours[0])] <=
           glm::length(vector_area(hole.corners)) * (1 + kSlack);
  }

  [[nodiscard]] int material(const Hole& hole) const {
    return soup_.face_material.empty() ? -1
                                       : soup_.face_material[static_cast<std::size_t>(hole.neighbours[0])];
  }

  bool fill_flat(const Hole& hole) {
    PolygonSoup face;
    std::vector<int> corners;
    for (const Corner& c : hole.corners) {
      corners.push_back(static_cast<int>(face.points.size()));
      face.points.push_back(at(c));
    }
    face.add_face(corners);
    const repair::FaceMeasure measure = repair::measure_face(face, 0);
    if (!measure.has_area || measure.side_unevenness > kFlatness) return false;
    const glm::dvec3 x =
        glm::normalize(face.points[1] - face.points[0] -
                       measure.normal * glm::dot(face.points[1] - face.points[0], measure.normal));
    const glm::dvec3 y = glm::cross(measure.normal, x);
    std::vector<glm::dvec2> outline;
    for (const glm::dvec3& p : face.points)
      outline.emplace_back(glm::dot(p - measure.centre, x), glm::dot(p - measure.centre, y));
    if (!is_simple(outline)) return false;
    writer_.add_face(hole.corners, -1, material(hole));
    return true;
  }

  /// How good a filling of the chain i … k is: its largest bend (1 - cosine), then its area.
  struct Cost {
    double bend = 0;
    double area = 0;
    auto operator<=>(const Cost&) const = default;
  };
  struct Cell {
    Cost cost{std::numeric_limits<double>::infinity(), 0};
    std::size_t middle = 0;
    glm::dvec3 normal{0};
  };

  bool fill_bending_least(const Hole& hole) {
    const std::size_t n = hole.corners.size();
    if (n > kMostCorners) return false;
    std::vector<Cell> cells(n * n);
    for (std::size_t i = 0; i + 1 < n; ++i) {
      cells[i * n + i + 1] = {{}, i, normal_beyond(hole, i)};
    }
    const glm::dvec3 last = normal_beyond(hole, n - 1);
    for (std::size_t length = 2; length < n; ++length) {
      for (std::size_t i = 0; i + length < n; ++i) {
        const std::size_t k = i + length;
        const bool is_last = length == n - 1;
        if (!is_last && edges_.contains(edge_key(hole.corners[i].point, hole.corners[k].point))) continue;
        for (std::size_t m = i + 1; m < k; ++m)
          try_triangle(hole, cells, {i, m, k}, is_last ? &last : nullptr);
      }
    }
    if (!(cells[n - 1].cost.bend <= 2)) return false;
    add_triangles(hole, cells);
    return true;
  }

  void try_triangle(const Hole& hole, std::vector<Cell>& cells, std::array<std::size_t, 3> t,
                    const glm::dvec3* beyond) const {
    const std::size_t n = hole.corners.size();
    const auto [i, m, k] = t;
    const Cell& left = cells[i * n + m];
    const Cell& right = cells[m * n + k];
    const glm::dvec3 p = at(hole.corners[i]);
    const glm::dvec3 normal = glm::cross(at(hole.corners[m]) - p, at(hole.corners[k]) - p);
    const double twice_area = glm::length(normal);
    const double span = std::max(glm::length(at(hole.corners[m]) - p), glm::length(at(hole.corners[k]) - p));
    if (!(twice_area > 1e-6 * span * span)) return;
    const glm::dvec3 unit = normal / twice_area;
    Cost cost{std::max({left.cost.bend, right.cost.bend, 1 - glm::dot(unit, left.normal),
                        1 - glm::dot(unit, right.normal)}),
              left.cost.area + right.cost.area + 0.5 * twice_area};
    if (beyond != nullptr) cost.bend = std::max(cost.bend, 1 - glm::dot(unit, *beyond));
    Cell& cell = cells[i * n + k];
    if (cost < cell.cost) cell = {cost, m, unit};
  }

  void add_triangles(const Hole& hole, const std::vector<Cell>& cells) {
    std::vector<std::array<std::size_t, 2>> stack{{0, hole.corners.size() - 1}};
    while (!stack.empty()) {
      const auto [a, b] = stack.back();
      stack.pop_back();
      if (b == a + 1) continue;
      const std::size_t m = cells[a * hole.corners.size() + b].middle;
      writer_.add_face(std::array{hole.corners[a], hole.corners[m], hole.corners[b]}, -1, material(hole));
      edges_.insert(edge_key(hole.corners[a].point, hole.corners[b].point));
      stack.push_back({a, m});
      stack.push_back({m, b});
    }
  }

  bool fill_with_fan(const Hole& hole) {
    Corner middle{static_cast<int>(writer_.soup().points.size())};
    glm::dvec3 centre(0);
    const auto n = static_cast<double>(hole.corners.size());
    for (const Corner& c : hole.corners) {
      centre += at(c) / n;
      middle.uv += c.uv / n;
    }
    for (std::size_t i = 0; i < hole.corners.size(); ++i) {
      const glm::dvec3 p = at(hole.corners[i]) - centre;
      const glm::dvec3 q = at(hole.corners[(i + 1) % hole.corners.size()]) - centre;
      if (!(glm::length(glm::cross(p, q)) > 1e-6 * std::max(glm::dot(p, p), glm::dot(q, q)))) return false;
    }
    writer_.soup().points.push_back(centre);
    for (std::size_t i = 0; i < hole.corners.size(); ++i) {
      writer_.add_face(std::array{hole.corners[i], hole.corners[(i + 1) % hole.corners.size()], middle}, -1,
                       material(hole));
    }
    return true;
  }

  const PolygonSoup& soup_;
  repair::SoupWriter writer_;
  std::unordered_set<std::uint64_t> edges_;
  std::vector<double> part_area_;
};

}  // namespace

std::vector<int> hole_sizes(const PolygonSoup& soup) {
  const PolygonSoup work = repair::joined(soup);
  std::vector<int> sizes;
  for (const Hole& hole : find_holes(work, repair::sorted_sides(work)))
    sizes.push_back(static_cast<int>(hole.corners.size()));
  std::ranges::sort(sizes);
  return sizes;
}

Repaired close_holes(const PolygonSoup& soup, int max_edges) {
  const PolygonSoup work = repair::joined(soup);
  const std::vector<Hole> holes = find_holes(work, repair::sorted_sides(work));
  Filler filler(work);
  int n_closed = 0;
  for (const Hole& hole : holes) {
    if (hole.corners.size() <= static_cast<std::size_t>(std::max(max_edges, 0)) && filler.fill(hole))
      ++n_closed;
  }
  if (n_closed == 0) return repair::unchanged(soup);
  const auto n_holes = static_cast<int>(holes.size());
  const int n_new = filler.writer().soup().n_faces() - work.n_faces();
  return filler.writer().finish(n_closed, "Closed " + counted(n_closed, "hole", "holes") + " with " +
                                              counted(n_new, "new face", "new faces") +
                                              repair::before_after(n_holes, n_holes - n_closed, "borders") +
                                              ".");
}

}  // namespace netwright
