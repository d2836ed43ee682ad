// Merging coplanar faces: the shape stays, triangulated solids get their faces back, and seams are respected.
#include "core/mesh/merge_faces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

#include "core/base/error.h"
#include "core/base/polygon2.h"
#include "core/mesh/convex_cuts.h"
#include "core/mesh/merge_pieces.h"
#include "tests/support.h"

namespace netwright {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

double area_of(const Mesh& mesh) {
  double area = 0;
  for (const FaceId f : mesh.faces()) area += mesh.area(f);
  return area;
}

/// Signed volume under the faces, from the middle of the box; means little for open shapes but must not
/// change.
double volume_of(const Mesh& mesh) {
  double volume = 0;
  for (const FaceId f : mesh.faces())
    volume += mesh.area(f) * glm::dot(mesh.normal(f), mesh.centre(f) - mesh.box().centre()) / 3;
  return volume;
}

int euler(const Mesh& mesh) {
  return static_cast<int>(mesh.n_vertices()) - static_cast<int>(mesh.n_edges()) +
         static_cast<int>(mesh.n_faces());
}

/// Every polygon in triangles, with texture coordinates and materials carried along.
PolygonSoup triangulated(const PolygonSoup& soup) {
  const DualGraph dual(testing::make_mesh(soup));
  const Mesh& mesh = dual.mesh();
  PolygonSoup result;
  result.name = soup.name;
  result.materials = soup.materials;
  for (const VertexId v : mesh.vertices()) result.points.push_back(mesh.position(v));
  for (const FaceId f : mesh.faces()) {
    std::vector<glm::dvec2> flat;
    for (const HalfedgeId h : mesh.halfedges(f)) flat.push_back(dual.flat(h));
    for (const auto& t : triangulate(flat)) {
      std::vector<int> corners;
      for (const int i : t) {
        const HalfedgeId h(mesh.first(f).value + i);
        corners.push_back(mesh.from(h).value);
        if (mesh.has_uv()) result.corner_uv.push_back(mesh.uv(h));
      }
      result.add_face(corners);
      if (!soup.face_material.empty()) result.face_material.push_back(mesh.material(f));
    }
  }
  return result;
}

Mesh merged_mesh(const MergedFaces& merged) {
  return Mesh(merged.soup, merged.is_flipped, merged.face_source);
}

MergedFaces merge(const PolygonSoup& soup, const MergeOptions& options = {}) {
  return merge_coplanar_faces(Mesh(soup), options);
}

/// The same faces in terms of points, wherever each starts.
bool is_same(const PolygonSoup& a, const PolygonSoup& b) {
  return a.points == b.points && a.corners == b.corners && a.face_begin == b.face_begin &&
         a.corner_uv == b.corner_uv && a.face_material == b.face_material;
}

/// Every triangle into four.
PolygonSoup refined(const PolygonSoup& triangles) {
  PolygonSoup result;
  result.points = triangles.points;
  std::map<std::pair<int, int>, int> middle_of;
  const auto middle = [&](int a, int b) {
    const auto [place, is_new] =
        middle_of.try_emplace(std::minmax(a, b), static_cast<int>(result.points.size()));
    if (is_new)
      result.points.push_back(
          (triangles.points[static_cast<std::size_t>(a)] + triangles.points[static_cast<std::size_t>(b)]) /
          2.0);
    return place->second;
  };
  for (int f = 0; f < triangles.n_faces(); ++f) {
    const auto c = triangles.face(f);
    const int ab = middle(c[0], c[1]);
    const int bc = middle(c[1], c[2]);
    const int ca = middle(c[2], c[0]);
    result.add_face(std::vector{c[0], ab, ca});
    result.add_face(std::vector{ab, c[1], bc});
    result.add_face(std::vector{ca, bc, c[2]});
    result.add_face(std::vector{ab, bc, ca});
  }
  return result;
}

TEST(MergeFaces, KeepsTheShapeOfEveryZooShape) {
  for (const testing::ZooShape& shape : testing::zoo()) {
    SCOPED_TRACE(shape.soup.name);
    const Mesh before(refined(triangulated(shape.soup)));
    const MergedFaces merged = merge_coplanar_faces(before);
    const Mesh after = merged_mesh(merged);
    EXPECT_EQ(merged.n_before, static_cast<int>(before.n_faces()));
    EXPECT_LT(after.n_faces(), before.n_faces());
    EXPECT_NEAR(area_of(after), area_of(before), 1e-9 * area_of(before));
    EXPECT_NEAR(volume_of(after), volume_of(before), 1e-9 * area_of(before) * before.box().diagonal());
    EXPECT_EQ(after.is_closed(), before.is_closed());
    EXPECT_EQ(after.n_border_loops(), before.n_border_loops());
    EXPECT_EQ(after.genus(), before.genus());
    EXPECT_EQ(after.n_components(), before.n_components());
    EXPECT_EQ(euler(after), euler(before));
    EXPECT_NO_THROW(DualGraph(std::make_shared<const Mesh>(after)));
  }
}

TEST(MergeFaces, GivesTriangulatedSolidsTheirFacesBack) {
  using namespace shapes;
  std::vector<PolygonSoup> solids{cube(),     regular_prism(17), antiprism(12), letter_l(),
                                  letter_e(), star(7),           gear(10),      sand_clock()};
  for (PolygonSoup& solid : platonic_solids()) solids.push_back(std::move(solid));
  for (PolygonSoup& solid : archimedean_solids()) solids.push_back(std::move(solid));
  for (const PolygonSoup& solid : solids) {
    SCOPED_TRACE(solid.name);
    const MergedFaces merged = merge(refined(triangulated(solid)));
    EXPECT_EQ(merged.n_after(), solid.n_faces());
    EXPECT_EQ(merged_mesh(merged).n_vertices(), Mesh(solid).n_vertices());
    EXPECT_EQ(merged.n_split_regions, 0);
    EXPECT_TRUE(unmerged_flat_edges(merged_mesh(merged)).empty());
  }
}

TEST(MergeFaces, MakesSixFacesOfACubeOfManySquares) {
  const MergedFaces merged = merge(shapes::grid_cube(6));
  EXPECT_EQ(merged.n_after(), 6);
  EXPECT_EQ(merged.n_groups, 6);
  EXPECT_EQ(merged.soup.points.size(), 8U);
  ASSERT_EQ(merged.sentences.size(), 2U);
  EXPECT_EQ(merged.sentences[0], "216 faces became 6: 6 flat polygons were made of several faces each.");
  EXPECT_EQ(merged.sentences[1], "210 points that no face needs any more were dropped.");
}

TEST(MergeFaces, PartsFacesWithAHoleIntoConvexPolygons) {
  const MergedFaces one = merge(triangulated(shapes::cuboid_with_holes(1, 1, 2)));
  EXPECT_EQ(one.n_after(), 4 + 4 + 2 * 4) << "four sides, four walls, two caps in four parts each";
  EXPECT_EQ(one.n_split_regions, 2);
  const Mesh mesh = merged_mesh(one);
  EXPECT_EQ(mesh.genus(), 1);
  EXPECT_EQ(unmerged_flat_edges(mesh).size(), 8U) << "four seams in each cap";
  const MergedFaces four = merge(refined(triangulated(shapes::cuboid_with_holes(2, 2))));
  const Mesh holes = merged_mesh(four);
  EXPECT_EQ(holes.genus(), 4);
  EXPECT_LE(holes.n_vertices(), Mesh(shapes::cuboid_with_holes(2, 2)).n_vertices());
  EXPECT_LE(four.n_after(), 4 + 16 + 2 * 4 * 4) << "no more than one part for every corner of a hole";
  for (const FaceId f : holes.faces()) {
    std::vector<glm::dvec3> corners;
    for (const HalfedgeId h : holes.halfedges(f)) corners.push_back(holes.position(h));
    EXPECT_TRUE(is_open(laid_flat(corners)));
  }
}

TEST(MergeFaces, MergesNothingOnRoundShapes) {
  for (const PolygonSoup& soup :
       std::vector{shapes::icosphere(4), shapes::icosphere(30), shapes::globe(), shapes::bumpy_patch(6, 6)}) {
    SCOPED_TRACE(soup.name);
    const MergedFaces merged = merge(soup);
    EXPECT_EQ(merged.n_after(), soup.n_faces());
    EXPECT_EQ(merged.n_groups, 0);
    EXPECT_EQ(merged.n_points_dropped, 0);
    ASSERT_EQ(merged.sentences.size(), 1U);
    EXPECT_NE(merged.sentences[0].find("within 0.1 degrees"), std::string::npos) << merged.sentences[0];
  }
}

TEST(MergeFaces, DoesNothingTheSecondTimeAndTheSameEveryTime) {
  for (const testing::ZooShape& shape : testing::zoo()) {
    SCOPED_TRACE(shape.soup.name);
    const PolygonSoup triangles = refined(triangulated(shape.soup));
    const MergedFaces first = merge(triangles);
    EXPECT_TRUE(is_same(first.soup, merge(triangles).soup));
    const MergedFaces second = merge_coplanar_faces(merged_mesh(first));
    EXPECT_TRUE(is_same(second.soup, first.soup));
    EXPECT_EQ(second.n_groups, 0);
  }
}

TEST(MergeFaces, TellsWhereEveryFaceAndPointCameFrom) {
  const Mesh before(refined(triangulated(shapes::letter_e())));
  const MergedFaces merged = merge_coplanar_faces(before);
  ASSERT_EQ(merged.sources.size(), static_cast<std::size_t>(merged.n_after()));
  const Mesh after = merged_mesh(merged);
  std::set<FaceId> seen;
  FaceId last_first;
  for (const FaceId f : after.faces()) {
    const std::vector<FaceId>& sources = merged.sources[f.index()];
    double area = 0;
    for (const FaceId s : sources) {
      EXPECT_TRUE(seen.insert(s).second);
      EXPECT_GT(glm::dot(before.normal(s), after.normal(f)), 1 - 1e-9);
      area += before.area(s);
    }
    EXPECT_NEAR(area, after.area(f), 1e-9);
    EXPECT_TRUE(std::is_sorted(sources.begin(), sources.end()));
    EXPECT_LT(last_first, sources.front());
    EXPECT_EQ(after.face_source(f), before.face_source(sources.front()));
    last_first = sources.front();
  }
  EXPECT_EQ(seen.size(), before.n_faces());
  ASSERT_EQ(merged.point_source.size(), merged.soup.points.size());
  for (std::size_t p = 0; p < merged.soup.points.size(); ++p)
    EXPECT_EQ(merged.soup.points[p], before.position(merged.point_source[p]));
}

TEST(MergeFaces, LeavesAnUndoneGroupExactlyAsItWasAndTheOthersMerged) {
  const Mesh before(refined(triangulated(shapes::cube())));
  const MergedFaces all = merge_coplanar_faces(before);
  ASSERT_EQ(all.n_after(), 6);
  MergeOptions options;
  options.left_alone = all.sources[2];
  const MergedFaces merged = merge_coplanar_faces(before, options);
  EXPECT_EQ(merged.n_after(), 5 + 8);
  EXPECT_EQ(merged.n_groups, 5);
  const Mesh after = merged_mesh(merged);
  EXPECT_TRUE(after.is_closed());
  for (const FaceId f : after.faces()) {
    const std::vector<FaceId>& sources = merged.sources[f.index()];
    if (!std::binary_search(options.left_alone.begin(), options.left_alone.end(), sources.front())) continue;
    ASSERT_EQ(sources.size(), 1U);
    ASSERT_EQ(after.degree(f), 3);
    for (int i = 0; i < 3; ++i)
      EXPECT_EQ(after.position(HalfedgeId(after.first(f).value + i)),
                before.position(HalfedgeId(before.first(sources[0]).value + i)));
  }
}

TEST(MergeFaces, KeepsThePointsThatAPolygonLeftAloneHas) {
  // A prism over a hexagon of which two corners lie in the middle of straight sides.
  const std::vector<glm::dvec2> outline{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}};
  const PolygonSoup prism = shapes::prism(outline, 1);
  EXPECT_EQ(merge(prism).n_after(), 6);
  EXPECT_EQ(merge(prism).soup.points.size(), 8U);
  const Mesh mesh(prism);
  MergeOptions options;
  for (const FaceId f : mesh.faces()) {
    if (mesh.degree(f) == 6) options.left_alone.push_back(f);
  }
  ASSERT_EQ(options.left_alone.size(), 2U);
  const MergedFaces merged = merge_coplanar_faces(mesh, options);
  EXPECT_EQ(merged.n_after(), 6);
  EXPECT_EQ(merged.soup.points.size(), 12U);
}

