// Everything in shapes.h but the regular and half-regular solids, which are in shapes_solids.cpp. Points are
// computed, faces are written down counter-clockwise seen from outside.
#include "core/mesh/shapes.h"

#include <array>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <map>
#include <numbers>
#include <utility>

namespace netwright::shapes {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

PolygonSoup named(std::string name) {
  PolygonSoup soup;
  soup.name = std::move(name);
  return soup;
}

void add_face(PolygonSoup& soup, std::initializer_list<int> corners) {
  soup.add_face(std::span(corners.begin(), corners.size()));
}

int add_point(PolygonSoup& soup, glm::dvec3 p) {
  soup.points.push_back(p);
  return static_cast<int>(soup.points.size()) - 1;
}

/// n points around the y axis, counter-clockwise seen from above; returns the first one's index.
int add_ring(PolygonSoup& soup, int n, double radius, double y, double start = 0) {
  const int first = static_cast<int>(soup.points.size());
  for (int i = 0; i < n; ++i) {
    const double angle = kTurn * (i + start) / n;
    add_point(soup, {radius * std::cos(angle), y, -radius * std::sin(angle)});
  }
  return first;
}

/// n quads between a lower and an upper ring.
void add_wall(PolygonSoup& soup, int n, int low, int high) {
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    add_face(soup, {low + i, low + j, high + j, high + i});
  }
}

/// n triangles from a ring to a point above it.
void add_roof(PolygonSoup& soup, int n, int ring, int tip) {
  for (int i = 0; i < n; ++i) add_face(soup, {ring + i, ring + (i + 1) % n, tip});
}

/// n triangles from a ring to a point below it.
void add_funnel(PolygonSoup& soup, int n, int ring, int tip) {
  for (int i = 0; i < n; ++i) add_face(soup, {ring + (i + 1) % n, ring + i, tip});
}

/// One face over a whole ring, looking up or down.
void add_cap(PolygonSoup& soup, int n, int ring, bool looks_up) {
  std::vector<int> corners;
  for (int i = 0; i < n; ++i) corners.push_back(looks_up ? ring + i : ring + n - 1 - i);
  soup.add_face(corners);
}

/// Points by their place on a whole-numbered grid, each made once.
class GridPoints {
 public:
  GridPoints(PolygonSoup& soup, glm::dvec3 step, glm::dvec3 origin)
      : soup_(soup), step_(step), origin_(origin) {}
  int operator()(int x, int y, int z) {
    const auto [place, is_new] = index_.try_emplace({x, y, z}, 0);
    if (is_new) place->second = add_point(soup_, origin_ + step_ * glm::dvec3(x, y, z));
    return place->second;
  }

 private:
  PolygonSoup& soup_;
  glm::dvec3 step_;
  glm::dvec3 origin_;
  std::map<std::array<int, 3>, int> index_;
};

/// The four upright walls around the cell (x, z) of a grid, as far as `is_open(x, z)` says that nothing is
/// beyond.
template <class IsOpen>
void add_cell_walls(PolygonSoup& soup, GridPoints& at, int x, int z, int height, const IsOpen& is_open) {
  if (is_open(x, z + 1))
    add_face(soup, {at(x, 0, z + 1), at(x + 1, 0, z + 1), at(x + 1, height, z + 1), at(x, height, z + 1)});
  if (is_open(x, z - 1))
    add_face(soup, {at(x + 1, 0, z), at(x, 0, z), at(x, height, z), at(x + 1, height, z)});
  if (is_open(x + 1, z))
    add_face(soup, {at(x + 1, 0, z + 1), at(x + 1, 0, z), at(x + 1, height, z), at(x + 1, height, z + 1)});
  if (is_open(x - 1, z))
    add_face(soup, {at(x, 0, z), at(x, 0, z + 1), at(x, height, z + 1), at(x, height, z)});
}

/// An extruded pattern of grid cells: floor, ceiling and walls in quads, one high.
template <class IsOpen>
void add_cells(PolygonSoup& soup, GridPoints& at, int nx, int nz, const IsOpen& is_open) {
  for (int x = 0; x < nx; ++x) {
    for (int z = 0; z < nz; ++z) {
      if (is_open(x, z)) continue;
      add_face(soup, {at(x, 1, z), at(x, 1, z + 1), at(x + 1, 1, z + 1), at(x + 1, 1, z)});
      add_face(soup, {at(x, 0, z), at(x + 1, 0, z), at(x + 1, 0, z + 1), at(x, 0, z + 1)});
      add_cell_walls(soup, at, x, z, 1, is_open);
    }
  }
}

