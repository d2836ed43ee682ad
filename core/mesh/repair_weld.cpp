// Joins points: hashes them into cells to learn which lie at one place, then lets those places become one
// point where faces meet along an edge. Parts that merely touch at a point or edge stay apart.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <map>
#include <unordered_map>

#include "core/base/predicates.h"
#include "core/mesh/repair.h"
#include "core/mesh/repair_topology.h"

namespace netwright {
namespace {

using repair::Side;

/// Finds the first point seen within a distance of another, among those asked for so far.
class PointFinder {
 public:
  PointFinder(const std::vector<glm::dvec3>& points, const Box3& box, double distance)
      : points_(points), origin_(box.min), distance_(distance) {}

  int first_near(int point) {
    const glm::dvec3 p = points_[static_cast<std::size_t>(point)];
    if (distance_ <= 0) return exact_.try_emplace({p.x + 0.0, p.y + 0.0, p.z + 0.0}, point).first->second;
    const Cell cell = cell_of(p);
    for (const int offset : kNeighbours) {
      const Cell other{cell[0] + offset % 3 - 1, cell[1] + offset / 3 % 3 - 1, cell[2] + offset / 9 - 1};
      const auto found = cells_.find(other);
      if (found == cells_.end()) continue;
      for (const int candidate : found->second) {
        if (glm::length(points_[static_cast<std::size_t>(candidate)] - p) <= distance_) return candidate;
      }
    }
    cells_[cell].push_back(point);
    return point;
  }

 private:
  using Cell = std::array<std::int64_t, 3>;
  struct Hash {
    std::size_t operator()(const Cell& cell) const {
      std::uint64_t h = 0;
      for (const std::int64_t x : cell) h = (h ^ static_cast<std::uint64_t>(x)) * 0x9E3779B97F4A7C15ULL;
      return static_cast<std::size_t>(h ^ (h >> 32));
    }
  };
  // The own cell (13) first: that is where an equal point nearly always is.
  static constexpr std::array<int, 27> kNeighbours{13, 0,  1,  2,  3,  4,  5,  6,  7,  8,  9,  10, 11, 12,
                                                   14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26};

  [[nodiscard]] Cell cell_of(glm::dvec3 p) const {
    const glm::dvec3 q = (p - origin_) / distance_;
    return {static_cast<std::int64_t>(q.x), static_cast<std::int64_t>(q.y), static_cast<std::int64_t>(q.z)};
  }

