// Faces made flat: the identities of the polygon Laplacian, the flow and its finish on noisy shapes of known
// kinds, how little they move, and what is said when it cannot be done.
#include "core/mesh/planarize.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/base/polygon2.h"
#include "core/mesh/polygon_laplacian.h"
#include "tests/support.h"

namespace netwright {
namespace {

using testing::make_mesh;
using testing::zoo;
using testing::ZooShape;

glm::dvec3 random_direction(Random& random) {
  return {2 * random.unit() - 1, 2 * random.unit() - 1, 2 * random.unit() - 1};
}

PolygonSoup shaken(PolygonSoup soup, double amount, std::uint64_t seed = 1) {
  Random random(seed);
  for (glm::dvec3& point : soup.points) point += amount * random_direction(random);
  return soup;
}

/// A ring of m × n quads, none of which is flat once twisted.
PolygonSoup quad_torus(int m, int n) {
  PolygonSoup soup;
  soup.name = "quad torus";
  for (int i = 0; i < m; ++i) {
    for (int j = 0; j < n; ++j) {
      const double a = 2 * std::numbers::pi * i / m;
      const double b = 2 * std::numbers::pi * (j + 0.3 * std::sin(a)) / n;
      const double r = 2 + std::cos(b);
      soup.points.emplace_back(r * std::cos(a), std::sin(b), -r * std::sin(a));
      const int k = (i + 1) % m;
      const int l = (j + 1) % n;
      soup.add_face(std::vector<int>{i * n + j, k * n + j, k * n + l, i * n + l});
    }
  }
  return soup;
}

PolygonSoup bumped_cube_sphere() {
  PolygonSoup soup = shapes::grid_cube(6);
  Box3 box;
  for (const glm::dvec3& point : soup.points) box.add(point);
  for (glm::dvec3& point : soup.points) point = glm::normalize(point - box.centre());
  return shaken(soup, 0.02);
}

PolygonSoup cube_with_a_lifted_corner() {
  PolygonSoup soup = shapes::cube();
  soup.points[6] += glm::dvec3(0.1, 0.05, 0.2);
  return soup;
}

/// Two quads back to back on four corners that are far from one plane.
PolygonSoup pillow() {
  PolygonSoup soup;
  soup.name = "pillow";
  soup.points = {{0, 0, 0}, {1, 0, 1}, {1, 1, 0}, {0, 1, 1}};
  soup.add_face(std::vector<int>{0, 1, 2, 3});
  soup.add_face(std::vector<int>{3, 2, 1, 0});
  return soup;
}

PlanarizeResult flatten(const PolygonSoup& soup, const PlanarizeOptions& options = {}) {
  Progress progress;
  return planarize(*make_mesh(soup), options, progress);
}

double worst_unevenness(const Mesh& mesh) {
  double worst = 0;
  for (const FaceId f : mesh.faces()) worst = std::max(worst, mesh.unevenness(f));
  return worst;
}

/// How far the corners of faces from `first_face` on lie apart; points may be numbered differently.
double largest_move(const PolygonSoup& a, const PolygonSoup& b, int first_face = 0) {
  double largest = 0;
  for (auto i = static_cast<std::size_t>(a.face_begin[static_cast<std::size_t>(first_face)]);
       i < a.corners.size(); ++i) {
    largest = std::max(largest, glm::distance(a.points[static_cast<std::size_t>(a.corners[i])],
                                              b.points[static_cast<std::size_t>(b.corners[i])]));
  }
  return largest;
}

/// The face as its best plane shows it.
std::vector<glm::dvec2> outline(const Mesh& mesh, FaceId f) {
  std::vector<glm::dvec3> corners;
  for (const HalfedgeId h : mesh.halfedges(f)) corners.push_back(mesh.position(h));
  return frame_of(corners).flat;
}

/// Star-shaped about its middle, concave more often than not, in a plane that leans.
std::vector<glm::dvec3> random_flat_polygon(int n, Random& random) {
  const glm::dvec3 x = glm::normalize(random_direction(random));
  const glm::dvec3 y = glm::normalize(glm::cross(x, random_direction(random)));
  const glm::dvec3 centre = 5.0 * random_direction(random);
  std::vector<glm::dvec3> corners;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    const double radius = 0.2 + random.unit();
    corners.push_back(centre + radius * (std::cos(angle) * x + std::sin(angle) * y));
  }
  return corners;
}

/// The largest entry of C Cᵀ E.
double seen_by_completion(const std::vector<glm::dvec3>& corners) {
  const CornerMatrix matrix = completion(frame_of(corners));
  double largest = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    glm::dvec3 sum(0);
    for (std::size_t j = 0; j < corners.size(); ++j) {
      sum += matrix(i, j) * (corners[(j + 1) % corners.size()] - corners[j]);
    }
    largest = std::max(largest, glm::length(sum));
  }
  return largest;
}

