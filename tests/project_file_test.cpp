// Project files: what was saved comes back, whole and the same; what is damaged is told in one sentence.
#include "core/project/project_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/project/derived.h"
#include "core/project/shape_bytes.h"
#include "tests/project_same.h"
#include "tests/project_support.h"
#include "tests/sheet_support.h"

namespace netwright {
namespace {

namespace fs = std::filesystem;
using testing::expect_same;
using testing::project_of;
using testing::solved;
using testing::TemporaryFolder;

Project reopened(const Project& project) {
  return parse_project(project_bytes(project), "test.netwright").project;
}

std::string refusal(const std::string& bytes) {
  try {
    static_cast<void>(parse_project(bytes, "test.netwright"));
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Read) << error.what();
    return error.what();
  }
  return "";
}

std::string refusal(const ProjectParts& parts) {
  try {
    static_cast<void>(from_parts(parts, "test.netwright"));
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Read) << error.what();
    return error.what();
  }
  return "";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

/// A globe with a picture on half of it and a colour on the rest.
PolygonSoup painted_globe() {
  PolygonSoup soup = shapes::globe(5, 8);
  Image image{.width = 5, .height = 3, .rgba = {}};
  for (int i = 0; i < 60; ++i) image.rgba.push_back(static_cast<std::uint8_t>(i * 4 + i % 3));
  soup.materials = {{"sea", {0.1, 0.2, 0.9}, nullptr}, {"land", {1, 1, 1}, nullptr}};
  soup.materials[1].texture = std::make_shared<const Image>(image);
  soup.face_material.assign(static_cast<std::size_t>(soup.n_faces()), 0);
  for (std::size_t f = 0; f < soup.face_material.size() / 2; ++f) soup.face_material[f] = 1;
  soup.face_material.back() = -1;
  soup.notices = {"The picture clouds.png was not found."};
  return soup;
}

void set_printing(Project& project) {
  TabSettings& tabs = project.tabs;
  tabs.pattern = TabSettings::Pattern::Alternating;
  tabs.width_mm = kChildTabWidth;
  tabs.angle_rad = 0.5;
  tabs.on_borders = true;
  tabs.edits = {{EdgeId(2), TabSide::Second, 3.5, std::nullopt, 1.25},
                {EdgeId(11), TabSide::None, std::nullopt, std::nullopt, std::nullopt}};
  SheetSettings& sheet = project.sheet;
  sheet.lines.cut = {{0.1, 0.2, 0.7}, 0.4, {3, 1, 0.5, 1}};
  sheet.lines.mountain = {{0.5, 0, 0}, 0.3, {2, 1.2}};
  sheet.lines.valley = {{0, 0.25, 0}, 0.15, {3, 0.9}};
  sheet.lines.tab_fold = {{0, 0, 0.75}, 0.1, {}};
  sheet.lines.flat_below_rad = 0.05;
  sheet.lines.only_ends = true;
  sheet.labels = {false, false, true, true, true, true, 3.25};
  sheet.pictures = {false, 150, 0.5, PictureSettings::OnTabs::White};
  sheet.printed_side = PrintedSide::Both;
  sheet.is_grey = true;
  const Image logo{.width = 2, .height = 1, .rgba = {1, 2, 3, 4, 5, 6, 7, 8}};
  sheet.words = {"Globe", "A. Folder", "120 g/m²", std::make_shared<const Image>(logo)};
  project.glued = {EdgeId(3), EdgeId(7)};
  project.exports = {true, true, true, 144, InstructionPage::Last};
  sheet.hidden_folds = {EdgeId(1), EdgeId(6)};
  sheet.shown_folds = {EdgeId(8)};
}

Project full_project() {
  Project project = project_of(painted_globe(), {.faces = 40, .merges = true});
  project.path = "/models/globe.obj";
  project.seed = 0xFEDCBA9876543210U;
  project = pin_root(solved(std::move(project), 7), FaceId(3));
  Constraints pins = project.pins;
  set_pin(pins, EdgeId(4), EdgePin::MustFold);
  set_pin(pins, EdgeId(17), EdgePin::MustFold);
  set_pin(pins, EdgeId(9), EdgePin::MustCut);
  keep_together(pins, {FaceId(8), FaceId(5), FaceId(21)});
  keep_together(pins, {FaceId(30), FaceId(2)});
  project = set_pins(std::move(project), pins);
  project.paper = {"Letter", Orientation::Landscape, 12.5};
  project.size = {PrintSize::Kind::Height, 210.7};
  set_printing(project);
  return project;
}

TEST(ProjectFile, GivesBackEveryShapeOfTheZooAsItWas) {
  for (const testing::ZooShape& shape : testing::zoo()) {
    SCOPED_TRACE(shape.soup.name);
    const Project project = solved(project_of(shape.soup));
    ASSERT_TRUE(project.run->is_proved);
    expect_same(project, reopened(project));
  }
}

TEST(ProjectFile, KeepsEverythingThatTheUserMade) {
  const Project project = full_project();
  expect_same(project, reopened(project));
}

TEST(ProjectFile, RefusesSettingsThatCannotBePrinted) {
  const ProjectParts good = to_parts(full_project(), {}, nullptr);
  const auto told = [&](const std::string& from, const std::string& to) {
    ProjectParts parts = good;
    parts.json = replaced(parts.json, from, to);
    return refusal(parts);
  };
  EXPECT_EQ(
      told("\"dpi\": 150", "\"dpi\": 100000"),
      "test.netwright is damaged: “dpi” of the pictures is not a number it could be; open an earlier copy of "
      "it.");
  EXPECT_NE(told("\"dash_mm\": [3, 1, 0.5, 1]", "\"dash_mm\": [0, 0]"), "");
  EXPECT_NE(told("\"dash_mm\": [3, 1, 0.5, 1]", "\"dash_mm\": [3]"), "");
  EXPECT_NE(told("\"pattern\": \"alternating\"", "\"pattern\": \"zigzag\""), "");
  EXPECT_NE(told("\"hidden_folds\": [", "\"hidden_folds\": [99999, 0, "), "");
  EXPECT_NE(told("\"width_mm\": 3.5", "\"width_mm\": 3000.5"), "");
  EXPECT_EQ(told("\"on_borders\": true", "\"on_borders\": false"), "");
}

TEST(ProjectFile, KnowsTheSideOfATabWhicheverFaceAnEdgeBeginsWith) {
  const Project project = full_project();
  const Mesh& mesh = project.dual->mesh();
  const EdgeId e = project.tabs.edits.front().edge;
  const auto corner_text = [&](HalfedgeId h) {
    return "[" + std::to_string(mesh.face(h).value) + ", " +
           std::to_string(h.value - mesh.first(mesh.face(h)).value) + "]";
  };
  const HalfedgeId side = mesh.halfedge(e);
  ProjectParts parts = to_parts(project, {}, nullptr);
  parts.json =
      replaced(parts.json, "\"at\": " + corner_text(side), "\"at\": " + corner_text(mesh.twin(side)));
  const TabEdit edit = from_parts(parts, "test.netwright").project.tabs.edits.front();
  EXPECT_EQ(edit.edge, e);
  EXPECT_EQ(edit.side, TabSide::First);
  EXPECT_EQ(edit.first_angle_rad, 1.25);
  EXPECT_EQ(edit.second_angle_rad, std::nullopt);
}

TEST(ProjectFile, KeepsTheSizeInEveryWordForIt) {
  Project project = project_of(shapes::letter_e());
  project.paper.format = custom_paper(300, 200);
  project.size.edge = EdgeId(5);
  project.size.edge_mm = 31.5;
  project.size.scale = 4.25;
  project.size.sheets = 7;
  for (const auto kind : {PrintSize::Kind::FitPage, PrintSize::Kind::Height, PrintSize::Kind::EdgeLength,
                          PrintSize::Kind::Scale, PrintSize::Kind::FitSheets}) {
    project.size.kind = kind;
    EXPECT_EQ(reopened(project).size, project.size);
  }
  EXPECT_EQ(reopened(project).paper, project.paper);
}

TEST(ProjectFile, KnowsMergedFacesAndGroupsThatWereSplitAgain) {
  const Project merged = project_of(shapes::grid_cube(3), {.merges = true});
  expect_same(merged, reopened(merged));
  const std::vector<int> group = merged.made->groups[FaceId(4)];
  const Project split = solved(project_of(shapes::grid_cube(3), {.merges = true, .apart = {group}}));
  const Project again = reopened(split);
  expect_same(split, again);
  EXPECT_EQ(again.made->origins, split.made->origins);
  ASSERT_EQ(again.recipe.apart.size(), 1U);
  EXPECT_EQ(again.recipe.apart.front(), group);
  const Project ringed = project_of(shapes::cuboid_with_holes(1, 1), {.merges = true});
  expect_same(ringed, reopened(ringed));
}

TEST(ProjectFile, KeepsProjectsWithoutANet) {
  const Project project = project_of(shapes::letter_e());
  const Project again = reopened(project);
  expect_same(project, again);
  EXPECT_EQ(again.tree, nullptr);
  EXPECT_FALSE(again.run.has_value());
}

TEST(ProjectFile, KeepsRepairedSplitAndTurnedModels) {
  PolygonSoup broken = testing::inside_out(shapes::cuboid({1, 2, 3}));
  broken.add_face(std::vector<int>(broken.face(0).begin(), broken.face(0).end()));
  broken.points.back() += glm::dvec3(0.1, 0.2, 0.15);
  for (const UnevenFaces uneven : {UnevenFaces::Split, UnevenFaces::Flatten}) {
    const Project project =
        solved(project_of(broken, {.up = UpAxis::Z, .repairs = Repairs{}, .uneven = uneven}));
    EXPECT_FALSE(project.made->done.empty());
    expect_same(project, reopened(project));
  }
}

TEST(ProjectFile, KeepsWhichRepairsWereWantedAndWhichPartsWereLeftOut) {
  PolygonSoup balls = shapes::combined(shapes::icosphere(2), shapes::icosphere(3), {9, 0, 0});
  balls.corners.resize(balls.corners.size() - 3);
  balls.face_begin.pop_back();
  Recipe recipe{.left_out = {0}, .faces = 120};
  recipe.repairs.welds = true;
  recipe.repairs.weld_tolerance = 1e-5;
  recipe.repairs.max_hole_edges = 3;
  const Project project = project_of(balls, recipe);
  EXPECT_TRUE(project.dual->mesh().is_closed());
  const Project again = reopened(project);
  expect_same(project, again);
  Progress progress;
  MadeModel looked_at = *again.made;
  add_survey(looked_at, progress);
  EXPECT_EQ(looked_at.stages->survey->parts.size(), 2U) << "the part that was left out can be taken back";
  recipe.left_out.clear();
  expect_same(make_model(project.source, recipe, project.made->stages, progress),
              make_model(again.source, recipe, again.made->stages, progress));
}

TEST(ProjectFile, ChangingTheRecipeAfterOpeningGivesWhatItWouldHaveGivenBefore) {
  const Project project = project_of(shapes::icosphere(4), {.faces = 100});
  const Project again = reopened(project);
  Progress progress;
  for (const Recipe& recipe : {Recipe{.faces = 60}, Recipe{}, Recipe{.repairs = Repairs{}, .merges = true}}) {
    const MadeModel before = make_model(project.source, recipe, project.made->stages, progress);
    const MadeModel after = make_model(again.source, recipe, again.made->stages, progress);
    expect_same(before, after);
  }
}

TEST(ProjectFile, TheSameProjectIsTheSameFile) {
  const Project project = full_project();
  EXPECT_EQ(project_bytes(project), project_bytes(project));
  EXPECT_EQ(project_bytes(project), project_bytes(reopened(project)));
}

TEST(ProjectFile, SaysWhatItIsAtAFixedPlace) {
  const std::string bytes = project_bytes(project_of(shapes::cube()));
  EXPECT_EQ(bytes.substr(30, 31), "mimetypeapplication/x-netwright");
  EXPECT_TRUE(is_project(bytes.substr(0, 64)));
  EXPECT_FALSE(is_project(bytes.substr(0, 40)));
  EXPECT_FALSE(is_project("PK\x03\x04 and something else that is long enough to be looked at closely"));
  EXPECT_FALSE(is_project(""));
}

TEST(ProjectFile, CanBeUnpackedByAnyZipProgram) {
  const TemporaryFolder folder;
  save_project(full_project(), folder / "globe.netwright");
  const std::string listing =
      testing::output_of({"python3", "-m", "zipfile", "-l", (folder / "globe.netwright").string()});
  for (const char* entry : {"mimetype", "project.json", "thumbnail.png", "shapes/source", "shapes/base",
                            "shapes/mesh", "pictures/1.png"})
    EXPECT_NE(listing.find(entry), std::string::npos) << entry;
}

TEST(ProjectFile, RemembersWhichFileAnAutosavedProjectBelongsTo) {
  const std::string bytes = project_bytes(project_of(shapes::cube()), "/home/me/cube.netwright");
  EXPECT_EQ(parse_project(bytes, "x").belongs_to, fs::path("/home/me/cube.netwright"));
  EXPECT_TRUE(parse_project(project_bytes(project_of(shapes::cube())), "x").belongs_to.empty());
}

TEST(ProjectFile, CanBeGlancedAt) {
  const TemporaryFolder folder;
  save_project(full_project(), folder / "globe.netwright", "/home/me/globe.netwright");
  const ProjectGlance glance = glance_at_project(folder / "globe.netwright");
  EXPECT_EQ(glance.outline.name, full_project().source->name);
  EXPECT_EQ(glance.outline.belongs_to, fs::path("/home/me/globe.netwright"));
  EXPECT_EQ(glance.outline.n_faces, static_cast<int>(full_project().dual->mesh().n_faces()));
  EXPECT_TRUE(glance.outline.is_proved);
  ASSERT_EQ(glance.thumbnail.width, 256);
  const auto alpha_at = [&](int x, int y) {
    return glance.thumbnail.rgba[static_cast<std::size_t>(4 * (256 * y + x) + 3)];
  };
  EXPECT_EQ(alpha_at(128, 128), 255) << "the model is in the middle";
  EXPECT_EQ(alpha_at(1, 1), 0) << "and nothing in the corner";
}

class GoldenProject : public ::testing::TestWithParam<const char*> {
 protected:
  static Project read() {
    const fs::path golden = fs::path(NETWRIGHT_SOURCE) / "tests/golden" / GetParam();
    EXPECT_TRUE(is_project_file(golden));
    return load_project(golden).project;
  }
};

TEST_P(GoldenProject, CanBeRead) {
  const Project project = read();
  EXPECT_EQ(project.source->name, "globe");
  EXPECT_EQ(project.path, fs::path("globe.obj"));
  EXPECT_EQ(project.recipe, (Recipe{.faces = 40, .merges = true}));
  EXPECT_EQ(project.dual->mesh().n_faces(), 40U);
  ASSERT_EQ(project.source->materials.size(), 2U);
  ASSERT_TRUE(project.source->materials[1].texture);
  EXPECT_EQ(project.source->materials[1].texture->width, 5);
  EXPECT_EQ(project.seed, 9U);
  EXPECT_EQ(project.pins.root, FaceId(3));
  EXPECT_EQ(project.paper, (PaperSetup{"Letter", Orientation::Landscape, 12.5}));
  EXPECT_EQ(project.size, (PrintSize{PrintSize::Kind::Height, 210.7}));
  ASSERT_TRUE(project.tree && project.run);
  EXPECT_TRUE(project.tree->is_root(FaceId(3)));
  EXPECT_TRUE(project.run->is_proved);
  EXPECT_EQ(project.run->seed, 7U);
  Progress progress;
  const auto derived = derive(project, nullptr, 1, progress);
  ASSERT_TRUE(derived->sheets) << derived->fault;
  EXPECT_EQ(derived->shown->net.n_pieces, 1);
}

INSTANTIATE_TEST_SUITE_P(ProjectFile, GoldenProject, ::testing::Values("v1.netwright", "v2.netwright"));

TEST(ProjectFile, TheFirstVersionKnewNoTabsAndIsPrintedWithTheUsualOnes) {
  const Project project = load_project(fs::path(NETWRIGHT_SOURCE) / "tests/golden/v1.netwright").project;
  EXPECT_EQ(project.tabs, TabSettings());
  EXPECT_EQ(project.sheet, SheetSettings());
}

TEST(ProjectFile, TheSecondVersionKnowsTabsLinesAndWords) {
  const Project project = load_project(fs::path(NETWRIGHT_SOURCE) / "tests/golden/v2.netwright").project;
  Project wanted;
  set_printing(wanted);
  EXPECT_EQ(project.tabs, wanted.tabs);
  EXPECT_EQ(project.exports, wanted.exports);
  EXPECT_EQ(project.glued, wanted.glued);
  expect_same(project.sheet, wanted.sheet);
}

TEST(ProjectFile, MissingValuesMeanTheDefaultsOfOlderFiles) {
  ProjectParts parts = to_parts(project_of(shapes::cube()), {}, nullptr);
  parts.json = R"({"format": 1})";
  const Project project = from_parts(parts, "old").project;
  EXPECT_EQ(project.dual->mesh().n_faces(), 6U);
  EXPECT_EQ(project.paper, PaperSetup{});
  EXPECT_EQ(project.recipe, Recipe{});
}

TEST(ProjectFile, TellsThatAFileIsOfANewerNetwright) {
  const ProjectParts good = to_parts(full_project(), {}, nullptr);
  ProjectParts parts = good;
  const auto format = [](int number) { return "\"format\": " + std::to_string(number); };
  parts.json = replaced(good.json, format(kProjectFormat), format(kProjectFormat + 1));
  const std::string told = "newer Netwright (format " + std::to_string(kProjectFormat + 1);
  EXPECT_NE(refusal(parts).find(told), std::string::npos) << refusal(parts);
  parts.json = replaced(good.json, "\"merges\":", "\"folds_itself\": true, \"merges\":");
  EXPECT_NE(refusal(parts).find("newer Netwright (the recipe has “folds_itself”"), std::string::npos)
      << refusal(parts);
}

TEST(ProjectFile, RefusesWhatDoesNotFitTogether) {
  const ProjectParts good = to_parts(full_project(), {}, nullptr);
  const ProjectParts other = to_parts(solved(project_of(shapes::cube())), {}, nullptr);
  ProjectParts parts = good;
  parts.json = replaced(good.json, "\"tree\": [", "\"tree\": [0, ");
  EXPECT_NE(refusal(parts).find("“tree” of the project is not one of this mesh"), std::string::npos);
  parts = good;
  parts.mesh = other.mesh;
  EXPECT_NE(refusal(parts), "");
  parts = good;
  parts.mesh = good.source;
  EXPECT_NE(refusal(parts).find("does not say where its faces came from"), std::string::npos);
  parts = good;
  parts.source = good.mesh;
  EXPECT_NE(refusal(parts).find("a mesh stands where"), std::string::npos);
  parts = good;
  parts.pictures.clear();
  EXPECT_NE(refusal(parts).find("“picture” of a material"), std::string::npos);
  parts.pictures = {"no picture"};
  EXPECT_NE(refusal(parts).find("pictures cannot be read"), std::string::npos);
  parts = good;
  parts.json = replaced(good.json, "\"root\": 3", "\"root\": 4000");
  EXPECT_NE(refusal(parts).find("“root” of the pins"), std::string::npos);
  parts.json = replaced(good.json, "\"must_fold\": [", "\"must_fold\": [0, 99, ");
  EXPECT_NE(refusal(parts).find("“must_fold” of the pins names an edge that is not there"),
            std::string::npos);
  parts.json = replaced(good.json, "\"together\": [", "\"together\": [[5, 6], ");
  EXPECT_NE(refusal(parts).find("“together” of the pins names a face twice"), std::string::npos);
  parts.json = replaced(good.json, "\"Letter\"", "\"Papyrus\"");
  EXPECT_NE(refusal(parts).find("a paper that this Netwright does not know"), std::string::npos);
  parts.json = replaced(good.json, "\"kind\": \"height\"", "\"kind\": \"weight\"");
  EXPECT_NE(refusal(parts).find("“kind” of the size"), std::string::npos);
  parts.json = "[1, 2]";
  EXPECT_NE(refusal(parts).find("the project is not what it should be"), std::string::npos);
}

TEST(ProjectFile, ProvesAgainWhatAFileCallsProved) {
  Project project = project_of(shapes::hat());
  // All faces around one: a star of folds that overlaps.
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Random random(seed);
    UnfoldTree tree = steepest_edge_tree(*project.dual, random);
    if (find_overlaps(layout(project.dual, tree), 1e-6).empty()) continue;
    project = accept_tree(std::move(project), std::move(tree), {.is_proved = true});
    break;
  }
  ASSERT_TRUE(project.tree) << "no tree of the hat overlaps any more";
  const Project again = reopened(project);
  EXPECT_FALSE(again.run->is_proved);
  EXPECT_GT(again.run->overlaps, 0);
}