/// The shortest text that reads back as the same number; -0 as 0.
std::string number(double x) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), x + 0.0).ptr;
  return {text.data(), end};
}

std::vector<glm::dvec2> toothed_outline(int n, std::span<const glm::dvec2> radius_and_share) {
  std::vector<glm::dvec2> outline;
  for (int i = 0; i < n; ++i) {
    for (const glm::dvec2 corner : radius_and_share) {
      const double angle = kTurn * (i + corner.y) / n;
      outline.emplace_back(corner.x * std::cos(angle), corner.x * std::sin(angle));
    }
  }
  return outline;
}

}  // namespace

PolygonSoup cuboid(glm::dvec3 size) {
  const std::array<glm::dvec2, 4> outline{{{-size.x / 2, -size.z / 2},
                                           {size.x / 2, -size.z / 2},
                                           {size.x / 2, size.z / 2},
                                           {-size.x / 2, size.z / 2}}};
  return prism(outline, size.y, "cuboid");
}

PolygonSoup cube(double edge) {
  PolygonSoup soup = cuboid(glm::dvec3(edge));
  soup.name = "cube";
  return soup;
}

PolygonSoup grid_cube(int n) {
  PolygonSoup soup = named("grid cube");
  GridPoints at(soup, glm::dvec3(1.0 / n), glm::dvec3(-0.5, 0, -0.5));
  for (int a = 0; a < n; ++a) {
    for (int b = 0; b < n; ++b) {
      add_face(soup, {at(a, n, b), at(a, n, b + 1), at(a + 1, n, b + 1), at(a + 1, n, b)});
      add_face(soup, {at(a, 0, b), at(a + 1, 0, b), at(a + 1, 0, b + 1), at(a, 0, b + 1)});
      add_face(soup, {at(a, b, n), at(a + 1, b, n), at(a + 1, b + 1, n), at(a, b + 1, n)});
      add_face(soup, {at(a, b, 0), at(a, b + 1, 0), at(a + 1, b + 1, 0), at(a + 1, b, 0)});
      add_face(soup, {at(n, a, b), at(n, a + 1, b), at(n, a + 1, b + 1), at(n, a, b + 1)});
      add_face(soup, {at(0, a, b), at(0, a, b + 1), at(0, a + 1, b + 1), at(0, a + 1, b)});
    }
  }
  return soup;
}

PolygonSoup prism(std::span<const glm::dvec2> outline, double height, const std::string& name) {
  PolygonSoup soup = named(name);
  const int n = static_cast<int>(outline.size());
  for (const glm::dvec2 p : outline) add_point(soup, {p.x, 0, -p.y});
  for (const glm::dvec2 p : outline) add_point(soup, {p.x, height, -p.y});
  add_wall(soup, n, 0, n);
  add_cap(soup, n, n, true);
  add_cap(soup, n, 0, false);
  return soup;
}

PolygonSoup regular_prism(int n_sides, double height) {
  const std::array<glm::dvec2, 1> corner{{{1, 0}}};
  return prism(toothed_outline(n_sides, corner), height, "prism " + std::to_string(n_sides));
}

PolygonSoup antiprism(int n_sides) {
  PolygonSoup soup = named("antiprism " + std::to_string(n_sides));
  const int low = add_ring(soup, n_sides, 1, 0);
  const int high = add_ring(soup, n_sides, 1, 1, 0.5);
  for (int i = 0; i < n_sides; ++i) {
    const int j = (i + 1) % n_sides;
    add_face(soup, {low + i, low + j, high + i});
    add_face(soup, {low + j, high + j, high + i});
  }
  add_cap(soup, n_sides, high, true);
  add_cap(soup, n_sides, low, false);
  return soup;
}

PolygonSoup pyramid(int n_sides, double height) {
  PolygonSoup soup = named("pyramid " + std::to_string(n_sides));
  const int ring = add_ring(soup, n_sides, 1, 0);
  add_roof(soup, n_sides, ring, add_point(soup, {0, height, 0}));
  add_cap(soup, n_sides, ring, false);
  return soup;
}

PolygonSoup bipyramid(int n_sides, double height) {
  PolygonSoup soup = named("bipyramid " + std::to_string(n_sides));
  const int ring = add_ring(soup, n_sides, 1, 0);
  add_roof(soup, n_sides, ring, add_point(soup, {0, height, 0}));
  add_funnel(soup, n_sides, ring, add_point(soup, {0, -height, 0}));
  return soup;
}

