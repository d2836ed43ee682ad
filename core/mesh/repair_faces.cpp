// Faces that are none: corners named twice are taken out, faces without area go and leave their corners to
// the neighbours so that no gap opens, and of doubled faces one stays.
#include <algorithm>
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

using repair::Corner;
using Corners = std::vector<Corner>;

/// The loops that remain when a face visits a point twice, without those of fewer than three corners.
std::vector<Corners> untangled(const Corners& corners) {
  std::vector<Corners> loops;
  Corners open;
  std::unordered_map<int, std::size_t> place;
  for (const Corner& corner : corners) {
    const auto [found, is_new] = place.try_emplace(corner.point, open.size());
    if (is_new) {
      open.push_back(corner);
      continue;
    }
    const std::size_t first = found->second;  // the loop that begins there closes here; the point stays
    Corners loop(open.begin() + static_cast<std::ptrdiff_t>(first), open.end());
    for (std::size_t i = first + 1; i < open.size(); ++i) place.erase(open[i].point);
    open.resize(first + 1);
    if (loop.size() >= 3) loops.push_back(std::move(loop));
  }
  if (open.size() >= 3) loops.push_back(std::move(open));
  return loops;
}

bool is_tangled(std::span<const int> face) {
  if (face.size() < 3) return true;
  std::vector<int> sorted(face.begin(), face.end());
  std::ranges::sort(sorted);
  return std::ranges::adjacent_find(sorted) != sorted.end();
}

/// A soup whose faces can be changed one by one, and asked which of them use an edge.
class FaceTable {
 public:
  struct Face {
    Corners corners;  ///< empty: dropped
    int source;
  };

  explicit FaceTable(const PolygonSoup& soup) : points_(soup.points) {
    for (int f = 0; f < soup.n_faces(); ++f) add({repair::face_corners(soup, f), f});
  }

  [[nodiscard]] int size() const { return static_cast<int>(faces_.size()); }
  [[nodiscard]] const Face& face(int f) const { return faces_[static_cast<std::size_t>(f)]; }
  [[nodiscard]] glm::dvec3 at(const Corner& c) const { return points_[static_cast<std::size_t>(c.point)]; }

  int add(Face face) {
    const int f = size();
    for (std::size_t i = 0; i < face.corners.size(); ++i) register_side(face.corners, i, f);
    faces_.push_back(std::move(face));
    return f;
  }

  void set(int f, Corners corners) {
    for (std::size_t i = 0; i < corners.size(); ++i) register_side(corners, i, f);
    faces_[static_cast<std::size_t>(f)].corners = std::move(corners);
  }

  /// Puts corners behind the i-th one of face f.
  void insert(int f, std::size_t i, const Corners& more) {
    Corners& corners = faces_[static_cast<std::size_t>(f)].corners;
    corners.insert(corners.begin() + static_cast<std::ptrdiff_t>(i) + 1, more.begin(), more.end());
    for (std::size_t k = i; k <= i + more.size(); ++k) register_side(corners, k, f);
  }

  /// The faces other than `f` with a side between a and b, in either direction.
  [[nodiscard]] std::vector<int> others_at(int a, int b, int f) const {
    std::vector<int> others;
    const auto found = faces_at_.find(key(a, b));
    if (found == faces_at_.end()) return others;
    constexpr std::size_t kMost = 64;  // more faces at an edge than that come apart anyway
    for (const int g : found->second) {
      if (others.size() < kMost && g != f && find_side(g, a, b) >= 0 &&
          std::ranges::find(others, g) == others.end())
        others.push_back(g);
    }
    return others;
  }

  /// Where face f's side between a and b starts, or -1.
  [[nodiscard]] int find_side(int f, int a, int b) const {
    const Corners& corners = face(f).corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const int p = corners[i].point;
      const int q = corners[i + 1 == corners.size() ? 0 : i + 1].point;
      if ((p == a && q == b) || (p == b && q == a)) return static_cast<int>(i);
    }
    return -1;
  }

 private:
  static std::uint64_t key(int a, int b) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(std::min(a, b))) << 32 |
           static_cast<std::uint32_t>(std::max(a, b));
  }
  void register_side(const Corners& corners, std::size_t i, int f) {
    faces_at_[key(corners[i].point, corners[i + 1 == corners.size() ? 0 : i + 1].point)].push_back(f);
  }

  const std::vector<glm::dvec3>& points_;
  std::vector<Face> faces_;
  std::unordered_map<std::uint64_t, std::vector<int>> faces_at_;
};