/// Two unit squares in a strip, each in two triangles, the second one bent up by an angle.
PolygonSoup bent_strip(double angle_rad) {
  PolygonSoup soup;
  soup.name = "strip";
  const double x = 1 + std::cos(angle_rad);
  const double y = std::sin(angle_rad);
  soup.points = {{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}, {x, y, 1}, {x, y, 0}};
  for (const std::vector<int>& face :
       std::vector<std::vector<int>>{{0, 1, 2}, {0, 2, 3}, {3, 2, 4}, {3, 4, 5}})
    soup.add_face(face);
  return soup;
}

TEST(MergeFaces, MergesUpToTheToleranceAndNoFurther) {
  const double bend = 0.02 * kDegree;
  const auto count = [&](double tolerance_deg) {
    return merge(bent_strip(bend), {.tolerance_rad = tolerance_deg * kDegree, .left_alone = {}}).n_after();
  };
  EXPECT_EQ(count(0), 2) << "the squares alone";
  EXPECT_EQ(count(0.019), 2);
  EXPECT_EQ(count(0.021), 1);
  EXPECT_EQ(count(0.1), 1);
  EXPECT_EQ(merge(bent_strip(0), {.tolerance_rad = 0, .left_alone = {}}).n_after(), 1);
  EXPECT_EQ(merge(bent_strip(1e-9), {.tolerance_rad = 0, .left_alone = {}}).n_after(), 2);
  EXPECT_EQ(unmerged_flat_edges(Mesh(bent_strip(bend)), 0.019 * kDegree).size(), 2U);
  EXPECT_EQ(unmerged_flat_edges(Mesh(bent_strip(bend)), 0.021 * kDegree).size(), 3U);
}

