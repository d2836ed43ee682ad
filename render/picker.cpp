// Picking on the CPU. The model's box tree halves its triangles at the median of the longest side; the net's
// grid has about one cell per face and lists the convex parts that touch each.
#include "render/picker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace netwright {
namespace {

constexpr int kLeafTriangles = 4;
constexpr double kMiss = std::numeric_limits<double>::infinity();

double axis_of(const glm::dvec3& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

/// Where the ray enters the box, or kMiss.
double enter(const Box3& box, const Ray& ray, const glm::dvec3& inverse) {
  const glm::dvec3 a = (box.min - ray.origin) * inverse;
  const glm::dvec3 b = (box.max - ray.origin) * inverse;
  const glm::dvec3 low = glm::min(a, b);
  const glm::dvec3 high = glm::max(a, b);
  const double from = std::max({low.x, low.y, low.z, 0.0});
  return from <= std::min({high.x, high.y, high.z}) ? from : kMiss;
}

/// Distance along the ray to the triangle, or kMiss (Moeller and Trumbore).
double hit(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const Ray& ray) {
  const glm::dvec3 u = b - a;
  const glm::dvec3 v = c - a;
  const glm::dvec3 p = glm::cross(ray.direction, v);
  const double determinant = glm::dot(u, p);
  if (determinant == 0) return kMiss;
  const glm::dvec3 s = ray.origin - a;
  const double x = glm::dot(s, p) / determinant;
  const glm::dvec3 q = glm::cross(s, u);
  const double y = glm::dot(ray.direction, q) / determinant;
  if (x < 0 || y < 0 || x + y > 1) return kMiss;
  const double t = glm::dot(v, q) / determinant;
  return t >= 0 ? t : kMiss;
}

}  // namespace

void ModelPicker::set_model(std::shared_ptr<const DualGraph> dual) {
  if (dual == dual_) return;
  dual_ = std::move(dual);
  pose_version_ = 0;
  triangles_.clear();
  nodes_.clear();
  if (dual_) collect(ModelPose(dual_->mesh()));
}

void ModelPicker::set_pose(const Corners* corners, std::uint64_t version) {
  if (version == pose_version_ || !dual_) return;
  pose_version_ = version;
  collect(ModelPose(dual_->mesh(), corners));
}

void ModelPicker::collect(const ModelPose& pose) {
  triangles_.clear();
  nodes_.clear();
  for (const FaceId f : pose.mesh().faces()) {
    const auto corner = [&](int k) { return pose.position(HalfedgeId(pose.mesh().first(f).value + k)); };
    for (int p = 0; p < dual_->n_parts(f); ++p) {
      const std::span<const int> part = dual_->part(f, p);
      for (std::size_t k = 2; k < part.size(); ++k)
        triangles_.push_back({corner(part[0]), corner(part[k - 1]), corner(part[k]), f});
    }
  }
  build();
}

void ModelPicker::build() {
  if (triangles_.empty()) return;
  nodes_.push_back({{}, 0, static_cast<int>(triangles_.size())});
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    Node node = nodes_[n];
    const auto begin = triangles_.begin() + node.first;
    const auto end = begin + node.count;
    Box3 middles;
    for (auto t = begin; t != end; ++t) {
      for (const glm::dvec3& p : {t->a, t->b, t->c}) node.box.add(p);
      middles.add((t->a + t->b + t->c) / 3.0);
    }
    if (node.count > kLeafTriangles) {
      const glm::dvec3 size = middles.size();
      const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
      const int half = node.count / 2;
      std::nth_element(begin, begin + half, end, [axis](const Triangle& a, const Triangle& b) {
        return axis_of(a.a + a.b + a.c, axis) < axis_of(b.a + b.b + b.c, axis);
      });
      const auto child = static_cast<int>(nodes_.size());
      nodes_.push_back({{}, node.first, half});
      nodes_.push_back({{}, node.first + half, node.count - half});
      node.first = child;
      node.count = 0;
    }
    nodes_[n] = node;
  }
}

FaceId ModelPicker::pick(const Ray& ray) const {
  FaceId best;
  if (nodes_.empty()) return best;
  const glm::dvec3 inverse = 1.0 / ray.direction;
  double nearest = kMiss;
  // Halving keeps the tree's depth at the logarithm of the triangles: 64 open nodes are always enough.
  std::array<int, 64> open{};
  std::size_t n_open = 1;
  while (n_open > 0) {
    const Node& node = nodes_[static_cast<std::size_t>(open[--n_open])];
    if (enter(node.box, ray, inverse) >= nearest) continue;
    if (node.count == 0) {
      open[n_open++] = node.first;
      open[n_open++] = node.first + 1;
      continue;
    }
    for (int k = node.first; k < node.first + node.count; ++k) {
      const Triangle& t = triangles_[static_cast<std::size_t>(k)];
      const double distance = hit(t.a, t.b, t.c, ray);
      if (distance >= nearest) continue;
      nearest = distance;
      best = t.face;
    }
  }
  return best;
}