glm::dvec3 vector_area(const FaceTable& table, const Corners& corners) {
  glm::dvec3 centre(0);
  for (const Corner& c : corners) centre += table.at(c) / static_cast<double>(corners.size());
  glm::dvec3 area(0);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    area += 0.5 * glm::cross(table.at(corners[i]) - centre,
                             table.at(corners[i + 1 == corners.size() ? 0 : i + 1]) - centre);
  }
  return area;
}

std::size_t farthest_from(const FaceTable& table, const Corners& corners, std::size_t from) {
  std::size_t best = from;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (glm::length(table.at(corners[i]) - table.at(corners[from])) >
        glm::length(table.at(corners[best]) - table.at(corners[from])))
      best = i;
  }
  return best;
}

/// A face without area as two chains of corners from its one end to the other.
struct Chains {
  Corners there;                   ///< first end … last end
  Corners back;                    ///< the other way round the face, also first end … last end
  std::vector<double> there_at{};  ///< how far along the line each corner lies
  std::vector<double> back_at{};
  double length = 0;
  double off_line = 0;  ///< largest distance of a corner from the line
};

Chains split_into_chains(const FaceTable& table, const Corners& corners) {
  const std::size_t n = corners.size();
  const std::size_t first = farthest_from(table, corners, farthest_from(table, corners, 0));
  const std::size_t last = farthest_from(table, corners, first);
  Chains chains;
  const glm::dvec3 origin = table.at(corners[first]);
  const glm::dvec3 span = table.at(corners[last]) - origin;
  chains.length = glm::length(span);
  const glm::dvec3 line = chains.length > 0 ? span / chains.length : glm::dvec3(0);
  const auto along = [&](const Corner& c) { return glm::dot(table.at(c) - origin, line); };
  for (std::size_t i = first;; i = (i + 1) % n) {
    chains.there.push_back(corners[i]);
    chains.there_at.push_back(along(corners[i]));
    if (i == last) break;
  }
  for (std::size_t i = first;; i = (i + n - 1) % n) {
    chains.back.push_back(corners[i]);
    chains.back_at.push_back(along(corners[i]));
    if (i == last) break;
  }
  for (const Corner& c : corners) {
    const glm::dvec3 p = table.at(c) - origin;
    chains.off_line = std::max(chains.off_line, glm::length(p - line * glm::dot(p, line)));
  }
  return chains;
}

class DegenerateFaces {
 public:
  explicit DegenerateFaces(const PolygonSoup& soup) : table_(soup) {}

  /// Returns how many faces were mended or dropped.
  int mend(const std::vector<int>& culprits) {
    std::vector<int> queue = culprits;
    // Each turn drops a face, cuts one up or hands corners on; the bound is for shapes nobody thought of.
    const std::size_t bound = 20 * culprits.size() + 100;
    for (std::size_t k = 0; k < queue.size() && k < bound; ++k) mend_face(queue[k], queue);
    return static_cast<int>(culprits.size());
  }

  [[nodiscard]] const FaceTable& table() const { return table_; }

 private:
  void mend_face(int f, std::vector<int>& queue) {
    untangle(f, table_.face(f).corners, queue);
    const Corners corners = table_.face(f).corners;
    if (corners.empty() || has_area(corners)) return;
    const Chains chains = split_into_chains(table_, corners);
    constexpr double kStraight = 1e-6;  // of the length: the face is no line but crosses itself
    if (corners.size() > 3 && chains.off_line > kStraight * chains.length) {
      table_.set(f, {});
      for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        queue.push_back(table_.add({{corners[0], corners[i], corners[i + 1]}, table_.face(f).source}));
      return;
    }
    hand_on(f, chains.there, chains.there_at, chains.back, chains.back_at, queue);
    hand_on(f, chains.back, chains.back_at, chains.there, chains.there_at, queue);
    table_.set(f, {});
  }

  [[nodiscard]] bool has_area(const Corners& corners) const {
    double size = 0;
    const std::size_t a = farthest_from(table_, corners, 0);
    const std::size_t b = farthest_from(table_, corners, a);
    size = glm::length(table_.at(corners[a]) - table_.at(corners[b]));
    return glm::length(vector_area(table_, corners)) > kDegenerateHeight * size * size;
  }

  void untangle(int f, const Corners& corners, std::vector<int>& queue) {
    std::vector<Corners> loops = untangled(corners);
    if (loops.size() == 1 && loops[0].size() == corners.size()) return;
    table_.set(f, loops.empty() ? Corners() : loops[0]);
    if (!loops.empty()) queue.push_back(f);
    for (std::size_t i = 1; i < loops.size(); ++i)
      queue.push_back(table_.add({std::move(loops[i]), table_.face(f).source}));
  }

