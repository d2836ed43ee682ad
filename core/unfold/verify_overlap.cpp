// Proof, part three: no two faces of a piece overlap. Every face is cut into convex parts with exact
// predicates; two parts are free of each other when some edge of one has the other beyond its line, but for a
// depth whose upper bound, all rounding counted, is kProofDepth mean edges. A doubtful pair counts as an
// overlap.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>
#include <span>

#include "core/base/geometry.h"
#include "core/base/predicates.h"
#include "core/unfold/verify_checks.h"

namespace netwright::proof {
namespace {

using Polygon = std::vector<glm::dvec2>;

/// Convex parts of a face, counter-clockwise. A concave face that is covered by k parts of which each is at
/// most d deep in another face holds no disc wider than k d of it (Bang's theorem on planks), so the parts
/// decide.
struct FaceParts {
  std::vector<Polygon> parts;
  Box2 box;
  bool is_simple = true;
};

Polygon counter_clockwise(const Subject& s, std::size_t face) {
  Polygon polygon;
  for (const int corner : s.net.faces[face]) polygon.push_back(s.points[static_cast<std::size_t>(corner)]);
  if (s.turn[face] < 0) std::reverse(polygon.begin(), polygon.end());
  return polygon;
}

/// +1 for a side that runs right (or straight up), -1 for the opposite; 0 for a side without length.
int heading(glm::dvec2 from, glm::dvec2 to) {
  if (from.x != to.x) return from.x < to.x ? 1 : -1;
  if (from.y != to.y) return from.y < to.y ? 1 : -1;
  return 0;
}

/// Exactly: no corner turns right, and the outline goes round once.
bool is_convex(const Polygon& p) {
  const std::size_t n = p.size();
  int changes = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec2 a = p[i];
    const glm::dvec2 b = p[(i + 1) % n];
    const glm::dvec2 c = p[(i + 2) % n];
    const int in = heading(a, b);
    const int out = heading(b, c);
    const int bend = orientation(a, b, c);
    if (in == 0 || bend < 0 || (bend == 0 && in != out)) return false;
    changes += in != out ? 1 : 0;
  }
  return changes == 2;
}

/// Exactly: is p within the closed counter-clockwise triangle?
bool is_in_triangle(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
  return orientation(a, b, p) >= 0 && orientation(b, c, p) >= 0 && orientation(c, a, p) >= 0;
}

bool cross_properly(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 d) {
  return orientation(a, b, c) * orientation(a, b, d) < 0 && orientation(c, d, a) * orientation(c, d, b) < 0;
}

/// Sides that cross, or corners at one point.
bool crosses_itself(const Polygon& p) {
  const std::size_t n = p.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      if (p[i] == p[j] || cross_properly(p[i], p[(i + 1) % n], p[j], p[(j + 1) % n])) return true;
    }
  }
  return false;
}

/// Can the corner at `k` of what is left be cut off? Its triangle must hold no other corner.
bool is_ear(const Polygon& left, std::size_t k) {
  const std::size_t n = left.size();
  const glm::dvec2 a = left[(k + n - 1) % n];
  const glm::dvec2 b = left[k];
  const glm::dvec2 c = left[(k + 1) % n];
  if (orientation(a, b, c) <= 0) return false;
  return std::none_of(left.begin(), left.end(),
                      [&](glm::dvec2 p) { return p != a && p != b && p != c && is_in_triangle(p, a, b, c); });
}

/// Ear clipping; false when the outline allows none, that is when it touches or crosses itself.
bool clip_ears(Polygon left, std::vector<Polygon>& triangles) {
  while (left.size() >= 3) {
    const std::size_t n = left.size();
    const auto neighbours = [&](std::size_t k) {
      return Polygon{left[(k + n - 1) % n], left[k], left[(k + 1) % n]};
    };
    std::size_t k = 0;
    while (k < n && !is_ear(left, k)) ++k;
    if (k < n) {
      triangles.push_back(neighbours(k));
    } else {  // corners in the middle of a straight side: nothing is lost with them
      k = 0;
      const auto is_straight = [&](const Polygon& t) { return orientation(t[0], t[1], t[2]) == 0; };
      while (k < n && !is_straight(neighbours(k))) ++k;
      if (k == n) return false;
    }
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(k));
  }
  return true;
}

FaceParts split(const Polygon& polygon) {
  FaceParts face;
  for (const glm::dvec2 p : polygon) face.box.add(p);
  if (is_convex(polygon)) {
    face.parts = {polygon};
  } else {
    face.is_simple = !crosses_itself(polygon) && clip_ears(polygon, face.parts);
  }
  return face;
}

