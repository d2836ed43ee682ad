// Two tools make most of these shapes: boxes on a grid whose lines may be any distance apart, of which the
// outer sides become faces, and rings of corners joined by triangles.
#include "core/mesh/shapes_hard.h"

#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <vector>

#include "core/mesh/shapes.h"

namespace netwright::shapes {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

int add_point(PolygonSoup& soup, glm::dvec3 p) {
  soup.points.push_back(p);
  return static_cast<int>(soup.points.size()) - 1;
}

void add_triangle(PolygonSoup& soup, int a, int b, int c) { soup.add_face(std::array<int, 3>{a, b, c}); }

/// Where the lines of a grid are along each axis, and which of the boxes between them are filled.
struct Boxes {
  std::array<std::vector<double>, 3> lines;
  std::function<bool(int, int, int)> is_filled;

  [[nodiscard]] int count(std::size_t axis) const { return static_cast<int>(lines[axis].size()) - 1; }
  [[nodiscard]] bool has(const std::array<int, 3>& box) const {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (box[axis] < 0 || box[axis] >= count(axis)) return false;
    return is_filled(box[0], box[1], box[2]);
  }
};

class BoxSides {
 public:
  explicit BoxSides(const Boxes& boxes) : boxes_(boxes) {}

  PolygonSoup make() && {
    for (int x = 0; x < boxes_.count(0); ++x)
      for (int y = 0; y < boxes_.count(1); ++y)
        for (int z = 0; z < boxes_.count(2); ++z)
          if (boxes_.is_filled(x, y, z)) add_sides({x, y, z});
    return std::move(soup_);
  }

 private:
  void add_sides(const std::array<int, 3>& box) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int side : {0, 1}) {
        std::array<int, 3> beyond = box;
        beyond[axis] += side == 0 ? -1 : 1;
        if (!boxes_.has(beyond)) add_side(box, axis, side);
      }
    }
  }

  /// The two other axes in turn span the side; which comes first makes it look outward.
  void add_side(const std::array<int, 3>& box, std::size_t axis, int side) {
    const std::size_t first = (axis + (side == 1 ? 1 : 2)) % 3;
    const std::size_t second = (axis + (side == 1 ? 2 : 1)) % 3;
    constexpr std::array<std::array<int, 2>, 4> kAround{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    std::array<int, 4> corners{};
    for (std::size_t i = 0; i < 4; ++i) {
      std::array<int, 3> place = box;
      place[axis] += side;
      place[first] += kAround[i][0];
      place[second] += kAround[i][1];
      corners[i] = at(place);
    }
    soup_.add_face(corners);
  }

  int at(const std::array<int, 3>& place) {
    const auto [found, is_new] = index_.try_emplace(place, 0);
    if (is_new) {
      glm::dvec3 p(0);
      for (std::size_t axis = 0; axis < 3; ++axis)
        p[static_cast<int>(axis)] = boxes_.lines[axis][static_cast<std::size_t>(place[axis])];
      found->second = add_point(soup_, p);
    }
    return found->second;
  }

  const Boxes& boxes_;
  PolygonSoup soup_;
  std::map<std::array<int, 3>, int> index_;
};

PolygonSoup box_sides(const std::string& name, const Boxes& boxes) {
  PolygonSoup soup = BoxSides(boxes).make();
  soup.name = name;
  return soup;
}

/// Lines of n filled boxes one wide with `gap` between them.
std::vector<double> spaced_lines(int n, double gap) {
  std::vector<double> lines;
  for (int i = 0; i < n; ++i) {
    lines.push_back(i * (1 + gap));
    lines.push_back(i * (1 + gap) + 1);
  }
  return lines;
}

std::vector<double> unit_lines(int n) {
  std::vector<double> lines;
  for (int i = 0; i <= n; ++i) lines.push_back(i);
  return lines;
}

std::string sizes(int a, int b) { return " " + std::to_string(a) + " x " + std::to_string(b); }

