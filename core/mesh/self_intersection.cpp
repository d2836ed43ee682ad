// A tree of boxes finds candidate pairs; two faces cross when each has corners on both sides of the other's
// plane and the stretches they cut out of the common line of both planes overlap.
#include "core/mesh/self_intersection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <span>

#include "core/base/geometry.h"
#include "core/base/predicates.h"
#include "core/mesh/repair_topology.h"

namespace netwright {
namespace {

/// What the tests need to know of every face, from a mesh or a soup.
struct Faces {
  std::vector<std::size_t> begin{0};
  std::vector<glm::dvec3> corners;
  std::vector<repair::FaceMeasure> measures;
  std::vector<Box3> boxes;

  [[nodiscard]] int size() const { return static_cast<int>(measures.size()); }
  [[nodiscard]] std::span<const glm::dvec3> face(int f) const {
    const auto at = static_cast<std::size_t>(f);
    return std::span(corners).subspan(begin[at], begin[at + 1] - begin[at]);
  }
  [[nodiscard]] const repair::FaceMeasure& measure(int f) const {
    return measures[static_cast<std::size_t>(f)];
  }
  void finish_face(const repair::FaceMeasure& measure) {
    measures.push_back(measure);
    Box3 box;
    for (std::size_t i = begin.back(); i < corners.size(); ++i) box.add(corners[i]);
    boxes.push_back(box);
    begin.push_back(corners.size());
  }
};

class CrossingTest {
 public:
  explicit CrossingTest(const Faces& faces) : faces_(faces) {}

  bool operator()(int a, int b) {
    const repair::FaceMeasure& face_a = faces_.measure(a);
    const repair::FaceMeasure& face_b = faces_.measure(b);
    if (!face_a.has_area || !face_b.has_area) return false;
    const double touch = kCrossingDepth * std::max(face_a.size, face_b.size);
    if (!measure(a, b, touch + face_b.unevenness * face_b.size, heights_a_)) return false;
    if (!measure(b, a, touch + face_a.unevenness * face_a.size, heights_b_)) return false;
    const glm::dvec3 line = glm::cross(face_a.normal, face_b.normal);
    const double sine = glm::length(line);
    if (!(sine > kCrossingDepth)) return false;  // as good as parallel: they can only touch
    find_stretches(a, line / sine, heights_a_, stretches_a_);
    find_stretches(b, line / sine, heights_b_, stretches_b_);
    for (std::size_t i = 0; i + 1 < stretches_a_.size(); i += 2) {
      for (std::size_t j = 0; j + 1 < stretches_b_.size(); j += 2) {
        const double begin = std::max(stretches_a_[i], stretches_b_[j]);
        const double end = std::min(stretches_a_[i + 1], stretches_b_[j + 1]);
        if (end - begin > touch) return true;
      }
    }
    return false;
  }

 private:
  /// Heights of f's corners over the plane of `other`, those within `touch` set to 0; false unless there are
  /// some on both sides.
  bool measure(int f, int other, double touch, std::vector<double>& heights) const {
    heights.clear();
    bool has_above = false;
    bool has_below = false;
    for (const glm::dvec3& p : faces_.face(f)) {
      double height = glm::dot(p - faces_.measure(other).centre, faces_.measure(other).normal);
      if (std::abs(height) <= touch) height = 0;
      has_above |= height > 0;
      has_below |= height < 0;
      heights.push_back(height);
    }
    return has_above && has_below;
  }

  /// Where the outline of f passes through the other plane, sorted along the line: pairs bound the stretches
  /// that lie inside f. Corners on the plane count as above, so that their number is even.
  void find_stretches(int f, glm::dvec3 line, const std::vector<double>& heights,
                      std::vector<double>& stretches) const {
    stretches.clear();
    const std::size_t n = heights.size();
    const auto corners = faces_.face(f);
    const glm::dvec3 centre = faces_.measure(f).centre;
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t j = i + 1 == n ? 0 : i + 1;
      if ((heights[i] < 0) == (heights[j] < 0)) continue;
      const glm::dvec3 p = corners[i] - centre;
      const glm::dvec3 q = corners[j] - centre;
      const double share = heights[i] / (heights[i] - heights[j]);
      stretches.push_back(glm::dot(p + share * (q - p) + centre, line));
    }
    std::ranges::sort(stretches);
  }

  const Faces& faces_;
  std::vector<double> heights_a_;
  std::vector<double> heights_b_;
  std::vector<double> stretches_a_;
  std::vector<double> stretches_b_;
};

bool boxes_meet(const Box3& a, const Box3& b) {
  return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y &&
         a.min.z <= b.max.z && b.min.z <= a.max.z;
}

int longest_axis(glm::dvec3 size) {
  if (size.x >= size.y && size.x >= size.z) return 0;
  return size.y >= size.z ? 1 : 2;
}

/// Boxes around boxes, halved by the faces' middles. Node n has its halves at left and left + 1.
class BoxTree {
 public:
  explicit BoxTree(const std::vector<Box3>& boxes) : boxes_(boxes), order_(boxes.size()) {
    std::iota(order_.begin(), order_.end(), 0);
    nodes_.push_back({{}, 0, static_cast<int>(order_.size()), -1});
    for (std::size_t n = 0; n < nodes_.size(); ++n) split(n);
  }

