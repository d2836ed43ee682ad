// Proof, part two: what is joined to what, in the net and on the model. The net must fall into the expected
// number of trees, no face may be mirrored, and every cut must have its partner.
#include <algorithm>
#include <numeric>
#include <tuple>

#include "core/unfold/verify_checks.h"

namespace netwright::proof {
namespace {

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

// Corners listed clockwise among counter-clockwise ones: programs that trust the lists would cut that face
// out wrong side up.
void check_listing(const Subject& s, Faults& faults) {
  std::vector<int> left;
  std::vector<int> right;
  for (std::size_t f = 0; f < s.turn.size(); ++f)
    (s.turn[f] > 0 ? left : right).push_back(static_cast<int>(f));
  const std::vector<int>& fewer = right.size() <= left.size() ? right : left;
  if (!fewer.empty())
    faults.push_back(about_faces(s.net, fewer, "lists its", "list their") +
                     " corners the other way round than the rest of the net.");
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
  } else {
    check_listing(s, faults);
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

}  // namespace netwright::proof