TEST(MergeFaces, TightensTheToleranceWhereAPolygonWouldNotBeFlat) {
  // Two degrees across a strip are far over kFlatness: the fold stays although the tolerance allows it.
  const MergedFaces merged = merge(bent_strip(2 * kDegree), {.tolerance_rad = 3 * kDegree, .left_alone = {}});
  EXPECT_EQ(merged.n_after(), 2);
  const Mesh mesh = merged_mesh(merged);
  for (const FaceId f : mesh.faces()) EXPECT_LE(mesh.unevenness(f), kFlatness);
  EXPECT_EQ(unmerged_flat_edges(mesh, 3 * kDegree).size(), 1U);
}

TEST(MergeFaces, BendsNoPolygonWithInwardCorners) {
  // An L of three squares. Bent by a thousandth of a degree it would be flat enough, but laying it flat would
  // shorten its sides, and its neighbours would stick out into the notch.
  const auto l_shape = [](double height) {
    PolygonSoup soup;
    soup.name = "L";
    soup.points = {{0, 0, 0},  {1, 0, 0},  {2, height, 0}, {2, height, -1},
                   {1, 0, -1}, {1, 0, -2}, {0, 0, -2},     {0, 0, -1}};
    for (const std::vector<int>& face :
         std::vector<std::vector<int>>{{0, 1, 4, 7}, {1, 2, 3, 4}, {7, 4, 5, 6}})
      soup.add_face(face);
    return soup;
  };
  EXPECT_EQ(merge(l_shape(0)).n_after(), 1);
  EXPECT_EQ(merge(l_shape(1e-6)).n_after(), 1);
  EXPECT_EQ(merge(l_shape(2e-4)).n_after(), 2) << "a straight part of two squares, and the third one";
}