/// At least how far `other` reaches over the line p -> q to its left: as a distance, so an upper bound of the
/// shift that frees a counter-clockwise convex polygon with this edge from it. Differences and products are
/// each off by 2^-53 of themselves at most; 2^-50 covers their sum, and then the division and the root.
double reach(glm::dvec2 p, glm::dvec2 q, const Polygon& other) {
  const glm::dvec2 e = q - p;
  const double length = std::hypot(e.x, e.y);
  if (!(length > 1e-150)) return std::numeric_limits<double>::infinity();  // its direction would be guesswork
  double farthest = -std::numeric_limits<double>::infinity();
  for (const glm::dvec2 corner : other) {
    const glm::dvec2 d = corner - p;
    const double left = e.x * d.y;
    const double right = e.y * d.x;
    farthest = std::max(farthest, (left - right) + 0x1p-50 * (std::abs(left) + std::abs(right)));
  }
  if (!(farthest > 0)) return 0;
  return farthest / length * (1 + 0x1p-49) + 0x1p-1000;  // the last term outweighs any underflow
}

/// Upper bound of the depth of two convex polygons; stops as soon as it is at most `enough`.
double depth(const Polygon& a, const Polygon& b, double enough) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < a.size() && least > enough; ++i) {
    least = std::min(least, reach(a[i], a[(i + 1) % a.size()], b));
  }
  for (std::size_t i = 0; i < b.size() && least > enough; ++i) {
    least = std::min(least, reach(b[i], b[(i + 1) % b.size()], a));
  }
  return least;
}

double depth(const FaceParts& a, const FaceParts& b, double enough) {
  double deepest = 0;
  for (const Polygon& p : a.parts) {
    for (const Polygon& q : b.parts) deepest = std::max(deepest, depth(p, q, enough));
  }
  return deepest;
}

bool boxes_meet(const Box2& a, const Box2& b) {
  return a.min.x < b.max.x && b.min.x < a.max.x && a.min.y < b.max.y && b.min.y < a.max.y;
}

/// All pairs whose boxes meet, by a sweep along the longer way.
template <class Visit>
void for_each_candidate(const std::vector<FaceParts>& faces, const Visit& visit) {
  Box2 all;
  for (const FaceParts& face : faces) all.add(face.box);
  const int axis = all.size().x >= all.size().y ? 0 : 1;
  std::vector<std::size_t> order(faces.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return faces[a].box.min[axis] < faces[b].box.min[axis]; });
  std::vector<std::size_t> open;
  for (const std::size_t f : order) {
    const double front = faces[f].box.min[axis];
    std::erase_if(open, [&](std::size_t g) { return faces[g].box.max[axis] <= front; });
    for (const std::size_t g : open) {
      if (boxes_meet(faces[f].box, faces[g].box)) visit(std::min(f, g), std::max(f, g));
    }
    open.push_back(f);
  }
}

std::string in_words(double depth_in_edges) {
  std::string text(32, '\0');
  text.resize(static_cast<std::size_t>(std::snprintf(text.data(), text.size(), "%.2g", depth_in_edges)));
  return text;
}

}  // namespace

Overlaps check_overlaps(const Subject& s, Faults& faults) {
  std::vector<FaceParts> faces;
  std::vector<int> tangled;
  for (std::size_t f = 0; f < s.net.faces.size(); ++f) {
    faces.push_back(split(counter_clockwise(s, f)));
    if (!faces.back().is_simple) tangled.push_back(static_cast<int>(f));
  }
  if (!tangled.empty()) {
    faults.push_back(about_faces(s.net, tangled, "has an outline that crosses", "have outlines that cross") +
                     " itself.");
  }
  const double limit = kProofDepth * s.mean_edge * (1 - 0x1p-50);
  Overlaps result;
  std::pair<std::size_t, std::size_t> worst;
  for_each_candidate(faces, [&](std::size_t f, std::size_t g) {
    if (s.piece[f] != s.piece[g]) return;
    const double deep = depth(faces[f], faces[g], limit);
    if (deep <= limit) return;
    ++result.pairs;
    if (deep / s.mean_edge <= result.deepest) return;
    result.deepest = deep / s.mean_edge;
    worst = {f, g};
  });
  if (result.pairs > 0) {
    const std::string pair = "faces " + face_name(s.net, static_cast<int>(worst.first)) + " and " +
                             face_name(s.net, static_cast<int>(worst.second));
    faults.push_back(std::to_string(result.pairs) +
                     (result.pairs == 1 ? " pair of faces overlaps" : " pairs of faces overlap") + ", " +
                     pair + " the deepest by " + in_words(result.deepest) + " of the mean edge.");
  }
  return result;
}

}  // namespace netwright::proof