/// One end of the box with tubes, in coarse triangles: a strip between each two rows of openings, and fans
/// from the box's own corners to the outermost openings. `opening(i, j)` is the point at line i across and
/// line j along, of the 2 nx × 2 nz lines that bound the openings; `corner` are the box's own, in the same
/// order around as an opening's (0, 0), (1, 0), (1, 1), (0, 1).
template <class Opening>
void add_tubes_end(PolygonSoup& soup, int nx, int nz, const std::array<int, 4>& corner,
                   const Opening& opening, bool is_turned) {
  const auto add = [&](int a, int b, int c) {
    is_turned ? add_triangle(soup, a, c, b) : add_triangle(soup, a, b, c);
  };
  for (int j = 0; j + 1 < 2 * nz; ++j) {
    for (int i = 0; i + 1 < 2 * nx; ++i) {
      if (i % 2 == 0 && j % 2 == 0) continue;
      add(opening(i, j), opening(i + 1, j), opening(i + 1, j + 1));
      add(opening(i, j), opening(i + 1, j + 1), opening(i, j + 1));
    }
  }
  const int last_x = 2 * nx - 1;
  const int last_z = 2 * nz - 1;
  for (int i = 0; i < last_x; ++i) {
    add(corner[0], opening(i + 1, 0), opening(i, 0));
    add(corner[2], opening(i, last_z), opening(i + 1, last_z));
  }
  for (int j = 0; j < last_z; ++j) {
    add(corner[1], opening(last_x, j + 1), opening(last_x, j));
    add(corner[3], opening(0, j), opening(0, j + 1));
  }
  add(corner[0], corner[1], opening(last_x, 0));
  add(corner[1], corner[2], opening(last_x, last_z));
  add(corner[2], corner[3], opening(0, last_z));
  add(corner[3], corner[0], opening(0, 0));
}

/// The corners of the box and of its openings at one height, the box's own four first; returns the first's
/// index.
int add_tubes_level(PolygonSoup& soup, int nx, int nz, double y, double gap) {
  const double width = nx + (nx + 1) * gap;
  const double depth = nz + (nz + 1) * gap;
  const auto line = [gap](int i) {
    const int n_before = i / 2;
    return n_before * (1 + gap) + gap + i % 2;
  };
  const int first = add_point(soup, {0, y, 0});
  add_point(soup, {width, y, 0});
  add_point(soup, {width, y, depth});
  add_point(soup, {0, y, depth});
  for (int j = 0; j < 2 * nz; ++j)
    for (int i = 0; i < 2 * nx; ++i) add_point(soup, {line(i), y, line(j)});
  return first;
}

/// Two triangles for a side with these corners.
void add_wall(PolygonSoup& soup, int a, int b, int c, int d) {
  add_triangle(soup, a, b, c);
  add_triangle(soup, a, c, d);
}

}  // namespace

PolygonSoup box_with_tubes(int nx, int nz, double length, double gap) {
  PolygonSoup soup;
  soup.name = "box with tubes" + sizes(nx, nz);
  const int low = add_tubes_level(soup, nx, nz, 0, gap);
  const int high = add_tubes_level(soup, nx, nz, length, gap);
  for (int i = 0; i < 4; ++i) {
    const int j = (i + 1) % 4;
    add_wall(soup, low + j, low + i, high + i, high + j);
  }
  const auto opening = [&](int level, int i, int j) { return level + 4 + j * 2 * nx + i; };
  for (int j = 0; j < 2 * nz; j += 2) {
    for (int i = 0; i < 2 * nx; i += 2) {
      constexpr std::array<std::array<int, 2>, 5> kAround{{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}};
      for (std::size_t k = 0; k < 4; ++k) {
        const auto [ax, az] = kAround[k];
        const auto [bx, bz] = kAround[k + 1];
        add_wall(soup, opening(low, i + ax, j + az), opening(low, i + bx, j + bz),
                 opening(high, i + bx, j + bz), opening(high, i + ax, j + az));
      }
    }
  }
  for (const int level : {low, high}) {
    add_tubes_end(
        soup, nx, nz, {level, level + 1, level + 2, level + 3},
        [&](int i, int j) { return opening(level, i, j); }, level == high);
  }
  return soup;
}

PolygonSoup comb(int n_teeth, double length, double gap) {
  return box_sides("comb " + std::to_string(n_teeth),
                   {{spaced_lines(n_teeth, gap), {0, 1, 1 + length}, {0, 3}},
                    [](int x, int y, int) { return y == 0 || x % 2 == 0; }});
}

PolygonSoup brush(int nx, int nz, double length, double gap) {
  return box_sides("brush" + sizes(nx, nz),
                   {{spaced_lines(nx, gap), {0, 1, 1 + length}, spaced_lines(nz, gap)},
                    [](int x, int y, int z) { return y == 0 || (x % 2 == 0 && z % 2 == 0); }});
}

