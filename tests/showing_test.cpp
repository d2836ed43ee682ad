// What can be shown besides: x-ray, numbers, the list of overlaps, flights to a face.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/unfold/overlap_depth.h"
#include "tests/gui_support.h"
#include "tests/support.h"
#include "ui/net_numbers.h"

namespace netwright::testing {
namespace {

const Mesh& mesh_of(Gui& gui) { return gui.session().project().dual->mesh(); }

/// Stops a search that cannot succeed: its overlaps stay.
void leave_overlaps(Gui& gui) {
  const PolygonSoup hats = with_hats(shapes::icosphere(1));
  gui.session().open_bytes("hats.obj", shapes::to_obj(hats));
  ASSERT_TRUE(gui.until([&] {
    return gui.session().has_model() && mesh_of(gui).n_faces() == static_cast<std::size_t>(hats.n_faces());
  }));
  gui.key('S');
  ASSERT_TRUE(gui.until([&] { return gui.session().shown() != nullptr; }));
  gui.session().stop();
  ASSERT_TRUE(gui.until([&] { return gui.session().state() == RunState::Idle; }));
  gui.frames(3);
  ASSERT_GT(gui.session().shown()->overlaps.size(), 1U);
}

TEST(Xray, ShowsWhatTheModelHides) {
  Gui gui;
  gui.open_sample("Cube");
  gui.point({2, 2});
  const WidgetRect picture = gui.rect("model/picture");
  const OrbitCamera& camera = gui.app.workspace().model_view().camera();
  const Mesh& mesh = mesh_of(gui);
  // The corner at the far side of the cube: three edges meet there, and faces are in front of it.
  VertexId far(0);
  for (const VertexId v : mesh.vertices())
    if (glm::distance(mesh.position(v), camera.eye()) > glm::distance(mesh.position(far), camera.eye()))
      far = v;
  glm::dvec3 along(0);
  for (const HalfedgeId h : mesh.halfedges())
    if (mesh.from(h) == far) along = mesh.position(mesh.next(h)) - mesh.position(h);
  const auto pixel = glm::ivec2(glm::dvec2(picture.min.x, picture.min.y) +
                                glm::dvec2(camera.project(mesh.position(far) + 0.4 * along)));
  const auto contrast = [&] {
    const Image image = gui.window.read_pixels();
    return std::abs(brightness(image, pixel) - brightness(image, pixel + glm::ivec2(14, 10)));
  };
  const double opaque = contrast();
  gui.key('X');
  EXPECT_TRUE(gui.ui().settings.is_xray);
  gui.frames(2);
  EXPECT_GT(contrast(), opaque + 4) << "a hidden edge must shine through";
  gui.click("model/X-ray");
  EXPECT_FALSE(gui.ui().settings.is_xray);
}

TEST(Numbers, StandWhereThereIsRoom) {
  Gui gui;
  gui.open_sample("Bunny");
  ASSERT_TRUE(gui.unfold());
  gui.key('L');
  ASSERT_TRUE(gui.ui().settings.show_numbers);
  gui.point({2, 2});
  const Image far = gui.window.read_pixels();
  const glm::dvec2 at = gui.net_pixel(FaceId(40));
  gui.point(at);
  gui.window.scroll({0, 22});
  gui.frames(3);
  gui.point({2, 2});
  const Image with = gui.window.read_pixels();
  gui.key('L');
  gui.frames(2);
  const Image without = gui.window.read_pixels();
  EXPECT_NE(with.rgba, without.rgba);
  EXPECT_GT(gui.app.workspace().net_view().n_numbers(), 3);
  gui.key('L');
  gui.key('F');
  gui.frames(3);
  EXPECT_EQ(gui.app.workspace().net_view().n_numbers(), 0) << "from afar nobody could read them";
}

TEST(OverlapDepth, IsTheShortestWayOut) {
  // Two squares of one net, pushed into each other by hand.
  const auto dual = make_dual(shapes::cube());
  Net net = layout(dual, UnfoldTree(6));
  for (const FaceId f : dual->mesh().faces()) net.placement[f] = Rigid2{1, 0, 100.0 * f.value, 0};
  const Box2 box = net.box(FaceId(0));
  net.placement[FaceId(1)] = net.placement[FaceId(0)];
  net.placement[FaceId(1)].x += box.size().x * 0.75;
  net.placement[FaceId(1)].y += box.size().y * 0.1;
  EXPECT_NEAR(overlap_depth(net, {FaceId(0), FaceId(1)}), box.size().x * 0.25, 1e-9);
  EXPECT_EQ(overlap_depth(net, {FaceId(0), FaceId(2)}), 0);
}

TEST(OverlapPanel, ListsTheDeepestFirstAndFliesThere) {
  Gui gui;
  leave_overlaps(gui);
  gui.ui().settings.open_sections.fill(false);
  gui.frames(3);
  gui.click("section/Overlaps");
  gui.frames(3);
  const auto& rows = gui.ui().overlaps.rows;
  ASSERT_EQ(rows.size(), std::min(gui.session().shown()->overlaps.size(), OverlapList::kMostRows));
  EXPECT_TRUE(std::is_sorted(rows.begin(), rows.end(),
                             [](const auto& a, const auto& b) { return a.depth > b.depth; }));
  EXPECT_GT(rows.back().depth, 0);
  const Overlap overlap = rows.front().overlap;
  gui.click("overlaps/0");
  ASSERT_TRUE(gui.until([&] {
    gui.frames();
    return glm::distance(gui.app.workspace().net_view().camera().centre(), [&] {
             Box2 box = gui.app.workspace().scene().net()->box(overlap.first);
             box.add(gui.app.workspace().scene().net()->box(overlap.second));
             return box.centre();
           }()) < 1e-9;
  }));
  const FaceStates& states = gui.app.workspace().scene().states();
  EXPECT_TRUE(states.has(overlap.first, FaceState::Selected));
  EXPECT_TRUE(states.has(overlap.second, FaceState::Selected));
  Box3 box;
  for (const FaceId f : {overlap.first, overlap.second})
    for (const HalfedgeId h : mesh_of(gui).halfedges(f)) box.add(mesh_of(gui).position(h));
  EXPECT_LT(glm::distance(gui.app.workspace().model_view().camera().target(), box.centre()), 1e-9);
  gui.key(keys::kEscape);
  EXPECT_FALSE(gui.ui().shown_overlap.has_value());
}

TEST(OverlapPanel, IsThereOnlyWhenThereIsSomethingToList) {
  Gui gui;
  gui.open_sample("Cube");
  ASSERT_TRUE(gui.unfold());
  EXPECT_FALSE(gui.widgets.find("section/Overlaps").has_value());
  leave_overlaps(gui);
  EXPECT_TRUE(gui.widgets.find("section/Overlaps").has_value());
}

TEST(Flights, ADoubleClickInTheNetTurnsTheModelToAFaceOnItsBack) {
  Gui gui;
  gui.open_sample("Bunny");
  ASSERT_TRUE(gui.unfold());
  const Mesh& mesh = mesh_of(gui);
  const OrbitCamera before = gui.app.workspace().model_view().camera();
  FaceId hidden;
  for (const FaceId f : mesh.faces())
    if (glm::dot(mesh.normal(f), glm::normalize(before.eye() - mesh.centre(f))) < -0.8) hidden = f;
  ASSERT_TRUE(hidden.is_valid());
  gui.double_click(gui.net_pixel(hidden));
  gui.frames(30);
  const OrbitCamera& camera = gui.app.workspace().model_view().camera();
  EXPECT_LT(glm::distance(camera.target(), mesh.centre(hidden)), 1e-9);
  EXPECT_GT(glm::dot(mesh.normal(hidden), glm::normalize(camera.eye() - mesh.centre(hidden))), 0.5);
}

}  // namespace
}  // namespace netwright::testing
