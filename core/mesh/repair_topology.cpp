// Sides sorted by edge, groups with a sense of turning, measures of faces, and the writer of soups.
#include "core/mesh/repair_topology.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/predicates.h"

namespace netwright::repair {

void sort_sides(std::vector<Side>& sides) {
  std::ranges::sort(sides, {}, [](const Side& s) { return std::array{s.low, s.high, s.face, s.corner}; });
}

std::vector<Side> sorted_sides(const PolygonSoup& soup) {
  std::vector<Side> sides;
  sides.reserve(soup.corners.size());
  for (int f = 0; f < soup.n_faces(); ++f) {
    const auto face = soup.face(f);
    const int begin = soup.face_begin[static_cast<std::size_t>(f)];
    for (std::size_t i = 0; i < face.size(); ++i) {
      const int a = face[i];
      const int b = face[i + 1 == face.size() ? 0 : i + 1];
      sides.push_back({std::min(a, b), std::max(a, b), f, begin + static_cast<int>(i), a < b});
    }
  }
  sort_sides(sides);
  return sides;
}

TurnedGroups::Place TurnedGroups::find(int i) {
  int root = i;
  bool is_turned = false;
  while (parent_[static_cast<std::size_t>(root)] != root) {
    is_turned ^= is_turned_[static_cast<std::size_t>(root)] != 0;
    root = parent_[static_cast<std::size_t>(root)];
  }
  bool rest = is_turned;  // hang the whole path below the root
  while (parent_[static_cast<std::size_t>(i)] != root && i != root) {
    const auto at = static_cast<std::size_t>(i);
    const bool step = is_turned_[at] != 0;
    i = parent_[at];
    parent_[at] = root;
    is_turned_[at] = rest ? 1 : 0;
    rest ^= step;
  }
  return {root, is_turned};
}

bool TurnedGroups::unite(int a, int b, bool is_turned) {
  Place first = find(a);
  Place second = find(b);
  const bool is_root_turned = first.is_turned ^ second.is_turned ^ is_turned;
  if (first.group == second.group) return !is_root_turned;
  if (size_[static_cast<std::size_t>(first.group)] < size_[static_cast<std::size_t>(second.group)])
    std::swap(first, second);
  parent_[static_cast<std::size_t>(second.group)] = first.group;
  size_[static_cast<std::size_t>(first.group)] += size_[static_cast<std::size_t>(second.group)];
  is_turned_[static_cast<std::size_t>(second.group)] = is_root_turned ? 1 : 0;
  return true;
}

int n_used_points(const PolygonSoup& soup) {
  std::vector<char> is_used(soup.points.size(), 0);
  for (const int corner : soup.corners) is_used[static_cast<std::size_t>(corner)] = 1;
  return static_cast<int>(std::ranges::count(is_used, 1));
}

Groups corner_fans(const PolygonSoup& soup, std::span<const Side> sides) {
  Groups fans(soup.corners.size());
  for_each_edge(sides, [&](std::span<const Side> edge) {
    if (!is_manifold_edge(edge)) return;
    const auto ends = [&](const Side& s) {
      return std::array{s.corner, next_corner(soup, s.face, s.corner)};
    };
    const bool runs_same_way = edge[0].is_upward == edge[1].is_upward;
    fans.unite(ends(edge[0])[0], ends(edge[1])[runs_same_way ? 0 : 1]);
    fans.unite(ends(edge[0])[1], ends(edge[1])[runs_same_way ? 1 : 0]);
  });
  return fans;
}

Box3 used_box(const PolygonSoup& soup) {
  Box3 box;
  for (const int corner : soup.corners) box.add(soup.points[static_cast<std::size_t>(corner)]);
  return box;
}

namespace {

/// The longest side or diagonal; of faces with very many corners the diagonal of their box, which is at most
/// 1.7 times as long, so that the work stays bounded.
double face_size(const PolygonSoup& soup, std::span<const int> face) {
  constexpr std::size_t kManyCorners = 1000;
  double size = 0;
  Box3 box;
  for (std::size_t i = 0; i < face.size(); ++i) {
    const glm::dvec3 p = soup.points[static_cast<std::size_t>(face[i])];
    box.add(p);
    if (face.size() > kManyCorners) continue;
    for (std::size_t j = i + 1; j < face.size(); ++j)
      size = std::max(size, glm::length(soup.points[static_cast<std::size_t>(face[j])] - p));
  }
  return face.size() > kManyCorners ? box.diagonal() : size;
}

}  // namespace

FaceMeasure measure_face(const PolygonSoup& soup, int f) {
  const auto face = soup.face(f);
  const auto at = [&](std::size_t i) { return soup.points[static_cast<std::size_t>(face[i % face.size()])]; };
  FaceMeasure measure;
  if (face.size() < 3) return measure;
  for (std::size_t i = 0; i < face.size(); ++i) measure.centre += at(i) / static_cast<double>(face.size());
  glm::dvec3 vector_area(0);
  for (std::size_t i = 0; i < face.size(); ++i)
    vector_area += glm::cross(at(i) - measure.centre, at(i + 1) - measure.centre) * 0.5;
  measure.size = face_size(soup, face);
  const double area = glm::length(vector_area);
  measure.has_area = area > kDegenerateHeight * measure.size * measure.size;
  if (!measure.has_area) return measure;
  measure.normal = vector_area / area;
  if (face.size() == 3) return measure;
  double off = 0;
  double longest_side = 0;
  for (std::size_t i = 0; i < face.size(); ++i) {
    off = std::max(off, std::abs(glm::dot(at(i) - measure.centre, measure.normal)));
    longest_side = std::max(longest_side, glm::length(at(i + 1) - at(i)));
  }
  measure.unevenness = off / measure.size;
  measure.side_unevenness = off / longest_side;
  return measure;
}

std::vector<Corner> face_corners(const PolygonSoup& soup, int f) {
  std::vector<Corner> corners;
  const auto begin = static_cast<std::size_t>(soup.face_begin[static_cast<std::size_t>(f)]);
  const auto face = soup.face(f);
  for (std::size_t i = 0; i < face.size(); ++i)
    corners.push_back({face[i], soup.corner_uv.empty() ? glm::dvec2(0) : soup.corner_uv[begin + i]});
  return corners;
}

SoupWriter::SoupWriter(const PolygonSoup& from) : from_(from) {
  PolygonSoup& soup = result_.soup;
  soup.name = from.name;
  soup.up_axis = from.up_axis;
  soup.points = from.points;
  soup.materials = from.materials;
  soup.notices = from.notices;
  soup.is_indexed = true;
  soup.is_joined = true;
  soup.face_begin.reserve(from.face_begin.size());
  soup.corners.reserve(from.corners.size());
}

void SoupWriter::copy_face(int f) {
  const auto at = static_cast<std::size_t>(f);
  PolygonSoup& soup = result_.soup;
  soup.add_face(from_.face(f));
  if (!from_.corner_uv.empty()) {
    soup.corner_uv.insert(soup.corner_uv.end(), from_.corner_uv.begin() + from_.face_begin[at],
                          from_.corner_uv.begin() + from_.face_begin[at + 1]);
  }
  if (!from_.face_material.empty()) soup.face_material.push_back(from_.face_material[at]);
  result_.face_source.push_back(f);
}

void SoupWriter::add_face(std::span<const Corner> corners, int source, int material) {
  PolygonSoup& soup = result_.soup;
  for (const Corner& corner : corners) {
    soup.corners.push_back(corner.point);
    if (!from_.corner_uv.empty()) soup.corner_uv.push_back(corner.uv);
  }
  soup.face_begin.push_back(static_cast<int>(soup.corners.size()));
  if (!from_.face_material.empty()) soup.face_material.push_back(material);
  result_.face_source.push_back(source);
}

Repaired SoupWriter::finish(int count, std::string sentence) {
  result_.is_turned.assign(result_.face_source.size(), false);
  result_.count = count;
  result_.sentence = std::move(sentence);
  return std::move(result_);
}

Repaired unchanged(const PolygonSoup& soup) {
  const auto n = static_cast<std::size_t>(soup.n_faces());
  Repaired result{.soup = soup, .face_source = std::vector<int>(n), .is_turned = {}, .sentence = {}};
  std::iota(result.face_source.begin(), result.face_source.end(), 0);
  result.is_turned.assign(n, false);
  return result;
}

PolygonSoup joined(const PolygonSoup& soup) {
  PolygonSoup copy = soup;
  weld(copy);
  return copy;
}

std::string doubled_points_sentence(int n_merged) {
  return counted(n_merged, "point lies", "points lie") + " where another one is; they were merged.";
}

std::string turned_faces_sentence(std::ptrdiff_t n_turned) {
  return counted(n_turned, "face was", "faces were") + " turned over to face outward like the rest.";
}

std::string turned_sentence(std::ptrdiff_t n_turned) {
  return "Turned " + counted(n_turned, "face", "faces") + " over to face outward like the rest.";
}

std::string before_after(int before, int after, const std::string& many) {
  return " (" + grouped(before) + " → " + grouped(after) + " " + many + ")";
}

}  // namespace netwright::repair
