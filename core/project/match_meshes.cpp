// Exact partners are found first and reserved, so that nothing that has moved takes the place of something
// that has not. What remains is paired greedily, nearest first.
#include "core/project/match_meshes.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "core/project/point_grid.h"

namespace netwright {

namespace {

constexpr double kSamePlaceShare = 1e-5;         // of the diagonal: what six written digits leave of a place
constexpr double kSameLengthShare = 0.1;         // but never more than this of an edge
constexpr double kSameWay = 0.8660254037844387;  // cos 30°
constexpr double kSameSide = 0.5;                // cos 60°
constexpr double kMostLonger = 2.5;
constexpr std::size_t kMostPartners = 6;  // candidates kept for each edge and face

struct Segment {
  glm::dvec3 a;
  glm::dvec3 b;
  glm::dvec3 outward;  // of both faces together; zero where they lie on each other
  [[nodiscard]] glm::dvec3 middle() const { return 0.5 * (a + b); }
  [[nodiscard]] double length() const { return glm::length(b - a); }
};

glm::dvec3 outward(const Mesh& mesh, EdgeId e) {
  const HalfedgeId h = mesh.halfedge(e);
  const FaceId beyond = mesh.neighbour(h);
  const glm::dvec3 sum =
      mesh.normal(mesh.face(h)) + (beyond.is_valid() ? mesh.normal(beyond) : glm::dvec3(0));
  const double length = glm::length(sum);
  return length > 1e-6 ? sum / length : glm::dvec3(0);
}

Segment segment(const Mesh& mesh, EdgeId e, const ModelFrame& frame) {
  const HalfedgeId h = mesh.halfedge(e);
  return {frame(mesh.position(mesh.from(h))), frame(mesh.position(mesh.to(h))),
          frame.direction(outward(mesh, e))};
}

bool look_the_same_way(const Segment& one, const Segment& other) {
  if (one.outward == glm::dvec3(0) || other.outward == glm::dvec3(0)) return true;
  return glm::dot(one.outward, other.outward) >= kSameSide;
}

struct Pair {
  bool is_last = true;  // those that are asked for first come first
  double distance = 0;
  std::int32_t from = 0;
  std::int32_t to = 0;
  bool operator<(const Pair& other) const {
    return std::tie(is_last, distance, from, to) <
           std::tie(other.is_last, other.distance, other.from, other.to);
  }
};

/// Nearest pairs first, each end once.
template <class Id>
void pair_off(std::vector<Pair> pairs, IdVector<Id, Id>& partner, IdVector<Id, char>& is_taken) {
  std::sort(pairs.begin(), pairs.end());
  for (const Pair& pair : pairs) {
    const Id from(pair.from);
    const Id to(pair.to);
    if (partner[from].is_valid() || is_taken[to] != 0) continue;
    partner[from] = to;
    is_taken[to] = 1;
  }
}

void keep_nearest(std::vector<Pair>& found, std::vector<Pair>& all) {
  const auto n = static_cast<std::ptrdiff_t>(std::min(found.size(), kMostPartners));
  std::partial_sort(found.begin(), found.begin() + n, found.end());
  all.insert(all.end(), found.begin(), found.begin() + n);
}

double cell_of(const Mesh& mesh) { return std::max(mesh.mean_edge(), 1e-6 * mesh.box().diagonal()); }

/// The new mesh's edges, ready to be asked for.
class Edges {
 public:
  explicit Edges(const Mesh& mesh) : same_place_(kSamePlaceShare * mesh.box().diagonal()) {
    std::vector<glm::dvec3> middles;
    for (const EdgeId e : mesh.edges()) {
      segments_.push_back(segment(mesh, e, {}));
      middles.push_back(segments_.back().middle());
    }
    grid_.emplace(std::move(middles), cell_of(mesh));
  }

  void exact(const Segment& own, std::int32_t from, std::vector<Pair>& pairs) const {
    const double reach = std::min(same_place_, kSameLengthShare * own.length());
    grid_->near(own.middle(), reach, [&](std::size_t i, double distance) {
      const Segment& other = segments_[i];
      const double off = std::min(std::max(glm::length(own.a - other.a), glm::length(own.b - other.b)),
                                  std::max(glm::length(own.a - other.b), glm::length(own.b - other.a)));
      if (off > reach || !look_the_same_way(own, other)) return;
      // Of edges on top of each other the one whose faces look most alike is meant.
      const double unlike = 1 - glm::dot(own.outward, other.outward);
      pairs.push_back({true, distance + reach * unlike, from, static_cast<std::int32_t>(i)});
    });
  }

  template <class IsFree>
  void near(const Segment& own, Pair pair, const IsFree& is_free, std::vector<Pair>& pairs) const {
    const double length = own.length();
    std::vector<Pair> found;
    grid_->near(own.middle(), 0.5 * kMostLonger * length, [&](std::size_t i, double distance) {
      const Segment& other = segments_[i];
      const double beside = other.length();
      const double longer = std::max(length, beside);
      if (!is_free(i) || distance > 0.5 * longer || longer > kMostLonger * std::min(length, beside)) return;
      const double along = std::abs(glm::dot(own.b - own.a, other.b - other.a));
      if (along < kSameWay * length * beside || !look_the_same_way(own, other)) return;
      pair.distance = distance;
      pair.to = static_cast<std::int32_t>(i);
      found.push_back(pair);
    });
    keep_nearest(found, pairs);
  }