  /// Gives the corners of the chain `from` that lie within a side of `to` to the other face at that side.
  void hand_on(int f, const Corners& to, const std::vector<double>& to_at, const Corners& from,
               const std::vector<double>& from_at, std::vector<int>& queue) {
    for (std::size_t i = 0; i + 1 < to.size(); ++i) {
      std::vector<int> points;
      std::vector<double> shares;
      bool is_attached = false;
      for (std::size_t k = 0; k < from.size(); ++k) {
        if (k + 1 < from.size() && from_at[k + 1] > to_at[i] && from_at[k] < to_at[i + 1])
          is_attached |= !table_.others_at(from[k].point, from[k + 1].point, f).empty();
        if (from_at[k] <= to_at[i] || from_at[k] >= to_at[i + 1]) continue;
        points.push_back(from[k].point);
        shares.push_back((from_at[k] - to_at[i]) / (to_at[i + 1] - to_at[i]));
      }
      if (points.empty() || !is_attached) continue;
      for (const int g : table_.others_at(to[i].point, to[i + 1].point, f)) {
        insert(g, to[i].point, to[i + 1].point, points, shares);
        untangle(g, table_.face(g).corners, queue);
      }
    }
  }

  /// Puts points into g's side between a and b, at these shares of the way from a to b.
  void insert(int g, int a, int b, std::vector<int> points, std::vector<double> shares) {
    const Corners& corners = table_.face(g).corners;
    const auto i = static_cast<std::size_t>(table_.find_side(g, a, b));
    const Corner start = corners[i];
    const Corner end = corners[i + 1 == corners.size() ? 0 : i + 1];
    if (start.point != a) {
      std::ranges::reverse(points);
      std::ranges::reverse(shares);
      for (double& share : shares) share = 1 - share;
    }
    Corners inserted;
    for (std::size_t k = 0; k < points.size(); ++k)
      inserted.push_back({points[k], start.uv + (end.uv - start.uv) * shares[k]});
    table_.insert(g, i, inserted);
  }

  FaceTable table_;
};

}  // namespace

Repaired drop_degenerate_faces(const PolygonSoup& soup) {
  const PolygonSoup work = repair::joined(soup);
  std::vector<int> culprits;
  for (int f = 0; f < work.n_faces(); ++f) {
    if (is_tangled(work.face(f)) || !repair::measure_face(work, f).has_area) culprits.push_back(f);
  }
  if (culprits.empty()) return repair::unchanged(soup);
  DegenerateFaces faces(work);
  const int n_mended = faces.mend(culprits);
  std::vector<std::vector<int>> parts(static_cast<std::size_t>(work.n_faces()));
  for (int f = 0; f < faces.table().size(); ++f) {
    if (!faces.table().face(f).corners.empty())
      parts[static_cast<std::size_t>(faces.table().face(f).source)].push_back(f);
  }
  repair::SoupWriter writer(work);
  for (int f = 0; f < work.n_faces(); ++f) {
    const auto at = static_cast<std::size_t>(f);
    const int material = work.face_material.empty() ? -1 : work.face_material[at];
    for (const int part : parts[at]) writer.add_face(faces.table().face(part).corners, f, material);
  }
  const int n_after = writer.soup().n_faces();
  return writer.finish(n_mended, "Cleared away " + counted(n_mended, "face", "faces") +
                                     " without area or with a corner named twice" +
                                     repair::before_after(work.n_faces(), n_after, "faces") + ".");
}

Repaired drop_doubled_faces(const PolygonSoup& soup) {
  const PolygonSoup work = repair::joined(soup);
  std::map<std::vector<int>, int> first_with;
  repair::SoupWriter writer(work);
  for (int f = 0; f < work.n_faces(); ++f) {
    std::vector<int> corners(work.face(f).begin(), work.face(f).end());
    std::ranges::sort(corners);
    if (first_with.try_emplace(std::move(corners), f).second) writer.copy_face(f);
  }
  const int n_after = writer.soup().n_faces();
  const int n_dropped = work.n_faces() - n_after;
  if (n_dropped == 0) return repair::unchanged(soup);
  return writer.finish(n_dropped, "Dropped " + counted(n_dropped, "doubled face", "doubled faces") +
                                      repair::before_after(work.n_faces(), n_after, "faces") + ".");
}

}  // namespace netwright