TEST(PolygonLaplacian, CompletionSeesNothingOfFlatFaces) {
  Random random(7);
  for (int trial = 0; trial < 200; ++trial) {
    EXPECT_LT(seen_by_completion(random_flat_polygon(3 + trial % 9, random)), 1e-13);
  }
}

TEST(PolygonLaplacian, CompletionSeesEveryCornerOffThePlane) {
  Random random(8);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<glm::dvec3> corners = random_flat_polygon(4 + trial % 8, random);
    const PolygonFrame frame = frame_of(corners);
    corners[static_cast<std::size_t>(random.below(static_cast<int>(corners.size())))] += 0.1 * frame.normal;
    EXPECT_GT(seen_by_completion(corners), 1e-3);
  }
}

TEST(PolygonLaplacian, IsTheCotangentLaplacianOnTriangles) {
  Random random(9);
  for (int trial = 0; trial < 100; ++trial) {
    const std::vector<glm::dvec3> t{random_direction(random), random_direction(random),
                                    random_direction(random)};
    const CornerMatrix matrix = polygon_laplacian(t, 1 + trial);
    const double scale = std::max({matrix(0, 0), matrix(1, 1), matrix(2, 2)});
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const std::size_t k = (i + 2) % 3;
      const glm::dvec3 u = t[i] - t[k];
      const glm::dvec3 v = t[j] - t[k];
      const double cotangent = glm::dot(u, v) / glm::length(glm::cross(u, v));
      EXPECT_NEAR(matrix(i, j) / scale, -0.5 * cotangent / scale, 1e-12);
      EXPECT_NEAR(matrix(j, i), matrix(i, j), 1e-12 * scale);
    }
  }
}

TEST(PolygonLaplacian, IsTheGradientOfTheAreaWithoutTheCompletion) {
  Random random(10);
  for (int n = 3; n < 9; ++n) {
    std::vector<glm::dvec3> corners = random_flat_polygon(n, random);
    for (glm::dvec3& corner : corners) corner += 0.2 * random_direction(random);
    const CornerMatrix matrix = polygon_laplacian(corners, 0);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      glm::dvec3 gradient(0);
      for (std::size_t j = 0; j < corners.size(); ++j) gradient += matrix(i, j) * corners[j];
      for (int axis = 0; axis < 3; ++axis) {
        std::vector<glm::dvec3> before = corners;
        std::vector<glm::dvec3> after = corners;
        before[i][axis] -= 1e-5;
        after[i][axis] += 1e-5;
        const double slope = (glm::length(vector_area(after)) - glm::length(vector_area(before))) / 2e-5;
        EXPECT_NEAR(gradient[axis], slope, 1e-8);
      }
    }
  }
}

