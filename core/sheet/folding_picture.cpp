// Pictures of the folding, by the painter's order: far faces first, every face followed by its own edges, all
// as fills, so that what is nearer covers what is behind it.
#include <algorithm>
#include <cmath>

#include "core/sheet/instructions.h"
#include "core/unfold/fold_pose.h"

namespace netwright {

namespace {

constexpr double kEdgeWidth = 0.14;                // mm
constexpr std::size_t kMostFacesWithEdges = 4000;  // more than that is black at this size
constexpr glm::dvec3 kOutside{0.80, 0.87, 0.96};
constexpr glm::dvec3 kInside{0.97, 0.93, 0.85};
constexpr glm::dvec3 kEdgeInk{0.22, 0.25, 0.3};

/// Looks along `depth`, which grows away from the eye; `right` and `down` span the picture.
struct View {
  glm::dvec3 right{1, 0, 0};
  glm::dvec3 down{0, -1, 0};
  glm::dvec3 depth{0, 0, -1};
};

/// The turn that takes an eye looking along -z, x to the right, to one that `to_eye` points at.
glm::dquat turn_towards(const glm::dvec3& to_eye, const glm::dvec3& up) {
  const glm::dvec3 right = glm::normalize(glm::cross(up, to_eye));
  return glm::normalize(glm::quat_cast(glm::dmat3(right, glm::cross(to_eye, right), to_eye)));
}

/// The flat net is seen as printed, the model standing, from the front, a little from the right and above;
/// between the two the eye wanders.
View view_of(const Mesh& mesh, FaceId held, double amount) {
  const bool is_y_up = mesh.up_axis() == UpAxis::Y;
  const glm::dvec3 up = is_y_up ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
  const glm::dvec3 front = is_y_up ? glm::dvec3(0, 0, 1) : glm::dvec3(0, -1, 0);
  const glm::dvec3 normal = glm::normalize(mesh.normal(held));
  const bool is_level = std::abs(glm::dot(normal, up)) > 0.99;
  const glm::dquat flat = turn_towards(normal, is_level ? front : up);
  const glm::dquat standing =
      turn_towards(glm::normalize(0.75 * front + 0.5 * glm::cross(up, front) + 0.42 * up), up);
  const glm::dquat turn = glm::slerp(flat, standing, amount);
  return {turn * glm::dvec3(1, 0, 0), turn * glm::dvec3(0, -1, 0), turn * glm::dvec3(0, 0, -1)};
}

struct SeenFace {
  FaceId face;
  double depth = 0;
  glm::dvec3 colour{1, 1, 1};
  std::vector<glm::dvec2> points;
};

/// Newell's normal, which needs no face to be even.
glm::dvec3 normal_of(const std::vector<glm::dvec3>& points) {
  glm::dvec3 normal(0);
  for (std::size_t i = 0; i < points.size(); ++i)
    normal += glm::cross(points[i], points[(i + 1) % points.size()]);
  const double length = glm::length(normal);
  return length > 0 ? normal / length : glm::dvec3(0, 0, 1);
}

SeenFace see(const Mesh& mesh, FaceId f, const IdVector<HalfedgeId, glm::dvec3>& corners, const View& view) {
  SeenFace seen{f, 0, {}, {}};
  std::vector<glm::dvec3> points;
  for (const HalfedgeId h : mesh.halfedges(f)) {
    points.push_back(corners[h]);
    seen.points.emplace_back(glm::dot(corners[h], view.right), glm::dot(corners[h], view.down));
    seen.depth += glm::dot(corners[h], view.depth) / mesh.degree(f);
  }
  for (glm::dvec3& p : points) p -= corners[mesh.first(f)];
  const glm::dvec3 normal = normal_of(points);
  const bool is_outside = glm::dot(normal, view.depth) < 0;
  const glm::dvec3 light = glm::normalize(-view.depth - 0.5 * view.down - 0.6 * view.right);
  const double shade = 0.62 + 0.38 * std::abs(glm::dot(normal, light));
  seen.colour = (is_outside ? kOutside : kInside) * shade;
  return seen;
}

Fill edge_fill(glm::dvec2 from, glm::dvec2 to) {
  const glm::dvec2 along = to - from;
  const double length = glm::length(along);
  const glm::dvec2 half =
      length > 0 ? glm::dvec2(-along.y, along.x) * (kEdgeWidth / 2 / length) : glm::dvec2(0);
  return {Layer::Print, {from + half, to + half, to - half, from - half}, kEdgeInk};
}

}  // namespace

std::vector<Fill> folding_picture(const Net& net, double amount, const Box2& box) {
  const Mesh& mesh = net.mesh();
  const FoldPath path(net);
  const View view = view_of(mesh, path.held(), std::clamp(amount, 0.0, 1.0));
  const IdVector<HalfedgeId, glm::dvec3> corners = path.corners(amount);
  std::vector<SeenFace> faces;
  Box2 seen{glm::dvec2(1e300), glm::dvec2(-1e300)};
  for (const FaceId f : mesh.faces()) {
    faces.push_back(see(mesh, f, corners, view));
    for (const glm::dvec2 p : faces.back().points) seen = {glm::min(seen.min, p), glm::max(seen.max, p)};
  }
  std::ranges::stable_sort(faces, std::greater<>(), &SeenFace::depth);

  const glm::dvec2 room = box.size() / glm::max(seen.size(), glm::dvec2(1e-12));
  const double scale = std::min(room.x, room.y);
  const glm::dvec2 shift = box.centre() - seen.centre() * scale;
  std::vector<Fill> fills;
  for (SeenFace& face : faces) {
    for (glm::dvec2& p : face.points) p = p * scale + shift;
    fills.push_back({Layer::Print, face.points, face.colour});
    if (mesh.n_faces() > kMostFacesWithEdges) continue;
    std::size_t i = 0;
    for (const HalfedgeId h : mesh.halfedges(face.face)) {
      const std::size_t next = (i + 1) % face.points.size();
      if (!net.dual->is_hidden(mesh.edge(h))) fills.push_back(edge_fill(face.points[i], face.points[next]));
      ++i;
    }
  }
  return fills;
}

}  // namespace netwright