 private:
  std::vector<Segment> segments_;
  double same_place_;
  std::optional<PointGrid> grid_;
};

void match_edges(const Mesh& from, const Mesh& to, const ModelFrame& frame, const std::vector<EdgeId>& first,
                 MeshMatch& match) {
  const Edges edges(to);
  IdVector<EdgeId, char> is_taken(to.n_edges(), 0);
  match.edges = IdVector<EdgeId, EdgeId>(from.n_edges());
  match.is_edge_same = IdVector<EdgeId, char>(from.n_edges(), 0);
  std::vector<Pair> pairs;
  for (const EdgeId e : from.edges()) edges.exact(segment(from, e, frame), e.value, pairs);
  pair_off(std::move(pairs), match.edges, is_taken);
  for (const EdgeId e : from.edges()) match.is_edge_same[e] = match.edges[e].is_valid() ? 1 : 0;

  IdVector<EdgeId, char> is_first(from.n_edges(), 0);
  for (const EdgeId e : first) is_first[e] = 1;
  const auto is_free = [&](std::size_t i) { return is_taken[EdgeId(static_cast<std::int32_t>(i))] == 0; };
  pairs.clear();
  for (const EdgeId e : from.edges()) {
    if (match.edges[e].is_valid()) continue;
    edges.near(segment(from, e, frame), {is_first[e] == 0, 0, e.value, 0}, is_free, pairs);
  }
  pair_off(std::move(pairs), match.edges, is_taken);
}

void match_faces(const Mesh& from, const Mesh& to, const ModelFrame& frame, MeshMatch& match) {
  std::vector<glm::dvec3> centres;
  for (const FaceId f : to.faces()) centres.push_back(to.centre(f));
  const PointGrid grid(std::move(centres), cell_of(to));
  IdVector<FaceId, char> is_taken(to.n_faces(), 0);
  match.faces = IdVector<FaceId, FaceId>(from.n_faces());
  match.is_face_same = IdVector<FaceId, char>(from.n_faces(), 0);
  const auto look = [&](bool is_exact) {
    std::vector<Pair> pairs;
    for (const FaceId f : from.faces()) {
      if (match.faces[f].is_valid()) continue;
      const double size = frame.scale * from.size(f);
      const double same = std::min(kSamePlaceShare * to.box().diagonal(), kSameLengthShare * size);
      const glm::dvec3 normal = frame.direction(from.normal(f));
      std::vector<Pair> found;
      grid.near(frame(from.centre(f)), is_exact ? same : size, [&](std::size_t i, double off) {
        const FaceId other(static_cast<std::int32_t>(i));
        const double other_size = to.size(other);
        const bool is_near =
            is_exact ? std::abs(other_size - size) <= same : off <= 0.25 * (other_size + size);
        if (!is_near || is_taken[other] != 0 || glm::dot(normal, to.normal(other)) < kSameWay) return;
        found.push_back({true, off, f.value, other.value});
      });
      keep_nearest(found, pairs);
    }
    pair_off(std::move(pairs), match.faces, is_taken);
  };
  look(true);
  for (const FaceId f : from.faces()) match.is_face_same[f] = match.faces[f].is_valid() ? 1 : 0;
  look(false);
}

/// The share of edges that lie exactly where they lay; of very many a sample says enough.
double share_found(const Mesh& from, const Edges& edges, const ModelFrame& frame) {
  constexpr std::size_t kSample = 4000;
  const std::size_t stride = from.n_edges() / kSample + 1;
  std::size_t n_asked = 0;
  std::size_t n_found = 0;
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < from.n_edges(); i += stride, ++n_asked) {
    pairs.clear();
    edges.exact(segment(from, EdgeId(static_cast<std::int32_t>(i)), frame), 0, pairs);
    n_found += pairs.empty() ? 0 : 1;
  }
  return static_cast<double>(n_found) / static_cast<double>(n_asked);
}

/// Turned so, scaled and shifted until the boxes coincide as well as they can.
ModelFrame box_on_box(const Mesh& from, const Mesh& to, ModelFrame::Turn turn) {
  ModelFrame frame;
  frame.turn = turn;
  frame.scale = to.box().diagonal() / from.box().diagonal();
  frame.shift = to.box().centre() - frame.scale * frame.direction(from.box().centre());
  return frame;
}

/// Written in another unit or turned, but about the same origin.
ModelFrame about_the_origin(const Mesh& from, const Mesh& to, ModelFrame::Turn turn) {
  ModelFrame frame = box_on_box(from, to, turn);
  frame.shift = glm::dvec3(0);
  for (const double unit : {1.0, 10.0, 0.1, 100.0, 0.01, 1000.0, 0.001, 25.4, 1 / 25.4})
    if (std::abs(frame.scale / unit - 1) < 0.25) frame.scale = unit;
  return frame;
}

}  // namespace

glm::dvec3 ModelFrame::direction(const glm::dvec3& d) const {
  switch (turn) {
    case Turn::UpToZ:
      return {d.x, -d.z, d.y};
    case Turn::UpToY:
      return {d.x, d.z, -d.y};
    case Turn::None:
      break;
  }
  return d;
}

ModelFrame find_frame(const Mesh& from, const Mesh& to) {
  constexpr double kEnough = 0.2;
  const Edges edges(to);
  ModelFrame best;
  double most = share_found(from, edges, best);
  using Turn = ModelFrame::Turn;
  for (const Turn turn : {Turn::None, Turn::UpToZ, Turn::UpToY}) {
    for (const ModelFrame& frame : {about_the_origin(from, to, turn), box_on_box(from, to, turn)}) {
      if (most >= kEnough) return best;
      const double share = share_found(from, edges, frame);
      if (share <= 2 * most + 0.02) continue;
      most = share;
      best = frame;
    }
  }
  return best;
}

MeshMatch match_meshes(const Mesh& from, const Mesh& to, const ModelFrame& frame,
                       const std::vector<EdgeId>& first) {
  MeshMatch match;
  match_edges(from, to, frame, first, match);
  match_faces(from, to, frame, match);
  return match;
}

}  // namespace netwright
