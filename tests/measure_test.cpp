// The measuring tool, as a person uses it: distances and angles at printed size.
#include "ui/measure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/gui_support.h"
#include "tests/support.h"
#include "ui/selection.h"

namespace netwright::testing {
namespace {

struct Measured : Gui {
  Measured() {
    open_sample("Cube");
    EXPECT_TRUE(unfold());
    key('D');
  }
  [[nodiscard]] const Mesh& mesh() { return session().project().dual->mesh(); }
  [[nodiscard]] const Net& net() { return *app.workspace().scene().net(); }
  [[nodiscard]] double side_mm() { return mesh().length(EdgeId(0)) * session().pages()->scale; }
  glm::dvec2 in_net(glm::dvec2 point) {
    const WidgetRect picture = rect("net/picture");
    return glm::dvec2(picture.min.x, picture.min.y) + app.workspace().net_view().camera().to_pixel(point);
  }
  glm::dvec2 on_model(const glm::dvec3& point) {
    const WidgetRect picture = rect("model/picture");
    return glm::dvec2(picture.min.x, picture.min.y) +
           glm::dvec2(app.workspace().model_view().camera().project(point));
  }
  void click_at(glm::dvec2 at) {
    point(at);
    window.press_mouse();
    frames();
    window.release_mouse();
    frames(3);
  }
};

double number_in(const std::string& text) {
  try {
    return std::stod(text);
  } catch (const std::exception&) {
    return -1;
  }
}

TEST(Measure, CornersOfASideAreItsLengthApart) {
  Measured gui;
  const HalfedgeId h = gui.mesh().first(FaceId(2));
  gui.click_at(gui.in_net(gui.net().corner(h)) + glm::dvec2(3, 2));
  EXPECT_EQ(gui.ui().measuring.points.size(), 1U);
  gui.click_at(gui.in_net(gui.net().corner(gui.mesh().next(h))) - glm::dvec2(2, 3));
  ASSERT_EQ(gui.ui().measuring.points.size(), 2U);
  EXPECT_NEAR(number_in(gui.ui().hint), gui.side_mm(), 0.051) << gui.ui().hint;
  EXPECT_EQ(gui.ui().hint.find("in the net"), std::string::npos) << "in one face both distances are the same";
  EXPECT_FALSE(has_selection(gui.ui())) << "the tool's clicks select nothing";
}

TEST(Measure, TheNetAndTheModelMayDisagree) {
  Measured gui;
  // The far corners of two faces at a fold: on paper two sides wide, on the model bent.
  const Mesh& mesh = gui.mesh();
  FaceId child;
  for (const FaceId f : mesh.faces())
    if (!gui.net().tree.is_root(f)) child = f;
  const HalfedgeId up = gui.net().tree.to_parent(child);
  const HalfedgeId here = mesh.prev(up);
  const HalfedgeId there = mesh.next(mesh.next(mesh.twin(up)));
  gui.click_at(gui.in_net(gui.net().corner(here)));
  gui.click_at(gui.in_net(gui.net().corner(there)));
  const double flat = glm::distance(gui.net().corner(here), gui.net().corner(there));
  const double bent = glm::distance(mesh.position(here), mesh.position(there));
  ASSERT_GT(flat, bent * 1.05);
  const std::string hint = gui.ui().hint;
  const double scale = gui.session().pages()->scale;
  EXPECT_NEAR(number_in(hint), flat * scale, 0.051) << hint;
  const auto at = hint.find("in the net, ");
  ASSERT_NE(at, std::string::npos) << hint;
  EXPECT_NEAR(number_in(hint.substr(at + 12)), bent * scale, 0.051) << hint;
}

TEST(Measure, WorksOnTheModelAndTellsTheAngleOfEdges) {
  Measured gui;
  const Mesh& mesh = gui.mesh();
  const OrbitCamera& camera = gui.app.workspace().model_view().camera();
  FaceId front(0);
  for (const FaceId f : mesh.faces())
    if (glm::dot(mesh.normal(f), glm::normalize(camera.eye() - mesh.centre(f))) >
        glm::dot(mesh.normal(front), glm::normalize(camera.eye() - mesh.centre(front))))
      front = f;
  const HalfedgeId a = mesh.first(front);
  const HalfedgeId b = mesh.next(a);
  const auto middle = [&](HalfedgeId h) { return (mesh.position(h) + mesh.position(mesh.next(h))) * 0.5; };
  gui.click_at(gui.on_model(middle(a)));
  ASSERT_EQ(gui.ui().measuring.points.size(), 1U);
  EXPECT_TRUE(gui.ui().measuring.points[0].side.is_valid());
  gui.click_at(gui.on_model(middle(b)));
  EXPECT_NEAR(number_in(gui.ui().hint), gui.side_mm() / std::sqrt(2.0), 1.5) << gui.ui().hint;
  EXPECT_NE(gui.ui().hint.find("angle of the edges 90.0°"), std::string::npos) << gui.ui().hint;
}

TEST(Measure, ShowsItsPointsInItsOwnColour) {
  Measured gui;
  const HalfedgeId h = gui.mesh().first(FaceId(2));
  gui.click_at(gui.in_net(gui.net().corner(h)));
  gui.click_at(gui.in_net(gui.net().corner(gui.mesh().next(h))));
  gui.point({2, 2});
  const auto pixel = glm::ivec2(gui.in_net(gui.net().corner(h)));
  const Image image = gui.window.read_pixels();
  const auto at = 4 * (static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(image.width) +
                       static_cast<std::size_t>(pixel.x));
  const Colour wanted = palette(Theme::Light).measure;
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(image.rgba[at + static_cast<std::size_t>(i)], 255 * wanted[i], 12) << "channel " << i;
}

TEST(Measure, EscapeLetsGoOfThePointThenOfTheTool) {
  Measured gui;
  gui.click_at(gui.net_pixel(FaceId(1)));
  ASSERT_EQ(gui.ui().measuring.points.size(), 1U);
  gui.key(keys::kEscape);
  EXPECT_TRUE(gui.ui().measuring.is_on);
  EXPECT_TRUE(gui.ui().measuring.points.empty());
  gui.key(keys::kEscape);
  EXPECT_FALSE(gui.ui().measuring.is_on);
  gui.click_at(gui.net_pixel(FaceId(1)));
  EXPECT_EQ(gui.ui().selected, FaceId(1)) << "without the tool clicks select again";
}

TEST(Measure, ControlSwitchesSnappingOff) {
  Measured gui;
  const HalfedgeId h = gui.mesh().first(FaceId(2));
  const glm::dvec2 inside = gui.net().placement[FaceId(2)](glm::dvec2(0));
  const glm::dvec2 corner = gui.net().corner(h);
  const glm::dvec2 beside = corner + (inside - corner) * 0.03;
  gui.point(gui.in_net(beside));
  const auto place = [&] { return place_in_net(gui.net(), gui.ui().measuring.hovered); };
  EXPECT_LT(glm::distance(place(), corner), 1e-9);
  gui.window.hold_modifiers(kControl);
  gui.frames(2);
  EXPECT_GT(glm::distance(place(), corner), 1e-3 * glm::distance(inside, corner));
  gui.window.hold_modifiers(0);
}

TEST(Measure, APointHasTheSamePlaceInBothViews) {
  Measured gui;
  const DualGraph& dual = *gui.session().project().dual;
  const ModelPose model(gui.mesh());
  for (const HalfedgeId h : gui.mesh().halfedges()) {
    const PaperPoint point{gui.mesh().face(h), dual.flat(h), HalfedgeId()};
    EXPECT_LT(glm::distance(place_in_space(dual, model, point), gui.mesh().position(h)), 1e-9);
    EXPECT_LT(glm::distance(place_in_net(gui.net(), point), gui.net().corner(h)), 1e-9);
  }
}

}  // namespace
}  // namespace netwright::testing
