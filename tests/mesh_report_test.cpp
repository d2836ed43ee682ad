// The report's figures over the zoo, uneven faces, and faces that cut through each other.
#include "core/mesh/mesh_report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "core/mesh/self_intersection.h"
#include "tests/support.h"

namespace netwright {
namespace {

using Topic = MeshReport::Topic;
using testing::make_mesh;
using testing::zoo;
using testing::ZooShape;

bool has_line(const MeshReport& report, const std::string& part) {
  return std::ranges::any_of(
      report.lines, [&](const MeshReport::Line& line) { return line.text.find(part) != std::string::npos; });
}

TEST(MeshReport, KnowsTheZoo) {
  for (const ZooShape& shape : zoo()) {
    const MeshReport report = report_on(*make_mesh(shape.soup));
    EXPECT_EQ(report.n_faces, shape.soup.n_faces()) << shape.soup.name;
    EXPECT_EQ(report.n_vertices, static_cast<int>(shape.soup.points.size())) << shape.soup.name;
    EXPECT_EQ(report.is_closed, shape.is_closed) << shape.soup.name;
    EXPECT_EQ(report.genus, shape.genus) << shape.soup.name;
    EXPECT_EQ(report.n_components, shape.n_components) << shape.soup.name;
    EXPECT_EQ(report.n_self_intersections, 0) << shape.soup.name;
    EXPECT_TRUE(report.is_fit()) << shape.soup.name;
  }
}

TEST(MeshReport, CountsBorders) {
  const MeshReport tube = report_on(*make_mesh(shapes::open_cylinder(10, 2)));
  EXPECT_EQ(tube.n_border_loops, 2);
  EXPECT_EQ(tube.n_border_edges, 20);
  EXPECT_TRUE(has_line(tube, "open, 2 borders"));
}

TEST(MeshReport, TellsHowFarFacesAreFromFlat) {
  PolygonSoup soup = shapes::grid_patch(2, 1);
  soup.points[0].y = 0.1;
  const MeshReport report = report_on(*make_mesh(soup));
  EXPECT_EQ(report.n_uneven_faces, 1);
  EXPECT_NEAR(report.worst_unevenness, 0.0177, 2e-3);
  EXPECT_FALSE(report.is_fit());
  EXPECT_TRUE(has_line(report, "not flat, by up to 1.8 % of the face's size (face 1)"));
}

TEST(MeshReport, WritesSharesAsPeopleReadThem) {
  EXPECT_EQ(percent(0.0344), "3.4 %");
  EXPECT_EQ(percent(0.00061), "0.061 %");
  EXPECT_EQ(percent(1), "100.0 %");
}

TEST(SelfIntersection, FindsTwoCubesThatOverlap) {
  const auto mesh = make_mesh(shapes::combined(shapes::cube(), shapes::cube(), {0.5, 0.3, 0.2}));
  const auto pairs = self_intersections(*mesh);
  EXPECT_EQ(pairs.size(), 6U);
  for (const auto& [a, b] : pairs) EXPECT_NE(mesh->component(a), mesh->component(b));
  EXPECT_TRUE(has_line(report_on(*mesh), "cuts through itself in 6 places"));
}

TEST(SelfIntersection, FindsCrossingSheetsOfEqualSize) {
  PolygonSoup cross;
  cross.points = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0},
                  {0, -1, -1}, {0, -1, 1}, {0, 1, 1}, {0, 1, -1}};
  cross.add_face(std::vector<int>{0, 1, 2, 3});
  cross.add_face(std::vector<int>{4, 5, 6, 7});
  EXPECT_EQ(self_intersections(*make_mesh(cross)).size(), 1U);
}

TEST(SelfIntersection, LetsShapesTouch) {
  for (const glm::dvec3 shift :
       {glm::dvec3(1, 0, 0), glm::dvec3(1, 0.5, 0), glm::dvec3(1, 1, 0.25), glm::dvec3(1, 1, 1)}) {
    EXPECT_TRUE(
        self_intersections(*make_mesh(shapes::combined(shapes::cube(), shapes::cube(), shift))).empty());
  }
}

TEST(SelfIntersection, IgnoresContactWithinTheRoundingOfTheFile) {
  EXPECT_TRUE(
      self_intersections(*make_mesh(shapes::combined(shapes::cube(), shapes::cube(), {1 - 1e-7, 0.2, 0.1})))
          .empty());
}

TEST(SelfIntersection, SeesThroughTheNotchOfAConcaveFace) {
  PolygonSoup soup = shapes::letter_l();  // a thin rod passes where the L is open, then through its foot
  const PolygonSoup rod = shapes::cuboid({0.2, 6, 0.2});
  EXPECT_TRUE(self_intersections(*make_mesh(shapes::combined(soup, rod, {2, -3, -2}))).empty());
  EXPECT_EQ(self_intersections(*make_mesh(shapes::combined(soup, rod, {2, -3, -0.5}))).size(), 8U);
}

TEST(SelfIntersection, DoesNotDependOnTheScale) {
  for (const double scale : {1e-30, 1e30}) {
    PolygonSoup soup = shapes::combined(shapes::cube(), shapes::cube(), {0.5, 0.3, 0.2});
    for (glm::dvec3& p : soup.points) p *= scale;
    EXPECT_EQ(self_intersections(*make_mesh(soup)).size(), 6U);
  }
}

