// The hard families: closed, oriented outward, of the genus and number of faces their rule says, at more than
// one size each.
#include "core/mesh/shapes_hard.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "core/mesh/mesh.h"
#include "tests/support.h"

namespace netwright {
namespace {

struct HardShape {
  PolygonSoup soup;
  int n_faces = 0;
  int genus = 0;
};

std::vector<HardShape> hard_shapes() {
  using namespace shapes;
  return {{box_with_tubes(1, 1, 5), 32, 1},
          {box_with_tubes(3, 2, 9, 0.25), 132, 6},
          {box_with_tubes(6, 6, 3), 732, 36},
          {comb(1, 4), 10, 0},
          {comb(5, 8, 0.2), 58, 0},
          {brush(1, 1, 2), 10, 0},
          {brush(3, 2, 5, 0.5), 30 + 16 + 24, 0},
          {scaffold(1), 72, 5},
          {scaffold(2), 270, 28},
          {menger_sponge(0), 6, 0},
          {menger_sponge(1), 72, 5},
          {menger_sponge(2), 1056, 81},
          {screw(1), 76, 0},
          {screw(5, 8), 180, 0},
          {spiked(icosphere(1), 2), 60, 0},
          {spiked(torus(6, 4), 1.5), 144, 1},
          {star_spindle(5, 0.3, 8), 20, 0}};
}

double volume(const PolygonSoup& soup) {
  double six_volumes = 0;
  const auto at = [&](int i) { return soup.points[static_cast<std::size_t>(i)]; };
  for (int f = 0; f < soup.n_faces(); ++f) {
    const auto face = soup.face(f);
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
      six_volumes += glm::dot(at(face[0]), glm::cross(at(face[i]), at(face[i + 1])));
  }
  return six_volumes / 6;
}

/// Corners less edges plus faces.
int euler_number(const Mesh& mesh) {
  return static_cast<int>(mesh.n_vertices() + mesh.n_faces()) - static_cast<int>(mesh.n_edges());
}

TEST(ShapesHard, AreClosedAndOfTheGenusTheirRuleSays) {
  for (const HardShape& shape : hard_shapes()) {
    const auto mesh = testing::make_mesh(shape.soup);
    EXPECT_EQ(shape.soup.n_faces(), shape.n_faces) << shape.soup.name;
    EXPECT_TRUE(mesh->is_closed()) << shape.soup.name;
    EXPECT_EQ(euler_number(*mesh), 2 - 2 * shape.genus) << shape.soup.name;
    EXPECT_GT(volume(shape.soup), 0) << shape.soup.name;
  }
}

}  // namespace
}  // namespace netwright
