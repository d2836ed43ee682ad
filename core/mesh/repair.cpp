// Welds by hashing points into cells, orients by walking from face to face, and puts the pieces together in
// prepare(). Point and face numbers in messages are those of the file, counted from 1.
#include "core/mesh/repair.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <map>
#include <unordered_map>
#include <utility>

#include "core/base/error.h"
#include "core/base/geometry.h"
#include "core/base/predicates.h"

namespace netwright {
namespace {

[[noreturn]] void refuse(const PolygonSoup& soup, const std::string& what) {
  throw Error(ErrorKind::Unfit, (soup.name.empty() ? "The model" : soup.name) + ": " + what);
}

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

Box3 used_box(const PolygonSoup& soup) {
  Box3 box;
  for (const int corner : soup.corners) box.add(soup.points[static_cast<std::size_t>(corner)]);
  return box;
}

/// One side of a face: its two points in order of number, its face, and whether it runs from low to high.
struct Side {
  int low;
  int high;
  int face;
  bool is_upward;
};

/// All sides, those of one edge next to each other.
std::vector<Side> sorted_sides(const PolygonSoup& soup) {
  std::vector<Side> sides;
  sides.reserve(soup.corners.size());
  for (int f = 0; f < soup.n_faces(); ++f) {
    const auto face = soup.face(f);
    for (std::size_t i = 0; i < face.size(); ++i) {
      const int a = face[i];
      const int b = face[(i + 1) % face.size()];
      sides.push_back({std::min(a, b), std::max(a, b), f, a < b});
    }
  }
  std::ranges::sort(sides, {}, [](const Side& s) { return std::array{s.low, s.high, s.face}; });
  return sides;
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
  const std::vector<Side> sides = sorted_sides(soup);
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t j = i;
    while (j < sides.size() && sides[j].low == sides[i].low && sides[j].high == sides[i].high) ++j;
    const Side& a = sides[i];
    if (j - i == 2 && a.face != sides[i + 1].face) {
      const Side& b = sides[i + 1];
      const bool is_turned = a.is_upward == b.is_upward;
      links[static_cast<std::size_t>(a.face)].push_back({b.face, is_turned, a.low, a.high});
      links[static_cast<std::size_t>(b.face)].push_back({a.face, is_turned, a.low, a.high});
    }
    i = j;
  }
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

/// Six times the volume under the component's faces, seen from a point inside its box so that nothing
/// cancels.
double signed_volume(const PolygonSoup& soup, const std::vector<int>& faces,
                     const std::vector<bool>& turned) {
  Box3 box;
  for (const int f : faces) {
    for (const int corner : soup.face(f)) box.add(soup.points[static_cast<std::size_t>(corner)]);
  }
  double volume = 0;
  for (const int f : faces) {
    const auto face = soup.face(f);
    const auto at = [&](std::size_t i) {
      return soup.points[static_cast<std::size_t>(face[i])] - box.centre();
    };
    double part = 0;
    for (std::size_t i = 1; i + 1 < face.size(); ++i) part += glm::dot(at(0), glm::cross(at(i), at(i + 1)));
    volume += turned[static_cast<std::size_t>(f)] ? -part : part;
  }
  return volume;
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

/// Two faces with the same corners are a modelling accident that the edge test would describe badly.
void refuse_doubled_faces(const PolygonSoup& soup) {
  std::map<std::vector<int>, int> first_with;
  for (int f = 0; f < soup.n_faces(); ++f) {
    std::vector<int> corners(soup.face(f).begin(), soup.face(f).end());
    std::ranges::sort(corners);
    const auto [place, is_new] = first_with.try_emplace(std::move(corners), f);
    if (!is_new) {
      refuse(soup,
             "faces " + std::to_string(place->second + 1) + " and " + std::to_string(f + 1) +
                 " have the same corners; delete one of them, or merge doubles in a modelling program.");
    }
  }
}

void refuse_lost_size(const PolygonSoup& soup) {
  const double diagonal = used_box(soup).diagonal();
  if (diagonal < 1e-75) refuse(soup, "all its points lie in one place; export it again at a larger scale.");
}

void add_notice(MeshReport& report, std::string text) {
  report.lines.push_back({MeshReport::Line::Kind::Notice, std::move(text)});
}

std::string counted(std::ptrdiff_t n, const std::string& one, const std::string& many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

/// What is wrong with uneven faces, as the one refusing sentence.
std::string uneven_sentence(const Mesh& mesh, const MeshReport& report) {
  FaceId worst(0);
  for (const FaceId f : mesh.faces()) {
    if (mesh.unevenness(f) > mesh.unevenness(worst)) worst = f;
  }
  return mesh.name() + ": " + counted(report.n_uneven_faces, "face is", "faces are") + " not flat, face " +
         std::to_string(mesh.face_source(worst) + 1) + " most of all (" + percent(report.worst_unevenness) +
         " of its size), and paper cannot follow; triangulate it in a modelling program.";
}

}  // namespace

int weld(PolygonSoup& soup) {
  const Box3 box = used_box(soup);
  PointFinder finder(soup.points, box, soup.is_indexed ? 0 : kWeldDistance * box.diagonal());
  std::vector<int> first(soup.points.size(), -1);
  int n_merged = 0;
  for (int& corner : soup.corners) {
    int& mine = first[static_cast<std::size_t>(corner)];
    if (mine < 0) {
      mine = finder.first_near(corner);
      if (mine != corner) ++n_merged;
    }
    corner = mine;
  }
  return n_merged;
}

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
    const bool is_wrong = is_closed(soup, links, faces)
                              ? signed_volume(soup, faces, turned) < 0
                              : 2 * n_turned > static_cast<std::ptrdiff_t>(faces.size());
    for (const int f : faces) {
      if (is_wrong) turned[static_cast<std::size_t>(f)] = !turned[static_cast<std::size_t>(f)];
    }
  }
  for (int f = 0; f < soup.n_faces(); ++f) {
    if (turned[static_cast<std::size_t>(f)]) turn_face(soup, f);
  }
  return turned;
}

namespace {

/// One try at a mesh: what it took, or why there is none.
struct Attempt {
  PolygonSoup soup;
  std::shared_ptr<const Mesh> mesh;
  std::string refusal;
  int n_merged = 0;
  std::ptrdiff_t n_turned = 0;
};

Attempt build(const PolygonSoup& soup, bool merges_points) {
  Attempt attempt{.soup = soup, .mesh = nullptr, .refusal = {}};
  try {
    refuse_lost_size(attempt.soup);
    if (merges_points) attempt.n_merged = weld(attempt.soup);
    refuse_doubled_faces(attempt.soup);
    const std::vector<bool> turned = orient(attempt.soup);
    attempt.n_turned = std::ranges::count(turned, true);
    attempt.mesh = std::make_shared<const Mesh>(attempt.soup, turned);
  } catch (const Error& error) {
    attempt.refusal = error.what();
    attempt.n_turned = 0;
  }
  return attempt;
}

}  // namespace

PreparedModel prepare(const PolygonSoup& soup) {
  const bool is_indexed = soup.is_indexed;
  Attempt attempt = build(soup, true);
  if (!attempt.mesh && is_indexed && attempt.n_merged > 0) {
    // Closed parts that touch are apart in the file already; nobody should be told to part them.
    Attempt apart = build(soup, false);
    if (apart.mesh && apart.mesh->is_closed()) attempt = std::move(apart);
  }
  PreparedModel model{.mesh = attempt.mesh, .report = {}, .refusal = attempt.refusal};
  model.report = model.mesh ? report_on(*model.mesh) : report_on(attempt.soup, model.refusal);
  if (model.report.n_uneven_faces > 0) model.refusal = uneven_sentence(*model.mesh, model.report);
  if (is_indexed && attempt.n_merged > 0) {
    add_notice(model.report, counted(attempt.n_merged, "point lies", "points lie") +
                                 " where another one is; they were merged.");
  }
  if (attempt.n_turned > 0) {
    add_notice(model.report, counted(attempt.n_turned, "face was", "faces were") +
                                 " turned over to face outward like the rest.");
  }
  for (const std::string& notice : soup.notices) add_notice(model.report, notice);
  return model;
}

}  // namespace netwright
