// Looks a soup over once its points are joined: each fault in a pass of its own over faces or sorted sides.
#include "core/mesh/repair_findings.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

#include "core/base/error.h"
#include "core/base/predicates.h"
#include "core/mesh/repair.h"
#include "core/mesh/repair_topology.h"

namespace netwright::repair {
namespace {

bool is_broken(std::span<const int> face) {
  if (face.size() < 3) return true;
  std::vector<int> sorted(face.begin(), face.end());
  std::ranges::sort(sorted);
  return std::ranges::adjacent_find(sorted) != sorted.end();
}

void look_at_faces(const PolygonSoup& soup, Findings& found) {
  std::map<std::vector<int>, int> first_with;
  std::vector<std::pair<double, int>> uneven;
  for (int f = 0; f < soup.n_faces(); ++f) {
    if (is_broken(soup.face(f))) {
      found.broken_faces.push_back(f);
      continue;
    }
    std::vector<int> corners(soup.face(f).begin(), soup.face(f).end());
    std::ranges::sort(corners);
    if (!first_with.try_emplace(std::move(corners), f).second) found.doubled_faces.push_back(f);
    const FaceMeasure measure = measure_face(soup, f);
    if (!measure.has_area) found.zero_area_faces.push_back(f);
    found.worst_unevenness = std::max(found.worst_unevenness, measure.unevenness);
    if (measure.side_unevenness > kFlatness) uneven.emplace_back(-measure.unevenness, f);
  }
  std::ranges::sort(uneven);
  for (const auto& [unevenness, face] : uneven) found.uneven_faces.push_back(face);
}

/// Counts fans per point: those with several are pinched, unless a crowded edge ends there anyway.
void look_at_points(const PolygonSoup& soup, Groups& fans, Findings& found) {
  std::vector<char> is_excused(soup.points.size(), 0);
  for (const auto& edge : found.crowded_edges) {
    for (const int point : edge) is_excused[static_cast<std::size_t>(point)] = 1;
  }
  std::vector<int> n_fans(soup.points.size(), 0);
  for (std::size_t c = 0; c < soup.corners.size(); ++c) {
    if (fans.find(static_cast<int>(c)) == static_cast<int>(c))
      ++n_fans[static_cast<std::size_t>(soup.corners[c])];
  }
  for (std::size_t p = 0; p < n_fans.size(); ++p) {
    if (n_fans[p] > 1 && is_excused[p] == 0) found.pinched_points.push_back(static_cast<int>(p));
  }
}

/// Border sides that share a fan follow each other; what hangs together that way is a loop.
struct Loops {
  int n_border = 0;  ///< with at least one side that no other face has
  int n_all = 0;     ///< also those that crowded edges alone make
};

Loops count_loops(const PolygonSoup& soup, std::span<const Side> sides, Groups& fans) {
  Groups loops(soup.corners.size());
  std::vector<int> border;
  std::vector<int> all;
  for_each_edge(sides, [&](std::span<const Side> edge) {
    if (is_manifold_edge(edge)) return;
    for (const Side& side : edge) {
      const int start = fans.find(side.corner);
      loops.unite(start, fans.find(next_corner(soup, side.face, side.corner)));
      all.push_back(start);
      if (edge.size() == 1) border.push_back(start);
    }
  });
  const auto count = [&](std::vector<int>& starts) {
    for (int& start : starts) start = loops.find(start);
    std::ranges::sort(starts);
    return static_cast<int>(std::ranges::unique(starts).begin() - starts.begin());
  };
  return {count(border), count(all)};
}

void look_at_edges(const PolygonSoup& soup, Findings& found) {
  const std::vector<Side> sides = sorted_sides(soup);
  Groups parts(static_cast<std::size_t>(soup.n_faces()));
  Groups whole(static_cast<std::size_t>(soup.n_faces()));  // not connected across crowded edges
  int n_edges = 0;
  for_each_edge(sides, [&](std::span<const Side> edge) {
    for (const Side& side : edge) parts.unite(edge[0].face, side.face);
    if (is_manifold_edge(edge)) {
      whole.unite(edge[0].face, edge[1].face);
      ++n_edges;
      return;
    }
    n_edges += static_cast<int>(edge.size());
    const std::array ends{edge[0].low, edge[0].high};
    if (edge.size() > 1) {
      found.crowded_edges.push_back(ends);
      return;
    }
    found.border_edges.push_back(ends);
    found.border_length += glm::distance(soup.points[static_cast<std::size_t>(ends[0])],
                                         soup.points[static_cast<std::size_t>(ends[1])]);
  });
  Groups fans = corner_fans(soup, sides);
  look_at_points(soup, fans, found);
  const auto count_groups = [](Groups& groups, std::size_t n) {
    int count = 0;
    for (int i = 0; i < static_cast<int>(n); ++i) count += groups.find(i) == i ? 1 : 0;
    return count;
  };
  const auto n_faces = static_cast<std::size_t>(soup.n_faces());
  found.n_parts = count_groups(parts, n_faces);
  const Loops loops = count_loops(soup, sides, fans);
  found.n_border_loops = loops.n_border;
  const int euler = count_groups(fans, soup.corners.size()) - n_edges + soup.n_faces();
  found.genus = (2 * count_groups(whole, n_faces) - loops.n_all - euler) / 2;
}

void look_at_orientation(PolygonSoup soup, const std::vector<int>& face_source, Findings& found) {
  try {
    const std::vector<bool> turned = orient(soup);
    for (std::size_t f = 0; f < turned.size(); ++f) {
      if (turned[f]) found.turned_faces.push_back(face_source[f]);
    }
  } catch (const Error&) {
    found.is_one_sided = true;
  }
}

/// The soup without faces that are broken or doubled: what they do to their edges is no fault of its own.
Repaired without_blunders(const PolygonSoup& soup, const Findings& found) {
  std::vector<char> is_left_out(static_cast<std::size_t>(soup.n_faces()), 0);
  for (const int f : found.broken_faces) is_left_out[static_cast<std::size_t>(f)] = 1;
  for (const int f : found.doubled_faces) is_left_out[static_cast<std::size_t>(f)] = 1;
  SoupWriter writer(soup);
  for (int f = 0; f < soup.n_faces(); ++f) {
    if (is_left_out[static_cast<std::size_t>(f)] == 0) writer.copy_face(f);
  }
  return writer.finish(0, {});
}

}  // namespace

Findings find_faults(const PolygonSoup& soup) {
  Findings found;
  PolygonSoup work = soup;
  const int n_merged = weld(work);
  if (soup.is_indexed) {
    found.n_merged = n_merged;
    std::vector<char> is_joined(soup.points.size(), 0);
    for (std::size_t c = 0; c < soup.corners.size(); ++c)
      if (work.corners[c] != soup.corners[c]) is_joined[static_cast<std::size_t>(soup.corners[c])] = 1;
    for (std::size_t p = 0; p < is_joined.size(); ++p)
      if (is_joined[p] != 0) found.doubled_points.push_back(static_cast<int>(p));
    std::vector<char> is_used(soup.points.size(), 0);
    for (const int corner : soup.corners) is_used[static_cast<std::size_t>(corner)] = 1;
    for (std::size_t p = 0; p < is_used.size(); ++p) {
      if (is_used[p] == 0) found.isolated_points.push_back(static_cast<int>(p));
    }
  }
  found.n_vertices = n_used_points(work);
  found.size = used_box(work).size();
  look_at_faces(work, found);
  Repaired rest = without_blunders(work, found);
  look_at_edges(rest.soup, found);
  look_at_orientation(std::move(rest.soup), rest.face_source, found);
  return found;
}

}  // namespace netwright::repair
