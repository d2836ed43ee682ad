// What several test programs share: the zoo of shapes with what is known about each, and short ways from a
// shape to a Mesh or DualGraph.
#pragma once

#include <array>
#include <glm/geometric.hpp>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/base/random.h"
#include "core/mesh/dual_graph.h"
#include "core/mesh/mesh.h"
#include "core/mesh/shapes.h"
#include "core/mesh/shapes_hard.h"

namespace netwright::testing {

struct ZooShape {
  PolygonSoup soup;
  bool is_closed = true;
  bool has_concave_faces = false;
  int genus = 0;
  int n_components = 1;
};

inline std::shared_ptr<const Mesh> make_mesh(const PolygonSoup& soup) {
  return std::make_shared<const Mesh>(soup);
}

inline std::shared_ptr<const DualGraph> make_dual(const PolygonSoup& soup) {
  return std::make_shared<const DualGraph>(make_mesh(soup));
}

/// Every kind of shape that must unfold, small ones first within a kind. All faces are flat.
inline std::vector<ZooShape> zoo() {
  using namespace shapes;
  std::vector<ZooShape> all;
  const auto add = [&](PolygonSoup soup) -> ZooShape& {
    all.push_back({.soup = std::move(soup)});
    return all.back();
  };
  for (PolygonSoup& solid : platonic_solids()) add(std::move(solid));
  for (PolygonSoup& solid : archimedean_solids()) add(std::move(solid));
  add(cuboid({1, 20, 0.5}));
  add(grid_cube(3));
  add(regular_prism(17));
  add(antiprism(12));
  add(pyramid(5, 4));
  add(bipyramid(7));
  add(icosphere(2));
  add(sand_clock());
  add(globe());
  add(hat());
  for (PolygonSoup& soup : std::vector{letter_l(), letter_e(), star(7), gear(10)}) {
    add(std::move(soup)).has_concave_faces = true;
  }
  add(torus(8, 6)).genus = 1;
  add(cuboid_with_holes(1, 1, 2)).genus = 1;
  add(cuboid_with_holes(2, 2)).genus = 4;
  add(box_with_tubes(2, 2, 6, 0.4)).genus = 4;
  add(scaffold(1)).genus = 5;
  add(screw(1));
  for (PolygonSoup& soup : std::vector{grid_patch(5, 4), bumpy_patch(6, 6), open_cylinder(16, 3)}) {
    add(std::move(soup)).is_closed = false;
  }
  add(combined(cube(), tetrahedron(), {5, 0, 0})).n_components = 2;
  ZooShape& mixed = add(combined(torus(6, 5), grid_patch(2, 2), {9, 0, 0}));
  mixed.is_closed = false;
  mixed.genus = 1;
  mixed.n_components = 2;
  return all;
}

/// What is hard to unfold: of every hard family a model that is solved in a moment, of those that we know to
/// have harder ones the hardest such.
inline std::vector<PolygonSoup> hard_zoo() {
  using namespace shapes;
  return {box_with_tubes(4, 4, 5, 0.4),
          box_with_tubes(6, 6, 8, 0.3),
          comb(32, 128, 0.25),
          brush(8, 8, 10, 0.25),
          screw(16),
          screw(16, 12, 4, 0.2),
          scaffold(3),
          menger_sponge(2),
          spiked(icosphere(4), 1.25),
          spiked(icosphere(2), 1.5),
          spiked(torus(5, 4), 1.75),
          star_spindle(256, 0.1, 8)};
}

/// The smallest we know on which the search takes ten seconds, a million iterations (240 triangles): twelve
/// angles of more than 72 degrees around nearly every corner, of which no five go into a full turn, so that
/// three cuts have to part them four by four.
inline PolygonSoup hardest_shape() { return shapes::spiked(shapes::icosphere(2), 2); }

/// How hats look, in terms of the first side of the triangle below.
struct HatShape {
  double brim_rise = 0.17;
  double spike_height = 1.15;
  int n_hats = 1'000'000;  ///< the first so many triangles get one
};

/// Triangles with hats on them: a raised brim and a tall spike, nine triangles. A hat has no unfolding
/// unless cuts lead from one of its three corners to another, and on a closed shape the cuts of one piece
/// cannot do that for as many hats as there are corners: there is no net (Bern, Demaine, Eppstein, Kuo,
/// Mantler, Snoeyink, "Ununfoldable Polyhedra with Convex Faces", 2003).
inline PolygonSoup with_hats(const PolygonSoup& triangles, const HatShape& shape = {}) {
  PolygonSoup soup;
  soup.name = "hats";
  soup.points = triangles.points;
  for (int f = 0; f < triangles.n_faces(); ++f) {
    if (f >= shape.n_hats) {
      soup.add_face(triangles.face(f));
      continue;
    }
    std::array<int, 3> corner{};
    std::array<glm::dvec3, 3> p{};
    for (std::size_t i = 0; i < 3; ++i) {
      corner[i] = triangles.face(f)[i];
      p[i] = triangles.points[static_cast<std::size_t>(corner[i])];
    }
    const glm::dvec3 up = glm::normalize(glm::cross(p[1] - p[0], p[2] - p[0])) * glm::distance(p[0], p[1]);
    const glm::dvec3 centre = (p[0] + p[1] + p[2]) / 3.0;
    const int brim = static_cast<int>(soup.points.size());
    for (const glm::dvec3& corner_point : p)
      soup.points.push_back((corner_point + centre) / 2.0 + shape.brim_rise * up);
    const int tip = static_cast<int>(soup.points.size());
    soup.points.push_back(centre + shape.spike_height * up);
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const int from = corner[static_cast<std::size_t>(i)];
      const int to = corner[static_cast<std::size_t>(j)];
      soup.add_face(std::vector<int>{from, to, brim + j});
      soup.add_face(std::vector<int>{from, brim + j, brim + i});
      soup.add_face(std::vector<int>{brim + i, brim + j, tip});
    }
  }
  return soup;
}

/// A search that never ends, so it can be watched, paused and stopped at leisure.
inline PolygonSoup endless_search() { return with_hats(shapes::icosphere(4)); }

/// The shape turned inside out.
inline PolygonSoup inside_out(const PolygonSoup& soup) {
  PolygonSoup turned = soup;
  turned.face_begin = {0};
  turned.corners.clear();
  for (int f = 0; f < soup.n_faces(); ++f) {
    turned.add_face(std::vector<int>(soup.face(f).rbegin(), soup.face(f).rend()));
  }
  return turned;
}

}  // namespace netwright::testing
