// What is said about a net before it is printed.
#include "core/sheet/buildability.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/unfold/steepest_edge.h"
#include "tests/support.h"

namespace netwright {
namespace {

using testing::make_dual;

/// A strip of squares in the plane, all joined, with one cell as low as `waist`.
PolygonSoup strip(double waist) {
  PolygonSoup soup;
  soup.name = "strip";
  for (int i = 0; i <= 5; ++i) {
    const double half = i == 2 || i == 3 ? waist / 2 : 0.5;
    soup.points.push_back({i, -half, 0});
    soup.points.push_back({i, half, 0});
  }
  for (int i = 0; i < 5; ++i) soup.add_face(std::vector<int>{2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
  return soup;
}

Net some_net(const std::shared_ptr<const DualGraph>& dual) {
  Random random(3);
  return layout(dual, steepest_edge_tree(*dual, random));
}

Net joined(const PolygonSoup& soup) {
  const auto dual = make_dual(soup);
  const Mesh& mesh = dual->mesh();
  return layout(dual, tree_from_folds(mesh, IdVector<EdgeId, char>(mesh.n_edges(), 1)));
}

PageLayout at_scale(const Net& net, double scale) {
  PageLayout layout;
  layout.scale = scale;
  layout.pieces.resize(static_cast<std::size_t>(net.n_pieces));
  layout.pages.resize(1);
  return layout;
}

TEST(Judge, FindsTheWaistOfAStrip) {
  for (const double waist : {0.1, 0.3, 0.7}) {
    const Net net = joined(strip(waist));
    const Buildability judged = judge(net, at_scale(net, 10));
    EXPECT_NEAR(judged.neck.width_mm, 10 * waist, 1e-9) << waist;
    EXPECT_GE(judged.neck.faces.size(), 1U);
    EXPECT_NEAR(judged.smallest_edge_mm, 10 * waist, 1e-9);
    EXPECT_EQ(judged.n_sheets, 1);
  }
}

TEST(Judge, GoesStraightThroughThePaperWhereNoFoldIsAsShort) {
  // A chevron: its inner corner is nearer to the outer side than any of its folds is long.
  PolygonSoup soup;
  soup.name = "notched";
  soup.points = {{0, 0, 0}, {4, 0, 0}, {8, 0, 0}, {8, 3, 0}, {4, 0.5, 0}, {0, 3, 0}};
  soup.add_face(std::vector<int>{0, 1, 5});
  soup.add_face(std::vector<int>{1, 4, 5});
  soup.add_face(std::vector<int>{1, 2, 4});
  soup.add_face(std::vector<int>{2, 3, 4});
  const Net net = joined(soup);
  const Buildability judged = judge(net, at_scale(net, 2));
  EXPECT_NEAR(judged.neck.width_mm, 1.0, 1e-9) << "the fold below the notch";
  PolygonSoup apart = soup;
  apart.points[1] = {3, 0, 0};
  const Net leaning = joined(apart);
  const Buildability other = judge(leaning, at_scale(leaning, 2));
  EXPECT_NEAR(other.neck.width_mm, 1.0, 1e-9) << "straight down, beside the slanted fold";
  EXPECT_LT(other.neck.width_mm, 2 * std::hypot(1.0, 0.5));
}

TEST(Judge, NeverReportsANeckThatIsLongerThanTheShortestFold) {
  for (const testing::ZooShape& shape : testing::zoo()) {
    const auto dual = make_dual(shape.soup);
    const Mesh& mesh = dual->mesh();
    const Net net = some_net(dual);
    const Buildability judged = judge(net, at_scale(net, 1));
    for (const EdgeId e : mesh.edges()) {
      if (net.tree.is_fold(mesh, e)) {
        EXPECT_LE(judged.neck.width_mm, mesh.length(e) + 1e-12) << shape.soup.name;
      }
      EXPECT_GE(mesh.length(e), judged.smallest_edge_mm - 1e-12) << shape.soup.name;
    }
    EXPECT_GT(judged.neck.width_mm, 0) << shape.soup.name;
  }
}

TEST(Judge, CountsFoldsAndCutsOfACube) {
  const auto dual = make_dual(shapes::cube());
  const Mesh& mesh = dual->mesh();
  const Net net = some_net(dual);
  const Buildability judged = judge(net, at_scale(net, 4));
  EXPECT_EQ(judged.n_folds, 5);
  EXPECT_EQ(judged.n_cuts, 7);
  const double side = mesh.length(EdgeId(0)) * 4;
  EXPECT_NEAR(judged.folds_mm, 5 * side, 1e-9);
  EXPECT_NEAR(judged.cuts_mm, 14 * side, 1e-9);
  EXPECT_NEAR(judged.sharpest_corner_rad, std::numbers::pi / 2, 1e-9);
}

TEST(LinesOf, WarnsUnderFiveMillimetresAndIsAlarmedUnderThree) {
  const Net net = joined(strip(0.4));
  const auto grade = [&](double scale) {
    return lines_of(judge(net, at_scale(net, scale)), net).front().grade;
  };
  EXPECT_EQ(grade(20), BuildLine::Grade::Fact);
  EXPECT_EQ(grade(10), BuildLine::Grade::Warning);
  EXPECT_EQ(grade(5), BuildLine::Grade::Trouble);
  const auto lines = lines_of(judge(net, at_scale(net, 10)), net);
  EXPECT_EQ(lines[0].text, "Smallest edge 4.0 mm");
  EXPECT_EQ(lines[1].text, "2 edges under 5.0 mm");
  ASSERT_EQ(lines.front().edges.size(), 1U);
}

}  // namespace
}  // namespace netwright
