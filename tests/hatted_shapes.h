// Shapes with and without a net that several tests of impossibility share.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/support.h"

namespace netwright::testing {

/// An octahedron, one face of which wears a hat: its faces come first, three to a side: outer, inner, tip.
inline PolygonSoup one_hat() {
  const PolygonSoup plain = shapes::octahedron();
  PolygonSoup first = plain;
  first.face_begin = {0};
  first.corners.clear();
  first.add_face(plain.face(0));
  PolygonSoup soup = with_hats(first);
  for (int f = 1; f < plain.n_faces(); ++f) soup.add_face(plain.face(f));
  return soup;
}

/// How a cup is drawn at random: each is the least of a value and how much more it may be.
struct CupRange {
  double spread, more_spread;  ///< of the rim below, against the lid
  double height, more_height;
  double turn;               ///< of a corner of the lid, in eighths of a full turn
  double point, more_point;  ///< distances of the lid's points and notches from the middle
  double notch, more_notch;
};

/// A star of four points with walls that lean outwards all around, open below: in narrow notches the walls
/// may have no room.
inline PolygonSoup random_cup(Random& random, const CupRange& range) {
  constexpr int n = 8;
  const double spread = range.spread + range.more_spread * random.unit();
  const double height = range.height + range.more_height * random.unit();
  PolygonSoup soup;
  std::vector<int> lid;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * (i + range.turn * random.unit()) / n;
    const bool is_point = i % 2 == 0;
    const double more = is_point ? range.more_point : range.more_notch;
    const double r = (is_point ? range.point : range.notch) + (more > 0 ? more * random.unit() : 0);
    soup.points.emplace_back(r * std::cos(angle), r * std::sin(angle), height);
    lid.push_back(i);
  }
  soup.add_face(lid);
  for (int i = 0; i < n; ++i) {
    const glm::dvec3 above = soup.points[static_cast<std::size_t>(i)];
    soup.points.emplace_back(spread * above.x, spread * above.y, 0);
    const int j = (i + 1) % n;
    soup.add_face(std::vector<int>{j, i, n + i, n + j});
  }
  return soup;
}

}  // namespace netwright::testing
