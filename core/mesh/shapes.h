// Shapes made by rule, for tests, samples and first steps. All are oriented outward, y is up, sizes are in
// model units, and every face is flat unless the comment says otherwise.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/mesh/soup.h"

namespace netwright::shapes {

PolygonSoup cube(double edge = 1);
PolygonSoup cuboid(glm::dvec3 size);
/// A cube whose sides are grids of n × n squares.
PolygonSoup grid_cube(int n);

/// An upright prism over a simple polygon given counter-clockwise (seen from above, x right, z towards the
/// viewer).
PolygonSoup prism(std::span<const glm::dvec2> outline, double height, const std::string& name = "prism");
PolygonSoup regular_prism(int n_sides, double height = 1);
PolygonSoup antiprism(int n_sides);
PolygonSoup pyramid(int n_sides, double height = 1);
PolygonSoup bipyramid(int n_sides, double height = 1);
/// Concave caps: the letters E and L, a star, a gear.
PolygonSoup letter_e();
PolygonSoup letter_l();
PolygonSoup star(int n_points);
PolygonSoup gear(int n_teeth);

PolygonSoup tetrahedron();
PolygonSoup octahedron();
PolygonSoup dodecahedron();
PolygonSoup icosahedron();
/// The five, the cube among them.
std::vector<PolygonSoup> platonic_solids();
/// The thirteen, with names like "snub cube".
std::vector<PolygonSoup> archimedean_solids();

/// An icosahedron whose faces are split into n² triangles, brought onto the unit sphere: 20 n² faces (2: 80).
PolygonSoup icosphere(int n);
/// A ring of m × n triangle pairs; m around the ring, n around the tube. Genus 1.
PolygonSoup torus(int m, int n, double ring_radius = 2, double tube_radius = 1);
/// The paper's figure 1: two cones of n sides tip to tip, joined by a neck.
PolygonSoup sand_clock(int n_sides = 8);
/// A box with nx × nz square holes from top to bottom. Genus nx · nz; faces are quads.
PolygonSoup cuboid_with_holes(int nx, int nz, double height = 1);
/// A sphere of flat latitude bands (quads, triangles at the poles) with texture coordinates.
PolygonSoup globe(int n_bands = 10, int n_meridians = 16);
/// A wide brim with a tall spike on it, glued on a box: nets of it overlap easily.
PolygonSoup hat();

/// Open: a flat patch of m × n squares, a bumpy one of triangles, a tube without ends.
PolygonSoup grid_patch(int m, int n);
PolygonSoup bumpy_patch(int m, int n);
PolygonSoup open_cylinder(int n_sides, int n_rings = 1);

/// Two shapes as one model of several components, the second one moved by `shift`.
PolygonSoup combined(const PolygonSoup& a, const PolygonSoup& b, glm::dvec3 shift);

/// The shape as a Wavefront OBJ file (with texture coordinates when it has them and `material_library` is
/// named).
std::string to_obj(const PolygonSoup& soup, const std::string& material_library = "");

}  // namespace netwright::shapes
