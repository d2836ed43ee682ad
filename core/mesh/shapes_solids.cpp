// The platonic and archimedean solids: their corners are written down as in the textbooks, with permuted and
// signed coordinates, and their faces are found as the flat sides of the convex hull. The icosphere too.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <utility>

#include "core/mesh/shapes.h"

namespace netwright::shapes {
namespace {

constexpr double kPhi = std::numbers::phi;

enum class Permute { All, Even };
enum class Signs { All, EvenMinus, OddMinus };

bool is_near(glm::dvec3 a, glm::dvec3 b) { return glm::length(a - b) < 1e-9; }

void add_once(std::vector<glm::dvec3>& points, glm::dvec3 p) {
  if (std::ranges::none_of(points, [&](glm::dvec3 q) { return is_near(p, q); })) points.push_back(p);
}

/// Every point that comes from p by permuting its coordinates and changing their signs.
void add_orbit(std::vector<glm::dvec3>& points, glm::dvec3 p, Permute permute, Signs signs = Signs::All) {
  constexpr std::array<std::array<int, 3>, 6> kOrders{
      {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
  const std::size_t n_orders = permute == Permute::Even ? 3 : 6;
  for (std::size_t k = 0; k < n_orders; ++k) {
    for (unsigned bits = 0; bits < 8; ++bits) {
      const bool is_odd = ((bits ^ (bits >> 1) ^ (bits >> 2)) & 1U) != 0;
      if ((signs == Signs::EvenMinus && is_odd) || (signs == Signs::OddMinus && !is_odd)) continue;
      const glm::dvec3 q((bits & 1U) != 0 ? -p.x : p.x, (bits & 2U) != 0 ? -p.y : p.y,
                         (bits & 4U) != 0 ? -p.z : p.z);
      add_once(points, {q[kOrders[k][0]], q[kOrders[k][1]], q[kOrders[k][2]]});
    }
  }
}

/// Points in one plane with this outward normal, put in order around it.
std::vector<int> sorted_around(const std::vector<glm::dvec3>& points, std::vector<int> face,
                               glm::dvec3 normal) {
  glm::dvec3 centre(0);
  for (const int i : face) centre += points[static_cast<std::size_t>(i)];
  centre /= static_cast<double>(face.size());
  const glm::dvec3 u = glm::normalize(points[static_cast<std::size_t>(face.front())] - centre);
  const glm::dvec3 v = glm::cross(normal, u);
  const auto angle = [&](int i) {
    const glm::dvec3 d = points[static_cast<std::size_t>(i)] - centre;
    const double a = std::atan2(glm::dot(d, v), glm::dot(d, u));
    return a < -1e-9 ? a + 2 * std::numbers::pi : a;
  };
  std::ranges::sort(face, {}, angle);
  return face;
}

/// The corners in the plane through points i, j, k when that plane is a side of the hull and these three are
/// its first corners; empty otherwise.
std::vector<int> hull_side(const std::vector<glm::dvec3>& points, std::size_t i, std::size_t j,
                           std::size_t k) {
  glm::dvec3 normal = glm::cross(points[j] - points[i], points[k] - points[i]);
  if (glm::length(normal) < 1e-9) return {};
  normal = glm::normalize(normal);
  if (glm::dot(normal, points[i]) < 0) normal = -normal;
  std::vector<int> face;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const double height = glm::dot(normal, points[p] - points[i]);
    if (height > 1e-7) return {};
    if (height < -1e-7) continue;
    const bool is_one_of_three = p == i || p == j || p == k;
    if (p < k && !is_one_of_three) return {};
    face.push_back(static_cast<int>(p));
  }
  return sorted_around(points, face, normal);
}

/// The convex hull of points around the origin, coplanar triangles as one face. For a few hundred points.
PolygonSoup hull(const std::string& name, const std::vector<glm::dvec3>& points) {
  PolygonSoup soup;
  soup.name = name;
  soup.points = points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      for (std::size_t k = j + 1; k < points.size(); ++k) {
        const std::vector<int> face = hull_side(points, i, j, k);
        if (!face.empty()) soup.add_face(face);
      }
    }
  }
  return soup;
}

PolygonSoup solid(const std::string& name, std::initializer_list<glm::dvec3> corners, Permute permute,
                  Signs signs = Signs::All) {
  std::vector<glm::dvec3> points;
  for (const glm::dvec3 p : corners) add_orbit(points, p, permute, signs);
  return hull(name, points);
}

PolygonSoup snub_cube() {
  const double t = (1 + std::cbrt(19 - 3 * std::sqrt(33.0)) + std::cbrt(19 + 3 * std::sqrt(33.0))) / 3;
  std::vector<glm::dvec3> points;
  add_orbit(points, {1, 1 / t, t}, Permute::Even, Signs::OddMinus);
  add_orbit(points, {1 / t, 1, t}, Permute::Even, Signs::EvenMinus);
  return hull("snub cube", points);
}

PolygonSoup snub_dodecahedron() {
  const double root = std::sqrt(kPhi - 5.0 / 27.0);
  const double xi = std::cbrt((kPhi + root) / 2) + std::cbrt((kPhi - root) / 2);
  const double a = xi - 1 / xi;
  const double b = xi * kPhi + kPhi * kPhi + kPhi / xi;
  return solid("snub dodecahedron",
               {{2 * a, 2, 2 * b},
                {a + b / kPhi + kPhi, -a * kPhi + b + 1 / kPhi, a / kPhi + b * kPhi - 1},
                {a + b / kPhi - kPhi, a * kPhi - b + 1 / kPhi, a / kPhi + b * kPhi + 1},
                {-a / kPhi + b * kPhi + 1, -a + b / kPhi - kPhi, a * kPhi + b - 1 / kPhi},
                {-a / kPhi + b * kPhi - 1, a - b / kPhi - kPhi, a * kPhi + b + 1 / kPhi}},
               Permute::Even, Signs::OddMinus);
}

}  // namespace