TEST(ProjectFile, RefusesEveryCutShortFile) {
  const std::string bytes = project_bytes(solved(project_of(shapes::letter_l())));
  for (std::size_t n = 0; n < bytes.size(); n += 1 + n / 40)
    EXPECT_TRUE(refusal(bytes.substr(0, n)).ends_with(".")) << n << " of " << bytes.size() << " bytes";
}

TEST(ProjectFile, NoticesEveryFlippedBitOfWhatItHolds) {
  const Project project = solved(project_of(shapes::letter_l()));
  const std::string bytes = project_bytes(project);
  Random random(3);
  for (int i = 0; i < 400; ++i) {
    std::string damaged = bytes;
    damaged[static_cast<std::size_t>(random.below(static_cast<int>(bytes.size())))] ^=
        static_cast<char>(1 << random.below(8));
    // Times and the like may change without harm: then the project is the one that was saved.
    try {
      const Project read = parse_project(damaged, "test.netwright").project;
      expect_same(project, read);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::Read);
    }
  }
}

TEST(ProjectFile, BelievesNoCountsAndNoSizes) {
  const ProjectParts good = to_parts(project_of(shapes::cube()), {}, nullptr);
  for (std::size_t count = 0; count < 7; ++count) {
    for (const std::uint64_t lie :
         {std::uint64_t{0}, std::uint64_t{1} << 31, std::uint64_t{1} << 60, ~std::uint64_t{0}}) {
      ProjectParts parts = good;
      std::array<char, 8> raw{};
      std::memcpy(raw.data(), &lie, sizeof lie);
      parts.mesh.replace(8 + 8 * count, 8, raw.data(), raw.size());
      if (parts.mesh == good.mesh) continue;
      EXPECT_NE(refusal(parts), "") << count << " as " << lie;
    }
  }
}

