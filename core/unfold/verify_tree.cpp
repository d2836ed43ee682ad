// Proof, part two: what is joined to what, in the net and on the model. The net must fall into the expected
// number of trees, no face may be mirrored, every cut must have its partner and every fold the right mark.
#include <algorithm>
#include <cmath>
#include <numeric>
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

class Groups {
 public:
  explicit Groups(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
  void unite(int a, int b) { at(find(a)) = find(b); }
  /// Numbers the groups from 0 on in order of their first member.
  std::vector<int> numbered(int& count) {
    std::vector<int> number(parent_.size(), -1);
    std::vector<int> result(parent_.size());
    count = 0;
    for (std::size_t i = 0; i < parent_.size(); ++i) {
      int& n = number[static_cast<std::size_t>(find(static_cast<int>(i)))];
      if (n < 0) n = count++;
      result[i] = n;
    }
    return result;
  }

 private:
  int& at(int i) { return parent_[static_cast<std::size_t>(i)]; }
  int find(int i) {
    while (at(i) != i) i = at(i) = at(at(i));
    return i;
  }
  std::vector<int> parent_;
};

/// All sides of all faces by the numbers of their ends, sorted; `number` turns a net point into an end.
template <class Number>
std::vector<Side> sorted_sides(const FlatNet& net, const Number& number) {
  std::vector<Side> sides;
  for (std::size_t f = 0; f < net.faces.size(); ++f) {
    const std::vector<int>& face = net.faces[f];
    for (std::size_t i = 0; i < face.size(); ++i) {
      const int a = number(face[i]);
      const int b = number(face[(i + 1) % face.size()]);
      sides.push_back({std::min(a, b), std::max(a, b), static_cast<int>(f), static_cast<int>(i), a < b});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.face, a.corner) < std::tie(b.low, b.high, b.face, b.corner);
  });
  return sides;
}

/// Sides at one edge of the model, by piece: components that touch in space without being connected there
/// share places too, and are told apart by the pieces they make.
std::vector<std::vector<Side>> partners(const Subject& s, const Side* first, const Side* last) {
  if (last - first <= 2) return {std::vector<Side>(first, last)};
  std::vector<std::vector<Side>> groups;
  for (const Side* side = first; side != last; ++side) {
    const int piece = s.piece[static_cast<std::size_t>(side->face)];
    const auto same = std::find_if(groups.begin(), groups.end(), [&](const std::vector<Side>& group) {
      return s.piece[static_cast<std::size_t>(group.front().face)] == piece;
    });
    if (same == groups.end()) {
      groups.push_back({*side});
    } else {
      same->push_back(*side);
    }
  }
  return groups;
}

struct Neighbour {
  int face = 0;
  bool runs_alike = false;  ///< the file winds both faces the same way round
};

std::vector<std::vector<Neighbour>> model_neighbours(const Subject& s) {
  std::vector<std::vector<Neighbour>> result(s.net.faces.size());
  for_each_edge(s.model_sides, [&](const Side* first, const Side* last) {
    for (const std::vector<Side>& group : partners(s, first, last)) {
      if (group.size() != 2) continue;
      const bool runs_alike = group[0].runs_up != group[1].runs_up;
      result[static_cast<std::size_t>(group[0].face)].push_back({group[1].face, runs_alike});
      result[static_cast<std::size_t>(group[1].face)].push_back({group[0].face, runs_alike});
    }
  });
  return result;
}

/// Walks one connected part of the model from `start`, giving each face the direction its neighbours ask for.
/// Returns the faces met; `is_two_sided` becomes false when a face is asked for both.
std::vector<int> spread_direction(const std::vector<std::vector<Neighbour>>& neighbours, int start,
                                  std::vector<int>& direction, bool& is_two_sided) {
  std::vector<int> met{start};
  direction[static_cast<std::size_t>(start)] = 1;
  for (std::size_t i = 0; i < met.size(); ++i) {
    const auto face = static_cast<std::size_t>(met[i]);
    for (const Neighbour& next : neighbours[face]) {
      int& known = direction[static_cast<std::size_t>(next.face)];
      const int wanted = next.runs_alike ? direction[face] : -direction[face];
      if (known == 0) {
        known = wanted;
        met.push_back(next.face);
      } else if (known != wanted) {
        is_two_sided = false;
      }
    }
  }
  return met;
}

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

