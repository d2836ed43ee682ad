// The glTF reader: scenes with moved nodes, buffers inside and beside the file, and damage of every kind.
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/mesh/read.h"
#include "core/mesh/repair.h"
#include "core/mesh/shapes.h"
#include "tests/model_files.h"

namespace netwright {
namespace {

using testing::gltf_buffer;
using testing::gltf_text;
using testing::to_glb;

std::string refusal(const std::string& name, const std::string& bytes,
                    const CompanionLookup& companions = {}) {
  try {
    read_soup_bytes(name, bytes, companions);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Read);
    return error.what();
  }
  return "accepted";
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), with);
}

TEST(ReadGltf, ReadsTheTrianglesOfABinaryFile) {
  const PolygonSoup sphere = shapes::icosphere(2);
  const PolygonSoup soup = read_soup_bytes("sphere.glb", to_glb(sphere));
  EXPECT_EQ(soup.corners, sphere.corners);
  EXPECT_FALSE(soup.is_indexed);
  EXPECT_EQ(soup.up_axis, UpAxis::Y);
  for (std::size_t i = 0; i < sphere.points.size(); ++i) {
    EXPECT_LT(glm::length(soup.points[i] - sphere.points[i]), 1e-6);
  }
}

TEST(ReadGltf, FindsItsBufferThroughTheLookup) {
  const PolygonSoup sphere = shapes::icosphere(1);
  const std::string text = gltf_text(sphere, R"({"mesh":0})", "my%20buffer.bin");
  const PolygonSoup soup = read_soup_bytes("sphere.gltf", text, [&](const std::string& name) {
    return name == "my buffer.bin" ? std::optional(gltf_buffer(sphere)) : std::nullopt;
  });
  EXPECT_EQ(soup.corners, sphere.corners);
}

TEST(ReadGltf, NamesTheBufferThatIsMissing) {
  const std::string text = gltf_text(shapes::icosphere(1), R"({"mesh":0})", "gone.bin");
  EXPECT_NE(refusal("a.gltf", text).find("gone.bin"), std::string::npos);
}

TEST(ReadGltf, AppliesTheMotionsOfNestedNodes) {
  const PolygonSoup soup = read_soup_bytes(
      "a.glb",
      to_glb(shapes::tetrahedron(), R"({"children":[1],"translation":[10,0,0]},{"mesh":0,"scale":[2,2,2]})"));
  for (const glm::dvec3& p : soup.points) {
    EXPECT_NEAR(std::abs(p.x - 10), 2, 1e-6);
    EXPECT_NEAR(std::abs(p.y), 2, 1e-6);
  }
}

TEST(ReadGltf, TurnsTheFacesOfMirroredNodes) {
  const std::string glb = to_glb(shapes::icosphere(2), R"({"mesh":0,"scale":[-1,1,1]})");
  const PreparedModel model = prepare(read_soup_bytes("a.glb", glb));
  ASSERT_TRUE(model.is_fit()) << model.refusal;
  for (const FaceId f : model.mesh->faces()) EXPECT_FALSE(model.mesh->is_flipped(f));
}

TEST(ReadGltf, UnrollsStripsAndFansIntoTriangles) {
  PolygonSoup strip;
  strip.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  strip.corners = {0, 1, 2, 3};
  const std::string text = gltf_text(strip, R"({"mesh":0})", "b.bin");
  const CompanionLookup buffer = [&](const std::string&) { return std::optional(gltf_buffer(strip)); };
  const std::string plain = R"("indices":1)";
  const PolygonSoup as_strip =
      read_soup_bytes("a.gltf", replaced(text, plain, plain + R"(,"mode":5)"), buffer);
  EXPECT_EQ(as_strip.corners, (std::vector<int>{0, 1, 2, 1, 3, 2}));
  const PolygonSoup as_fan = read_soup_bytes("a.gltf", replaced(text, plain, plain + R"(,"mode":6)"), buffer);
  EXPECT_EQ(as_fan.corners, (std::vector<int>{0, 1, 2, 0, 2, 3}));
  EXPECT_NE(refusal("a.gltf", replaced(text, plain, plain + R"(,"mode":4)"), buffer).find("incomplete"),
            std::string::npos);
  EXPECT_NE(refusal("a.gltf", replaced(text, plain, plain + R"(,"mode":1)"), buffer).find("no shape"),
            std::string::npos);
}

TEST(ReadGltf, RefusesWhatLiesOutsideItsBuffer) {
  const PolygonSoup sphere = shapes::icosphere(1);
  const std::string text = gltf_text(sphere, R"({"mesh":0})", "b.bin");
  const CompanionLookup buffer = [&](const std::string&) { return std::optional(gltf_buffer(sphere)); };
  ASSERT_EQ(refusal("a.gltf", text, buffer), "accepted");
  EXPECT_NE(refusal("a.gltf", replaced(text, R"("count":12)", R"("count":12000)"), buffer), "accepted");
  EXPECT_NE(refusal("a.gltf", replaced(text, R"("byteOffset":144)", R"("byteOffset":99999)"), buffer),
            "accepted");
  EXPECT_NE(refusal("a.gltf", replaced(text, R"("bufferView":1)", R"("bufferView":7)"), buffer), "accepted");
  EXPECT_NE(refusal("a.gltf", replaced(text, R"("POSITION":0)", R"("POSITION":9)"), buffer), "accepted");
  EXPECT_NE(refusal("a.gltf", replaced(text, R"("nodes":[0])", R"("nodes":[3])"), buffer), "accepted");
}

TEST(ReadGltf, RefusesIndicesBeyondThePoints) {
  PolygonSoup soup = shapes::icosphere(1);
  soup.corners[7] = 500;
  EXPECT_NE(refusal("a.glb", to_glb(soup)).find("corner 8"), std::string::npos);
}

TEST(ReadGltf, RefusesNodesThatContainThemselves) {
  const std::string glb = to_glb(shapes::icosphere(1), R"({"children":[1]},{"mesh":0,"children":[0]})");
  EXPECT_NE(refusal("a.glb", glb), "accepted");
}

TEST(ReadGltf, RefusesAFileCutShortAnywhere) {
  const std::string glb = to_glb(shapes::tetrahedron());
  for (std::size_t n = 1; n < glb.size(); n += 7)
    EXPECT_NE(refusal("a.glb", glb.substr(0, n)), "accepted") << n;
}

TEST(ReadGltf, SaysThatCompressedShapesCannotBeRead) {
  const std::string text = replaced(gltf_text(shapes::icosphere(1), R"({"mesh":0})", "b.bin"), R"("scene":0)",
                                    R"("scene":0,"extensionsRequired":["KHR_draco_mesh_compression"])");
  const std::string said = refusal(
      "a.gltf", text, [](const std::string&) { return std::optional(gltf_buffer(shapes::icosphere(1))); });
  EXPECT_NE(said.find("without compression"), std::string::npos) << said;
}

}  // namespace
}  // namespace netwright