TEST(PolygonLaplacian, LeavesLinearFunctionsAloneOnFlatMeshes) {
  PolygonSoup soup = shapes::grid_patch(4, 4);
  Random random(11);
  for (glm::dvec3& point : soup.points) point += glm::dvec3(0.2 * random.unit(), 0, 0.2 * random.unit());
  const auto mesh = make_mesh(soup);
  std::vector<double> sums(mesh->n_vertices(), 0.0);
  std::vector<char> is_inside(mesh->n_vertices(), 1);
  for (const EdgeId e : mesh->edges()) {
    if (!mesh->is_border(e)) continue;
    is_inside[mesh->from(mesh->halfedge(e)).index()] = 0;
    is_inside[mesh->to(mesh->halfedge(e)).index()] = 0;
  }
  for (const FaceId f : mesh->faces()) {
    std::vector<glm::dvec3> corners;
    std::vector<std::size_t> vertices;
    for (const HalfedgeId h : mesh->halfedges(f)) {
      corners.push_back(mesh->position(h));
      vertices.push_back(mesh->from(h).index());
    }
    const CornerMatrix matrix = polygon_laplacian(corners, 2);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      for (std::size_t j = 0; j < corners.size(); ++j) {
        sums[vertices[i]] += matrix(i, j) * (3 * corners[j].x - 2 * corners[j].z + 1);
      }
    }
  }
  int n_inside = 0;
  for (std::size_t v = 0; v < sums.size(); ++v) {
    if (is_inside[v] == 0) continue;
    ++n_inside;
    EXPECT_NEAR(sums[v], 0, 1e-12);
  }
  EXPECT_EQ(n_inside, 9);
}

TEST(Planarize, LeavesWhatIsFlatAsItIs) {
  for (const ZooShape& shape : zoo()) {
    const auto mesh = make_mesh(shape.soup);
    Progress progress;
    const PlanarizeResult result = planarize(*mesh, {}, progress);
    EXPECT_TRUE(result.has_converged) << shape.soup.name;
    EXPECT_EQ(result.iterations, 0) << shape.soup.name;
    EXPECT_EQ(result.largest_move, 0) << shape.soup.name;
    for (const VertexId v : mesh->vertices()) {
      ASSERT_EQ(result.soup.points[v.index()], mesh->position(v)) << shape.soup.name;
    }
  }
}

struct Noisy {
  PolygonSoup soup;
  double most_moved;  // share of the size that the shape may move
};

std::vector<Noisy> noisy_shapes() {
  return {{cube_with_a_lifted_corner(), 0.06},
          {shaken(shapes::dodecahedron(), 0.05), 0.03},
          {quad_torus(12, 8), 0.02},
          {shaken(quad_torus(16, 10), 0.03), 0.02},
          {bumped_cube_sphere(), 0.02},
          {shaken(shapes::letter_e(), 0.03), 0.02},
          {shaken(shapes::gear(10), 0.01), 0.02},
          {shaken(shapes::regular_prism(17), 0.03), 0.03},
          {shaken(shapes::cuboid_with_holes(2, 2), 0.03), 0.02}};
}

TEST(Planarize, MakesEveryFaceFlatAndMovesLittle) {
  for (const Noisy& noisy : noisy_shapes()) {
    const auto before = make_mesh(noisy.soup);
    const PlanarizeResult result = flatten(noisy.soup);
    ASSERT_TRUE(result.has_converged) << noisy.soup.name << ": " << result.sentence;
    const Mesh after(result.soup);
    EXPECT_GT(worst_unevenness(*before), 1e-3) << noisy.soup.name;
    EXPECT_NEAR(result.unevenness_before, worst_unevenness(*before), 1e-12) << noisy.soup.name;
    EXPECT_LE(worst_unevenness(after), 1e-6) << noisy.soup.name;
    EXPECT_GT(result.largest_move, 0) << noisy.soup.name;
    EXPECT_LT(result.moved_share, noisy.most_moved) << noisy.soup.name;
    EXPECT_NEAR(largest_move(noisy.soup, result.soup), result.largest_move, 1e-12) << noisy.soup.name;
    EXPECT_NEAR(result.moved_share * before->box().diagonal(), result.largest_move, 1e-12);
    EXPECT_GT(result.hausdorff, 0) << noisy.soup.name;
    EXPECT_LE(result.hausdorff, result.largest_move) << noisy.soup.name;
  }
}

