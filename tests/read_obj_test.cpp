// The OBJ reader: polygons, numbers, indices, material libraries, and the many ways lines can end.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "core/base/error.h"
#include "core/base/image.h"
#include "core/mesh/read.h"
#include "core/mesh/shapes.h"
#include "tests/model_files.h"

namespace netwright {
namespace {

using testing::read_file;

const std::string kTetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size()) {
    text.replace(at, what.size(), with);
  }
  return text;
}

std::string refusal(const std::string& text) {
  try {
    read_soup_bytes("model.obj", text);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Read);
    return error.what();
  }
  return "accepted";
}

TEST(ReadObj, KeepsPolygonsAsTheyAre) {
  const PolygonSoup gear = shapes::gear(80);  // its caps have 320 corners each
  const PolygonSoup soup = read_soup_bytes("gear.obj", shapes::to_obj(gear));
  EXPECT_EQ(soup.face_begin, gear.face_begin);
  EXPECT_EQ(soup.corners, gear.corners);
}

TEST(ReadObj, KeepsEveryDigitOfTheCoordinates) {
  const PolygonSoup sphere = shapes::icosphere(3);
  EXPECT_EQ(read_soup_bytes("sphere.obj", shapes::to_obj(sphere)).points, sphere.points);
}

TEST(ReadObj, CountsNegativeIndicesBackwards) {
  const PolygonSoup soup =
      read_soup_bytes("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 0 0 1\nf -4 -1 -3\n");
  EXPECT_EQ(soup.corners, (std::vector<int>{0, 1, 2, 0, 3, 1}));
}

TEST(ReadObj, LetsFacesNamePointsThatComeLater) {
  EXPECT_EQ(read_soup_bytes("a.obj", "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n").n_faces(), 1);
}

TEST(ReadObj, UnderstandsEveryLineEndAndAByteOrderMark) {
  const std::vector<int> corners = read_soup_bytes("a.obj", kTetrahedron).corners;
  EXPECT_EQ(read_soup_bytes("a.obj", replaced(kTetrahedron, "\n", "\r\n")).corners, corners);
  EXPECT_EQ(read_soup_bytes("a.obj", replaced(kTetrahedron, "\n", "\r")).corners, corners);
  EXPECT_EQ(read_soup_bytes("a.obj", "\xEF\xBB\xBF" + kTetrahedron).corners, corners);
  EXPECT_EQ(read_soup_bytes("a.obj", replaced(kTetrahedron, "f 1 3 2", "f 1 \\\n 3 2  ")).corners, corners);
}

TEST(ReadObj, ReadsALastLineThatPromisesAnotherOne) {
  EXPECT_EQ(read_soup_bytes("a.obj", kTetrahedron + "f 3 2 1 \\").n_faces(), 5);
  const std::string said = refusal("v 0 0 0\nf x \\");
  EXPECT_NE(said.find("face 1 (line 2)"), std::string::npos) << said;
}

TEST(ReadObj, TakesHugeAndTinyCoordinates) {
  for (const char* size : {"1e30", "1e-30"}) {
    const std::string text = replaced(kTetrahedron, "1 0 0\n", std::string(size) + " 0 0\n");
    EXPECT_EQ(read_soup_bytes("a.obj", text).points[1].x, std::stod(size));
  }
}

TEST(ReadObj, RefusesNumbersThatAreNoneWithTheirPointAndLine) {
  for (const char* word : {"nan", "inf", "-inf", "1e999", "abc", "1,5"}) {
    const std::string said = refusal(replaced(kTetrahedron, "v 0 1 0", std::string("v 0 ") + word + " 0"));
    EXPECT_NE(said.find("point 3 (line 3)"), std::string::npos) << said;
    EXPECT_NE(said.find(word), std::string::npos) << said;
  }
}

TEST(ReadObj, RefusesBadIndicesWithTheirFaceAndLine) {
  for (const char* index : {"0", "9", "-9", "x", "0/1"}) {
    const std::string said = refusal(replaced(kTetrahedron, "f 2 3 4", std::string("f 2 3 ") + index));
    EXPECT_NE(said.find("face 3 (line 7)"), std::string::npos) << said;
  }
}