TEST(ProjectFile, RefusesAZipBomb) {
  const TemporaryFolder folder;
  // 65 MB of blanks in 65 kB.
  const std::string script =
      "import zipfile,sys\n"
      "z=zipfile.ZipFile(sys.argv[1],'w',zipfile.ZIP_DEFLATED)\n"
      "z.writestr('mimetype','application/x-netwright',zipfile.ZIP_STORED)\n"
      "z.writestr('project.json','{\"format\":1}'+' '*(65<<20))\n"
      "z.close()\n";
  testing::output_of({"python3", "-c", script, (folder / "bomb.netwright").string()});
  const std::string bytes = read_file(folder / "bomb.netwright", 1 << 20);
  EXPECT_NE(refusal(bytes).find("larger than any project's"), std::string::npos) << refusal(bytes);
}

TEST(SaveProject, KeepsTheOldFileWhenTheFolderIsGoneOrFull) {
  const TemporaryFolder folder;
  const Project project = project_of(shapes::cube());
  EXPECT_THROW(save_project(project, folder / "gone" / "cube.netwright"), Error);
  save_project(project, folder / "cube.netwright");
  EXPECT_EQ(folder.files().size(), 1U);
  expect_same(project, load_project(folder / "cube.netwright").project);
}

TEST(LoadProject, SaysWhatIsNoProject) {
  const TemporaryFolder folder;
  write_file(folder / "empty.netwright", "");
  write_file(folder / "cube.netwright", shapes::to_obj(shapes::cube()));
  const auto told = [](const fs::path& path) -> std::string {
    try {
      static_cast<void>(load_project(path));
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(told(folder / "empty.netwright").find("is empty"), std::string::npos);
  EXPECT_NE(told(folder / "cube.netwright").find("is no Netwright project"), std::string::npos);
  EXPECT_NE(told(folder / "none.netwright").find("does not exist"), std::string::npos);
}

TEST(IsProjectFile, LooksAtNameAndContent) {
  const TemporaryFolder folder;
  const std::string bytes = project_bytes(project_of(shapes::cube()));
  write_file(folder / "renamed.zip", bytes);
  write_file(folder / "cube.obj", shapes::to_obj(shapes::cube()));
  EXPECT_TRUE(is_project_file(folder / "renamed.zip"));
  EXPECT_TRUE(is_project_file(folder / "missing.NetWright"));
  EXPECT_FALSE(is_project_file(folder / "cube.obj"));
  EXPECT_FALSE(is_project_file(folder / "missing.obj"));
}

}  // namespace
}  // namespace netwright