void NetPicker::clear() {
  version_ = 0;
  corners_.clear();
  parts_.clear();
  cell_begin_.clear();
  cell_parts_.clear();
}

int NetPicker::column(double x) const {
  return static_cast<int>(std::clamp(std::floor((x - box_.min.x) / cell_), 0.0, columns_ - 1.0));
}

int NetPicker::row(double y) const {
  return static_cast<int>(std::clamp(std::floor((y - box_.min.y) / cell_), 0.0, rows_ - 1.0));
}

void NetPicker::set_net(const Net& net, std::uint64_t version) {
  if (version != 0 && version == version_) return;
  clear();
  version_ = version;
  box_ = Box2();
  collect_parts(net);
  if (!parts_.empty()) fill_grid();
}

void NetPicker::collect_parts(const Net& net) {
  const Mesh& mesh = net.mesh();
  for (const FaceId f : mesh.faces()) {
    for (int p = 0; p < net.dual->n_parts(f); ++p) {
      const std::span<const int> part = net.dual->part(f, p);
      parts_.push_back({static_cast<int>(corners_.size()), static_cast<int>(part.size()), f});
      for (const int c : part) {
        corners_.push_back(net.corner(HalfedgeId(mesh.first(f).value + c)));
        box_.add(corners_.back());
      }
    }
  }
}

Box2 NetPicker::part_box(const Part& part) const {
  Box2 box;
  for (int k = 0; k < part.count; ++k) box.add(corners_[static_cast<std::size_t>(part.first + k)]);
  return box;
}

void NetPicker::fill_grid() {
  const glm::dvec2 size = box_.size();
  const double per_side = std::ceil(std::sqrt(static_cast<double>(parts_.size())));
  cell_ = std::max({size.x / per_side, size.y / per_side, std::numeric_limits<double>::min()});
  columns_ = static_cast<int>(size.x / cell_) + 1;
  rows_ = static_cast<int>(size.y / cell_) + 1;
  // Counting sort: first how many parts each cell has, then the parts themselves.
  cell_begin_.assign(static_cast<std::size_t>(columns_ * rows_) + 1, 0);
  const auto for_cells = [this](const Part& part, auto&& action) {
    const Box2 box = part_box(part);
    for (int r = row(box.min.y); r <= row(box.max.y); ++r)
      for (int c = column(box.min.x); c <= column(box.max.x); ++c)
        action(static_cast<std::size_t>(r * columns_ + c));
  };
  for (const Part& part : parts_) for_cells(part, [this](std::size_t cell) { ++cell_begin_[cell + 1]; });
  for (std::size_t k = 1; k < cell_begin_.size(); ++k) cell_begin_[k] += cell_begin_[k - 1];
  cell_parts_.resize(static_cast<std::size_t>(cell_begin_.back()));
  std::vector<int> next(cell_begin_.begin(), cell_begin_.end() - 1);
  for (std::size_t p = 0; p < parts_.size(); ++p)
    for_cells(parts_[p], [&](std::size_t cell) {
      cell_parts_[static_cast<std::size_t>(next[cell]++)] = static_cast<int>(p);
    });
}

bool NetPicker::contains(const Part& part, glm::dvec2 point) const {
  const auto at = [&](int k) { return corners_[static_cast<std::size_t>(part.first + k)]; };
  for (int k = 0; k < part.count; ++k) {
    const glm::dvec2 a = at(k);
    if (cross(at((k + 1) % part.count) - a, point - a) < 0) return false;
  }
  return true;
}

FaceId NetPicker::pick(glm::dvec2 point) const {
  if (parts_.empty() || point.x < box_.min.x || point.y < box_.min.y || point.x > box_.max.x ||
      point.y > box_.max.y)
    return FaceId();
  const auto cell = static_cast<std::size_t>(row(point.y) * columns_ + column(point.x));
  // Parts are listed in the order of their faces, which is the order of painting: the last hit is on top.
  for (int k = cell_begin_[cell + 1] - 1; k >= cell_begin_[cell]; --k) {
    const Part& part = parts_[static_cast<std::size_t>(cell_parts_[static_cast<std::size_t>(k)])];
    if (contains(part, point)) return part.face;
  }
  return FaceId();
}

}  // namespace netwright
