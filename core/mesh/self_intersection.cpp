// Sweeps boxes along the longest axis for candidate pairs; two faces cross when each has corners on both
// sides of the other's plane and the stretches they cut out of the common line of both planes overlap.
#include "core/mesh/self_intersection.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>

#include "core/base/geometry.h"
#include "core/base/predicates.h"

namespace netwright {
namespace {

/// A face and its box.
struct Candidate {
  FaceId face;
  Box3 box;
};

class CrossingTest {
 public:
  explicit CrossingTest(const Mesh& mesh) : mesh_(mesh) {}

  bool operator()(FaceId a, FaceId b) {
    const double touch = kCrossingDepth * std::max(mesh_.size(a), mesh_.size(b));
    if (!measure(a, b, touch + mesh_.unevenness(b) * mesh_.size(b), heights_a_)) return false;
    if (!measure(b, a, touch + mesh_.unevenness(a) * mesh_.size(a), heights_b_)) return false;
    const glm::dvec3 line = glm::cross(mesh_.normal(a), mesh_.normal(b));
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
  bool measure(FaceId f, FaceId other, double touch, std::vector<double>& heights) const {
    heights.clear();
    bool has_above = false;
    bool has_below = false;
    for (const HalfedgeId h : mesh_.halfedges(f)) {
      double height = glm::dot(mesh_.position(h) - mesh_.centre(other), mesh_.normal(other));
      if (std::abs(height) <= touch) height = 0;
      has_above |= height > 0;
      has_below |= height < 0;
      heights.push_back(height);
    }
    return has_above && has_below;
  }

  /// Where the outline of f passes through the other plane, sorted along the line: pairs bound the stretches
  /// that lie inside f. Corners on the plane count as above, so that their number is even.
  void find_stretches(FaceId f, glm::dvec3 line, const std::vector<double>& heights,
                      std::vector<double>& stretches) const {
    stretches.clear();
    const std::size_t n = heights.size();
    const HalfedgeId first = mesh_.first(f);
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t j = i + 1 == n ? 0 : i + 1;
      if ((heights[i] < 0) == (heights[j] < 0)) continue;
      const glm::dvec3 p = mesh_.position(HalfedgeId(first.index() + i)) - mesh_.centre(f);
      const glm::dvec3 q = mesh_.position(HalfedgeId(first.index() + j)) - mesh_.centre(f);
      const double share = heights[i] / (heights[i] - heights[j]);
      stretches.push_back(glm::dot(p + share * (q - p) + mesh_.centre(f), line));
    }
    std::ranges::sort(stretches);
  }

  const Mesh& mesh_;
  std::vector<double> heights_a_;
  std::vector<double> heights_b_;
  std::vector<double> stretches_a_;
  std::vector<double> stretches_b_;
};

std::vector<Candidate> sorted_candidates(const Mesh& mesh, int axis) {
  std::vector<Candidate> candidates;
  candidates.reserve(mesh.n_faces());
  for (const FaceId f : mesh.faces()) {
    Candidate candidate{.face = f, .box = {}};
    for (const HalfedgeId h : mesh.halfedges(f)) candidate.box.add(mesh.position(h));
    candidates.push_back(candidate);
  }
  std::ranges::sort(candidates, {}, [axis](const Candidate& c) { return c.box.min[axis]; });
  return candidates;
}

bool boxes_meet(const Box3& a, const Box3& b) {
  return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y &&
         a.min.z <= b.max.z && b.min.z <= a.max.z;
}

int longest_axis(glm::dvec3 size) {
  if (size.x >= size.y && size.x >= size.z) return 0;
  return size.y >= size.z ? 1 : 2;
}

}  // namespace

std::vector<std::pair<FaceId, FaceId>> self_intersections(const Mesh& mesh) {
  const int axis = longest_axis(mesh.box().size());
  const std::vector<Candidate> candidates = sorted_candidates(mesh, axis);
  CrossingTest cross_each_other(mesh);
  std::vector<std::pair<FaceId, FaceId>> pairs;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Candidate& a = candidates[i];
    for (std::size_t j = i + 1; j < candidates.size() && candidates[j].box.min[axis] <= a.box.max[axis];
         ++j) {
      const Candidate& b = candidates[j];
      if (!boxes_meet(a.box, b.box) || !cross_each_other(a.face, b.face)) continue;
      pairs.emplace_back(std::min(a.face, b.face), std::max(a.face, b.face));
    }
  }
  std::ranges::sort(pairs);
  return pairs;
}

}  // namespace netwright