  /// Calls visit(i, j) once for each pair of boxes that meet, until it returns false; false when the work
  /// was cut off.
  template <class Visit>
  bool for_meeting_pairs(std::int64_t most_work, Visit visit) const {
    std::vector<std::array<int, 2>> stack{{0, 0}};
    while (!stack.empty()) {
      const auto [a, b] = stack.back();
      stack.pop_back();
      const Node& x = node(a);
      const Node& y = node(b);
      most_work -= 1 + (x.left < 0 && y.left < 0 ? (x.end - x.begin) * (y.end - y.begin) : 0);
      if (most_work < 0) return false;
      if (!boxes_meet(x.box, y.box)) continue;
      if (x.left < 0 && y.left < 0) {
        if (!visit_leaves(x, y, visit)) return false;
      } else if (a == b) {
        stack.push_back({x.left, x.left});
        stack.push_back({x.left + 1, x.left + 1});
        stack.push_back({x.left, x.left + 1});
      } else if (y.left < 0 || (x.left >= 0 && x.end - x.begin > y.end - y.begin)) {
        stack.push_back({x.left, b});
        stack.push_back({x.left + 1, b});
      } else {
        stack.push_back({a, y.left});
        stack.push_back({a, y.left + 1});
      }
    }
    return true;
  }

 private:
  struct Node {
    Box3 box;
    int begin;
    int end;
    int left;
  };
  static constexpr int kLeaf = 4;

  [[nodiscard]] const Node& node(int n) const { return nodes_[static_cast<std::size_t>(n)]; }
  [[nodiscard]] const Box3& box(int i) const {
    return boxes_[static_cast<std::size_t>(order_[static_cast<std::size_t>(i)])];
  }

  void split(std::size_t n) {
    const int begin = nodes_[n].begin;
    const int end = nodes_[n].end;
    Box3 middles;
    for (int i = begin; i < end; ++i) {
      nodes_[n].box.add(box(i));
      middles.add(box(i).centre());
    }
    if (end - begin <= kLeaf) return;
    const int axis = longest_axis(middles.size());
    const int half = (begin + end) / 2;
    std::nth_element(order_.begin() + begin, order_.begin() + half, order_.begin() + end, [&](int a, int b) {
      const double at_a = boxes_[static_cast<std::size_t>(a)].centre()[axis];
      const double at_b = boxes_[static_cast<std::size_t>(b)].centre()[axis];
      return at_a != at_b ? at_a < at_b : a < b;
    });
    nodes_[n].left = static_cast<int>(nodes_.size());
    nodes_.push_back({{}, begin, half, -1});
    nodes_.push_back({{}, half, end, -1});
  }

  template <class Visit>
  bool visit_leaves(const Node& x, const Node& y, Visit& visit) const {
    for (int i = x.begin; i < x.end; ++i) {
      for (int j = &x == &y ? i + 1 : y.begin; j < y.end; ++j) {
        if (boxes_meet(box(i), box(j)) &&
            !visit(order_[static_cast<std::size_t>(i)], order_[static_cast<std::size_t>(j)]))
          return false;
      }
    }
    return true;
  }

  const std::vector<Box3>& boxes_;
  std::vector<int> order_;
  std::vector<Node> nodes_;
};

SelfIntersections find_crossings(const Faces& faces) {
  constexpr std::int64_t kMostWork = 40'000'000;
  constexpr std::size_t kMostPairs = 100'000;
  std::int64_t corners_left = 400'000'000;  // of the faces compared, which may have very many
  SelfIntersections found;
  if (faces.size() == 0) return found;
  CrossingTest cross_each_other(faces);
  const BoxTree tree(faces.boxes);
  found.is_complete = tree.for_meeting_pairs(kMostWork, [&](int i, int j) {
    const int a = std::min(i, j);
    const int b = std::max(i, j);
    if (cross_each_other(a, b)) found.pairs.emplace_back(a, b);
    corners_left -= static_cast<std::int64_t>(faces.face(a).size() + faces.face(b).size());
    return found.pairs.size() < kMostPairs && corners_left > 0;
  });
  std::ranges::sort(found.pairs);
  return found;
}

}  // namespace

SelfIntersections find_self_intersections(const PolygonSoup& soup) {
  Faces faces;
  for (int f = 0; f < soup.n_faces(); ++f) {
    for (const int point : soup.face(f))
      faces.corners.push_back(soup.points[static_cast<std::size_t>(point)]);
    faces.finish_face(repair::measure_face(soup, f));
  }
  return find_crossings(faces);
}

SelfIntersections find_self_intersections(const Mesh& mesh) {
  Faces faces;
  for (const FaceId f : mesh.faces()) {
    for (const HalfedgeId h : mesh.halfedges(f)) faces.corners.push_back(mesh.position(h));
    faces.finish_face(
        {mesh.centre(f), mesh.normal(f), mesh.size(f), mesh.unevenness(f), true, mesh.side_unevenness(f)});
  }
  return find_crossings(faces);
}

std::vector<std::pair<FaceId, FaceId>> self_intersections(const Mesh& mesh) {
  std::vector<std::pair<FaceId, FaceId>> pairs;
  for (const auto& [a, b] : find_self_intersections(mesh).pairs) pairs.emplace_back(FaceId(a), FaceId(b));
  return pairs;
}

}  // namespace netwright
