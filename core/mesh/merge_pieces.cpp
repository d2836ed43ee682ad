// Parts are kept as rings of linked halfedges; joining two cuts their common run out of both rings. Long
// edges go first, so the seams that must stay in regions with holes are short ones.
#include "core/mesh/merge_pieces.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "core/base/polygon2.h"
#include "core/base/predicates.h"

namespace netwright {

namespace {

/// The Mesh measures the polygon again after points were dropped; what is flat here must be flat there.
constexpr double kFlatEnough = 0.9 * kFlatness;

}  // namespace

PieceMerger::PieceMerger(const Mesh& mesh)
    : mesh_(mesh),
      parent_(mesh.n_faces()),
      loop_size_(mesh.n_faces(), 0),
      next_(mesh.n_halfedges()),
      prev_(mesh.n_halfedges()),
      is_inside_(mesh.n_faces(), 0) {}

FaceId PieceMerger::find(FaceId f) {
  while (parent_[f] != f) {
    parent_[f] = parent_[parent_[f]];
    f = parent_[f];
  }
  return f;
}

std::vector<MergedPiece> PieceMerger::merge(std::span<const FaceId> region) {
  for (const FaceId f : region) {
    is_inside_[f] = 1;
    parent_[f] = f;
    loop_size_[f] = mesh_.degree(f);
    for (const HalfedgeId h : mesh_.halfedges(f)) {
      next_[h] = mesh_.next(h);
      prev_[h] = mesh_.prev(h);
    }
  }
  // A pair refused today may be joined when a third part has filled the gap between them.
  std::vector<HalfedgeId> waiting = inner_edges(region);
  for (std::size_t before = waiting.size() + 1; waiting.size() < before;) {
    before = waiting.size();
    std::erase_if(waiting,
                  [&](HalfedgeId h) { return find(mesh_.face(h)) == find(mesh_.neighbour(h)) || join(h); });
  }
  std::map<FaceId, MergedPiece> by_root;
  for (const FaceId f : region) {
    by_root[find(f)].sources.push_back(f);
    is_inside_[f] = 0;
  }
  std::vector<MergedPiece> pieces;
  for (auto& [root, piece] : by_root) {
    piece.loop = loop_of(piece.sources);
    pieces.push_back(std::move(piece));
  }
  std::sort(pieces.begin(), pieces.end(),
            [](const MergedPiece& a, const MergedPiece& b) { return a.sources.front() < b.sources.front(); });
  return pieces;
}

/// The ring around a part, from its smallest halfedge.
std::vector<HalfedgeId> PieceMerger::loop_of(const std::vector<FaceId>& sources) const {
  const auto start_in = [&](FaceId f) {
    for (const HalfedgeId h : mesh_.halfedges(f)) {
      const FaceId g = mesh_.neighbour(h);
      if (!g.is_valid() || !std::binary_search(sources.begin(), sources.end(), g)) return h;
    }
    return HalfedgeId();
  };
  HalfedgeId start;
  for (std::size_t i = 0; !start.is_valid(); ++i) start = start_in(sources[i]);
  std::vector<HalfedgeId> loop{start};
  for (HalfedgeId h = next_[start]; h != start; h = next_[h]) loop.push_back(h);
  return loop;
}

std::vector<HalfedgeId> PieceMerger::inner_edges(std::span<const FaceId> region) const {
  std::vector<HalfedgeId> edges;
  for (const FaceId f : region) {
    for (const HalfedgeId h : mesh_.halfedges(f)) {
      const HalfedgeId t = mesh_.twin(h);
      if (t.is_valid() && h < t && is_inside_[mesh_.face(t)] != 0) edges.push_back(h);
    }
  }
  std::sort(edges.begin(), edges.end(), [&](HalfedgeId a, HalfedgeId b) {
    const double length_a = mesh_.length(mesh_.edge(a));
    const double length_b = mesh_.length(mesh_.edge(b));
    return length_a != length_b ? length_a > length_b : a < b;
  });
  return edges;
}

/// Joins the parts on both sides of h when the union is a simple polygon again.
bool PieceMerger::join(HalfedgeId h) {
  const FaceId a = find(mesh_.face(h));
  const FaceId b = find(mesh_.neighbour(h));
  const int room = std::min(loop_size_[a], loop_size_[b]) - 1;
  HalfedgeId first = h;
  HalfedgeId last = h;
  int run = 1;
  while (run <= room && mesh_.twin(next_[last]) == prev_[mesh_.twin(last)]) {
    last = next_[last];
    ++run;
  }
  while (run <= room && mesh_.twin(prev_[first]) == next_[mesh_.twin(first)]) {
    first = prev_[first];
    ++run;
  }
  const int size = loop_size_[a] + loop_size_[b] - 2 * run;
  if (run > room || size < 3) return false;
  const HalfedgeId first_b = mesh_.twin(last);
  const HalfedgeId last_b = mesh_.twin(first);
  if (loop_size_[a] <= loop_size_[b] ? meet_elsewhere(first, last, b) : meet_elsewhere(first_b, last_b, a))
    return false;
  const HalfedgeId before_a = prev_[first];
  const HalfedgeId after_a = next_[last];
  const HalfedgeId before_b = prev_[first_b];
  const HalfedgeId after_b = next_[last_b];
  next_[before_a] = after_b;
  prev_[after_b] = before_a;
  next_[before_b] = after_a;
  prev_[after_a] = before_b;
  const FaceId root = loop_size_[a] < loop_size_[b] ? b : a;
  parent_[root == a ? b : a] = root;
  loop_size_[root] = size;
  return true;
}

/// Has the loop that runs from `first` to `last` along the other part a vertex in common with it besides?
bool PieceMerger::meet_elsewhere(HalfedgeId first, HalfedgeId last, FaceId other) {
  for (HalfedgeId h = next_[last]; h != first;) {
    h = next_[h];
    if (h != first && touches(h, other)) return true;
  }
  return false;
}

/// Has the part a face at the vertex where this corner is?
bool PieceMerger::touches(HalfedgeId corner, FaceId piece) {
  HalfedgeId h = corner;
  do {
    if (is_inside_[mesh_.face(h)] != 0 && find(mesh_.face(h)) == piece) return true;
    h = mesh_.twin(mesh_.prev(h));
  } while (h.is_valid() && h != corner);
  if (h.is_valid()) return false;
  for (h = mesh_.twin(corner); h.is_valid(); h = mesh_.twin(h)) {
    h = mesh_.next(h);
    if (is_inside_[mesh_.face(h)] != 0 && find(mesh_.face(h)) == piece) return true;
  }
  return false;
}

PolygonKind kind_of(std::span<const glm::dvec3> corners) {
  const std::size_t n = corners.size();
  if (n < 3) return PolygonKind::NotSimple;
  glm::dvec3 centre(0);
  for (const glm::dvec3& p : corners) centre += p / static_cast<double>(n);
  glm::dvec3 vector_area(0);
  double size = 0;
  glm::dvec3 side(0);
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec3& next = corners[(i + 1) % n];
    vector_area += glm::cross(corners[i] - centre, next - centre) * 0.5;
    if (glm::length(next - corners[i]) > glm::length(side)) side = next - corners[i];
    for (std::size_t j = i + 1; j < n; ++j) size = std::max(size, glm::length(corners[j] - corners[i]));
  }
  const double area = glm::length(vector_area);
  if (!(area > 2 * kDegenerateHeight * size * size)) return PolygonKind::NotSimple;
  const glm::dvec3 normal = vector_area / area;
  const glm::dvec3 x = glm::normalize(side - normal * glm::dot(side, normal));
  const glm::dvec3 y = glm::cross(normal, x);
  std::vector<glm::dvec2> flat;
  for (const glm::dvec3& p : corners) {
    if (n > 3 && std::abs(glm::dot(p - centre, normal)) > kFlatEnough * size) return PolygonKind::Uneven;
    flat.emplace_back(glm::dot(p - centre, x), glm::dot(p - centre, y));
  }
  return is_convex(flat) || is_simple(flat) ? PolygonKind::Paper : PolygonKind::NotSimple;
}

}  // namespace netwright