PolygonSoup tetrahedron() { return solid("tetrahedron", {{1, 1, 1}}, Permute::Even, Signs::EvenMinus); }
PolygonSoup octahedron() { return solid("octahedron", {{1, 0, 0}}, Permute::Even); }
PolygonSoup dodecahedron() { return solid("dodecahedron", {{1, 1, 1}, {0, 1 / kPhi, kPhi}}, Permute::Even); }
PolygonSoup icosahedron() { return solid("icosahedron", {{0, 1, kPhi}}, Permute::Even); }

std::vector<PolygonSoup> platonic_solids() {
  return {tetrahedron(), cube(), octahedron(), dodecahedron(), icosahedron()};
}

std::vector<PolygonSoup> archimedean_solids() {
  const double r2 = std::numbers::sqrt2;
  const double p = kPhi;
  return {
      solid("truncated tetrahedron", {{3, 1, 1}}, Permute::All, Signs::EvenMinus),
      solid("cuboctahedron", {{1, 1, 0}}, Permute::All),
      solid("truncated cube", {{r2 - 1, 1, 1}}, Permute::All),
      solid("truncated octahedron", {{0, 1, 2}}, Permute::All),
      solid("rhombicuboctahedron", {{1, 1, 1 + r2}}, Permute::All),
      solid("truncated cuboctahedron", {{1, 1 + r2, 1 + 2 * r2}}, Permute::All),
      snub_cube(),
      solid("icosidodecahedron", {{0, 0, p}, {0.5, p / 2, p * p / 2}}, Permute::Even),
      solid("truncated dodecahedron", {{0, 1 / p, 2 + p}, {1 / p, p, 2 * p}, {p, 2, p + 1}}, Permute::Even),
      solid("truncated icosahedron", {{0, 1, 3 * p}, {1, 2 + p, 2 * p}, {p, 2, 2 * p + 1}}, Permute::Even),
      solid("rhombicosidodecahedron", {{1, 1, p * p * p}, {p * p, p, 2 * p}, {2 + p, 0, p * p}},
            Permute::Even),
      solid("truncated icosidodecahedron",
            {{1 / p, 1 / p, 3 + p},
             {2 / p, p, 1 + 2 * p},
             {1 / p, p * p, 3 * p - 1},
             {2 * p - 1, 2, 2 + p},
             {p, 3, 2 * p}},
            Permute::Even),
      snub_dodecahedron(),
  };
}

PolygonSoup icosphere(int n) {
  const PolygonSoup base = icosahedron();
  PolygonSoup soup;
  soup.name = "icosphere " + std::to_string(20 * n * n);
  std::map<std::array<int, 6>, int>
      index;  // corners and weights of a lattice point, so that sides share theirs
  const auto at = [&](std::span<const int> face, std::array<int, 3> weight) {
    std::array<std::pair<int, int>, 3> parts;
    for (std::size_t k = 0; k < 3; ++k) parts[k] = {weight[k] == 0 ? -1 : face[k], weight[k]};
    std::ranges::sort(parts);
    const auto [place, is_new] = index.try_emplace(
        {parts[0].first, parts[0].second, parts[1].first, parts[1].second, parts[2].first, parts[2].second},
        static_cast<int>(soup.points.size()));
    if (is_new) {
      glm::dvec3 sum(0);
      for (const auto& [corner, w] : parts)
        if (w != 0) sum += static_cast<double>(w) * base.points[static_cast<std::size_t>(corner)];
      soup.points.push_back(glm::normalize(sum));
    }
    return place->second;
  };
  for (int f = 0; f < base.n_faces(); ++f) {
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n - i; ++j) {
        const int k = n - i - j;
        const std::array<int, 3> up{at(base.face(f), {k, i, j}), at(base.face(f), {k - 1, i + 1, j}),
                                    at(base.face(f), {k - 1, i, j + 1})};
        soup.add_face(up);
        if (k < 2) continue;
        const std::array<int, 3> down{at(base.face(f), {k - 1, i + 1, j}),
                                      at(base.face(f), {k - 2, i + 1, j + 1}),
                                      at(base.face(f), {k - 1, i, j + 1})};
        soup.add_face(down);
      }
    }
  }
  return soup;
}

}  // namespace netwright::shapes