TEST(Planarize, TurnsNoFaceOver) {
  for (const Noisy& noisy : noisy_shapes()) {
    const auto before = make_mesh(noisy.soup);
    const Mesh after(flatten(noisy.soup).soup);
    for (const FaceId f : before->faces()) {
      EXPECT_GT(glm::dot(before->normal(f), after.normal(f)), 0.5) << noisy.soup.name;
      EXPECT_TRUE(is_simple(outline(after, f))) << noisy.soup.name;
    }
  }
}

/// A ring of wide and very narrow quads in turn, whose corners are off by more than the narrow ones are wide.
PolygonSoup rumpled_strips() {
  constexpr int kStrips = 24;
  constexpr int kSides = 8;
  PolygonSoup soup;
  soup.name = "rumpled strips";
  Random random(4);
  for (int i = 0; i < kStrips; ++i) {
    for (int j = 0; j < kSides; ++j) {
      const int pair = i / 2;
      const double a = 4 * std::numbers::pi * pair / kStrips + (i % 2) * 0.03;
      const double b = 2 * std::numbers::pi * j / kSides;
      const double tube = 0.9 + 0.2 * random.unit();
      const double r = 2 + tube * std::cos(b);
      soup.points.emplace_back(r * std::cos(a), tube * std::sin(b), -r * std::sin(a));
      const int k = (i + 1) % kStrips;
      const int l = (j + 1) % kSides;
      soup.add_face(std::vector<int>{i * kSides + j, k * kSides + j, k * kSides + l, i * kSides + l});
    }
  }
  return soup;
}

TEST(Planarize, DoesNotTurnShortSidesRound) {
  const auto before = make_mesh(rumpled_strips());
  const PlanarizeResult result = flatten(rumpled_strips());
  ASSERT_TRUE(result.has_converged) << result.sentence;
  const Mesh after(result.soup);
  EXPECT_LE(worst_unevenness(after), 1e-6);
  for (const FaceId f : after.faces()) {
    EXPECT_GT(glm::dot(before->normal(f), after.normal(f)), 0);
    EXPECT_TRUE(is_simple(outline(after, f)) || !is_simple(outline(*before, f))) << "face " << f.value;
  }
}

TEST(Planarize, WorksAtBorders) {
  PolygonSoup open = shapes::grid_patch(6, 5);
  Random random(3);
  for (glm::dvec3& point : open.points) point.y += 0.15 * random.unit();
  const PlanarizeResult result = flatten(open);
  ASSERT_TRUE(result.has_converged) << result.sentence;
  const Mesh after(result.soup);
  EXPECT_FALSE(after.is_closed());
  EXPECT_LE(worst_unevenness(after), 1e-6);
  EXPECT_LT(result.moved_share, 0.02);
  EXPECT_TRUE(flatten(shaken(shapes::open_cylinder(16, 3), 0.02)).has_converged);
}

TEST(Planarize, FlattensPartsOnTheirOwn) {
  const PolygonSoup soup = shapes::combined(cube_with_a_lifted_corner(), shapes::dodecahedron(), {9, 0, 0});
  const PlanarizeResult result = flatten(soup);
  ASSERT_TRUE(result.has_converged) << result.sentence;
  EXPECT_GT(largest_move(soup, result.soup), 0.01);
  EXPECT_LT(largest_move(soup, result.soup, 6), 1e-9);
}

TEST(Planarize, NeverRaisesTheEnergyOfTheFlow) {
  for (const Noisy& noisy : noisy_shapes()) {
    const std::vector<double> energies = flatten(noisy.soup).flow_energies;
    ASSERT_GE(energies.size(), 2U) << noisy.soup.name;
    EXPECT_TRUE(std::is_sorted(energies.rbegin(), energies.rend())) << noisy.soup.name;
    EXPECT_LT(energies.back(), 0.5 * energies.front()) << noisy.soup.name;
  }
}

