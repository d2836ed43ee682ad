// The formats read by the helper program: each comes back as it was written, and lies are refused.
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/mesh/read.h"
#include "core/mesh/readers.h"
#include "core/mesh/repair.h"
#include "core/mesh/shapes.h"
#include "tests/model_files.h"

namespace netwright {
namespace {

using namespace testing;

std::string refusal(const std::string& name, const std::string& bytes) {
  try {
    read_soup_bytes(name, bytes);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Read);
    return error.what();
  }
  return "accepted";
}

/// Reads, and expects a fit mesh with the faces of the shape in their order.
void expect_same_shape(const std::string& name, const std::string& bytes, const PolygonSoup& shape) {
  const PreparedModel model = prepare(read_soup_bytes(name, bytes));
  ASSERT_TRUE(model.is_fit()) << model.refusal;
  const Mesh& mesh = *model.mesh;
  EXPECT_EQ(mesh.n_vertices(), shape.points.size()) << name;
  ASSERT_EQ(static_cast<int>(mesh.n_faces()), shape.n_faces()) << name;
  for (const FaceId f : mesh.faces()) {
    ASSERT_EQ(mesh.degree(f), static_cast<int>(shape.face(f.value).size()));
    std::size_t i = 0;
    for (const HalfedgeId h : mesh.halfedges(f)) {
      EXPECT_LT(glm::length(mesh.position(h) - corner(shape, f.value, i++)), 1e-4) << name;
    }
  }
}

TEST(ReadStl, WeldsTheTrianglesOfBothKinds) {
  const PolygonSoup sphere = shapes::icosphere(3);
  expect_same_shape("a.stl", to_binary_stl(sphere), sphere);
  expect_same_shape("a.stl", to_text_stl(sphere), sphere);
}

TEST(ReadStl, IsNotFooledByABinaryHeaderThatSaysSolid) {
  const PolygonSoup sphere = shapes::icosphere(2);
  expect_same_shape("a.stl", to_binary_stl(sphere, "solid facet model"), sphere);
}

TEST(ReadStl, RefusesCountsThatDoNotFitTheFile) {
  std::string bytes = to_binary_stl(shapes::icosphere(1));
  std::memset(bytes.data() + 80, 0xFF, 4);
  EXPECT_NE(refusal("a.stl", bytes).find("4294967295"), std::string::npos);
  EXPECT_NE(refusal("a.stl", to_binary_stl(shapes::icosphere(1)).substr(0, 500)).find("cut short"),
            std::string::npos);
  const std::string text = to_text_stl(shapes::icosphere(1));
  EXPECT_NE(refusal("a.stl", text.substr(0, text.size() / 2)).find("cut short"), std::string::npos);
}

TEST(ReadPly, ReadsTextAndBinaryWithPolygons) {
  const PolygonSoup solid = shapes::archimedean_solids().back();
  expect_same_shape("a.ply", to_text_ply(solid), solid);
  expect_same_shape("a.ply", to_binary_ply(solid), solid);
  const PolygonSoup star = shapes::star(100);  // its caps have 200 corners each
  expect_same_shape("a.ply", to_text_ply(star), star);
  expect_same_shape("a.ply", to_binary_ply(star), star);
}

TEST(ReadPly, RefusesFacesThatNameMissingPoints) {
  PolygonSoup soup = shapes::icosphere(1);
  soup.corners[4] = 99;
  EXPECT_NE(refusal("a.ply", to_text_ply(soup)).find("point 99"), std::string::npos);
}

TEST(ReadPly, RefusesCoordinatesThatAreNotNumbers) {
  PolygonSoup soup = shapes::icosphere(1);
  soup.points[4].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(refusal("a.ply", to_binary_ply(soup)).find("point 5"), std::string::npos);
}

TEST(Read3mf, ReadsTheModelInsideTheArchive) {
  const PolygonSoup sphere = shapes::icosphere(2);
  expect_same_shape("a.3mf", to_3mf(sphere), sphere);
}

TEST(Read3mf, RefusesAnArchiveThatIsCutShort) {
  const std::string bytes = to_3mf(shapes::icosphere(2));
  EXPECT_NE(refusal("a.3mf", bytes.substr(0, bytes.size() / 2)).find("a.3mf: "), std::string::npos);
}

TEST(ReadCollada, ReadsPolygonsAsTheyAre) {
  const PolygonSoup solid = shapes::archimedean_solids().back();
  expect_same_shape("a.dae", to_dae(solid), solid);
}

TEST(ReadCollada, RefusesWhatIsCutShortOrOnlyCalledSo) {
  const std::string bytes = to_dae(shapes::icosphere(2));
  EXPECT_NE(refusal("a.dae", bytes.substr(0, bytes.size() / 2)).find("a.dae: "), std::string::npos);
  EXPECT_NE(refusal("a.dae", "<svg></svg>").find("not that of a Collada file"), std::string::npos);
}

TEST(Read3ds, ReadsTriangles) {
  const PolygonSoup sphere = shapes::icosphere(2);
  PolygonSoup upright = sphere;  // z up in the file, y up once it is read
  for (glm::dvec3& p : upright.points) p = {p.x, p.z, -p.y};
  expect_same_shape("a.3ds", to_3ds(sphere), upright);
}

TEST(Read3ds, RefusesWhatIsCutShort) {
  const std::string bytes = to_3ds(shapes::icosphere(2));
  EXPECT_NE(refusal("a.3ds", bytes.substr(0, bytes.size() / 2)).find("a.3ds: "), std::string::npos);
}

TEST(ReadInChild, RefusesEveryBrokenBeginning) {
  const PolygonSoup sphere = shapes::icosphere(1);
  for (const auto& [name, bytes] : {std::pair<std::string, std::string>{"a.stl", to_binary_stl(sphere)},
                                    {"a.ply", to_binary_ply(sphere)}}) {
    for (std::size_t n = bytes.size() / 5; n < bytes.size() - 60; n += bytes.size() / 5) {
      EXPECT_NE(refusal(name, bytes.substr(0, n)), "accepted") << name << " cut at " << n;
    }
  }
}

TEST(ReadInChild, RefusesAListThatAsksForGigabytes) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "memory is not limited under sanitizers";
#endif
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uint int vertex_indices\nend_header\n";
  for (const float x : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F}) append(bytes, x);
  append(bytes, std::uint32_t{4'000'000'000});
  for (const int point : {0, 1, 2}) append(bytes, point);
  EXPECT_NE(refusal("a.ply", bytes).find("more memory than a model should"), std::string::npos);
}

PolygonSoup dressed_star() {
  PolygonSoup soup = shapes::star(5);
  for (std::size_t c = 0; c < soup.corners.size(); ++c) soup.corner_uv.emplace_back(c, 0.5);
  soup.materials = {{.name = "grey", .texture = nullptr},
                    {.name = "gold", .colour = {0.9, 0.7, 0.1}, .texture = nullptr}};
  for (int f = 0; f < soup.n_faces(); ++f) soup.face_material.push_back(f % 3 - 1);
  return soup;
}

readers::ParsedModel parsed(const PolygonSoup& soup) {
  return {.soup = soup, .pictures = {{"gold.png", "pixels"}}, .picture_of = {-1, 0}};
}

TEST(SoupBytes, ComeBackAsTheyWere) {
  const PolygonSoup soup = dressed_star();
  const readers::ParsedModel back = readers::unpack("star", readers::pack(parsed(soup)));
  EXPECT_EQ(back.soup.points, soup.points);
  EXPECT_EQ(back.soup.face_begin, soup.face_begin);
  EXPECT_EQ(back.soup.corners, soup.corners);
  EXPECT_EQ(back.soup.corner_uv, soup.corner_uv);
  EXPECT_EQ(back.soup.face_material, soup.face_material);
  ASSERT_EQ(back.soup.materials.size(), 2U);
  EXPECT_EQ(back.soup.materials[1].name, "gold");
  EXPECT_EQ(back.soup.materials[1].colour, glm::dvec3(0.9, 0.7, 0.1));
  EXPECT_EQ(back.picture_of, (std::vector<int>{-1, 0}));
  ASSERT_EQ(back.pictures.size(), 1U);
  EXPECT_EQ(back.pictures[0].name, "gold.png");
  EXPECT_EQ(back.pictures[0].bytes, "pixels");
}

TEST(SoupBytes, AreNotBelievedWhenTheyDoNotAddUp) {
  const std::string packed = readers::pack(parsed(dressed_star()));
  EXPECT_THROW(readers::unpack("star", ""), Error);
  EXPECT_THROW(readers::unpack("star", packed + "x"), Error);
  EXPECT_THROW(readers::unpack("star", packed.substr(0, packed.size() - 4)), Error);
  for (std::size_t count = 0; count < 7; ++count) {
    std::string lying = packed;
    std::memset(lying.data() + 1 + 8 * count, 0x7F, 8);
    EXPECT_THROW(readers::unpack("star", lying), Error) << count;
  }
  readers::ParsedModel model = parsed(dressed_star());
  model.picture_of[1] = 1;
  EXPECT_THROW(readers::unpack("star", readers::pack(model)), Error);
  model = parsed(dressed_star());
  model.soup.face_material[2] = 2;
  EXPECT_THROW(readers::unpack("star", readers::pack(model)), Error);
}

}  // namespace
}  // namespace netwright