TEST(ReadObj, RefusesFacesWithTooFewCorners) {
  EXPECT_NE(refusal(kTetrahedron + "f 1 2\n").find("face 5 (line 9) has only 2 corners"), std::string::npos);
  EXPECT_NE(refusal(kTetrahedron + "f\n").find("line 9 is a face without corners"), std::string::npos);
}

TEST(ReadObj, GivesEveryCornerItsTextureCoordinates) {
  const PolygonSoup globe = shapes::globe();
  const PolygonSoup soup = read_soup_bytes("globe.obj", shapes::to_obj(globe, "globe.mtl"));
  ASSERT_EQ(soup.corner_uv.size(), globe.corner_uv.size());
  for (std::size_t i = 0; i < globe.corner_uv.size(); ++i) {
    EXPECT_LT(glm::length(soup.corner_uv[i] - globe.corner_uv[i]), 1e-12);
  }
}

TEST(ReadObj, FindsMaterialsAndPicturesThroughTheLookup) {
  const std::filesystem::path samples = std::filesystem::path(NETWRIGHT_SOURCE) / "assets/samples";
  const PolygonSoup soup = read_soup_bytes(
      "globe.obj", read_file(samples / "globe.obj"),
      [&](const std::string& name) -> std::optional<std::string> { return read_file(samples / name); });
  ASSERT_EQ(soup.materials.size(), 1U);
  ASSERT_TRUE(soup.materials[0].texture);
  EXPECT_EQ(soup.materials[0].texture->width, 1024);
  EXPECT_EQ(soup.face_material, std::vector<int>(static_cast<std::size_t>(soup.n_faces()), 0));
  EXPECT_TRUE(soup.notices.empty());
}

TEST(ReadObj, GivesEachFaceTheMaterialInForce) {
  const std::string library = "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n";
  const std::string text =
      "mtllib c.mtl\n" +
      replaced(replaced(kTetrahedron, "f 1 3 2", "f 1 3 2\nusemtl blue "), "f 2 3 4", "usemtl red\nf 2 3 4");
  const PolygonSoup soup = read_soup_bytes("a.obj", text, [&](const std::string& name) {
    return name == "c.mtl" ? std::optional(library) : std::nullopt;
  });
  EXPECT_EQ(soup.face_material, (std::vector<int>{-1, 1, 0, 0}));
  EXPECT_EQ(soup.materials[1].colour, glm::dvec3(0, 0, 1));
}

TEST(ReadObj, SaysWhichCompanionIsMissingAndReadsOn) {
  const PolygonSoup soup = read_soup_bytes("a.obj", "mtllib gone.mtl\n" + kTetrahedron);
  ASSERT_EQ(soup.notices.size(), 1U);
  EXPECT_NE(soup.notices[0].find("gone.mtl"), std::string::npos);
  const PolygonSoup pictured =
      read_soup_bytes("a.obj", "mtllib c.mtl\nusemtl a\n" + kTetrahedron, [](const std::string& name) {
        return name == "c.mtl" ? std::optional<std::string>("newmtl a\nmap_Kd gone.png\n") : std::nullopt;
      });
  ASSERT_EQ(pictured.notices.size(), 1U);
  EXPECT_NE(pictured.notices[0].find("gone.png"), std::string::npos);
}

TEST(ReadObj, SurvivesAMaterialLibraryWithoutMaterials) {
  const PolygonSoup soup =
      read_soup_bytes("a.obj", "mtllib c.mtl\nusemtl x\n" + kTetrahedron,
                      [](const std::string&) { return std::optional<std::string>("# empty\n"); });
  EXPECT_EQ(soup.n_faces(), 4);
  EXPECT_TRUE(soup.materials.empty());
  EXPECT_TRUE(soup.face_material.empty());
}

}  // namespace
}  // namespace netwright