PolygonSoup scaffold(int n) {
  const std::vector<double> lines = unit_lines(2 * n + 1);
  return box_sides("scaffold " + std::to_string(n),
                   {{lines, lines, lines}, [](int x, int y, int z) { return x % 2 + y % 2 + z % 2 < 2; }});
}

PolygonSoup menger_sponge(int order) {
  int n = 1;
  for (int i = 0; i < order; ++i) n *= 3;
  const std::vector<double> lines = unit_lines(n);
  const auto is_filled = [](int x, int y, int z) {
    for (; x > 0 || y > 0 || z > 0; x /= 3, y /= 3, z /= 3)
      if ((x % 3 == 1 ? 1 : 0) + (y % 3 == 1 ? 1 : 0) + (z % 3 == 1 ? 1 : 0) >= 2) return false;
    return true;
  };
  return box_sides("Menger sponge " + std::to_string(order), {{lines, lines, lines}, is_filled});
}

PolygonSoup screw(int n_turns, int n_segments, double depth, double pitch) {
  PolygonSoup soup;
  soup.name = "screw " + std::to_string(n_turns);
  // Step t winds up from 0; the groove's bottom is one turn ahead of the crest that closes it from below.
  const int n_steps = n_turns * n_segments;
  const auto add_winding = [&](int n, double radius, double start_y) {
    const int first = static_cast<int>(soup.points.size());
    for (int t = 0; t <= n; ++t) {
      const double angle = kTurn * (t % n_segments) / n_segments;
      add_point(soup,
                {radius * std::cos(angle), start_y + pitch * t / n_segments, -radius * std::sin(angle)});
    }
    return first;
  };
  const int root = add_winding(n_steps + n_segments, 1, 0);
  const int crest = add_winding(n_steps, 1 + depth, pitch / 2);
  const int base = add_point(soup, {0, -pitch / 2, 0});
  const int top = add_point(soup, {0, pitch * (n_turns + 1.5), 0});
  const auto add_flank = [&](int low, int high) {
    add_triangle(soup, low, low + 1, high + 1);
    add_triangle(soup, low, high + 1, high);
  };
  for (int t = 0; t < n_steps; ++t) {
    add_flank(root + t, crest + t);
    add_flank(crest + t, root + t + n_segments);
  }
  for (int t = 0; t < n_segments; ++t) {
    add_triangle(soup, root + t + 1, root + t, base);
    add_triangle(soup, root + n_steps + t, root + n_steps + t + 1, top);
  }
  add_triangle(soup, crest, root + n_segments, base);
  add_triangle(soup, root, crest, base);
  add_triangle(soup, crest + n_steps, root + n_steps, top);
  add_triangle(soup, root + n_steps + n_segments, crest + n_steps, top);
  return soup;
}

PolygonSoup spiked(const PolygonSoup& triangles, double steepness) {
  PolygonSoup soup;
  soup.name = "spiked " + triangles.name;
  soup.points = triangles.points;
  for (int f = 0; f < triangles.n_faces(); ++f) {
    const auto face = triangles.face(f);
    const auto corner = [&](std::size_t i) {
      return triangles.points[static_cast<std::size_t>(face[i % 3])];
    };
    double sides = 0;
    for (std::size_t i = 0; i < 3; ++i) sides += glm::distance(corner(i), corner(i + 1));
    const glm::dvec3 up = glm::normalize(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
    const glm::dvec3 centre = (corner(0) + corner(1) + corner(2)) / 3.0;
    const int tip = add_point(soup, centre + up * (steepness * sides / 3));
    for (std::size_t i = 0; i < 3; ++i) add_triangle(soup, face[i], face[(i + 1) % 3], tip);
  }
  return soup;
}

PolygonSoup star_spindle(int n_points, double notch_radius, double half_height) {
  PolygonSoup soup;
  soup.name = "star spindle " + std::to_string(n_points);
  const int n = 2 * n_points;
  for (int i = 0; i < n; ++i) {
    const double angle = kTurn * i / n;
    const double r = i % 2 == 0 ? 1 : notch_radius;
    add_point(soup, {r * std::cos(angle), 0, -r * std::sin(angle)});
  }
  const int top = add_point(soup, {0, half_height, 0});
  const int bottom = add_point(soup, {0, -half_height, 0});
  for (int i = 0; i < n; ++i) {
    add_triangle(soup, i, (i + 1) % n, top);
    add_triangle(soup, (i + 1) % n, i, bottom);
  }
  return soup;
}

}  // namespace netwright::shapes
