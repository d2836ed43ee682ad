// Parts are kept as rings of linked halfedges; joining two cuts their common run out of both rings. Long
// edges go first, so the seams that must stay in regions with holes are short ones.
#include "core/mesh/merge_pieces.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "core/base/polygon2.h"
#include "core/base/predicates.h"
#include "core/mesh/convex_cuts.h"

namespace netwright {

namespace {

/// The Mesh measures the polygon again after points were dropped; what is flat here must be flat there.
constexpr double kFlatEnough = 0.9 * kFlatness;

/// A side of a polygon with inward corners may lose this length when it is laid flat, in mean edges: with
/// what the neighbour's side may lose it stays below what the search counts as an overlap.
constexpr double kLostLength = kSolveDepth / 4;

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

std::vector<MergedPiece> PieceMerger::merge(std::span<const FaceId> region, JoinRule rule) {
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
    std::erase_if(waiting, [&](HalfedgeId h) {
      return find(mesh_.face(h)) == find(mesh_.neighbour(h)) || join(h, rule);
    });
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
bool PieceMerger::join(HalfedgeId h, JoinRule rule) {
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
  if (rule == JoinRule::Convex && (turns_inward(before_a, after_b) || turns_inward(before_b, after_a)))
    return false;
  next_[before_a] = after_b;
  prev_[after_b] = before_a;
  next_[before_b] = after_a;
  prev_[after_a] = before_b;
  const FaceId root = loop_size_[a] < loop_size_[b] ? b : a;
  parent_[root == a ? b : a] = root;
  loop_size_[root] = size;
  return true;
}

/// Would the corner between two halfedges of one plane, the first ending where the second starts, be an
/// inward one?
bool PieceMerger::turns_inward(HalfedgeId in, HalfedgeId out) const {
  const glm::dvec3 here = mesh_.position(out);
  const glm::dvec3 way_in = here - mesh_.position(in);
  const glm::dvec3 way_out = mesh_.position(mesh_.to(out)) - here;
  const double left = glm::dot(glm::cross(way_in, way_out), mesh_.normal(mesh_.face(out)));
  return std::atan2(left, glm::dot(way_in, way_out)) < -kStraightTurn;
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

namespace {

struct Frame {
  glm::dvec3 centre{0};
  glm::dvec3 normal{0};
  double area = 0;
  double longest_side = 0;
  double size = 0;  ///< longest side or diagonal
  glm::dvec3 x{0};
  glm::dvec3 y{0};
};

/// Measures as the Mesh does: mean of the corners and Newell's vector area.
Frame frame_of(std::span<const glm::dvec3> corners) {
  const std::size_t n = corners.size();
  Frame frame;
  for (const glm::dvec3& p : corners) frame.centre += p / static_cast<double>(n);
  glm::dvec3 vector_area(0);
  glm::dvec3 side(0);
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec3& next = corners[(i + 1) % n];
    vector_area += glm::cross(corners[i] - frame.centre, next - frame.centre) * 0.5;
    if (glm::length(next - corners[i]) > glm::length(side)) side = next - corners[i];
    for (std::size_t j = i + 1; j < n; ++j)
      frame.size = std::max(frame.size, glm::length(corners[j] - corners[i]));
  }
  frame.longest_side = glm::length(side);
  frame.area = glm::length(vector_area);
  if (!(frame.area > 2 * kDegenerateHeight * frame.size * frame.size)) return frame;
  frame.normal = vector_area / frame.area;
  frame.x = glm::normalize(side - frame.normal * glm::dot(side, frame.normal));
  frame.y = glm::cross(frame.normal, frame.x);
  return frame;
}

std::vector<glm::dvec2> projected(std::span<const glm::dvec3> corners, const Frame& frame) {
  std::vector<glm::dvec2> flat;
  for (const glm::dvec3& p : corners)
    flat.emplace_back(glm::dot(p - frame.centre, frame.x), glm::dot(p - frame.centre, frame.y));
  return flat;
}

/// Does laying the polygon flat keep the length of every side, for the search's purposes?
bool keeps_lengths(std::span<const glm::dvec3> corners, const Frame& frame, double mean_edge) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3 side = corners[(i + 1) % corners.size()] - corners[i];
    const double length = glm::length(side);
    const double rise = glm::dot(side, frame.normal);
    // length - sqrt(length² - rise²), without the cancellation
    const double lost = rise * rise / (length + std::sqrt(std::max(0.0, length * length - rise * rise)));
    if (!(lost <= kLostLength * mean_edge)) return false;
  }
  return true;
}

}  // namespace

std::vector<glm::dvec2> laid_flat(std::span<const glm::dvec3> corners) {
  return projected(corners, frame_of(corners));
}

PolygonKind kind_of(std::span<const glm::dvec3> corners, double mean_edge) {
  if (corners.size() < 3) return PolygonKind::NotSimple;
  const Frame frame = frame_of(corners);
  if (!(frame.area > 2 * kDegenerateHeight * frame.size * frame.size)) return PolygonKind::NotSimple;
  if (corners.size() == 3) return PolygonKind::Paper;
  for (const glm::dvec3& p : corners) {
    if (std::abs(glm::dot(p - frame.centre, frame.normal)) > kFlatEnough * frame.longest_side)
      return PolygonKind::Uneven;
  }
  const std::vector<glm::dvec2> flat = projected(corners, frame);
  if (is_convex(flat)) return PolygonKind::Paper;
  if (!keeps_lengths(corners, frame, mean_edge)) return PolygonKind::Uneven;
  return is_simple(flat) ? PolygonKind::Paper : PolygonKind::NotSimple;
}

}  // namespace netwright