PolygonSoup letter_e() {
  const std::array<glm::dvec2, 12> outline{
      {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {2.5, 2}, {2.5, 3}, {1, 3}, {1, 4}, {3, 4}, {3, 5}, {0, 5}}};
  return prism(outline, 1, "letter E");
}

PolygonSoup letter_l() {
  const std::array<glm::dvec2, 6> outline{{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 4}, {0, 4}}};
  return prism(outline, 1, "letter L");
}

PolygonSoup star(int n_points) {
  const std::array<glm::dvec2, 2> tooth{{{1, 0}, {0.55, 0.5}}};
  return prism(toothed_outline(n_points, tooth), 0.5, "star " + std::to_string(n_points));
}

PolygonSoup gear(int n_teeth) {
  const std::array<glm::dvec2, 4> tooth{{{1, -0.15}, {1, 0.15}, {0.8, 0.25}, {0.8, 0.75}}};
  return prism(toothed_outline(n_teeth, tooth), 0.4, "gear " + std::to_string(n_teeth));
}

PolygonSoup torus(int m, int n, double ring_radius, double tube_radius) {
  PolygonSoup soup = named("torus");
  for (int i = 0; i < m; ++i) {
    for (int j = 0; j < n; ++j) {
      const double a = kTurn * i / m;
      const double b = kTurn * j / n;
      const double r = ring_radius + tube_radius * std::cos(b);
      add_point(soup, {r * std::cos(a), tube_radius * std::sin(b), -r * std::sin(a)});
    }
  }
  for (int i = 0; i < m; ++i) {
    for (int j = 0; j < n; ++j) {
      const int a = i * n + j;
      const int b = (i + 1) % m * n + j;
      const int c = (i + 1) % m * n + (j + 1) % n;
      const int d = i * n + (j + 1) % n;
      add_face(soup, {a, b, c});
      add_face(soup, {a, c, d});
    }
  }
  return soup;
}

PolygonSoup sand_clock(int n_sides) {
  PolygonSoup soup = named("sand clock");
  const int bottom = add_ring(soup, n_sides, 1, 0);
  const int neck_low = add_ring(soup, n_sides, 0.15, 1.4);
  const int neck_high = add_ring(soup, n_sides, 0.15, 1.6);
  const int top = add_ring(soup, n_sides, 1, 3);
  add_wall(soup, n_sides, bottom, neck_low);
  add_wall(soup, n_sides, neck_low, neck_high);
  add_wall(soup, n_sides, neck_high, top);
  add_cap(soup, n_sides, top, true);
  add_cap(soup, n_sides, bottom, false);
  return soup;
}

PolygonSoup cuboid_with_holes(int nx, int nz, double height) {
  PolygonSoup soup = named("cuboid with holes");
  const int width = 2 * nx + 1;
  const int depth = 2 * nz + 1;
  GridPoints at(soup, {1, height, 1}, {-0.5 * width, 0, -0.5 * depth});
  add_cells(soup, at, width, depth, [&](int x, int z) {
    return x < 0 || z < 0 || x >= width || z >= depth || (x % 2 == 1 && z % 2 == 1);
  });
  return soup;
}

PolygonSoup hat() {
  PolygonSoup soup = named("hat");
  GridPoints at(soup, {1, 0.5, 1}, {-1.5, 0, -1.5});
  const auto is_outside = [](int x, int z) { return x < 0 || z < 0 || x >= 3 || z >= 3; };
  for (int x = 0; x < 3; ++x) {
    for (int z = 0; z < 3; ++z) {
      add_face(soup, {at(x, 0, z), at(x + 1, 0, z), at(x + 1, 0, z + 1), at(x, 0, z + 1)});
      add_cell_walls(soup, at, x, z, 1, is_outside);
      if (x == 1 && z == 1) continue;
      add_face(soup, {at(x, 1, z), at(x, 1, z + 1), at(x + 1, 1, z + 1), at(x + 1, 1, z)});
    }
  }
  const std::array<int, 4> foot{at(1, 1, 2), at(2, 1, 2), at(2, 1, 1), at(1, 1, 1)};
  const int tip = add_point(soup, {0, 4, 0});
  for (std::size_t i = 0; i < 4; ++i) add_face(soup, {foot[i], foot[(i + 1) % 4], tip});
  return soup;
}

PolygonSoup grid_patch(int m, int n) {
  PolygonSoup soup = named("grid patch");
  GridPoints at(soup, glm::dvec3(1), glm::dvec3(0));
  for (int x = 0; x < m; ++x) {
    for (int z = 0; z < n; ++z)
      add_face(soup, {at(x, 0, z), at(x, 0, z + 1), at(x + 1, 0, z + 1), at(x + 1, 0, z)});
  }
  return soup;
}

