// Welding and orienting: what merges, what does not, which way faces end up, and that nothing else changes.
#include "core/mesh/repair.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/mesh/shapes.h"
#include "tests/support.h"

namespace netwright {
namespace {

using testing::zoo;
using testing::ZooShape;

/// The shape with points of its own for every face, as STL files have them.
PolygonSoup torn(const PolygonSoup& soup) {
  PolygonSoup apart;
  apart.name = soup.name;
  apart.is_indexed = false;
  for (int f = 0; f < soup.n_faces(); ++f) {
    std::vector<int> corners;
    for (const int point : soup.face(f)) {
      corners.push_back(static_cast<int>(apart.points.size()));
      apart.points.push_back(soup.points[static_cast<std::size_t>(point)]);
    }
    apart.add_face(corners);
  }
  return apart;
}

void reverse_face(PolygonSoup& soup, int f) {
  std::reverse(soup.corners.begin() + soup.face_begin[static_cast<std::size_t>(f)],
               soup.corners.begin() + soup.face_begin[static_cast<std::size_t>(f) + 1]);
}

double volume(const Mesh& mesh) {
  double six_volumes = 0;
  for (const FaceId f : mesh.faces())
    six_volumes += 2 * mesh.area(f) * glm::dot(mesh.normal(f), mesh.centre(f));
  return six_volumes;
}

TEST(Weld, PutsTornShapesTogetherAgain) {
  for (const ZooShape& shape : zoo()) {
    const PreparedModel model = prepare(torn(shape.soup));
    ASSERT_TRUE(model.is_fit()) << model.refusal;
    EXPECT_EQ(model.mesh->n_vertices(), shape.soup.points.size()) << shape.soup.name;
    EXPECT_EQ(model.mesh->is_closed(), shape.is_closed) << shape.soup.name;
  }
}

TEST(Weld, ForgivesTheRoundingOfFloats) {
  PolygonSoup apart = torn(shapes::icosphere(4));
  Random random(1);
  for (glm::dvec3& p : apart.points) {
    for (int axis = 0; axis < 3; ++axis) p[axis] += 1e-7 * (random.unit() - 0.5);
  }
  const PreparedModel model = prepare(apart);
  ASSERT_TRUE(model.is_fit()) << model.refusal;
  EXPECT_EQ(model.mesh->n_vertices(), 162U);
  EXPECT_TRUE(model.mesh->is_closed());
}

TEST(Weld, MergesPointsOfIndexedFilesOnlyWhenEqual) {
  PolygonSoup soup = torn(shapes::cube());
  soup.is_indexed = true;
  EXPECT_EQ(weld(soup), 16);
  PolygonSoup moved = torn(shapes::cube());
  moved.is_indexed = true;
  moved.points[0].x += 1e-12;
  EXPECT_EQ(weld(moved), 15);
}

TEST(Weld, TakesBothZerosForOne) {
  PolygonSoup soup;
  soup.points = {{0.0, 0, 0}, {-0.0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
  soup.add_face(std::vector<int>{0, 2, 3});
  soup.add_face(std::vector<int>{1, 4, 2});
  EXPECT_EQ(weld(soup), 1);
}

TEST(Weld, KeepsThePointNumbersOfTheFile) {
  PolygonSoup soup = torn(shapes::cube());
  const std::size_t n_points = soup.points.size();
  weld(soup);
  EXPECT_EQ(soup.points.size(), n_points);
}

TEST(Weld, JoinsFacesAcrossTextureSeams) {
  const PolygonSoup globe = shapes::globe();
  PolygonSoup apart = torn(globe);
  apart.is_indexed = true;
  apart.corner_uv = globe.corner_uv;
  const PreparedModel model = prepare(apart);
  ASSERT_TRUE(model.is_fit()) << model.refusal;
  EXPECT_TRUE(model.mesh->is_closed());
  for (const HalfedgeId h : model.mesh->halfedges()) EXPECT_EQ(model.mesh->uv(h), globe.corner_uv[h.index()]);
}

TEST(Orient, LeavesGoodShapesAlone) {
  for (const ZooShape& shape : zoo()) {
    PolygonSoup soup = shape.soup;
    const std::vector<bool> turned = orient(soup);
    EXPECT_EQ(std::ranges::count(turned, true), 0) << soup.name;
    EXPECT_EQ(soup.corners, shape.soup.corners) << soup.name;
  }
}

TEST(Orient, TurnsClosedShapesOutwardWhateverTheirFacesDid) {
  Random random(7);
  for (const ZooShape& shape : zoo()) {
    if (!shape.is_closed) continue;
    PolygonSoup soup = shape.soup;
    std::vector<bool> reversed;
    for (int f = 0; f < soup.n_faces(); ++f) {
      reversed.push_back(random.below(2) == 1);
      if (reversed.back()) reverse_face(soup, f);
    }
    const PreparedModel model = prepare(soup);
    ASSERT_TRUE(model.is_fit()) << model.refusal;
    EXPECT_GT(volume(*model.mesh), 0) << soup.name;
    for (const FaceId f : model.mesh->faces()) EXPECT_EQ(model.mesh->is_flipped(f), reversed[f.index()]);
  }
}

TEST(Orient, TurnsEachComponentByItself) {
  PolygonSoup soup = shapes::combined(shapes::cube(), testing::inside_out(shapes::cube()), {3, 0, 0});
  const std::vector<bool> turned = orient(soup);
  EXPECT_EQ(turned, (std::vector<bool>{false, false, false, false, false, false, true, true, true, true, true,
                                       true}));
}

TEST(Orient, FollowsTheMajorityWhereThereIsNoOutside) {
  PolygonSoup soup = shapes::grid_patch(3, 3);
  reverse_face(soup, 0);
  reverse_face(soup, 4);
  const std::vector<bool> turned = orient(soup);
  EXPECT_EQ(std::ranges::count(turned, true), 2);
  EXPECT_TRUE(turned[0] && turned[4]);
}

TEST(Orient, TurnsTextureCoordinatesWithTheirCorners) {
  PolygonSoup soup = shapes::globe();
  reverse_face(soup, 20);
  const int begin = soup.face_begin[20];
  std::reverse(soup.corner_uv.begin() + begin, soup.corner_uv.begin() + soup.face_begin[21]);
  orient(soup);
  EXPECT_EQ(soup.corner_uv, shapes::globe().corner_uv);
}

TEST(Orient, NamesTheEdgeWhereAOneSidedSurfaceCannotAgree) {
  PolygonSoup klein;  // a 6 × 6 torus whose last column is glued upside down
  constexpr int n = 6;
  for (int i = 0; i < n * n; ++i) klein.points.emplace_back(i % n, i / n, (i * i) % 7);
  const auto at = [](int column, int row) { return column < n ? column * n + row % n : (n - row % n) % n; };
  for (int c = 0; c < n; ++c) {
    for (int r = 0; r < n; ++r)
      klein.add_face(std::vector<int>{at(c, r), at(c + 1, r), at(c + 1, r + 1), at(c, r + 1)});
  }
  try {
    orient(klein);
    FAIL() << "a Klein bottle has no outside";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Unfit);
    EXPECT_NE(std::string(error.what()).find("between points"), std::string::npos);
  }
}

TEST(Prepare, KeepsFacesInTheOrderOfTheFile) {
  const PreparedModel model = prepare(torn(shapes::star(7)));
  ASSERT_TRUE(model.mesh);
  for (const FaceId f : model.mesh->faces()) EXPECT_EQ(model.mesh->face_source(f), f.value);
}

TEST(Prepare, WorksAtEveryScale) {
  for (const double scale : {1e-30, 1e-3, 1e30}) {
    PolygonSoup soup = torn(shapes::torus(8, 6));
    for (glm::dvec3& p : soup.points) p *= scale;
    const PreparedModel model = prepare(soup);
    ASSERT_TRUE(model.is_fit()) << model.refusal;
    EXPECT_EQ(model.report.genus, 1);
    EXPECT_EQ(model.report.n_self_intersections, 0);
  }
}

TEST(Prepare, TellsWhatItDid) {
  PolygonSoup soup = shapes::cube();
  reverse_face(soup, 2);
  soup.notices.emplace_back("A picture was missing.");
  const PreparedModel model = prepare(soup);
  ASSERT_TRUE(model.is_fit());
  std::vector<std::string> notices;
  for (const MeshReport::Line& line : model.report.lines) {
    if (line.kind == MeshReport::Line::Kind::Notice) notices.push_back(line.text);
  }
  ASSERT_EQ(notices.size(), 2U);
  EXPECT_EQ(notices[0], "1 face was turned over to face outward like the rest.");
  EXPECT_EQ(notices[1], "A picture was missing.");
}

TEST(Prepare, KeepsClosedPartsApartThatOnlyTouch) {
  for (const glm::dvec3 shift : {glm::dvec3(1, 1, 1), glm::dvec3(1, 1, 0), glm::dvec3(1, 0, 0)}) {
    const PreparedModel model = prepare(shapes::combined(shapes::cube(), shapes::cube(), shift));
    ASSERT_TRUE(model.is_fit()) << model.refusal;
    EXPECT_EQ(model.report.n_components, 2);
    EXPECT_EQ(model.report.n_vertices, 16);
  }
}

TEST(Prepare, DoesNotTakeLooseFacesForAModel) {
  PolygonSoup soup = torn(shapes::cube());
  soup.is_indexed = true;
  soup.points.emplace_back(2, 2, 2);
  soup.add_face(std::vector<int>{0, 1, static_cast<int>(soup.points.size()) - 1});
  const PreparedModel model = prepare(soup);
  EXPECT_FALSE(model.mesh);
  EXPECT_NE(model.refusal.find("has 3 faces"), std::string::npos) << model.refusal;
}

TEST(Prepare, HandsBackTheMeshOfAModelWithUnevenFaces) {
  PolygonSoup soup = shapes::cube();
  soup.points[0] += glm::dvec3(0.1, 0.1, 0.1);
  const PreparedModel model = prepare(soup);
  EXPECT_TRUE(model.mesh);
  EXPECT_FALSE(model.is_fit());
  EXPECT_NE(model.refusal.find("3 faces are not flat"), std::string::npos) << model.refusal;
}

TEST(Prepare, RefusesDoubledFacesByTheirNumbers) {
  PolygonSoup soup = shapes::cube();
  soup.add_face(std::vector<int>(soup.face(3).begin(), soup.face(3).end()));
  const PreparedModel model = prepare(soup);
  EXPECT_FALSE(model.mesh);
  EXPECT_NE(model.refusal.find("faces 4 and 7"), std::string::npos) << model.refusal;
  EXPECT_EQ(model.report.n_faces, 7);
  EXPECT_FALSE(model.report.is_fit());
}

}  // namespace
}  // namespace netwright