/// The first finding of a kind in full, the others as a number.
class Findings {
 public:
  void add(const std::string& sentence) {
    if (count_++ == 0) first_ = sentence;
  }
  void tell(Faults& faults) const {
    if (count_ == 0) return;
    const std::string others = count_ == 1 ? "." : " (and " + std::to_string(count_ - 1) + " more like it).";
    faults.push_back(first_ + others);
  }

 private:
  std::string first_;
  int count_ = 0;
};

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

void connect(Subject& s) {
  s.net_sides = sorted_sides(s.net, [](int point) { return point; });
  s.model_sides = sorted_sides(s.net, [&](int point) { return s.place[static_cast<std::size_t>(point)]; });
  Groups pieces(s.net.faces.size());
  for_each_edge(s.net_sides, [&](const Side* first, const Side* last) {
    for (const Side* side = first + 1; side < last; ++side) {
      s.joins.push_back({*first, *side});
      pieces.unite(first->face, side->face);
    }
  });
  s.piece = pieces.numbered(s.n_pieces);
  Groups components(s.net.faces.size());
  for_each_edge(s.model_sides, [&](const Side* first, const Side* last) {
    for (const std::vector<Side>& group : partners(s, first, last)) {
      for (const Side& side : group) components.unite(group.front().face, side.face);
    }
  });
  components.numbered(s.n_components);
}

void check_orientation(const Subject& s, Faults& faults) {
  const std::vector<std::vector<Neighbour>> neighbours = model_neighbours(s);
  std::vector<int> direction(s.net.faces.size(), 0);
  std::vector<int> mirrored;
  bool is_two_sided = true;
  for (std::size_t f = 0; f < direction.size(); ++f) {
    if (direction[f] != 0) continue;
    const std::vector<int> met = spread_direction(neighbours, static_cast<int>(f), direction, is_two_sided);
    std::vector<int> same;
    std::vector<int> opposite;
    for (const int face : met) {
      const auto i = static_cast<std::size_t>(face);
      (direction[i] == s.turn[i] ? same : opposite).push_back(face);
    }
    const std::vector<int>& fewer = opposite.size() <= same.size() ? opposite : same;
    mirrored.insert(mirrored.end(), fewer.begin(), fewer.end());
  }
  if (!is_two_sided) {
    faults.emplace_back("The model's surface has only one side, so the net has no printed side.");
  } else if (!mirrored.empty()) {
    std::sort(mirrored.begin(), mirrored.end());
    faults.push_back(about_faces(s.net, mirrored, "is", "are") + " mirrored against the rest of the net.");
  }
}

void check_forest(const Subject& s, int expected_pieces, Faults& faults) {
  Findings crowded;
  for_each_edge(s.net_sides, [&](const Side* first, const Side* last) {
    if (last - first <= 2) return;
    crowded.add("Faces " + face_name(s.net, first->face) + ", " + face_name(s.net, first[1].face) + " and " +
                face_name(s.net, first[2].face) + " are joined at one edge of the net");
  });
  crowded.tell(faults);
  const auto n_faces = static_cast<std::ptrdiff_t>(s.net.faces.size());
  const std::ptrdiff_t extra = static_cast<std::ptrdiff_t>(s.joins.size()) - (n_faces - s.n_pieces);
  if (extra > 0) {
    faults.push_back("The folds of the net close " + std::to_string(extra) +
                     (extra == 1 ? " ring" : " rings") + " of faces; a net must be a tree.");
  }
  const int expected = expected_pieces > 0 ? expected_pieces : s.n_components;
  if (s.n_pieces != expected) {
    faults.push_back("The net has " + std::to_string(s.n_pieces) + (s.n_pieces == 1 ? " piece" : " pieces") +
                     " where " + std::to_string(expected) + (expected == 1 ? " is" : " are") + " expected.");
  }
}

void check_pairing(const Subject& s, Faults& faults) {
  Findings crowded;
  Findings without_length;
  for_each_edge(s.model_sides, [&](const Side* first, const Side* last) {
    if (first->low == first->high) {
      without_length.add("Face " + face_name(s.net, first->face) + " has a side without length on the model");
      return;
    }
    for (const std::vector<Side>& group : partners(s, first, last)) {
      if (group.size() <= 2) continue;
      crowded.add("An edge of face " + face_name(s.net, group.front().face) + " belongs to " +
                  std::to_string(group.size()) + " faces of the model, so its cuts cannot be paired");
    }
  });
  without_length.tell(faults);
  crowded.tell(faults);
}

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
