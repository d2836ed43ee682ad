// Proof, part two, continued: the list of edges. Each edge of the net stands there once, cuts are marked as
// boundary, and every fold is a mountain, a valley or flat as it is on the model, at the angle it has there.
#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/base/geometry.h"
#include "core/base/predicates.h"
#include "core/unfold/verify_checks.h"

namespace netwright::proof {
namespace {

/// Folds bent less than this (0.1 degree) may be marked either way.
constexpr double kEitherWay = 0.0017453292519943296;

/// A written fold angle may be off by this much (radians): thin faces have no better normals.
constexpr double kAngleSlack = 1e-3;

glm::dvec3 unit_normal(const Subject& s, int face) {
  const std::vector<int>& corners = s.net.faces[static_cast<std::size_t>(face)];
  const auto at = [&](std::size_t i) {
    return s.folded[static_cast<std::size_t>(corners[i % corners.size()])];
  };
  double size = 0;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const glm::dvec3 d = at(i) - at(0);
    size = std::max({size, std::abs(d.x), std::abs(d.y), std::abs(d.z)});
  }
  glm::dvec3 normal(0);
  if (!(size > 0)) return normal;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    normal += glm::cross((at(i) - at(0)) / size, (at(i + 1) - at(0)) / size);
  }
  const double length = glm::length(normal);
  return length > 0 ? normal / length : normal;
}

/// Bend at a join, radians: positive where it is convex seen from the printed side (a mountain). The printed
/// side is the one from which the flat face runs counter-clockwise.
double bend(const Subject& s, const Side& a, const Side& b) {
  const std::vector<int>& corners = s.net.faces[static_cast<std::size_t>(a.face)];
  const auto i = static_cast<std::size_t>(a.corner);
  const double turn_a = s.turn[static_cast<std::size_t>(a.face)];
  const double turn_b = s.turn[static_cast<std::size_t>(b.face)];
  glm::dvec3 along = s.folded[static_cast<std::size_t>(corners[(i + 1) % corners.size()])] -
                     s.folded[static_cast<std::size_t>(corners[i])];
  along *= turn_a / std::hypot(along.x, along.y, along.z);
  const glm::dvec3 normal_a = turn_a * unit_normal(s, a.face);
  const glm::dvec3 normal_b = turn_b * unit_normal(s, b.face);
  return std::atan2(glm::dot(glm::cross(normal_a, normal_b), along), glm::dot(normal_a, normal_b));
}

bool mark_fits(Assignment mark, double bend_rad) {
  constexpr double kHalfTurn = 3.14159265358979;
  const bool is_either = std::abs(bend_rad) < kEitherWay || std::abs(bend_rad) > kHalfTurn - kAngleSlack;
  switch (mark) {
    case Assignment::Mountain:
      return is_either || bend_rad > 0;
    case Assignment::Valley:
      return is_either || bend_rad < 0;
    case Assignment::Flat:
      return std::abs(bend_rad) <= kFlatFold + kAngleSlack;
    case Assignment::Boundary:
      return false;
  }
  return false;
}

bool angle_fits(double fold_angle_rad, double bend_rad) {
  if (fold_angle_rad == 0) return true;  // not written
  const double off = fold_angle_rad + bend_rad;
  return std::abs(std::remainder(off, 2 * 3.14159265358979323846)) <= kAngleSlack;
}

struct ListedEdge {
  int low = 0;
  int high = 0;
  const FlatNet::Edge* edge = nullptr;
};

bool comes_before(const ListedEdge& a, const ListedEdge& b) {
  return std::tie(a.low, a.high) < std::tie(b.low, b.high);
}

std::vector<ListedEdge> sorted_edges(const FlatNet& net) {
  std::vector<ListedEdge> listed;
  for (const FlatNet::Edge& e : net.edges) {
    listed.push_back({std::min(e.from, e.to), std::max(e.from, e.to), &e});
  }
  std::sort(listed.begin(), listed.end(), comes_before);
  return listed;
}

std::string between(const Subject& s, const Side& a, const Side& b) {
  return "The fold between faces " + face_name(s.net, a.face) + " and " + face_name(s.net, b.face);
}

}  // namespace

void check_edges(const Subject& s, Faults& faults) {
  Findings missing;
  Findings repeated;
  Findings marked;
  Findings angled;
  const std::vector<ListedEdge> listed = sorted_edges(s.net);
  std::size_t n_known = 0;
  for_each_edge(s.net_sides, [&](const Side* first, const Side* last) {
    const auto [begin, end] =
        std::equal_range(listed.begin(), listed.end(), ListedEdge{first->low, first->high}, comes_before);
    const std::ptrdiff_t count = end - begin;
    n_known += static_cast<std::size_t>(count);
    const std::string name = face_name(s.net, first->face);
    if (count == 0) missing.add("An edge of face " + name + " is missing from the net's list of edges");
    if (count > 1) repeated.add("An edge of face " + name + " is listed more than once");
    if (count != 1) return;
    const FlatNet::Edge& edge = *begin->edge;
    if (last - first == 1) {
      if (edge.assignment != Assignment::Boundary)
        marked.add("A cut edge of face " + name + " is marked as a fold");
      return;
    }
    const double bend_rad = bend(s, first[0], first[1]);
    if (!mark_fits(edge.assignment, bend_rad)) {
      marked.add(between(s, first[0], first[1]) + " is marked wrongly: on the model it is a " +
                 (bend_rad > 0 ? "mountain" : "valley"));
    } else if (!angle_fits(edge.fold_angle_rad, bend_rad)) {
      angled.add(between(s, first[0], first[1]) + " has the wrong angle");
    }
  });
  for (const Findings& findings : {missing, repeated, marked, angled}) findings.tell(faults);
  if (n_known < listed.size()) {
    faults.push_back("The list of edges names " + std::to_string(listed.size() - n_known) +
                     " that no face has.");
  }
}

}  // namespace netwright::proof