TEST(MergeFaces, DoesNothingTheSecondTimeOnUnevenRingsEither) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const double height = std::pow(10.0, -2 - 5 * random.unit());
    PolygonSoup ring;
    ring.name = "ring";
    const int n = 3 + random.below(12);
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * i / n;
      for (const double radius : {1.0, 1.5, 2.0})
        ring.points.emplace_back(radius * std::cos(angle), height * random.unit(), -radius * std::sin(angle));
    }
    for (int i = 0; i < n; ++i) {
      for (int k = 0; k < 2; ++k) {
        const int a = 3 * i + k;
        const int b = 3 * ((i + 1) % n) + k;
        ring.add_face(std::vector{a, a + 1, b + 1});
        ring.add_face(std::vector{a, b + 1, b});
      }
    }
    const Mesh before(ring);
    const MergedFaces merged = merge_coplanar_faces(before);
    const Mesh after = merged_mesh(merged);
    EXPECT_EQ(after.n_border_loops(), 2U);
    EXPECT_EQ(euler(after), euler(before));
    EXPECT_NO_THROW(DualGraph(std::make_shared<const Mesh>(after)));
    EXPECT_TRUE(is_same(merge_coplanar_faces(after).soup, merged.soup));
    std::set<FaceId> seen;
    for (const auto& sources : merged.sources) seen.insert(sources.begin(), sources.end());
    EXPECT_EQ(seen.size(), before.n_faces());
  }
}