TEST(SelfIntersection, EndsAfterAFixedNumberOfPairs) {
  PolygonSoup needles;  // triangles that all pass through the same place, each through every other
  for (int i = 0; i < 700; ++i) {
    const double angle = 3.1 * i / 700;
    const glm::dvec3 along(std::cos(angle), std::sin(angle), 0.001 * i);
    const auto first = static_cast<int>(needles.points.size());
    needles.points.push_back(along + glm::dvec3(0, 0, 1));
    needles.points.push_back(along - glm::dvec3(0, 0, 1));
    needles.points.push_back(-along);
    needles.add_face(std::array{first, first + 1, first + 2});
  }
  const SelfIntersections found = find_self_intersections(needles);
  EXPECT_FALSE(found.is_complete);
  EXPECT_EQ(found.pairs.size(), 100'000U);
  EXPECT_TRUE(has_line(report_on(needles), "in at least 100\u2009000 places"));
}

TEST(MeshReport, SaysTheSameOfASoupAndOfItsMesh) {
  for (const ZooShape& shape : zoo()) {
    const MeshReport soup = report_on(shape.soup);
    const MeshReport mesh = report_on(*make_mesh(shape.soup));
    EXPECT_EQ(soup.n_faces, mesh.n_faces) << shape.soup.name;
    EXPECT_EQ(soup.n_vertices, mesh.n_vertices) << shape.soup.name;
    EXPECT_EQ(soup.n_components, mesh.n_components) << shape.soup.name;
    EXPECT_EQ(soup.genus, mesh.genus) << shape.soup.name;
    EXPECT_EQ(soup.n_border_edges, mesh.n_border_edges) << shape.soup.name;
    EXPECT_EQ(soup.n_border_loops, mesh.n_border_loops) << shape.soup.name;
    EXPECT_EQ(soup.is_closed, mesh.is_closed) << shape.soup.name;
    EXPECT_NEAR(soup.border_length, mesh.border_length, 1e-9 * (1 + mesh.border_length));
    EXPECT_EQ(soup.size, mesh.size);
    EXPECT_TRUE(soup.is_fit()) << shape.soup.name;
    for (const MeshReport::Line& line : mesh.lines) EXPECT_TRUE(has_line(soup, line.text)) << line.text;
    for (const MeshReport::Line& line : soup.lines) EXPECT_EQ(line.kind, MeshReport::Line::Kind::Fact);
  }
}

TEST(MeshReport, HandsOutTheCulprits) {
  PolygonSoup soup = shapes::combined(shapes::open_cylinder(6, 1), shapes::cube(), {5, 0, 0});
  soup.points[12] += glm::dvec3(0.1, 0.1, 0.1);
  const MeshReport report = report_on(soup);
  ASSERT_NE(report.find(Topic::Borders), nullptr);
  EXPECT_EQ(report.find(Topic::Borders)->edges.size(), 12U);
  EXPECT_EQ(report.count(Topic::Borders), 2);
  ASSERT_NE(report.find(Topic::UnevenFaces), nullptr);
  EXPECT_EQ(report.find(Topic::UnevenFaces)->faces.size(), 3U);
  for (const int f : report.find(Topic::UnevenFaces)->faces)
    EXPECT_EQ(std::ranges::count(soup.face(f), 12), 1);
  EXPECT_EQ(report.find(Topic::OneSided), nullptr);
  EXPECT_EQ(report.count(Topic::OneSided), 0);
}

TEST(MeshReport, NamesEveryTopicOnce) {
  std::set<std::string_view> names;
  for (int t = 0; t <= static_cast<int>(Topic::Other); ++t) names.insert(topic_name(static_cast<Topic>(t)));
  EXPECT_EQ(names.size(), static_cast<std::size_t>(Topic::Other) + 1);
  EXPECT_EQ(topic_name(Topic::UnevenFaces), "uneven_faces");
  EXPECT_EQ(topic_name(Topic::Other), "other");
}

TEST(MeshReport, GuessesTheUnitByFormatThenBySize) {
  const auto guess = [](const std::string& name, double edge) {
    PolygonSoup soup = shapes::cube(edge);
    soup.name = name;
    return std::string(guess_unit(soup).name);
  };
  EXPECT_EQ(guess("a.stl", 0.1), "mm");
  EXPECT_EQ(guess("a.GLB", 500), "m");
  EXPECT_EQ(guess("a.obj", 120), "mm");
  EXPECT_EQ(guess("a.obj", 12), "cm");
  EXPECT_EQ(guess("a.obj", 1.2), "m");
}

TEST(MeshReport, TellsMissingTexturesFromOtherNotices) {
  PolygonSoup soup = shapes::cube();
  soup.notices = {"The picture a.png was not found beside the model; its parts stay plain.",
                  "Something else."};
  const MeshReport report = report_on(soup);
  EXPECT_EQ(report.count(Topic::MissingTextures), 1);
  EXPECT_EQ(report.find(Topic::MissingTextures)->text, soup.notices[0]);
  EXPECT_EQ(report.find(Topic::Other)->text, "Something else.");
}

}  // namespace
}  // namespace netwright
