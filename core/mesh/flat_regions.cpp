// Grows regions face by face against the area-weighted mean plane of what was taken so far, so that a chain
// of tiny bends cannot add up to a curve. The largest faces go first: their planes are known best.
#include "core/mesh/flat_regions.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/geometry.h"
#include "core/base/predicates.h"

namespace netwright {

double rounding_of(const Mesh& mesh, double tolerance_rad) {
  return mesh.box().diagonal() * (kSamePlane + kMergeRounding * std::min(1.0, tolerance_rad / kMergeAngle));
}

PlaneTest::PlaneTest(const Mesh& mesh, double tolerance_rad)
    : mesh_(mesh), sine_(std::sin(tolerance_rad)), rounding_(rounding_of(mesh, tolerance_rad)) {}

bool PlaneTest::holds(FaceId f, const Plane& plane) const {
  const glm::dvec3& normal = mesh_.normal(f);
  if (glm::dot(normal, plane.normal) <= 0) return false;
  if (glm::length(glm::cross(normal, plane.normal)) <= sine_) return true;
  for (const HalfedgeId h : mesh_.halfedges(f)) {
    if (std::abs(glm::dot(mesh_.position(h) - plane.point, plane.normal)) > rounding_) return false;
  }
  return true;
}

UvMap::UvMap(const Mesh& mesh, FaceId f) : origin_(mesh.centre(f)) {
  for (const HalfedgeId h : mesh.halfedges(f)) uv_origin_ += mesh.uv(h) / static_cast<double>(mesh.degree(f));
  const glm::dvec3 n = mesh.normal(f);
  const glm::dvec3 side = mesh.position(mesh.next(mesh.first(f))) - mesh.position(mesh.first(f));
  const glm::dvec3 x = glm::normalize(side - n * glm::dot(side, n));
  const glm::dvec3 y = glm::cross(n, x);
  double xx = 0;
  double xy = 0;
  double yy = 0;
  glm::dvec2 x_sum(0);
  glm::dvec2 y_sum(0);
  for (const HalfedgeId h : mesh.halfedges(f)) {
    const glm::dvec2 at(glm::dot(mesh.position(h) - origin_, x), glm::dot(mesh.position(h) - origin_, y));
    const glm::dvec2 uv = mesh.uv(h) - uv_origin_;
    xx += at.x * at.x;
    xy += at.x * at.y;
    yy += at.y * at.y;
    x_sum += at.x * uv;
    y_sum += at.y * uv;
  }
  // Not zero: the face has an area.
  const double determinant = xx * yy - xy * xy;
  const glm::dvec2 by_x = (yy * x_sum - xy * y_sum) / determinant;
  const glm::dvec2 by_y = (xx * y_sum - xy * x_sum) / determinant;
  u_slope_ = by_x.x * x + by_y.x * y;
  v_slope_ = by_x.y * x + by_y.y * y;
}

bool UvMap::fits(const Mesh& mesh, FaceId f) const {
  for (const HalfedgeId h : mesh.halfedges(f)) {
    const glm::dvec3 d = mesh.position(h) - origin_;
    const glm::dvec2 expected = uv_origin_ + glm::dvec2(glm::dot(u_slope_, d), glm::dot(v_slope_, d));
    if (!(glm::length(mesh.uv(h) - expected) <= kSameUv)) return false;
  }
  return true;
}

std::vector<std::vector<FaceId>> FlatRegions::grow(std::span<const FaceId> faces, double tolerance_rad) {
  const PlaneTest test(mesh_, tolerance_rad);
  std::vector<FaceId> seeds(faces.begin(), faces.end());
  std::sort(seeds.begin(), seeds.end(), [&](FaceId a, FaceId b) {
    return mesh_.area(a) != mesh_.area(b) ? mesh_.area(a) > mesh_.area(b) : a < b;
  });
  for (const FaceId f : seeds) is_free_[f] = 1;
  std::vector<std::vector<FaceId>> regions;
  for (const FaceId seed : seeds) {
    if (is_free_[seed] != 0) regions.push_back(grow_from(seed, test));
  }
  return regions;
}

std::vector<FaceId> FlatRegions::grow_from(FaceId seed, const PlaneTest& test) {
  std::vector<FaceId> region;
  std::vector<FaceId> candidates;
  glm::dvec3 normal_sum(0);
  glm::dvec3 centre_sum(0);
  double area = 0;
  const auto take = [&](FaceId f) {
    is_free_[f] = 0;
    region.push_back(f);
    normal_sum += mesh_.area(f) * mesh_.normal(f);
    centre_sum += mesh_.area(f) * mesh_.centre(f);
    area += mesh_.area(f);
    for (const HalfedgeId h : mesh_.halfedges(f)) {
      const FaceId g = mesh_.neighbour(h);
      if (g.is_valid() && is_free_[g] != 0 && mesh_.material(g) == mesh_.material(seed))
        candidates.push_back(g);
    }
  };
  take(seed);
  std::optional<UvMap> uv;
  if (mesh_.has_uv()) uv.emplace(mesh_, seed);
  if (uv && !uv->fits(mesh_, seed)) return region;

  // Whoever was refused is asked again while the plane still moves.
  for (bool is_growing = true; is_growing && !candidates.empty();) {
    is_growing = false;
    std::vector<FaceId> refused;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const FaceId f = candidates[i];
      if (is_free_[f] == 0) continue;
      const Plane plane{centre_sum / area, glm::normalize(normal_sum)};
      if (test.holds(f, plane) && (!uv || uv->fits(mesh_, f))) {
        take(f);
        is_growing = true;
      } else {
        refused.push_back(f);
      }
    }
    std::sort(refused.begin(), refused.end());
    refused.erase(std::unique(refused.begin(), refused.end()), refused.end());
    candidates = std::move(refused);
  }
  std::sort(region.begin(), region.end());
  return region;
}

}  // namespace netwright
