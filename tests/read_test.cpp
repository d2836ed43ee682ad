// Picking a reader, paths of every kind, and the odd models in tests/data, each of which ends in one
// sentence.
#include "core/mesh/read.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <glm/geometric.hpp>

#include "core/base/error.h"
#include "core/mesh/repair.h"
#include "core/mesh/shapes.h"
#include "tests/model_files.h"

namespace netwright {
namespace {

using testing::write_file;

const std::filesystem::path kData = std::filesystem::path(NETWRIGHT_SOURCE) / "tests/data";
const std::filesystem::path kSamples = std::filesystem::path(NETWRIGHT_SOURCE) / "assets/samples";

/// What a person would be told about this file; empty when it can be unfolded.
std::string refusal(const std::filesystem::path& path) {
  try {
    return prepare(read_soup(path)).refusal;
  } catch (const Error& error) {
    return error.what();
  }
}

/// A folder of its own for each test, removed afterwards.
class Folder {
 public:
  Folder()
      : path_(std::filesystem::path(::testing::TempDir()) /
              ("netwright_read_test_áé_" + std::to_string(getpid()))) {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

TEST(ReadOddModels, EndInOneSentenceThatNamesFileAndPlace) {
  const std::vector<std::pair<std::string, std::string>> expected{
      {"bent_quad.obj", "face 1 most of all"},
      {"cut_short.glb", "incomplete or damaged"},
      {"cut_short.stl", "promises 4 triangles"},
      {"cut_short_text.stl", "cut short"},
      {"doubled_face.obj", "faces 1 and 5 have the same corners"},
      {"empty.obj", "the file is empty"},
      {"face_without_area.obj", "face 6 has no area"},
      {"index_beyond_points.obj", "face 3 (line 7) names point 9"},
      {"index_beyond_points.off", "face 1 names point 7"},
      {"index_zero.obj", "face 3 (line 7)"},
      {"infinite.obj", "point 3 (line 3)"},
      {"lying_count.stl", "promises 4294967295 triangles"},
      {"lying_counts.off", "promises 2000000000 points"},
      {"lying_header.ply", "promises 2000000000"},
      {"missing_buffer.gltf", "gone.bin"},
      {"no_end_of_header.ply", "header has no end"},
      {"not_a_number.obj", "point 3 (line 3)"},
      {"nothing_known.xyz", "no model in a format that can be read"},
      {"one_sided.obj", "only one side"},
      {"picture.obj", "a JPEG picture"},
      {"points_only.obj", "no faces"},
      {"repeated_corner.obj", "face 5 uses point 2 twice"},
      {"three_faces_on_one_edge.obj", "points 1 and 2 has 3 faces"},
      {"touching_in_a_point.obj", "at point 1"},
      {"two_coordinates.obj", "point 3 (line 3)"},
      {"two_corners.obj", "face 5 (line 9)"},
  };
  for (const auto& [name, place] : expected) {
    const std::string said = refusal(kData / name);
    EXPECT_EQ(said.rfind(name + ": ", 0), 0U) << said;
    EXPECT_NE(said.find(place), std::string::npos) << said;
    EXPECT_TRUE(said.ends_with('.')) << said;
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
  }
  std::size_t n_files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kData)) {
    if (entry.is_regular_file())
      n_files += is_model_path(entry.path()) || entry.path().extension() == ".xyz" ? 1 : 0;
  }
  EXPECT_EQ(n_files, expected.size()) << "every odd model is in the table above";
}

TEST(Read, KnowsAFormatByItsContentWhateverItsName) {
  const PolygonSoup sphere = shapes::icosphere(1);
  for (const std::string& bytes :
       {shapes::to_obj(sphere), testing::to_binary_stl(sphere), testing::to_text_stl(sphere),
        testing::to_text_ply(sphere), testing::to_off(sphere), testing::to_glb(sphere),
        testing::to_dae(sphere), testing::to_3ds(sphere)}) {
    EXPECT_EQ(read_soup_bytes("unknown", bytes).n_faces(), 20);
    EXPECT_EQ(read_soup_bytes("wrong.3mf", bytes).n_faces(), 20);
  }
}

TEST(Read, TakesTheUpAxisFromTheFormat) {
  const PolygonSoup sphere = shapes::icosphere(1);
  EXPECT_EQ(read_soup_bytes("a.obj", shapes::to_obj(sphere)).up_axis, UpAxis::Y);
  EXPECT_EQ(read_soup_bytes("a.stl", testing::to_binary_stl(sphere)).up_axis, UpAxis::Z);
}

TEST(Read, NamesWhatAZipArchiveIs) {
  const std::string zip = testing::to_zip({{"model.obj", "v 0 0 0\n"}});
  EXPECT_THROW(read_soup_bytes("models.zip", zip), Error);
}

TEST(Read, OpensPathsWithSpacesAndForeignLetters) {
  const Folder folder;
  for (const char* name : {"my cube.obj", "papír krabička 箱.obj", "UPPER.OBJ"}) {
    write_file(folder / name, shapes::to_obj(shapes::cube()));
    const PolygonSoup soup = read_soup(folder / name);
    EXPECT_EQ(soup.n_faces(), 6);
    EXPECT_EQ(soup.name, name);
  }
}

TEST(Read, FindsCompanionsBesideTheModel) {
  const Folder folder;
  std::filesystem::copy(kSamples / "globe.obj", folder / "globe.obj");
  write_file(folder / "globe.mtl", "newmtl globe\nmap_Kd C:\\elsewhere\\globe.png\n");
  std::filesystem::copy(kSamples / "globe.png", folder / "globe.png");
  const PolygonSoup soup = read_soup(folder / "globe.obj");
  ASSERT_EQ(soup.materials.size(), 1U);
  EXPECT_TRUE(soup.materials[0].texture);
}

TEST(Read, RefusesWhatIsNoFile) {
  const Folder folder;
  EXPECT_NE(refusal(folder / "gone.obj").find("no such file"), std::string::npos);
  std::filesystem::create_directory(folder / "folder.obj");
  EXPECT_NE(refusal(folder / "folder.obj").find("this is a folder"), std::string::npos);
  EXPECT_NE(refusal("/dev/null").find("not a regular file"), std::string::npos);
}

TEST(Read, SpeaksCleanTextWhateverTheFileSays) {
  const auto said = [](const std::string& name, const std::string& text) {
    try {
      read_soup_bytes(name, text);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_NE(said("a.obj",
                 "v 0 \xFF\x01"
                 "7 0\n")
                .find("\"??7\""),
            std::string::npos);
  EXPECT_NE(said("a.obj", "v 0 \xC3\xA9\xE7\xAE\xB1\xED\xA0\x80 0\n").find("\"é箱???\""), std::string::npos);
  EXPECT_EQ(said("\xC0\xAF.obj", "").rfind("??.obj: ", 0), 0U);
}

TEST(ModelFormats, ListEachExtensionOnce) {
  std::vector<std::string_view> extensions;
  for (const ModelFormat& format : model_formats()) {
    EXPECT_FALSE(format.label.empty());
    extensions.insert(extensions.end(), format.extensions.begin(), format.extensions.end());
  }
  EXPECT_EQ(extensions,
            (std::vector<std::string_view>{"obj", "glb", "gltf", "stl", "ply", "off", "3mf", "dae", "3ds"}));
  EXPECT_TRUE(is_model_path("A Model.STL"));
  EXPECT_FALSE(is_model_path("picture.png"));
  EXPECT_FALSE(is_model_path("obj"));
}

TEST(ModelFormats, StandInTheReadmeAsInTheTable) {
  std::string table;
  for (const auto& row : model_format_table()) {
    std::string line = "|";
    for (const std::string& cell : row) line += " " + cell + " |";
    table += line + "\n";
    if (table == line + "\n") table += "|---|---|---|---|---|---|---|\n";
  }
  const std::string readme = testing::read_file(std::filesystem::path(NETWRIGHT_SOURCE) / "README.md");
  EXPECT_NE(readme.find("\n" + table + "\n"), std::string::npos) << "README.md wants this table:\n" << table;
}

TEST(Samples, ReadAndAreFit) {
  int n_models = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kSamples)) {
    if (!is_model_path(entry.path())) continue;
    ++n_models;
    const PolygonSoup soup = read_soup(entry.path());
    EXPECT_TRUE(soup.notices.empty()) << entry.path();
    const PreparedModel model = prepare(soup);
    EXPECT_TRUE(model.is_fit()) << model.refusal;
    EXPECT_EQ(model.report.n_self_intersections, 0) << entry.path();
    EXPECT_TRUE(model.report.is_closed) << entry.path();
  }
  EXPECT_EQ(n_models, 6);
}

TEST(Samples, AreWhatOurCodeMakes) {
  const std::vector<std::pair<std::string, PolygonSoup>> made{{"cube.obj", shapes::cube()},
                                                              {"icosphere_80.obj", shapes::icosphere(2)},
                                                              {"sand_clock.obj", shapes::sand_clock()},
                                                              {"globe.obj", shapes::globe()}};
  for (const auto& [name, shape] : made) {
    const PolygonSoup soup = read_soup(kSamples / name);
    EXPECT_EQ(soup.corners, shape.corners) << name;
    EXPECT_EQ(soup.face_begin, shape.face_begin) << name;
    ASSERT_EQ(soup.corner_uv.size(), shape.corner_uv.size()) << name;
    for (std::size_t i = 0; i < soup.corner_uv.size(); ++i) {
      EXPECT_LT(glm::length(soup.corner_uv[i] - shape.corner_uv[i]), 1e-12) << name;
    }
    ASSERT_EQ(soup.points.size(), shape.points.size()) << name;
    for (std::size_t i = 0; i < soup.points.size(); ++i) {
      EXPECT_LT(glm::length(soup.points[i] - shape.points[i]), 1e-14) << name;
    }
  }
}

}  // namespace
}  // namespace netwright
