// Parts that the user may not want: small ones, those inside others, and points without faces.
#include "core/mesh/repair_parts.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/mesh/repair.h"
#include "core/mesh/repair_topology.h"

namespace netwright {

using repair::Part;
using repair::Side;

std::vector<Part> repair::find_parts(const PolygonSoup& soup) {
  repair::Groups groups(static_cast<std::size_t>(soup.n_faces()));
  const std::vector<Side> sides = repair::sorted_sides(soup);
  std::vector<char> has_border(static_cast<std::size_t>(soup.n_faces()), 0);
  repair::for_each_edge(sides, [&](std::span<const Side> edge) {
    for (const Side& side : edge) {
      groups.unite(edge[0].face, side.face);
      if (!repair::is_manifold_edge(edge)) has_border[static_cast<std::size_t>(side.face)] = 1;
    }
  });
  std::vector<int> part_of(static_cast<std::size_t>(soup.n_faces()), -1);
  std::vector<Part> parts;
  for (int f = 0; f < soup.n_faces(); ++f) {
    int& part = part_of[static_cast<std::size_t>(groups.find(f))];
    if (part < 0) {
      part = static_cast<int>(parts.size());
      parts.emplace_back();
    }
    Part& mine = parts[static_cast<std::size_t>(part)];
    mine.faces.push_back(f);
    for (const int point : soup.face(f)) mine.box.add(soup.points[static_cast<std::size_t>(point)]);
    mine.is_closed = mine.is_closed && has_border[static_cast<std::size_t>(f)] == 0;
  }
  return parts;
}

namespace {

Repaired without_parts(const PolygonSoup& soup, const PolygonSoup& work, const std::vector<Part>& parts,
                       const std::vector<bool>& is_dropped, const std::string& what) {
  const auto n_dropped = static_cast<int>(std::ranges::count(is_dropped, true));
  if (n_dropped == 0) return repair::unchanged(soup);
  std::vector<char> is_kept(static_cast<std::size_t>(work.n_faces()), 1);
  for (std::size_t p = 0; p < parts.size(); ++p) {
    if (!is_dropped[p]) continue;
    for (const int f : parts[p].faces) is_kept[static_cast<std::size_t>(f)] = 0;
  }
  repair::SoupWriter writer(work);
  for (int f = 0; f < work.n_faces(); ++f) {
    if (is_kept[static_cast<std::size_t>(f)] != 0) writer.copy_face(f);
  }
  const auto n_parts = static_cast<int>(parts.size());
  return writer.finish(n_dropped, "Dropped " + counted(n_dropped, what + " part", what + " parts") +
                                      repair::before_after(n_parts, n_parts - n_dropped, "parts") + ".");
}

/// The angle under which a point sees the triangle, positive from behind (van Oosterom and Strackee, 1983).
double solid_angle(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
  const double la = glm::length(a);
  const double lb = glm::length(b);
  const double lc = glm::length(c);
  const double above = glm::dot(a, glm::cross(b, c));
  const double below = la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
  return 2 * std::atan2(above, below);
}

/// True when the part's surface goes around the point.
bool encloses(const PolygonSoup& soup, const Part& part, glm::dvec3 point) {
  double angle = 0;
  const double size = part.box.diagonal();
  for (const int f : part.faces) {
    const auto face = soup.face(f);
    const auto at = [&](std::size_t i) {
      return (soup.points[static_cast<std::size_t>(face[i])] - point) / size;
    };
    for (std::size_t i = 1; i + 1 < face.size(); ++i) angle += solid_angle(at(0), at(i), at(i + 1));
  }
  return std::abs(angle) > 2 * std::numbers::pi;
}

bool contains(const Box3& outer, const Box3& inner) {
  return glm::all(glm::lessThan(outer.min, inner.min)) && glm::all(glm::lessThan(inner.max, outer.max));
}

/// Decides by a few of the inner part's corners; faces looked at are taken off `budget`.
bool lies_inside(const PolygonSoup& soup, const Part& inner, const Part& outer, std::int64_t& budget) {
  if (!outer.is_closed || !contains(outer.box, inner.box)) return false;
  constexpr std::size_t kSamples = 8;
  const std::size_t step = std::max<std::size_t>(1, inner.faces.size() / kSamples);
  for (std::size_t i = 0; i < inner.faces.size(); i += step) {
    budget -= static_cast<std::int64_t>(outer.faces.size());
    if (budget < 0) return false;
    const int point = soup.face(inner.faces[i])[0];
    if (!encloses(soup, outer, soup.points[static_cast<std::size_t>(point)])) return false;
  }
  return true;
}

}  // namespace

std::vector<bool> repair::find_small_parts(const PolygonSoup& soup, const std::vector<Part>& parts,
                                           double min_share) {
  const double model = used_box(soup).diagonal();
  std::vector<bool> is_small;
  std::size_t largest = 0;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    is_small.push_back(parts[p].box.diagonal() < min_share * model);
    if (parts[p].box.diagonal() > parts[largest].box.diagonal()) largest = p;
  }
  if (!is_small.empty()) is_small[largest] = false;
  return is_small;
}

std::vector<bool> repair::find_inner_parts(const PolygonSoup& soup, const std::vector<Part>& parts) {
  constexpr std::int64_t kMostFaces = 200'000'000;  // some seconds
  std::int64_t budget = kMostFaces;
  std::vector<std::size_t> closed;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    if (parts[p].is_closed) closed.push_back(p);
  }
  std::vector<bool> is_inner;
  for (const Part& part : parts) {
    is_inner.push_back(std::ranges::any_of(closed, [&](std::size_t outer) {
      --budget;
      return budget > 0 && &parts[outer] != &part && lies_inside(soup, part, parts[outer], budget);
    }));
  }
  return is_inner;
}

Repaired drop_small_parts(const PolygonSoup& soup, double min_share) {
  const PolygonSoup work = repair::joined(soup);
  const std::vector<Part> parts = repair::find_parts(work);
  return without_parts(soup, work, parts, repair::find_small_parts(work, parts, min_share), "small");
}

Repaired drop_inner_parts(const PolygonSoup& soup) {
  const PolygonSoup work = repair::joined(soup);
  const std::vector<Part> parts = repair::find_parts(work);
  return without_parts(soup, work, parts, repair::find_inner_parts(work, parts), "inner");
}

Repaired drop_isolated_points(const PolygonSoup& soup) {
  std::vector<int> number(soup.points.size(), -1);
  for (const int corner : soup.corners) number[static_cast<std::size_t>(corner)] = 0;
  const auto n_isolated = static_cast<int>(std::ranges::count(number, -1));
  if (n_isolated == 0) return repair::unchanged(soup);
  Repaired result = repair::unchanged(soup);
  PolygonSoup& work = result.soup;
  work.points.clear();
  for (std::size_t p = 0; p < number.size(); ++p) {
    if (number[p] < 0) continue;
    number[p] = static_cast<int>(work.points.size());
    work.points.push_back(soup.points[p]);
  }
  for (int& corner : work.corners) corner = number[static_cast<std::size_t>(corner)];
  const auto n_before = static_cast<int>(soup.points.size());
  result.count = n_isolated;
  result.sentence = "Dropped " + counted(n_isolated, "point that no face uses", "points that no face uses") +
                    repair::before_after(n_before, n_before - n_isolated, "points") + ".";
  return result;
}

}  // namespace netwright
