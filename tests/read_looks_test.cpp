// Colours and pictures as the formats have them: what a file says a face looks like is what its material says
// afterwards, and pictures that are not there are named in one sentence.
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>

#include "core/base/image.h"
#include "core/mesh/face_colours.h"
#include "core/mesh/read.h"
#include "core/mesh/shapes.h"
#include "tests/model_files.h"

namespace netwright {
namespace {

using namespace testing;

/// A picture file of one colour.
std::string png(std::uint8_t red) {
  Image image{4, 4, {}};
  for (int k = 0; k < 16; ++k) image.rgba.insert(image.rgba.end(), {red, 20, 30, 255});
  return encode_png(image);
}

CompanionLookup files(std::map<std::string, std::string> files) {
  return [files = std::move(files)](const std::string& name) -> std::optional<std::string> {
    const auto found = files.find(name);
    return found == files.end() ? std::nullopt : std::optional(found->second);
  };
}

const Material& material_of(const PolygonSoup& soup, int face) {
  static const Material kNone{.name = "none", .texture = nullptr};
  if (soup.face_material.empty()) return kNone;
  const int m = soup.face_material.at(static_cast<std::size_t>(face));
  return m < 0 ? kNone : soup.materials.at(static_cast<std::size_t>(m));
}

/// Are its colours those of the sRGB bytes?
::testing::AssertionResult is_coloured(const Material& material, const glm::dvec3& srgb_bytes) {
  const glm::dvec3 wanted = readers::linear_colour(srgb_bytes / 255.0);
  if (glm::length(material.colour - wanted) < 0.01) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << material.name << " is " << material.colour.r << " "
                                       << material.colour.g << " " << material.colour.b;
}

/// Two triangles of a square in Collada, the first with a picture, the second red.
std::string dressed_dae(const std::string& file) {
  const auto effect = [](const std::string& id, const std::string& more, const std::string& diffuse) {
    return "<effect id=\"" + id + "\"><profile_COMMON>" + more + "<technique sid=\"t\"><lambert><diffuse>" +
           diffuse + "</diffuse></lambert></technique></profile_COMMON></effect>";
  };
  return R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">)"
         R"(<asset><up_axis>Y_UP</up_axis></asset><library_images><image id="i"><init_from>)" +
         file + "</init_from></image></library_images><library_effects>" +
         effect("ep",
                R"(<newparam sid="s"><surface type="2D"><init_from>i</init_from></surface></newparam>)"
                R"(<newparam sid="m"><sampler2D><source>s</source></sampler2D></newparam>)",
                R"(<texture texture="m" texcoord="UV"/>)") +
         effect("er", "", "<color>1 0 0 1</color>") +
         R"(</library_effects><library_materials><material id="mp" name="pictured"><instance_effect url="#ep"/>)"
         R"(</material><material id="mr" name="red"><instance_effect url="#er"/></material></library_materials>)"
         R"(<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="pa" count="12">)"
         R"(0 0 0 1 0 0 1 1 0 0 1 0</float_array><technique_common><accessor source="#pa" stride="3" count="4">)"
         R"(<param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor>)"
         R"(</technique_common></source><source id="u"><float_array id="ua" count="8">0.1 0.2 0.9 0.2 0.9 0.8 0.1 0.8)"
         R"(</float_array><technique_common><accessor source="#ua" stride="2" count="4"><param name="S" type="float"/>)"
         R"(<param name="T" type="float"/></accessor></technique_common></source><vertices id="v">)"
         R"(<input semantic="POSITION" source="#p"/></vertices>)"
         R"(<triangles material="a" count="1"><input semantic="VERTEX" source="#v" offset="0"/>)"
         R"(<input semantic="TEXCOORD" source="#u" offset="1" set="0"/><p>0 0 1 1 2 2</p></triangles>)"
         R"(<triangles material="b" count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 2 3</p></triangles>)"
         R"(</mesh></geometry></library_geometries><library_visual_scenes><visual_scene id="s"><node>)"
         R"(<instance_geometry url="#g"><bind_material><technique_common><instance_material symbol="a" target="#mp"/>)"
         R"(<instance_material symbol="b" target="#mr"/></technique_common></bind_material></instance_geometry>)"
         R"(</node></visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

TEST(LooksOfCollada, AreColoursAndPicturesBesideTheModel) {
  const PolygonSoup soup =
      read_soup_bytes("a.dae", dressed_dae("./wood%20grain.png"), files({{"wood grain.png", png(200)}}));
  ASSERT_EQ(soup.n_faces(), 2);
  EXPECT_EQ(material_of(soup, 0).name, "pictured");
  ASSERT_TRUE(material_of(soup, 0).texture);
  EXPECT_EQ(material_of(soup, 0).texture->rgba[0], 200);
  EXPECT_TRUE(is_coloured(material_of(soup, 1), {255, 0, 0}));
  EXPECT_FALSE(material_of(soup, 1).texture);
  ASSERT_EQ(soup.corner_uv.size(), 6U);
  EXPECT_LT(glm::length(soup.corner_uv[2] - glm::dvec2(0.9, 0.8)), 1e-6) << "up is up";
  EXPECT_TRUE(soup.notices.empty());
}

TEST(LooksOfCollada, AreNamedWhenTheyAreMissing) {
  const PolygonSoup soup = read_soup_bytes("a.dae", dressed_dae("gone.png"));
  EXPECT_EQ(soup.n_faces(), 2);
  ASSERT_EQ(soup.notices.size(), 1U);
  EXPECT_EQ(soup.notices[0], "The picture gone.png was not found; its faces stay plain.");
  EXPECT_TRUE(is_coloured(material_of(soup, 1), {255, 0, 0}));
}

std::string chunk(std::uint16_t id, const std::string& content) {
  std::string bytes;
  append(bytes, id);
  append(bytes, static_cast<std::uint32_t>(content.size() + 6));
  return bytes + content;
}

/// A square of two triangles: the first has the picture, the second is green.
std::string dressed_3ds(const std::string& file) {
  const auto text = [](const std::string& words) { return words + '\0'; };
  const auto colour = [](std::uint8_t r, std::uint8_t g, std::uint8_t b) {
    return chunk(0x0011, {static_cast<char>(r), static_cast<char>(g), static_cast<char>(b)});
  };
  const std::string materials =
      chunk(0xAFFF, chunk(0xA000, text("pictured")) + chunk(0xA020, colour(255, 255, 255)) +
                        chunk(0xA200, chunk(0xA300, text(file)))) +
      chunk(0xAFFF, chunk(0xA000, text("green")) + chunk(0xA020, colour(0, 160, 0)));
  std::string points;
  std::string places;
  append(points, std::uint16_t{4});
  append(places, std::uint16_t{4});
  for (const auto& [x, y] :
       {std::pair(0.F, 0.F), std::pair(1.F, 0.F), std::pair(1.F, 1.F), std::pair(0.F, 1.F)}) {
    for (const float value : {x, y, 0.F}) append(points, value);
    for (const float value : {x / 2, y / 4}) append(places, value);
  }
  std::string faces;
  append(faces, std::uint16_t{2});
  for (const int index : {0, 1, 2, 7, 0, 2, 3, 7}) append(faces, static_cast<std::uint16_t>(index));
  const auto group = [&](const std::string& name, std::uint16_t face) {
    std::string content = text(name);
    append(content, std::uint16_t{1});
    append(content, face);
    return chunk(0x4130, content);
  };
  const std::string shape = chunk(0x4110, points) + chunk(0x4140, places) +
                            chunk(0x4120, faces + group("pictured", 0) + group("green", 1));
  return chunk(0x4D4D, chunk(0x3D3D, materials + chunk(0x4000, text("square") + chunk(0x4100, shape))));
}

TEST(LooksOf3ds, AreColoursAndPicturesBesideTheModel) {
  const PolygonSoup soup = read_soup_bytes("a.3ds", dressed_3ds("WOOD.PNG"), files({{"WOOD.PNG", png(120)}}));
  ASSERT_EQ(soup.n_faces(), 2);
  int n_pictured = 0;
  for (int f = 0; f < 2; ++f) {
    if (!material_of(soup, f).texture) {
      EXPECT_TRUE(is_coloured(material_of(soup, f), {0, 160, 0}));
      continue;
    }
    ++n_pictured;
    EXPECT_EQ(material_of(soup, f).texture->rgba[0], 120);
    for (int k = 3 * f; k < 3 * f + 3; ++k) {
      const glm::dvec3 p = soup.points[static_cast<std::size_t>(soup.corners[static_cast<std::size_t>(k)])];
      const glm::dvec2 uv = soup.corner_uv.at(static_cast<std::size_t>(k));
      const double height = std::max(std::abs(p.y), std::abs(p.z));  // the format's z becomes our y
      EXPECT_LT(glm::length(uv - glm::dvec2(p.x / 2, height / 4)), 1e-6);
    }
  }
  EXPECT_EQ(n_pictured, 1);
}

TEST(LooksOf3ds, AreNamedWhenTheyAreMissing) {
  const PolygonSoup soup = read_soup_bytes("a.3ds", dressed_3ds("GONE.JPG"));
  ASSERT_EQ(soup.notices.size(), 1U);
  EXPECT_NE(soup.notices[0].find("GONE.JPG was not found"), std::string::npos);
}

TEST(LooksOfPly, AreTheMeanOfThePointsColours) {
  const std::string text =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 2\n"
      "property list uchar int vertex_indices\nend_header\n0 0 0 255 0 0\n1 0 0 255 0 0\n1 1 0 255 0 0\n"
      "0 1 0 0 0 255\n3 0 1 2\n3 0 2 3\n";
  const PolygonSoup soup = read_soup_bytes("a.ply", text);
  EXPECT_TRUE(is_coloured(material_of(soup, 0), {255, 0, 0}));
  EXPECT_TRUE(is_coloured(material_of(soup, 1), {170, 0, 85}));
}

TEST(LooksOfPly, ArePicturesNamedInAComment) {
  const std::string text =
      "ply\nformat ascii 1.0\ncomment TextureFile wood.png\nelement vertex 3\nproperty float x\n"
      "property float y\nproperty float z\nproperty float s\nproperty float t\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n0 0 0 0.1 0.2\n1 0 0 0.9 0.2\n1 1 0 0.9 0.7\n3 0 "
      "1 2\n";
  const PolygonSoup soup = read_soup_bytes("a.ply", text, files({{"wood.png", png(66)}}));
  ASSERT_TRUE(material_of(soup, 0).texture);
  EXPECT_EQ(material_of(soup, 0).texture->rgba[0], 66);
  ASSERT_EQ(soup.corner_uv.size(), 3U);
  EXPECT_LT(glm::length(soup.corner_uv[2] - glm::dvec2(0.9, 0.7)), 1e-6);
}

TEST(LooksOfOff, AreTheColoursOfFaces) {
  const std::string points = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  const PolygonSoup soup = read_soup_bytes(
      "a.off", "OFF\n4 4 0\n" + points + "3 0 1 2 255 0 0\n3 0 2 3 0.0 0.5 1.0 1.0\n3 0 1 3\n3 1 2 3 7\n");
  EXPECT_TRUE(is_coloured(material_of(soup, 0), {255, 0, 0}));
  EXPECT_TRUE(is_coloured(material_of(soup, 1), {0, 127.5, 255}));
  EXPECT_EQ(soup.face_material[2], -1);
  EXPECT_EQ(soup.face_material[3], -1) << "the number of a colour in nobody's table";
  EXPECT_TRUE(read_soup_bytes("a.off", "OFF\n4 1 0\n" + points + "3 0 1 2\n").face_material.empty());
}

TEST(LooksOfOff, AreTheColoursOfPointsBehindTheirNormals) {
  const PolygonSoup soup = read_soup_bytes("a.off",
                                           "CNOFF\n3 1 0\n0 0 0 0 0 1 0 90 0 255\n1 0 0 0 0 1 0 90 0 255\n"
                                           "1 1 0 0 0 1 0 180 0 255\n3 0 1 2\n");
  EXPECT_TRUE(is_coloured(material_of(soup, 0), {0, 120, 0}));
}

TEST(LooksOf3mf, AreLeftOutRatherThanWrong) {
  const std::string model =
      R"(<?xml version="1.0" encoding="UTF-8"?><model unit="millimeter" )"
      R"(xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources><basematerials id="5">)"
      R"(<base name="red" displaycolor="#FF0000"/><base name="blue" displaycolor="#0000FFFF"/></basematerials>)"
      R"(<object id="1" type="model" pid="5" pindex="0"><mesh><vertices><vertex x="0" y="0" z="0"/>)"
      R"(<vertex x="1" y="0" z="0"/><vertex x="0" y="1" z="0"/></vertices><triangles>)"
      R"(<triangle v1="0" v2="1" v3="2"/><triangle v1="0" v2="2" v3="1" pid="5" p1="1"/></triangles></mesh>)"
      R"(</object></resources><build><item objectid="1"/></build></model>)";
  const PolygonSoup soup = read_soup_bytes("a.3mf", to_3mf_package(model));
  EXPECT_EQ(soup.n_faces(), 2);
  EXPECT_TRUE(soup.materials.empty()) << "Assimp would paint the whole object like its last triangle";
}

TEST(LooksOfStl, AreNone) {
  const PolygonSoup soup = read_soup_bytes("a.stl", to_binary_stl(shapes::tetrahedron()));
  EXPECT_TRUE(soup.materials.empty());
  EXPECT_TRUE(soup.face_material.empty());
}

TEST(FaceColours, BecomeFewerShadesWhereThereAreTooMany) {
  PolygonSoup soup;
  std::vector<std::optional<glm::dvec3>> colours;
  for (int f = 0; f < 8000; ++f) {
    soup.add_face(std::vector<int>{0, 1, 2});
    colours.emplace_back(glm::dvec3(f % 20, f / 20 % 20, f / 400) / 19.0);
  }
  readers::colour_faces(soup, colours);
  EXPECT_LE(soup.materials.size(), 1000U);
  EXPECT_GT(soup.materials.size(), 300U);
  for (std::size_t f = 0; f < colours.size(); ++f) {
    const glm::dvec3 off = soup.materials[static_cast<std::size_t>(soup.face_material[f])].colour -
                           readers::linear_colour(*colours[f]);
    EXPECT_LT(std::max({std::abs(off.r), std::abs(off.g), std::abs(off.b)}), 0.15);
  }
}

TEST(MissingPictures, AreToldInOneSentence) {
  std::string library;
  std::string text = "mtllib c.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (const char letter : std::string("abcdefg")) {
    library += std::string("newmtl ") + letter + "\nmap_Kd " + letter + ".png\n";
    text += std::string("usemtl ") + letter + "\nf 1 2 3\n";
  }
  const PolygonSoup soup = read_soup_bytes("a.obj", text, files({{"c.mtl", library}, {"b.png", png(9)}}));
  ASSERT_EQ(soup.notices.size(), 1U);
  EXPECT_EQ(soup.notices[0],
            "The pictures a.png, c.png, d.png, e.png and 2 more were not found; their faces stay plain.");
  EXPECT_TRUE(material_of(soup, 1).texture);
}

TEST(MissingPictures, OfGltfAreNamedAndNotFatal) {
  const PolygonSoup ball = shapes::icosphere(1);
  std::string text = gltf_text(ball, R"({"mesh":0})", "b.bin");
  const std::string before = R"("indices":1)";
  text.replace(text.find(before), before.size(), before + R"(,"material":0)");
  text.insert(text.rfind('}'), R"(,"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0},)"
                               R"("baseColorFactor":[1,0,0,1]}}],"textures":[{"source":0}],)"
                               R"("images":[{"uri":"lost.png"}])");
  const PolygonSoup soup = read_soup_bytes("a.gltf", text, files({{"b.bin", gltf_buffer(ball)}}));
  ASSERT_EQ(soup.notices.size(), 1U);
  EXPECT_EQ(soup.notices[0], "The picture lost.png was not found; its faces stay plain.");
  EXPECT_EQ(material_of(soup, 0).colour, glm::dvec3(1, 0, 0));
}

TEST(CompanionFiles, AreFoundWhateverTheCaseOfTheirNames) {
  const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "companion_files";
  std::filesystem::create_directories(folder);
  write_file(folder / "Wood.png", png(77));
  write_file(folder / "c.mtl", "newmtl a\nmap_Kd C:\\Users\\me\\WOOD.PNG\n");
  write_file(folder / "a.obj", "mtllib C.MTL\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const PolygonSoup soup = read_soup(folder / "a.obj");
  std::filesystem::remove_all(folder);
  EXPECT_TRUE(soup.notices.empty());
  ASSERT_TRUE(material_of(soup, 0).texture);
  EXPECT_EQ(material_of(soup, 0).texture->rgba[0], 77);
}

}  // namespace
}  // namespace netwright