TEST(MergeFaces, LetsNoChainOfTinyBendsAddUpToACurve) {
  // A quarter of a cylinder in steps of a twentieth of a degree.
  PolygonSoup soup;
  soup.name = "quarter";
  for (int i = 0; i <= 1800; ++i) {
    const double angle = i * 0.05 * kDegree;
    soup.points.emplace_back(std::sin(angle), std::cos(angle), 0);
    soup.points.emplace_back(std::sin(angle), std::cos(angle), 0.01);
    if (i > 0) soup.add_face(std::vector{2 * i - 2, 2 * i - 1, 2 * i + 1, 2 * i});
  }
  const Mesh before(soup);
  const MergedFaces merged = merge_coplanar_faces(before);
  const Mesh after = merged_mesh(merged);
  EXPECT_GT(after.n_faces(), 200U);
  for (const FaceId f : after.faces()) {
    EXPECT_LE(after.unevenness(f), kFlatness);
    for (const FaceId s : merged.sources[f.index()])
      EXPECT_GT(glm::dot(before.normal(s), after.normal(f)), std::cos(0.2 * kDegree));
  }
  EXPECT_TRUE(is_same(merge_coplanar_faces(after).soup, merged.soup));
}

TEST(MergeFaces, KeepsMaterialsApart) {
  PolygonSoup soup = shapes::grid_patch(4, 2);
  soup.materials.resize(2);
  for (int f = 0; f < soup.n_faces(); ++f) {
    double x = 0;
    for (const int c : soup.face(f)) x += soup.points[static_cast<std::size_t>(c)].x / 4;
    soup.face_material.push_back(x < Mesh(soup).box().centre().x ? 0 : 1);
  }
  const MergedFaces merged = merge(soup);
  ASSERT_EQ(merged.n_after(), 2);
  EXPECT_EQ(std::set<int>(merged.soup.face_material.begin(), merged.soup.face_material.end()),
            (std::set<int>{0, 1}));
  EXPECT_EQ(merged.soup.points.size(), 6U) << "the seam runs straight: its inner points went, its ends stay";
  EXPECT_EQ(unmerged_flat_edges(merged_mesh(merged)).size(), 1U);
  soup.face_material.assign(soup.face_material.size(), 1);
  EXPECT_EQ(merge(soup).n_after(), 1);
}

/// A patch with a picture spread over it, the right half shifted by `shift` and warped by `warp`.
PolygonSoup textured_patch(double shift, double warp) {
  PolygonSoup soup = shapes::grid_patch(4, 2);
  const Box3 box = Mesh(soup).box();
  for (int f = 0; f < soup.n_faces(); ++f) {
    double middle = 0;
    for (const int c : soup.face(f)) middle += soup.points[static_cast<std::size_t>(c)].x / 4;
    for (const int c : soup.face(f)) {
      const glm::dvec3 d = soup.points[static_cast<std::size_t>(c)] - box.min;
      glm::dvec2 uv(d.x / box.size().x, (d.y + d.z) / (box.size().y + box.size().z));
      uv.y += warp * uv.x * uv.x;
      if (middle > box.centre().x) uv.x += shift;
      soup.corner_uv.push_back(uv);
    }
  }
  return soup;
}

TEST(MergeFaces, CarriesTheTextureAndStopsAtItsSeams) {
  const MergedFaces whole = merge(textured_patch(0, 0));
  ASSERT_EQ(whole.n_after(), 1);
  ASSERT_EQ(whole.soup.corners.size(), 4U);
  ASSERT_EQ(whole.soup.corner_uv.size(), 4U);
  Box2 uv;
  for (const glm::dvec2& corner : whole.soup.corner_uv) uv.add(corner);
  EXPECT_EQ(uv.min, glm::dvec2(0, 0));
  EXPECT_EQ(uv.max, glm::dvec2(1, 1));
  const MergedFaces seam = merge(textured_patch(0.25, 0));
  EXPECT_EQ(seam.n_after(), 2);
  EXPECT_EQ(seam.soup.corner_uv.size(), seam.soup.corners.size());
  EXPECT_TRUE(is_same(merge_coplanar_faces(merged_mesh(seam)).soup, seam.soup));
  EXPECT_EQ(merge(textured_patch(0, 0.5)).n_after(), 4) << "columns of even texture";
}

