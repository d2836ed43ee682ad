// Hinges and flat faces of the dual graph, over the zoo.
#include "core/mesh/dual_graph.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/polygon2.h"
#include "tests/support.h"

namespace netwright {
namespace {

using testing::make_dual;
using testing::zoo;

TEST(DualGraph, FlattensFacesTrueToTheirLengths) {
  for (const auto& shape : zoo()) {
    const auto dual = make_dual(shape.soup);
    const Mesh& mesh = dual->mesh();
    for (const FaceId f : mesh.faces())
      for (const HalfedgeId a : mesh.halfedges(f))
        for (const HalfedgeId b : mesh.halfedges(f))
          ASSERT_NEAR(glm::distance(dual->flat(a), dual->flat(b)),
                      glm::distance(mesh.position(a), mesh.position(b)), 1e-6 * mesh.size(f))
              << shape.soup.name;
  }
}

TEST(DualGraph, FacesRunCounterClockwiseInTheirFrames) {
  for (const auto& shape : zoo()) {
    const auto dual = make_dual(shape.soup);
    for (const FaceId f : dual->mesh().faces()) {
      std::vector<glm::dvec2> corners;
      for (const HalfedgeId h : dual->mesh().halfedges(f)) corners.push_back(dual->flat(h));
      EXPECT_NEAR(signed_area(corners), dual->mesh().area(f), 1e-9 * dual->mesh().area(f)) << shape.soup.name;
    }
  }
}

TEST(DualGraph, UnrollingBringsBothEndsOfTheHingeTogether) {
  for (const auto& shape : zoo()) {
    const auto dual = make_dual(shape.soup);
    const Mesh& mesh = dual->mesh();
    for (const HalfedgeId h : mesh.halfedges()) {
      const HalfedgeId t = mesh.twin(h);
      if (!t.is_valid()) continue;
      const double tolerance = 1e-9 * mesh.size(mesh.face(h));
      EXPECT_LT(glm::distance(dual->unroll(h)(dual->flat(mesh.next(t))), dual->flat(h)), tolerance);
      EXPECT_LT(glm::distance(dual->unroll(h)(dual->flat(t)), dual->flat(mesh.next(h))), tolerance);
      const Rigid2 there_and_back = dual->unroll(h) * dual->unroll(t);
      EXPECT_NEAR(there_and_back.cos, 1, 1e-12);
      EXPECT_NEAR(there_and_back.x, 0, tolerance);
    }
  }
}

TEST(DualGraph, BendsAreRightAnglesOnACubeAndReflexInANotch) {
  const auto cube = make_dual(shapes::cube());
  for (const EdgeId e : cube->mesh().edges()) EXPECT_NEAR(cube->bend(e), M_PI / 2, 1e-12);
  const auto letter = make_dual(shapes::letter_l());
  int n_reflex = 0;
  for (const EdgeId e : letter->mesh().edges()) n_reflex += letter->bend(e) < 0 ? 1 : 0;
  EXPECT_EQ(n_reflex, 1);
}

TEST(DualGraph, SplitsOnlyConcaveFaces) {
  for (const auto& shape : zoo()) {
    const auto dual = make_dual(shape.soup);
    bool any = false;
    for (const FaceId f : dual->mesh().faces()) any = any || dual->n_parts(f) > 1;
    EXPECT_EQ(any, shape.has_concave_faces) << shape.soup.name;
  }
}

TEST(DualGraph, SaysHowFarAFaceIsFromFlat) {
  PolygonSoup soup = shapes::cube();
  soup.name = "bent.obj";
  soup.points[0].y += 0.1;
  try {
    make_dual(soup);
    FAIL() << "a bent face was accepted";
  } catch (const Error& error) {
    const std::string text = error.what();
    EXPECT_EQ(error.kind(), ErrorKind::Unfit);
    EXPECT_NE(text.find("bent.obj"), std::string::npos) << text;
    EXPECT_NE(text.find("is not flat"), std::string::npos) << text;
    EXPECT_NE(text.find('%'), std::string::npos) << text;
  }
}

TEST(DualGraph, MeanValenceIsThreeOnClosedTriangleMeshes) {
  EXPECT_DOUBLE_EQ(make_dual(shapes::icosphere(2))->mean_valence(), 3);
  EXPECT_DOUBLE_EQ(make_dual(shapes::cube())->mean_valence(), 4);
}

}  // namespace
}  // namespace netwright