PolygonSoup bumpy_patch(int m, int n) {
  PolygonSoup soup = named("bumpy patch");
  GridPoints at(soup, glm::dvec3(1), glm::dvec3(0));
  for (int x = 0; x < m; ++x) {
    for (int z = 0; z < n; ++z) {
      add_face(soup, {at(x, 0, z), at(x, 0, z + 1), at(x + 1, 0, z + 1)});
      add_face(soup, {at(x, 0, z), at(x + 1, 0, z + 1), at(x + 1, 0, z)});
    }
  }
  for (glm::dvec3& p : soup.points) p.y = 0.6 * std::sin(1.3 * p.x) * std::cos(1.7 * p.z) + 0.05 * p.x * p.z;
  return soup;
}

PolygonSoup open_cylinder(int n_sides, int n_rings) {
  PolygonSoup soup = named("open cylinder");
  int low = add_ring(soup, n_sides, 1, 0);
  for (int k = 1; k <= n_rings; ++k) {
    const int high = add_ring(soup, n_sides, 1, static_cast<double>(k) / n_rings);
    add_wall(soup, n_sides, low, high);
    low = high;
  }
  return soup;
}

PolygonSoup globe(int n_bands, int n_meridians) {
  PolygonSoup soup = named("globe");
  std::vector<int> rings;
  for (int k = 1; k < n_bands; ++k) {
    const double latitude = std::numbers::pi * (static_cast<double>(k) / n_bands - 0.5);
    rings.push_back(add_ring(soup, n_meridians, std::cos(latitude), std::sin(latitude)));
  }
  const int south = add_point(soup, {0, -1, 0});
  const int north = add_point(soup, {0, 1, 0});
  const auto add_uv = [&](double meridian, double band) {
    soup.corner_uv.emplace_back(meridian / n_meridians, band / n_bands);
  };
  for (int i = 0; i < n_meridians; ++i) {
    const int j = (i + 1) % n_meridians;
    add_face(soup, {rings.front() + j, rings.front() + i, south});
    add_uv(i + 1, 1), add_uv(i, 1), add_uv(i + 0.5, 0);
    for (std::size_t k = 0; k + 1 < rings.size(); ++k) {
      const auto band = static_cast<double>(k + 1);
      add_face(soup, {rings[k] + i, rings[k] + j, rings[k + 1] + j, rings[k + 1] + i});
      add_uv(i, band), add_uv(i + 1, band), add_uv(i + 1, band + 1), add_uv(i, band + 1);
    }
    add_face(soup, {rings.back() + i, rings.back() + j, north});
    add_uv(i, n_bands - 1), add_uv(i + 1, n_bands - 1), add_uv(i + 0.5, n_bands);
  }
  return soup;
}

PolygonSoup combined(const PolygonSoup& a, const PolygonSoup& b, glm::dvec3 shift) {
  PolygonSoup soup = a;
  soup.name = a.name + " and " + b.name;
  const int n_before = static_cast<int>(a.points.size());
  for (const glm::dvec3& p : b.points) soup.points.push_back(p + shift);
  for (int f = 0; f < b.n_faces(); ++f) {
    std::vector<int> corners(b.face(f).begin(), b.face(f).end());
    for (int& corner : corners) corner += n_before;
    soup.add_face(corners);
  }
  soup.corner_uv.clear();
  soup.face_material.clear();
  soup.materials.clear();
  return soup;
}

std::string to_obj(const PolygonSoup& soup, const std::string& material_library) {
  const bool has_uv = !soup.corner_uv.empty() && !material_library.empty();
  std::string text = "# " + soup.name + ", made by Netwright\n";
  if (has_uv) text += "mtllib " + material_library + "\n";
  for (const glm::dvec3& p : soup.points) {
    text += "v " + number(p.x) + " " + number(p.y) + " " + number(p.z) + "\n";
  }
  if (has_uv) {
    for (const glm::dvec2 uv : soup.corner_uv) text += "vt " + number(uv.x) + " " + number(uv.y) + "\n";
    text += "usemtl " + soup.name + "\n";
  }
  int corner = 0;
  for (int f = 0; f < soup.n_faces(); ++f) {
    text += "f";
    for (const int point : soup.face(f)) {
      text += " " + std::to_string(point + 1);
      if (has_uv) text += "/" + std::to_string(++corner);
    }
    text += "\n";
  }
  return text;
}

}  // namespace netwright::shapes
