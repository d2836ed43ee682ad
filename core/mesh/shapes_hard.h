// Families of shapes that are hard to unfold, made by rule, each with a size that makes it harder: for
// looking where the search ends. All are closed, oriented outward, y is up and every face is flat.
#pragma once

#include "core/mesh/soup.h"

namespace netwright::shapes {

/// The paper's figure 9: a box with nx × nz square tubes from top to bottom, one wide and `gap` apart, in as
/// few triangles as its corners allow: 12 + 20 nx nz. The walls of tubes longer than wide find no room in
/// their own openings. Genus nx · nz.
PolygonSoup box_with_tubes(int nx, int nz, double length, double gap = 1);

/// A bar with n_teeth plates on it, one thick, `gap` apart and `length` long; in quads. Genus 0.
PolygonSoup comb(int n_teeth, double length, double gap = 1);
/// A plate with nx × nz square pins on it, one wide, `gap` apart and `length` long; in quads. Genus 0.
PolygonSoup brush(int nx, int nz, double length, double gap = 1);

/// A scaffold of n × n × n cells: bars one thick, joined at the corners of the cells; in unit squares. Genus
/// 2 n³ + 3 n² (5, 28, 81 …): n = 1 is the Menger sponge of the first order.
PolygonSoup scaffold(int n);
/// The Menger sponge; of order 1 with 72 squares, of order 2 with 1056.
PolygonSoup menger_sponge(int order);

/// A threaded rod: a groove `depth` deep winds n_turns times around a core of radius 1, `pitch` apart, with
/// n_segments to a turn; in triangles. Genus 0.
PolygonSoup screw(int n_turns, int n_segments = 12, double depth = 0.5, double pitch = 0.5);

/// Triangles with a spike on each of them, so many times as high as its mean side is long: three triangles
/// for each. Where six met, twelve long angles meet then: more than two full turns from a steepness of about
/// 0.8 on, never more than three.
PolygonSoup spiked(const PolygonSoup& triangles, double steepness);

/// Long triangles from the points and notches of a star to a tip above and one below: 4 n_points faces, all
/// around two corners. Genus 0.
PolygonSoup star_spindle(int n_points, double notch_radius, double half_height);

}  // namespace netwright::shapes
