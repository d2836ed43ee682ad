// Simplification: what every step of every shape keeps, what options keep besides, and that the deviation
// told is the true one.
#include "core/mesh/simplify.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/mesh/deviation.h"
#include "core/mesh/self_intersection.h"
#include "core/mesh/shapes.h"
#include "tests/support.h"

namespace netwright {
namespace {

using testing::make_mesh;
using testing::zoo;
using testing::ZooShape;

Simplifier simplified(const PolygonSoup& soup, const SimplifyOptions& options = {}) {
  Progress progress;
  return Simplifier(make_mesh(soup), options, progress);
}

Mesh mesh_at(const Simplifier& simplifier, int n_faces) {
  return Mesh(simplifier.soup_at(n_faces), {}, simplifier.sources_at(n_faces));
}

/// Small and large shapes, open and closed, with holes and in parts.
std::vector<ZooShape> shapes_to_simplify() {
  std::vector<ZooShape> all = zoo();
  const auto add = [&](PolygonSoup soup) -> ZooShape& {
    all.push_back({.soup = std::move(soup)});
    return all.back();
  };
  add(shapes::icosphere(6));
  add(shapes::torus(24, 16)).genus = 1;
  add(shapes::grid_cube(9));
  add(testing::with_hats(shapes::icosphere(2)));
  for (PolygonSoup& soup : std::vector{shapes::bumpy_patch(12, 9), shapes::open_cylinder(24, 9)})
    add(std::move(soup)).is_closed = false;
  ZooShape& pair = add(shapes::combined(shapes::torus(12, 10), shapes::icosphere(4), {9, 0, 0}));
  pair.n_components = 2;
  pair.genus = 1;
  return all;
}

/// A sphere of latitude bands whose texture is the map of the world: one seam from pole to pole.
double sphere_radius_at_uv_error(const Mesh& mesh) {
  double worst = 0;
  for (const HalfedgeId h : mesh.halfedges()) {
    const glm::dvec3 p = glm::normalize(mesh.position(h));
    const double height_of_uv = -std::cos(mesh.uv(h).y * std::acos(-1.0));
    worst = std::max(worst, std::abs(p.y - height_of_uv));
  }
  return worst;
}

/// Points of the border loops, for comparing outlines.
std::vector<glm::dvec3> border_points(const Mesh& mesh) {
  std::vector<glm::dvec3> points;
  for (const EdgeId e : mesh.edges())
    if (mesh.is_border(e)) points.push_back(mesh.position(mesh.halfedge(e)));
  return points;
}

TEST(Simplify, KeepsTheKindOfSurfaceAtEveryCount) {
  for (const ZooShape& shape : shapes_to_simplify()) {
    const Mesh original(shape.soup);
    const Simplifier simplifier = simplified(shape.soup, {.least_faces = 4});
    EXPECT_EQ(simplifier.n_faces_max(), shape.soup.n_faces()) << shape.soup.name;
    EXPECT_LE(simplifier.n_faces_min(), simplifier.n_faces_max()) << shape.soup.name;
    for (int n = simplifier.n_faces_max(); n >= simplifier.n_faces_min(); --n) {
      const Mesh mesh = mesh_at(simplifier, n);
      ASSERT_LE(static_cast<int>(mesh.n_faces()), n) << shape.soup.name;
      ASSERT_EQ(mesh.is_closed(), shape.is_closed) << shape.soup.name << " at " << n;
      ASSERT_EQ(mesh.genus(), shape.genus) << shape.soup.name << " at " << n;
      ASSERT_EQ(mesh.n_components(), static_cast<std::size_t>(shape.n_components)) << shape.soup.name;
      ASSERT_EQ(mesh.n_border_loops(), original.n_border_loops()) << shape.soup.name << " at " << n;
    }
  }
}

TEST(Simplify, ComesCloseToEveryCountThatIsAskedFor) {
  const Simplifier sphere = simplified(shapes::icosphere(8));
  for (int n = 20; n <= 1280; ++n) EXPECT_GE(sphere.soup_at(n).n_faces(), n - 1);
  const Simplifier patch = simplified(shapes::bumpy_patch(12, 12));
  for (int n = patch.n_faces_min(); n <= patch.n_faces_max(); ++n)
    EXPECT_GE(patch.soup_at(n).n_faces(), n - 1);
}

TEST(Simplify, ReachesTwentyFacesAndNoFewerUnlessAsked) {
  EXPECT_EQ(simplified(shapes::icosphere(8)).n_faces_min(), 20);
  EXPECT_EQ(simplified(shapes::torus(30, 20)).n_faces_min(), 20);
  EXPECT_EQ(simplified(shapes::icosphere(8), {.least_faces = 4}).n_faces_min(), 4);
  EXPECT_EQ(simplified(shapes::icosphere(8), {.least_faces = 101}).n_faces_min(), 100);
}

TEST(Simplify, GivesTheMeshItselfForItsOwnCountAndMore) {
  for (const ZooShape& shape : zoo()) {
    const Mesh original(shape.soup);
    const Simplifier simplifier = simplified(shape.soup);
    for (const int n : {shape.soup.n_faces(), shape.soup.n_faces() + 1000}) {
      const Mesh same = mesh_at(simplifier, n);
      ASSERT_EQ(same.n_faces(), original.n_faces()) << shape.soup.name;
      for (const HalfedgeId h : original.halfedges()) ASSERT_EQ(same.position(h), original.position(h));
      EXPECT_EQ(simplifier.deviation_at(n), 0) << shape.soup.name;
    }
  }
}

TEST(Simplify, LeavesPolygonsWholeThatNothingHappenedTo) {
  PolygonSoup soup = shapes::combined(shapes::icosphere(8), shapes::cube(0.5), {5, 0, 0});
  const Mesh mesh = mesh_at(simplified(soup), 600);
  int n_squares = 0;
  for (const FaceId f : mesh.faces()) n_squares += mesh.degree(f) == 4 ? 1 : 0;
  EXPECT_EQ(n_squares, 6);
}

TEST(Simplify, GivesTheSameEveryTime) {
  const PolygonSoup soup = shapes::torus(40, 25);
  const PolygonSoup first = simplified(soup).soup_at(150);
  const PolygonSoup second = simplified(soup).soup_at(150);
  EXPECT_EQ(first.corners, second.corners);
  EXPECT_EQ(first.points, second.points);
}

TEST(Simplify, DoesNotMoveWhatIsFlat) {
  const Simplifier cube = simplified(shapes::grid_cube(12), {.least_faces = 4});
  EXPECT_LT(cube.deviation_at(12), 1e-6);
  EXPECT_EQ(cube.soup_at(12).n_faces(), 12);
}

TEST(Simplify, DeviatesMoreTheFewerFacesThereAre) {
  for (const PolygonSoup& soup :
       {shapes::icosphere(10), shapes::torus(40, 30), shapes::bumpy_patch(20, 20)}) {
    const Simplifier simplifier = simplified(soup);
    const double diagonal = simplifier.mesh()->box().diagonal();
    double last = 0;
    for (int n = simplifier.n_faces_max(); n >= 20; n = n * 2 / 3) {
      const double deviation = simplifier.deviation_at(n);
      EXPECT_GE(deviation, 0.8 * last - kDeviationTolerance * diagonal) << soup.name << " at " << n;
      last = deviation;
    }
    EXPECT_LT(simplifier.deviation_at(simplifier.n_faces_max() / 4), 0.02 * diagonal) << soup.name;
    EXPECT_GT(last, 0.01 * diagonal) << soup.name;
  }
}

TEST(Simplify, TellsADeviationThatNoSampleExceeds) {
  const Simplifier simplifier = simplified(shapes::torus(40, 30));
  const double diagonal = simplifier.mesh()->box().diagonal();
  Random random(5);
  for (const int n : {600, 150, 40}) {
    const Mesh small = mesh_at(simplifier, n);
    const double told = simplifier.deviation_at(n);
    double seen = 0;
    for (const auto& [from, to] :
         {std::pair(&small, simplifier.mesh().get()), std::pair(simplifier.mesh().get(), &small)}) {
      const SurfaceTree tree(*to);
      for (int i = 0; i < 20000; ++i) {
        const FaceId f(random.below(static_cast<int>(from->n_faces())));
        const double u = random.unit();
        const double v = random.unit() * (1 - u);
        const HalfedgeId h = from->first(f);
        const glm::dvec3 p = from->position(h) * (1 - u - v) + from->position(from->next(h)) * u +
                             from->position(from->prev(h)) * v;
        seen = std::max(seen, tree.nearest(p).distance);
      }
    }
    EXPECT_LE(seen, std::max(1.02 * told, told + kDeviationTolerance * diagonal));
    EXPECT_GE(seen, 0.8 * told) << "at " << n;
  }
}

TEST(Simplify, PushesNoFaceThroughAnother) {
  for (const PolygonSoup& soup : {shapes::torus(40, 25, 2, 1.9), shapes::sand_clock(40),
                                  testing::with_hats(shapes::icosphere(2)), shapes::gear(24)}) {
    const Simplifier simplifier = simplified(soup);
    ASSERT_TRUE(self_intersections(*simplifier.mesh()).empty()) << soup.name;
    for (int n = simplifier.n_faces_max(); n >= simplifier.n_faces_min(); n = std::min(n - 1, n * 3 / 4))
      EXPECT_TRUE(self_intersections(mesh_at(simplifier, n)).empty()) << soup.name << " at " << n;
  }
}

TEST(Simplify, KeepsTheOutlineOfAnOpenPatch) {
  const Simplifier patch = simplified(shapes::grid_patch(12, 12), {.least_faces = 4});
  const Mesh mesh = mesh_at(patch, patch.n_faces_min());
  double area = 0;
  for (const FaceId f : mesh.faces()) area += mesh.area(f);
  EXPECT_NEAR(area, 144, 1e-4);
  EXPECT_LE(mesh.n_faces(), 8u);
}

TEST(Simplify, MovesBordersOnlyAlongThemselves) {
  const Simplifier tube = simplified(shapes::open_cylinder(40, 20));
  const Box3 before = tube.mesh()->box();
  const Mesh mesh = mesh_at(tube, 100);
  for (const glm::dvec3& p : border_points(mesh))
    EXPECT_LT(std::min(std::abs(p.y - before.min.y), std::abs(p.y - before.max.y)), 1e-9);
}

TEST(Simplify, KeepsSharpEdgesWhenAsked) {
  SimplifyOptions options{.least_faces = 4, .keep_uv_seams = false, .keep_sharp_edges = true};
  const Simplifier gear = simplified(shapes::gear(10), options);
  EXPECT_EQ(gear.n_faces_min(), gear.n_faces_max()) << "every point is the corner of three sharp edges";
  const Simplifier prism = simplified(shapes::regular_prism(60), options);
  const Mesh mesh = mesh_at(prism, prism.n_faces_min());
  const Box3 before = prism.mesh()->box();
  for (const VertexId v : mesh.vertices())
    EXPECT_LT(
        std::min(std::abs(mesh.position(v).y - before.min.y), std::abs(mesh.position(v).y - before.max.y)),
        1e-9)
        << "a point left the rim";
}

TEST(Simplify, CarriesTextureCoordinatesAlong) {
  const PolygonSoup globe = shapes::globe(24, 40);
  ASSERT_LT(sphere_radius_at_uv_error(Mesh(globe)), 1e-6) << "the shape's own texture";
  for (const bool keep : {false, true}) {
    const Simplifier simplifier = simplified(globe, {.keep_uv_seams = keep});
    for (const int n : {800, 400}) {
      const Mesh mesh = mesh_at(simplifier, n);
      ASSERT_TRUE(mesh.has_uv());
      EXPECT_LT(sphere_radius_at_uv_error(mesh), 0.1) << n << (keep ? " with seams kept" : "");
    }
  }
}

TEST(Simplify, KeepsSeamsWhereTheyAreWhenAsked) {
  const Simplifier simplifier = simplified(shapes::globe(24, 40), {.keep_uv_seams = true});
  const Mesh mesh = mesh_at(simplifier, 200);
  int n_seam_edges = 0;
  for (const EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e);
    const HalfedgeId t = mesh.twin(h);
    const bool is_seam = std::abs(mesh.uv(h).x - mesh.uv(mesh.next(t)).x) > 0.5 ||
                         std::abs(mesh.uv(mesh.next(h)).x - mesh.uv(t).x) > 0.5;
    n_seam_edges += is_seam ? 1 : 0;
    for (const HalfedgeId c : {h, mesh.next(h), mesh.prev(h)})
      EXPECT_LT(std::abs(mesh.uv(c).x - mesh.uv(h).x), 0.5) << "a face reaches across the whole picture";
  }
  EXPECT_GT(n_seam_edges, 2);
}

TEST(Simplify, CarriesMaterialsAlong) {
  PolygonSoup soup = shapes::icosphere(10);
  soup.materials = {{.name = "south", .texture = nullptr}, {.name = "north", .texture = nullptr}};
  for (int f = 0; f < soup.n_faces(); ++f) {
    double y = 0;
    for (const int p : soup.face(f)) y += soup.points[static_cast<std::size_t>(p)].y / 3;
    soup.face_material.push_back(y > 0 ? 1 : 0);
  }
  const Mesh mesh = mesh_at(simplified(soup), 200);
  ASSERT_EQ(mesh.materials().size(), 2u);
  for (const FaceId f : mesh.faces()) {
    if (std::abs(mesh.centre(f).y) < 0.15) continue;
    EXPECT_EQ(mesh.material(f), mesh.centre(f).y > 0 ? 1 : 0);
  }
}

TEST(Simplify, NamesTheFaceThatEachOneWasAndThatTookItsPlace) {
  for (const ZooShape& shape : shapes_to_simplify()) {
    const Simplifier simplifier = simplified(shape.soup);
    const int n = std::max(simplifier.n_faces_min(), simplifier.n_faces_max() / 2);
    const auto sources = simplifier.sources_at(n);
    const auto heirs = simplifier.heirs_at(n);
    const PolygonSoup soup = simplifier.soup_at(n);
    ASSERT_EQ(static_cast<int>(sources.size()), soup.n_faces());
    ASSERT_EQ(static_cast<int>(heirs.size()), shape.soup.n_faces());
    for (const int heir : heirs) {
      ASSERT_GE(heir, 0);
      ASSERT_LT(heir, soup.n_faces());
    }
    for (std::size_t f = 0; f < sources.size(); ++f) {
      const int heir = heirs[static_cast<std::size_t>(sources[f])];
      EXPECT_EQ(sources[static_cast<std::size_t>(heir)], sources[f]) << shape.soup.name;
    }
  }
}

TEST(Simplify, LetsHeirsLieNearWhatTheyReplace) {
  const Simplifier simplifier = simplified(shapes::icosphere(10));
  const Mesh small = mesh_at(simplifier, 300);
  const auto heirs = simplifier.heirs_at(300);
  for (const FaceId f : simplifier.mesh()->faces())
    EXPECT_LT(glm::distance(simplifier.mesh()->centre(f), small.centre(FaceId(heirs[f.index()]))), 0.6);
}

TEST(Simplify, EndsWithAShorterHistoryWhenCancelled) {
  Progress progress;
  progress.cancel();
  const Simplifier simplifier(make_mesh(shapes::icosphere(20)), {}, progress);
  EXPECT_GT(simplifier.n_faces_min(), 7000);
  const Mesh mesh = mesh_at(simplifier, simplifier.n_faces_min());
  EXPECT_TRUE(mesh.is_closed());
}

TEST(Simplify, TellsHowFarItIs) {
  Progress progress;
  const Simplifier simplifier(make_mesh(shapes::icosphere(10)), {}, progress);
  EXPECT_FALSE(progress.phase().empty());
  EXPECT_GT(progress.fraction(), 0.9);
}

TEST(Deviation, IsTheHausdorffDistanceOfSpheres) {
  PolygonSoup outer = shapes::icosphere(12);
  for (glm::dvec3& p : outer.points) p *= 1.25;
  const double found = hausdorff_distance(SurfaceTree(outer), SurfaceTree(shapes::icosphere(12)));
  EXPECT_NEAR(found, 0.25, 0.01);
}

TEST(Deviation, SeesASpikeOnOneSideOnly) {
  const SurfaceTree flat(shapes::cube());
  PolygonSoup spiky = shapes::pyramid(4, 3);
  const SurfaceTree with_spike(spiky);
  EXPECT_GT(distance_from(with_spike, flat), distance_from(flat, with_spike));
}

TEST(Deviation, FindsTheNearestTriangleLikeALookAtAll) {
  const SurfaceTree tree(shapes::torus(20, 14));
  Random random(3);
  for (int i = 0; i < 500; ++i) {
    const glm::dvec3 p = 8.0 * glm::dvec3(random.unit(), random.unit(), random.unit()) - 4.0;
    double least = 1e9;
    for (const auto& t : tree.triangles())
      least = std::min(least, glm::distance(nearest_in_triangle(t, p), p));
    EXPECT_DOUBLE_EQ(tree.nearest(p).distance, least);
  }
}

}  // namespace
}  // namespace netwright
