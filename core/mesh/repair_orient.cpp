// Turns faces: walks from face to face so that neighbours run the same way, then turns whole components
// outward. Point and face numbers in messages are those of the file, counted from 1.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/error.h"
#include "core/mesh/repair.h"
#include "core/mesh/repair_topology.h"

namespace netwright {
namespace {

[[noreturn]] void refuse(const PolygonSoup& soup, const std::string& what) {
  throw Error(ErrorKind::Unfit, (soup.name.empty() ? "The model" : soup.name) + ": " + what);
}

/// Two faces that share an edge, and whether one must be turned for both to run the same way.
struct Link {
  int face;
  bool is_turned;
  int low;
  int high;
};

/// Links over edges with exactly two faces; edges with more are the Mesh's to refuse.
std::vector<std::vector<Link>> face_links(const PolygonSoup& soup) {
  std::vector<std::vector<Link>> links(static_cast<std::size_t>(soup.n_faces()));
  const std::vector<repair::Side> sides = repair::sorted_sides(soup);
  repair::for_each_edge(sides, [&](std::span<const repair::Side> edge) {
    if (!repair::is_manifold_edge(edge)) return;
    const repair::Side& a = edge[0];
    const repair::Side& b = edge[1];
    const bool is_turned = a.is_upward == b.is_upward;
    links[static_cast<std::size_t>(a.face)].push_back({b.face, is_turned, a.low, a.high});
    links[static_cast<std::size_t>(b.face)].push_back({a.face, is_turned, a.low, a.high});
  });
  return links;
}

/// The faces reached from `seed`, with `turned` set so that they run the same way as it.
std::vector<int> walk(const PolygonSoup& soup, const std::vector<std::vector<Link>>& links, int seed,
                      std::vector<bool>& turned, std::vector<bool>& seen) {
  std::vector<int> reached{seed};
  seen[static_cast<std::size_t>(seed)] = true;
  for (std::size_t k = 0; k < reached.size(); ++k) {
    const auto f = static_cast<std::size_t>(reached[k]);
    for (const Link& link : links[f]) {
      const auto g = static_cast<std::size_t>(link.face);
      const bool want = turned[f] != link.is_turned;
      if (!seen[g]) {
        seen[g] = true;
        turned[g] = want;
        reached.push_back(link.face);
      } else if (turned[g] != want) {
        refuse(soup, "the surface has only one side: going around it, faces " + std::to_string(f + 1) +
                         " and " + std::to_string(g + 1) + " cannot agree along the edge between points " +
                         std::to_string(link.low + 1) + " and " + std::to_string(link.high + 1) +
                         "; cut it open there in a modelling program.");
      }
    }
  }
  return reached;
}

/// Whether a closed component's volume is below zero: -1, above: 1, or 0 where there is none to speak of
/// (two sheets lying on each other). Seen from the middle of its box so that nothing cancels.
int sign_of_volume(const PolygonSoup& soup, const std::vector<int>& faces, const std::vector<bool>& turned) {
  Box3 box;
  for (const int f : faces) {
    for (const int corner : soup.face(f)) box.add(soup.points[static_cast<std::size_t>(corner)]);
  }
  double volume = 0;
  double total = 0;
  for (const int f : faces) {
    const auto face = soup.face(f);
    const auto at = [&](std::size_t i) {
      return soup.points[static_cast<std::size_t>(face[i])] - box.centre();
    };
    double part = 0;
    for (std::size_t i = 1; i + 1 < face.size(); ++i) part += glm::dot(at(0), glm::cross(at(i), at(i + 1)));
    volume += turned[static_cast<std::size_t>(f)] ? -part : part;
    total += std::abs(part);
  }
  constexpr double kRounding = 1e-12;
  if (std::abs(volume) <= kRounding * total) return 0;
  return volume < 0 ? -1 : 1;
}

bool is_closed(const PolygonSoup& soup, const std::vector<std::vector<Link>>& links,
               const std::vector<int>& faces) {
  return std::ranges::all_of(
      faces, [&](int f) { return links[static_cast<std::size_t>(f)].size() == soup.face(f).size(); });
}

void turn_face(PolygonSoup& soup, int f) {
  const auto begin = soup.face_begin[static_cast<std::size_t>(f)];
  const auto end = soup.face_begin[static_cast<std::size_t>(f) + 1];
  std::reverse(soup.corners.begin() + begin, soup.corners.begin() + end);
  if (!soup.corner_uv.empty()) std::reverse(soup.corner_uv.begin() + begin, soup.corner_uv.begin() + end);
}

}  // namespace

std::vector<bool> orient(PolygonSoup& soup) {
  const auto n = static_cast<std::size_t>(soup.n_faces());
  const std::vector<std::vector<Link>> links = face_links(soup);
  std::vector<bool> turned(n, false);
  std::vector<bool> seen(n, false);
  for (int seed = 0; seed < soup.n_faces(); ++seed) {
    if (seen[static_cast<std::size_t>(seed)]) continue;
    const std::vector<int> faces = walk(soup, links, seed, turned, seen);
    const auto n_turned =
        std::ranges::count_if(faces, [&](int f) { return turned[static_cast<std::size_t>(f)]; });
    const int volume = is_closed(soup, links, faces) ? sign_of_volume(soup, faces, turned) : 0;
    const bool is_wrong = volume == 0 ? 2 * n_turned > static_cast<std::ptrdiff_t>(faces.size()) : volume < 0;
    for (const int f : faces) {
      if (is_wrong) turned[static_cast<std::size_t>(f)] = !turned[static_cast<std::size_t>(f)];
    }
  }
  for (int f = 0; f < soup.n_faces(); ++f) {
    if (turned[static_cast<std::size_t>(f)]) turn_face(soup, f);
  }
  return turned;
}

Repaired orient_faces(const PolygonSoup& soup) {
  PolygonSoup work = repair::joined(soup);
  const std::vector<bool> turned = orient(work);
  const auto n_turned = std::ranges::count(turned, true);
  if (n_turned == 0) return repair::unchanged(soup);
  work.is_indexed = true;
  work.is_joined = true;
  Repaired result = repair::unchanged(work);
  result.is_turned = turned;
  result.count = static_cast<int>(n_turned);
  result.sentence = repair::turned_sentence(n_turned);
  return result;
}

}  // namespace netwright
