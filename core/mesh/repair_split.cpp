// Parts what paper cannot follow: edges with more than two faces and points where several fans meet. Faces
// at such an edge are paired, each pair stays together, and corners that no chain of pairs connects get
// points of their own.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/mesh/repair.h"
#include "core/mesh/repair_topology.h"

namespace netwright {
namespace {

using repair::Side;

/// Decides which sides stay together. Sides are known by the corner they start at.
class Pairing {
 public:
  explicit Pairing(const PolygonSoup& soup)
      : soup_(soup),
        mates_(soup.corners.size(), -1),
        groups_(static_cast<std::size_t>(soup.n_faces())),
        sides_(repair::sorted_sides(soup)) {
    std::vector<std::span<const Side>> crowded;
    repair::for_each_edge(sides_, [&](std::span<const Side> edge) {
      if (repair::is_manifold_edge(edge)) {
        groups_.unite(edge[0].face, edge[1].face, edge[0].is_upward == edge[1].is_upward);
        mate(edge[0], edge[1]);
      } else if (edge.size() > 1) {
        crowded.push_back(edge);
      }
    });
    // Faces that hang together elsewhere first: they bound one part. Then what goes on most smoothly.
    for (const bool is_within_group : {true, false}) {
      for (const std::span<const Side> edge : crowded) pair_up(edge, is_within_group);
    }
    n_crowded_ = static_cast<int>(crowded.size());
  }

  [[nodiscard]] const std::vector<int>& mates() const { return mates_; }
  [[nodiscard]] int n_crowded() const { return n_crowded_; }
  [[nodiscard]] std::span<const Side> sides() const { return sides_; }

 private:
  struct Candidate {
    double cost;
    std::size_t first;
    std::size_t second;
  };
  // An edge with thousands of faces has no sense to find in it; its faces come apart.
  static constexpr std::size_t kMostSides = 64;

  void mate(const Side& a, const Side& b) {
    mates_[static_cast<std::size_t>(a.corner)] = b.corner;
    mates_[static_cast<std::size_t>(b.corner)] = a.corner;
  }

  [[nodiscard]] bool is_free(const Side& s) const { return mates_[static_cast<std::size_t>(s.corner)] < 0; }

  void pair_up(std::span<const Side> edge, bool is_within_group) {
    if (edge.size() > kMostSides) return;
    const std::vector<double> angles = angles_around(edge);
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < edge.size(); ++i) {
      for (std::size_t j = i + 1; j < edge.size(); ++j) {
        if (!is_free(edge[i]) || !is_free(edge[j]) || edge[i].face == edge[j].face) continue;
        const auto a = groups_.find(edge[i].face);
        const auto b = groups_.find(edge[j].face);
        const bool is_one_group = a.group == b.group;
        if (is_within_group && !is_one_group) continue;
        const bool is_up = edge[i].is_upward != a.is_turned;
        const double turn = wrapped(angles[j] - angles[i]);
        if (is_one_group && is_up == (edge[j].is_upward != b.is_turned)) continue;
        // Within a part the wedge that it fills counts, between parts how smoothly one goes on in the other.
        const double wedge = is_up ? wrapped(-turn) : turn;
        candidates.push_back({is_within_group ? wedge : std::abs(turn - std::numbers::pi), i, j});
      }
    }
    std::ranges::stable_sort(candidates, {}, &Candidate::cost);
    for (const Candidate& c : candidates) {
      const Side& a = edge[c.first];
      const Side& b = edge[c.second];
      if (!is_free(a) || !is_free(b)) continue;
      if (groups_.unite(a.face, b.face, a.is_upward == b.is_upward)) mate(a, b);
    }
  }

