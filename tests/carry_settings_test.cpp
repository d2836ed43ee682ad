// What was said of single edges goes to the same edges of another mesh of the model.
#include "core/project/carry_settings.h"

#include <gtest/gtest.h>

#include "core/project/carry_pins.h"
#include "core/project/commands.h"
#include "tests/project_support.h"

namespace netwright {
namespace {

using testing::make_mesh;
using testing::project_of;

/// The direction in which the side First of an edge runs, and where its middle is.
struct Place {
  glm::dvec3 middle;
  glm::dvec3 along;
};

Place place(const Mesh& mesh, EdgeId e) {
  const HalfedgeId h = mesh.halfedge(e);
  const glm::dvec3& a = mesh.position(mesh.from(h));
  const glm::dvec3& b = mesh.position(mesh.to(h));
  return {(a + b) * 0.5, b - a};
}

PolygonSoup faces_in_reverse(const PolygonSoup& soup) {
  PolygonSoup reverse = soup;
  reverse.face_begin = {0};
  reverse.corners.clear();
  for (int f = soup.n_faces() - 1; f >= 0; --f) {
    for (auto i = soup.face_begin[static_cast<std::size_t>(f)];
         i < soup.face_begin[static_cast<std::size_t>(f) + 1]; ++i)
      reverse.corners.push_back(soup.corners[static_cast<std::size_t>(i)]);
    reverse.face_begin.push_back(static_cast<int>(reverse.corners.size()));
  }
  return reverse;
}

TEST(CarrySettings, ATabStaysOnItsFaceWhenEdgesBeginWithTheOtherOne) {
  const auto from = make_mesh(shapes::cube());
  const auto to = make_mesh(faces_in_reverse(shapes::cube()));
  TabSettings tabs;
  for (const EdgeId e : from->edges()) tabs.edits.push_back({e, TabSide::First, 3.0, 0.3, 0.6});
  SheetSettings sheet;
  carry_settings(
      tabs, sheet, *from, *to, [&](EdgeId e) { return nearest_edge(*from, e, *to); },
      [](const glm::dvec3& d) { return d; });
  ASSERT_EQ(tabs.edits.size(), from->n_edges());
  int n_swapped = 0;
  for (const TabEdit& edit : tabs.edits) {
    EdgeId old;
    for (const EdgeId e : from->edges())
      if (glm::length(place(*from, e).middle - place(*to, edit.edge).middle) < 1e-9) old = e;
    ASSERT_TRUE(old.is_valid());
    const bool is_reversed = glm::dot(place(*from, old).along, place(*to, edit.edge).along) < 0;
    n_swapped += is_reversed ? 1 : 0;
    EXPECT_EQ(edit.side, is_reversed ? TabSide::Second : TabSide::First);
    EXPECT_EQ(edit.first_angle_rad, is_reversed ? 0.6 : 0.3);
    EXPECT_EQ(edit.second_angle_rad, is_reversed ? 0.3 : 0.6);
  }
  EXPECT_GT(n_swapped, 0) << "otherwise nothing was tried";
}

TEST(CarrySettings, WhatFindsNoEdgeIsGoneAndNoEdgeIsNamedTwice) {
  const auto mesh = make_mesh(shapes::cube());
  TabSettings tabs;
  tabs.edits = {{EdgeId(1), TabSide::None, {}, {}, {}},
                {EdgeId(2), TabSide::Both, {}, {}, {}},
                {EdgeId(3), TabSide::First, {}, {}, {}}};
  SheetSettings sheet;
  sheet.hidden_folds = {EdgeId(4), EdgeId(5)};
  sheet.shown_folds = {EdgeId(6)};
  const auto to_seven = [](EdgeId e) { return e == EdgeId(2) ? EdgeId() : EdgeId(7); };
  carry_settings(tabs, sheet, *mesh, *mesh, to_seven, [](const glm::dvec3& d) { return d; });
  ASSERT_EQ(tabs.edits.size(), 1u);
  EXPECT_EQ(tabs.edits.front().edge, EdgeId(7));
  EXPECT_EQ(tabs.edits.front().side, TabSide::None);
  EXPECT_EQ(sheet.hidden_folds, std::vector<EdgeId>{EdgeId(7)});
  EXPECT_TRUE(sheet.shown_folds.empty()) << "a fold is not both hidden and shown";
}

TEST(CarrySettings, AnotherRecipeKeepsWhatWasSaidOfEdgesThatAreStillThere) {
  Project project = project_of(shapes::grid_cube(3));
  const auto& before = project.dual->mesh();
  const EdgeId rim(5);
  project.tabs.edits = {{rim, TabSide::Both, 4.0, {}, {}}};
  project.sheet.hidden_folds = {rim};
  const Recipe recipe{.uneven = UnevenFaces::Split};
  Project again = remake(project, recipe, project_of(shapes::grid_cube(3), recipe).made);
  ASSERT_EQ(again.tabs.edits.size(), 1u);
  EXPECT_EQ(again.tabs.edits.front().width_mm, 4.0);
  const Place old = place(before, rim);
  EXPECT_LT(glm::length(place(again.dual->mesh(), again.tabs.edits.front().edge).middle - old.middle), 1e-9);
  EXPECT_EQ(again.sheet.hidden_folds, std::vector<EdgeId>{again.tabs.edits.front().edge});
}

}  // namespace
}  // namespace netwright