TEST(MergeFaces, MovesNoTextureAnywhere) {
  const Mesh before(refined(triangulated(shapes::cube())));
  PolygonSoup soup = refined(triangulated(shapes::cube()));
  for (const int c : soup.corners) {
    const glm::dvec3& p = soup.points[static_cast<std::size_t>(c)];
    soup.corner_uv.emplace_back(0.3 * p.x + 0.1 * p.z + 0.5, 0.2 * p.y - 0.3 * p.z + 0.5);
  }
  const MergedFaces merged = merge(soup);
  EXPECT_EQ(merged.n_after(), 6);
  for (std::size_t i = 0; i < merged.soup.corners.size(); ++i) {
    const glm::dvec3& p = merged.soup.points[static_cast<std::size_t>(merged.soup.corners[i])];
    EXPECT_NEAR(merged.soup.corner_uv[i].x, 0.3 * p.x + 0.1 * p.z + 0.5, 1e-12);
    EXPECT_NEAR(merged.soup.corner_uv[i].y, 0.2 * p.y - 0.3 * p.z + 0.5, 1e-12);
  }
}

/// What must stay of an open mesh with slits: its topology and its size.
void expect_same_slits(const PolygonSoup& soup, int n_after) {
  const Mesh before(soup);
  const MergedFaces merged = merge_coplanar_faces(before);
  const Mesh after = merged_mesh(merged);
  EXPECT_EQ(merged.n_after(), n_after);
  EXPECT_EQ(after.n_border_loops(), before.n_border_loops());
  EXPECT_EQ(euler(after), euler(before));
  EXPECT_NEAR(area_of(after), area_of(before), 1e-12);
  EXPECT_NO_THROW(DualGraph(std::make_shared<const Mesh>(after)));
  EXPECT_TRUE(is_same(merge_coplanar_faces(after).soup, merged.soup));
}

TEST(MergeFaces, MakesNoPolygonThatTouchesItself) {
  // A square round a middle point, slit from the middle of one side to the middle point.
  PolygonSoup soup;
  soup.points = {{0, 0, 0}, {2, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 4, 0}, {0, 4, 0}, {2, 2, 0}, {2, 0, 0}};
  for (const std::vector<int>& face :
       std::vector<std::vector<int>>{{6, 1, 2}, {6, 2, 3}, {6, 3, 4}, {6, 4, 5}, {6, 5, 0}, {6, 0, 7}})
    soup.add_face(face);
  expect_same_slits(soup, 2);
}

TEST(MergeFaces, DoesNotSewUpASlitBetweenTwoColours) {
  // Two halves of a square, one of each material, joined left and right of a slit. Both sides of the slit are
  // straight, but if both lost their middle points they would be one edge.
  PolygonSoup soup;
  soup.points = {{0, 2, 0}, {1, 2, 0}, {2, 2, 0}, {2, 2, 0}, {3, 2, 0},
                 {4, 2, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0}, {4, 0, 0}};
  for (const std::vector<int>& face :
       std::vector<std::vector<int>>{{0, 1, 7}, {1, 2, 4, 5, 6, 7}, {0, 8, 1}, {1, 8, 9, 5, 4, 3}})
    soup.add_face(face);
  soup.face_material = {0, 0, 1, 1};
  soup.materials.resize(2);
  expect_same_slits(soup, 2);
}

TEST(MergeFaces, NeverTouchesFacesThatAreNotFlat) {
  PolygonSoup soup = shapes::cube();
  soup.points[0] += glm::dvec3(0.1, 0.2, 0.3);
  const MergedFaces merged = merge(soup);
  EXPECT_EQ(merged.n_after(), 6);
  EXPECT_EQ(merged.soup.corners, [&] {
    const Mesh mesh(soup);
    std::vector<int> corners;
    for (const HalfedgeId h : mesh.halfedges()) corners.push_back(mesh.from(h).value);
    return corners;
  }());
}

TEST(MergeFaces, RefusesWhatMakesNoSense) {
  const Mesh mesh(shapes::cube());
  EXPECT_THROW(merge_coplanar_faces(mesh, {.tolerance_rad = -1, .left_alone = {}}), Error);
  EXPECT_THROW(merge_coplanar_faces(mesh, {.tolerance_rad = 1, .left_alone = {}}), Error);
  EXPECT_THROW(merge_coplanar_faces(mesh, {.tolerance_rad = std::nan(""), .left_alone = {}}), Error);
  EXPECT_THROW(merge_coplanar_faces(mesh, {.tolerance_rad = 0, .left_alone = {FaceId(6)}}), Error);
}

}  // namespace
}  // namespace netwright