  /// Where each face lies around the edge, seen against its upward direction.
  [[nodiscard]] std::vector<double> angles_around(std::span<const Side> edge) const {
    const glm::dvec3 low = soup_.points[static_cast<std::size_t>(edge[0].low)];
    const glm::dvec3 up = normalised(soup_.points[static_cast<std::size_t>(edge[0].high)] - low);
    const glm::dvec3 aside = std::abs(up.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 x = normalised(glm::cross(up, aside));
    const glm::dvec3 y = glm::cross(up, x);
    std::vector<double> angles;
    for (const Side& side : edge) {
      const glm::dvec3 along = side.is_upward ? up : -up;
      const glm::dvec3 into = glm::cross(repair::measure_face(soup_, side.face).normal, along);
      angles.push_back(std::atan2(glm::dot(into, y), glm::dot(into, x)));
    }
    return angles;
  }

  static glm::dvec3 normalised(glm::dvec3 v) {
    const double length = glm::length(v);
    return length > 0 ? v / length : glm::dvec3(0);
  }

  static double wrapped(double angle) {
    const double turn = 2 * std::numbers::pi;
    const double rest = std::fmod(angle, turn);
    return rest < 0 ? rest + turn : rest;
  }

  const PolygonSoup& soup_;
  std::vector<int> mates_;  // per corner: where the side that goes on from its side starts, or -1
  repair::TurnedGroups groups_;
  std::vector<Side> sides_;
  int n_crowded_ = 0;
};

/// Gives each fan of corners a point of its own; the first fan keeps the point. Returns how many points were
/// added.
int separate_fans(PolygonSoup& soup, const std::vector<int>& mates) {
  repair::Groups fans(soup.corners.size());
  for (int f = 0; f < soup.n_faces(); ++f) {
    const auto at = static_cast<std::size_t>(f);
    for (int c = soup.face_begin[at]; c < soup.face_begin[at + 1]; ++c) {
      const int mate = mates[static_cast<std::size_t>(c)];
      if (mate < c) continue;
      const int face_of_mate =
          static_cast<int>(std::ranges::upper_bound(soup.face_begin, mate) - soup.face_begin.begin()) - 1;
      std::array mine{c, repair::next_corner(soup, f, c)};
      std::array theirs{mate, repair::next_corner(soup, face_of_mate, mate)};
      const auto point = [&](int corner) { return soup.corners[static_cast<std::size_t>(corner)]; };
      if (point(mine[0]) != point(theirs[0])) std::swap(theirs[0], theirs[1]);
      fans.unite(mine[0], theirs[0]);
      fans.unite(mine[1], theirs[1]);
    }
  }
  std::vector<int> fan_of_point(soup.points.size(), -1);
  std::vector<int> point_of_fan(soup.corners.size(), -1);
  int n_added = 0;
  for (std::size_t c = 0; c < soup.corners.size(); ++c) {
    int& point = soup.corners[c];
    const int fan = fans.find(static_cast<int>(c));
    int& mine = point_of_fan[static_cast<std::size_t>(fan)];
    if (mine < 0) {
      int& owner = fan_of_point[static_cast<std::size_t>(point)];
      mine = point;
      if (owner >= 0) {
        mine = static_cast<int>(soup.points.size());
        soup.points.push_back(soup.points[static_cast<std::size_t>(point)]);
        ++n_added;
      } else {
        owner = fan;
      }
    }
    point = mine;
  }
  return n_added;
}

/// Where one fan runs twice along an edge, splitting points cannot help: all pairs but one get a point in
/// the middle of theirs. Returns how many points were added, and the new soup in `result`.
int bend_double_edges(Repaired& result, const std::vector<int>& mates) {
  PolygonSoup& soup = result.soup;
  const std::vector<Side> sides = repair::sorted_sides(soup);
  std::vector<int> middle(soup.corners.size(), -1);
  int n_added = 0;
  repair::for_each_edge(sides, [&](std::span<const Side> edge) {
    if (edge.size() < 2 || repair::is_manifold_edge(edge)) return;
    for (const Side& side : edge) {
      const int mate = mates[static_cast<std::size_t>(side.corner)];
      if (side.corner == edge[0].corner || mate == edge[0].corner) continue;
      int& mine = middle[static_cast<std::size_t>(side.corner)];
      if (mine >= 0) continue;
      mine = static_cast<int>(soup.points.size());
      if (mate >= 0) middle[static_cast<std::size_t>(mate)] = mine;
      const glm::dvec3 low = soup.points[static_cast<std::size_t>(side.low)];
      const glm::dvec3 high = soup.points[static_cast<std::size_t>(side.high)];
      soup.points.push_back((low + high) * 0.5);
      ++n_added;
    }
  });
  if (n_added == 0) return 0;
  repair::SoupWriter writer(soup);
  for (int f = 0; f < soup.n_faces(); ++f) {
    const std::vector<repair::Corner> corners = repair::face_corners(soup, f);
    std::vector<repair::Corner> more;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      more.push_back(corners[i]);
      const auto c = static_cast<std::size_t>(soup.face_begin[static_cast<std::size_t>(f)]) + i;
      if (middle[c] < 0) continue;
      more.push_back({middle[c], (corners[i].uv + corners[i + 1 == corners.size() ? 0 : i + 1].uv) * 0.5});
    }
    writer.add_face(more, f,
                    soup.face_material.empty() ? -1 : soup.face_material[static_cast<std::size_t>(f)]);
  }
  result.soup = std::move(writer.soup());
  return n_added;
}

/// Points where several fans meet, but no crowded edge ends.
int count_pinched_points(const PolygonSoup& soup, const Pairing& pairing) {
  repair::Groups fans = repair::corner_fans(soup, pairing.sides());
  std::vector<int> n_fans(soup.points.size(), 0);
  for (std::size_t c = 0; c < soup.corners.size(); ++c) {
    if (fans.find(static_cast<int>(c)) == static_cast<int>(c))
      ++n_fans[static_cast<std::size_t>(soup.corners[c])];
  }
  repair::for_each_edge(pairing.sides(), [&](std::span<const Side> edge) {
    if (edge.size() < 2 || repair::is_manifold_edge(edge)) return;
    n_fans[static_cast<std::size_t>(edge[0].low)] = 0;
    n_fans[static_cast<std::size_t>(edge[0].high)] = 0;
  });
  return static_cast<int>(std::ranges::count_if(n_fans, [](int n) { return n > 1; }));
}

}  // namespace

Repaired split_non_manifold(const PolygonSoup& soup) {
  const PolygonSoup work = repair::joined(soup);
  const Pairing pairing(work);
  Repaired result = repair::unchanged(work);
  const auto n_before = repair::n_used_points(work);
  const int n_fans = separate_fans(result.soup, pairing.mates());
  const int n_middles = bend_double_edges(result, pairing.mates());
  result.count = n_fans + n_middles;
  if (result.count == 0) return repair::unchanged(soup);
  result.soup.is_indexed = true;
  result.soup.is_joined = true;
  const int n_points = count_pinched_points(work, pairing);
  std::string what;
  if (pairing.n_crowded() > 0)
    what = counted(pairing.n_crowded(), "edge", "edges") + " with more than two faces";
  if (n_points > 0) {
    what += (what.empty() ? "" : " and ") + counted(n_points, "point", "points") + " where parts touched";
  }
  result.sentence = "Split " + what + repair::before_after(n_before, n_before + result.count, "points") + ".";
  return result;
}

}  // namespace netwright