TEST(Planarize, AsksNothingOfSizeAndPlace) {
  PolygonSoup soup = bumped_cube_sphere();
  const PlanarizeResult small = flatten(soup);
  for (glm::dvec3& point : soup.points) point = 1000.0 * point + glm::dvec3(3000, -500, 70);
  const PlanarizeResult large = flatten(soup);
  EXPECT_NEAR(large.moved_share, small.moved_share, 1e-6);
  EXPECT_NEAR(large.largest_move, 1000 * small.largest_move, 1e-2);
  EXPECT_TRUE(large.has_converged);
}

TEST(Planarize, KeepsFacesUvAndMaterials) {
  PolygonSoup soup = shaken(shapes::globe(), 0.01);
  soup.up_axis = UpAxis::Z;
  soup.materials = {{"sea", {}, nullptr}, {"land", {}, nullptr}};
  for (int f = 0; f < soup.n_faces(); ++f) soup.face_material.push_back(f % 3 - 1);
  const PlanarizeResult result = flatten(soup);
  ASSERT_TRUE(result.has_converged) << result.sentence;
  EXPECT_EQ(result.soup.face_begin, soup.face_begin);
  EXPECT_LT(largest_move(soup, result.soup), 0.05);  // face by face, corner by corner
  EXPECT_EQ(result.soup.corner_uv, soup.corner_uv);
  EXPECT_EQ(result.soup.face_material, soup.face_material);
  ASSERT_EQ(result.soup.materials.size(), 2U);
  EXPECT_EQ(result.soup.materials[1].name, "land");
  EXPECT_EQ(result.soup.up_axis, UpAxis::Z);
  EXPECT_EQ(result.soup.name, soup.name);
}

TEST(Planarize, GivesTheSameShapeEveryTime) {
  const PlanarizeResult first = flatten(bumped_cube_sphere());
  const PlanarizeResult second = flatten(bumped_cube_sphere());
  EXPECT_EQ(first.soup.points, second.soup.points);
  EXPECT_EQ(first.iterations, second.iterations);
}

TEST(Planarize, EndsWhenCancelled) {
  Progress progress;
  progress.cancel();
  const auto mesh = make_mesh(bumped_cube_sphere());
  const PlanarizeResult result = planarize(*mesh, {}, progress);
  EXPECT_TRUE(result.was_cancelled);
  EXPECT_FALSE(result.has_converged);
  EXPECT_EQ(result.iterations, 0);
  EXPECT_EQ(result.soup.points.size(), mesh->n_vertices());
  EXPECT_NE(result.sentence.find("stopped"), std::string::npos);
}

TEST(Planarize, SaysWhenTheShapeWouldMoveTooFar) {
  const PlanarizeResult result = flatten(pillow());
  EXPECT_FALSE(result.has_converged);
  EXPECT_FALSE(result.was_cancelled);
  EXPECT_GT(result.unevenness_after, 0.01);
  EXPECT_LE(result.moved_share, 0.1);
  EXPECT_NE(result.sentence.find("more than the 10.0 % allowed"), std::string::npos) << result.sentence;
  EXPECT_NE(result.sentence.find("Split"), std::string::npos) << result.sentence;
  EXPECT_TRUE(flatten(pillow(), {.max_move = 1}).has_converged);
}

TEST(Planarize, SaysWhenItRanOutOfSteps) {
  const PolygonSoup soup = bumped_cube_sphere();
  const PlanarizeResult result = flatten(soup, {.max_iterations = 2});
  EXPECT_FALSE(result.has_converged);
  EXPECT_EQ(result.iterations, 2);
  EXPECT_LT(result.unevenness_after, result.unevenness_before);
  EXPECT_GT(result.unevenness_after, 1e-6);
  EXPECT_NE(result.sentence.find("within 2 steps"), std::string::npos) << result.sentence;
}

TEST(Planarize, SaysWhenTheTargetIsBeyondArithmetic) {
  const PlanarizeResult result = flatten(bumped_cube_sphere(), {.target = 1e-18});
  EXPECT_FALSE(result.has_converged);
  EXPECT_LT(result.unevenness_after, 1e-9);
  EXPECT_NE(result.sentence.find("did not become flat"), std::string::npos) << result.sentence;
}

}  // namespace
}  // namespace netwright