  const std::vector<glm::dvec3>& points_;
  glm::dvec3 origin_;
  double distance_;
  std::map<std::array<double, 3>, int> exact_;
  std::unordered_map<Cell, std::vector<int>, Hash> cells_;
};

/// Per point: the first point at its place (itself where no face uses it).
std::vector<int> find_places(const PolygonSoup& soup, double distance) {
  const Box3 box = repair::used_box(soup);
  constexpr double kFinestCells = 1e-15;  // of the diagonal; cells are counted in 64 bits
  PointFinder finder(soup.points, box, distance > kFinestCells * box.diagonal() ? distance : 0);
  std::vector<int> place(soup.points.size(), -1);
  for (const int corner : soup.corners) {
    int& mine = place[static_cast<std::size_t>(corner)];
    if (mine < 0) mine = finder.first_near(corner);
  }
  return place;
}

/// Per corner: no other face uses the side that starts there.
std::vector<bool> find_open_sides(const PolygonSoup& soup) {
  std::vector<bool> is_open(soup.corners.size(), false);
  const std::vector<Side> sides = repair::sorted_sides(soup);
  repair::for_each_edge(sides, [&](std::span<const Side> edge) {
    if (edge.size() == 1) is_open[static_cast<std::size_t>(edge[0].corner)] = true;
  });
  return is_open;
}

/// The soup's sides between places instead of points.
std::vector<Side> sides_between_places(const PolygonSoup& soup, const std::vector<int>& place) {
  PolygonSoup placed;
  placed.face_begin = soup.face_begin;
  placed.corners.reserve(soup.corners.size());
  for (const int corner : soup.corners) placed.corners.push_back(place[static_cast<std::size_t>(corner)]);
  return repair::sorted_sides(placed);
}

/// Which points become one.
repair::Groups group_points(const PolygonSoup& soup, const std::vector<int>& place) {
  repair::Groups groups(soup.points.size());
  const std::vector<bool> is_open = find_open_sides(soup);
  const auto point = [&](int corner) { return soup.corners[static_cast<std::size_t>(corner)]; };
  const std::vector<Side> sides = sides_between_places(soup, place);
  repair::for_each_edge(sides, [&](std::span<const Side> edge) {
    const auto ends = [&](const Side& side) {
      std::array both{point(side.corner), point(repair::next_corner(soup, side.face, side.corner))};
      if (place[static_cast<std::size_t>(both[0])] != side.low) std::swap(both[0], both[1]);
      return both;
    };
    if (edge[0].low == edge[0].high) {
      for (const Side& side : edge) groups.unite(ends(side)[0], ends(side)[1]);
      return;
    }
    const auto is_open_side = [&](const Side& s) { return is_open[static_cast<std::size_t>(s.corner)]; };
    const auto n_open = std::ranges::count_if(edge, is_open_side);
    // A loose face on a closed edge belongs there, unless a repair took it off.
    const bool joins_all = n_open > 0 && edge.size() > 2 && !soup.is_joined;
    if (!joins_all && n_open < 2) return;
    const Side* first = nullptr;
    for (const Side& side : edge) {
      if (!joins_all && !is_open_side(side)) continue;
      if (first == nullptr) first = &side;
      for (const std::size_t end : {0U, 1U}) groups.unite(ends(*first)[end], ends(side)[end]);
    }
  });
  return groups;
}

}  // namespace

int repair::join_points(PolygonSoup& soup, double distance) {
  const std::vector<int> place = find_places(soup, distance);
  Groups groups = group_points(soup, place);
  std::vector<int> first_of_group(soup.points.size(), -1);
  std::vector<char> is_merged(soup.points.size(), 0);
  int n_merged = 0;
  for (int& corner : soup.corners) {
    int& first = first_of_group[static_cast<std::size_t>(groups.find(corner))];
    if (first < 0) first = corner;
    char& mark = is_merged[static_cast<std::size_t>(corner)];
    if (first != corner && mark == 0) {
      mark = 1;
      ++n_merged;
    }
    corner = first;
  }
  return n_merged;
}

int weld(PolygonSoup& soup) {
  if (soup.is_joined) return 0;
  return repair::join_points(soup, soup.is_indexed ? 0 : kWeldDistance * repair::used_box(soup).diagonal());
}

Repaired weld_points(const PolygonSoup& soup, double tolerance) {
  PolygonSoup work = soup;
  if (!soup.is_indexed) weld(work);  // these files cannot share points; joining them is part of reading
  const std::vector<int> corners = work.corners;
  const int n_merged = repair::join_points(work, tolerance);
  if (n_merged == 0) return repair::unchanged(soup);
  std::vector<char> was_used(work.points.size(), 0);
  std::vector<char> is_used(work.points.size(), 0);
  for (const int corner : corners) was_used[static_cast<std::size_t>(corner)] = 1;
  for (const int corner : work.corners) is_used[static_cast<std::size_t>(corner)] = 1;
  std::vector<int> renumbered;
  std::vector<glm::dvec3> points;
  for (std::size_t p = 0; p < work.points.size(); ++p) {
    renumbered.push_back(static_cast<int>(points.size()));
    if (is_used[p] != 0 || (was_used[p] == 0 && soup.is_indexed)) points.push_back(work.points[p]);
  }
  for (int& corner : work.corners) corner = renumbered[static_cast<std::size_t>(corner)];
  const auto n_before = std::ranges::count(was_used, 1);
  work.points = std::move(points);
  work.is_indexed = true;
  work.is_joined = true;
  Repaired result = repair::unchanged(work);
  result.count = n_merged;
  result.sentence =
      "Merged " + counted(n_merged, "point", "points") + " into others" +
      repair::before_after(static_cast<int>(n_before), static_cast<int>(n_before) - n_merged, "points") + ".";
  return result;
}

}  // namespace netwright
